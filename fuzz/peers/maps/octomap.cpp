/// OctoMap's files: .bt and .ot, through AbstractOcTree and OcTree::readBinary. The grid is the tree's whole
/// range of keys, a voxel's index its OcTreeKey. A leaf that was pruned is all the voxels of its depth.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTreeStamped.h>
#include <octomap/octomap.h>
#include <peers/maps/voxel_map.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

constexpr unsigned depth = 16;
constexpr std::int64_t centre_key = 32768; // OctoMap's key of the cell [0, resolution)

template <class Tree> void add_leaves(voxel_map& map, const Tree& tree) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf))
      continue;
    const ::octomap::OcTreeKey key = leaf.getIndexKey();
    const auto side = std::uint32_t{1} << (depth - leaf.getDepth());
    map.add({key[0], key[1], key[2]}, {key[0] + side, key[1] + side, key[2] + side});
  }
}

std::unique_ptr<::octomap::AbstractOcTree> read_tree(const std::string& path) {
  if (path.ends_with(".bt")) {
    auto tree = std::make_unique<::octomap::OcTree>(1);
    if (!tree->readBinary(path))
      throw map_refused("OctoMap does not read it as a binary map (.bt)");
    return tree;
  }
  std::unique_ptr<::octomap::AbstractOcTree> tree(::octomap::AbstractOcTree::read(path));
  if (!tree)
    throw map_refused("OctoMap does not read it as a map (.ot)");
  return tree;
}

::octomap::point3d point(const vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

octant_key key_of(const ::octomap::OcTreeKey& key) {
  return peers::key_of(octant_index{key[0], key[1], key[2]});
}

/// The tree of a file, and where its occupied voxels are.
template <class Tree> class tree_of_map : public structure {
public:
  tree_of_map(std::unique_ptr<Tree> tree, const voxel_map& map) : tree_(std::move(tree)) {
    for (unsigned a = 0; a < 3; ++a) {
      std::uint32_t lo = UINT32_MAX, hi = 0;
      for (const octant_index& v : map.voxels) {
        lo = std::min(lo, v[a]);
        hi = std::max(hi, v[a]);
      }
      lo_[a] = map.planes[a][lo];
      hi_[a] = map.planes[a][hi + 1];
    }
  }

protected:
  std::unique_ptr<Tree> tree_;
  vec3 lo_{}, hi_{}; ///< all occupied voxels
};

template <class Tree> class cast_ray_of_map final : public tree_of_map<Tree> {
public:
  using tree_of_map<Tree>::tree_of_map;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    ::octomap::OcTreeKey from;
    if (!adapter::is_finite(to_float(r.origin())) ||
        !this->tree_->coordToKeyChecked(point(r.origin()), from))
      return std::nullopt;
    return ray_in_float(r);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    double range = 0; // so far that no occupied voxel lies behind
    for (unsigned a = 0; a < 3; ++a)
      range += std::fabs(r.origin()[a]) + std::fabs(this->lo_[a]) + std::fabs(this->hi_[a]);
    ::octomap::point3d centre;
    if (this->tree_->castRay(point(r.origin()), point(r.direction()), centre, true, range))
      found.push_back(key_of(this->tree_->coordToKey(centre)));
  }
};

template <class Tree> class ray_keys_of_map final : public tree_of_map<Tree> {
public:
  using tree_of_map<Tree>::tree_of_map;

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    const auto part = segment_of(r);
    ::octomap::OcTreeKey from, to;
    if (!part || !this->tree_->coordToKeyChecked(point(part->first), from) ||
        !this->tree_->coordToKeyChecked(point(part->second), to))
      return std::nullopt;
    int cells = 0; // its buffer of keys holds 100,000, and nothing checks that in a release build
    for (unsigned a = 0; a < 3; ++a)
      cells += std::abs(static_cast<int>(from[a]) - static_cast<int>(to[a])) + 2;
    return cells > 99'000 ? std::nullopt : ray_by_points(part->first, part->second);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto part = segment_of(r);
    if (!part || !this->tree_->computeRayKeys(point(part->first), point(part->second), keys_))
      return;
    for (const ::octomap::OcTreeKey& key : keys_)
      if (const auto* node = this->tree_->search(key);
          node != nullptr && this->tree_->isNodeOccupied(node))
        found.push_back(key_of(key));
  }

private:
  /// computeRayKeys leaves out the cell of the end: the ray ends two voxels after it has left the occupied
  /// ones on some axis.
  [[nodiscard]] std::optional<std::pair<vec3, vec3>> segment_of(const octree::ray& r) const {
    const vec3 &o = r.origin(), &d = r.direction();
    const double beyond = 2 * this->tree_->getResolution();
    double end = std::numeric_limits<double>::infinity();
    for (unsigned a = 0; a < 3; ++a)
      if (d[a] != 0)
        end = std::min(end,
                       ((d[a] > 0 ? this->hi_[a] + beyond : this->lo_[a] - beyond) - o[a]) / d[a]);
    if (end < 0)
      return std::nullopt;
    return std::pair(to_float(o),
                     to_float(vec3{o[0] + end * d[0], o[1] + end * d[1], o[2] + end * d[2]}));
  }

  ::octomap::KeyRay keys_;
};

template <template <class> class Structure>
std::unique_ptr<structure> built_from(const std::string& path, const map_options&,
                                      const voxel_map& map) {
  auto tree = read_tree(path);
  const auto built = [&](auto* of_type) {
    using type = std::remove_pointer_t<decltype(of_type)>;
    static_cast<void>(tree.release());
    return std::make_unique<Structure<type>>(std::unique_ptr<type>(of_type), map);
  };
  if (auto* t = dynamic_cast<::octomap::OcTree*>(tree.get()))
    return built(t);
  if (auto* c = dynamic_cast<::octomap::ColorOcTree*>(tree.get()))
    return built(c);
  if (auto* s = dynamic_cast<::octomap::OcTreeStamped*>(tree.get()))
    return built(s);
  return nullptr;
}

voxel_map read(const std::string& path, const map_options&);

} // namespace

map_library octomap_map() {
  return {read,
          {{"octomap-cast-ray", "first", "OctoMap, castRay through the map (float)",
            built_from<cast_ray_of_map>},
           {"octomap-ray-keys", "crossed", "OctoMap, computeRayKeys through the map (float)",
            built_from<ray_keys_of_map>}}};
}

namespace {

voxel_map read(const std::string& path, const map_options&) {
  const auto tree = read_tree(path);
  const double resolution = tree->getResolution();
  if (!(resolution > 0) || !std::isfinite(resolution * 65536) || !std::isfinite(1 / resolution))
    throw map_refused("its resolution is no length");
  voxel_map map;
  map.library = "OctoMap";
  map.names = "OcTreeKey";
  map.rule = "planes: (key - 32768) * resolution in double; indices: OcTreeKey, of a coordinate "
             "floor(coordinate * (1 / resolution)) + 32768 in double; pruned leaves expanded";
  if (const auto* t = dynamic_cast<const ::octomap::OcTree*>(tree.get()))
    add_leaves(map, *t);
  else if (const auto* c = dynamic_cast<const ::octomap::ColorOcTree*>(tree.get()))
    add_leaves(map, *c);
  else if (const auto* s = dynamic_cast<const ::octomap::OcTreeStamped*>(tree.get()))
    add_leaves(map, *s);
  else
    throw map_refused("a tree of type " + tree->getTreeType() +
                      ": OcTree, ColorOcTree and OcTreeStamped say which voxels are occupied");
  map.spacing = {resolution, resolution, resolution};
  for (auto& planes : map.planes)
    for (std::int64_t k = 0; k <= 2 * centre_key; ++k)
      planes.push_back(static_cast<double>(k - centre_key) * resolution);
  const auto keys = std::make_shared<::octomap::OcTree>(resolution);
  map.index = [keys](unsigned, double x) -> std::int64_t {
    ::octomap::key_type key = 0;
    if (keys->coordToKeyChecked(x, key))
      return key;
    return x < 0 ? -1 : 2 * centre_key;
  };
  return map;
}

} // namespace
} // namespace graze::peers
