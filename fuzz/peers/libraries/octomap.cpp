/// OctoMap, rays in float.
///
/// ray-keys: OcTree::computeRayKeys, from the origin to a point behind the root, and search(key) of
/// each cell. cast-ray: OcTree::castRay again and again, each time with the cell that it has hit made
/// free.
#include <algorithm>
#include <limits>
#include <octomap/octomap.h>
#include <peers/library.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

constexpr int centre_key = 32768; // OctoMap's key of the cell [0, resolution)

::octomap::point3d point(const vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

class tree : public structure {
public:
  tree(const occupied_octants& octants, const unit_cells& cells)
      : tree_(cells.edge), cells_(cells), root_(octants.root) {
    for (const octant_index& at : octants.indices) {
      const std::array<int, 3> cell = cells.cell(at);
      ::octomap::OcTreeKey key;
      for (unsigned a = 0; a < 3; ++a)
        key[a] = static_cast<::octomap::key_type>(cell[a] + centre_key);
      tree_.updateNode(key, true, true);
    }
    tree_.updateInnerOccupancy();
  }

protected:
  [[nodiscard]] octant_key key_of_cell(const ::octomap::OcTreeKey& key) const {
    return cells_.key(key[0] - centre_key, key[1] - centre_key, key[2] - centre_key);
  }

  ::octomap::OcTree tree_;
  unit_cells cells_;
  octree::cube root_;
};

class ray_keys final : public tree {
public:
  using tree::tree;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    const auto part = segment_of(r);
    ::octomap::OcTreeKey from, to;
    if (!part || !tree_.coordToKeyChecked(point(part->from), from) ||
        !tree_.coordToKeyChecked(point(part->to), to))
      return std::nullopt;
    int cells = 0; // its buffer of keys holds 100,000, and nothing checks that in a release build
    for (unsigned a = 0; a < 3; ++a)
      cells += std::abs(static_cast<int>(from[a]) - static_cast<int>(to[a])) + 2;
    if (cells > 99'000)
      return std::nullopt;
    return ray_by_points(part->from, part->to);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto part = segment_of(r);
    if (!part || !tree_.computeRayKeys(point(part->from), point(part->to), keys_))
      return;
    for (const ::octomap::OcTreeKey& key : keys_) {
      // Most cells outside of the root cost a look-up otherwise.
      bool inside = true;
      for (unsigned a = 0; a < 3; ++a) {
        const int place = static_cast<int>(key[a]) - centre_key - cells_.root[a];
        inside = inside && place >= 0 && place < cells_.side;
      }
      if (!inside)
        continue;
      if (const auto* node = tree_.search(key); node != nullptr && tree_.isNodeOccupied(node))
        found.push_back(key_of_cell(key));
    }
  }

private:
  struct segment {
    vec3 from, to; ///< in float
  };

  /// computeRayKeys leaves out the cell of the end: the ray ends outside of the root, two cells
  /// after it has left it on some axis.
  [[nodiscard]] std::optional<segment> segment_of(const octree::ray& r) const {
    const vec3 &o = r.origin(), &d = r.direction();
    const double beyond = 2 * cells_.edge;
    double end = std::numeric_limits<double>::infinity();
    for (unsigned a = 0; a < 3; ++a)
      if (d[a] != 0)
        end = std::min(
            end,
            ((d[a] > 0 ? root_.hi(static_cast<int>(a)) + beyond : root_.lo[a] - beyond) - o[a]) /
                d[a]);
    if (end < 0)
      return std::nullopt;
    return segment{to_float(o),
                   to_float(vec3{o[0] + end * d[0], o[1] + end * d[1], o[2] + end * d[2]})};
  }

  ::octomap::KeyRay keys_;
};

class cast_ray final : public tree {
public:
  using tree::tree;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    ::octomap::OcTreeKey from;
    if (cells_.side > 1 << 14 || !adapter::is_finite(to_float(r.origin())) ||
        !tree_.coordToKeyChecked(point(r.origin()), from))
      return std::nullopt;
    return ray_in_float(r);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const vec3 o = to_float(r.origin());
    double range = 0; // so far that no cell of the root lies behind
    for (unsigned a = 0; a < 3; ++a)
      range += std::fabs(o[a]) + std::fabs(root_.lo[a]) + root_.size;
    std::vector<::octomap::OcTreeKey> freed;
    ::octomap::point3d centre;
    while (tree_.castRay(point(o), point(r.direction()), centre, true, range)) {
      freed.push_back(tree_.coordToKey(centre));
      found.push_back(key_of_cell(freed.back()));
      tree_.setNodeValue(freed.back(), -1, true);
    }
    for (const ::octomap::OcTreeKey& key : freed)
      tree_.setNodeValue(key, 1, true);
  }
};

} // namespace

std::vector<variant> octomap_variants() {
  return {
      {"octomap-ray-keys", "crossed", timed::yes, "OctoMap", "OctoMap, computeRayKeys (float)",
       built_in_cells<ray_keys>},
      {"octomap-cast-ray", "crossed", timed::no, "OctoMap, castRay",
       "OctoMap, castRay again and again (float)", built_in_cells<cast_ray>},
  };
}

} // namespace graze::peers
