#include "peers.hpp"
#include "rounded_ray.hpp"
#include <algorithm>
#include <limits>
#include <octomap/octomap.h>

namespace graze::bench {
namespace {
constexpr int centre_key = 32768; // OctoMap's key of the cell [0, resolution)
} // namespace

template <> struct peer<octomap>::structure {
  explicit structure(const voxel_grid& grid)
      : tree(grid.voxel_size()), first(grid.first_cell()), root(grid.root.box()),
        beyond(2 * grid.voxel_size()), side(1 << grid.level()) {
    for (const voxel_index& v : grid.voxels) {
      ::octomap::OcTreeKey key;
      for (unsigned a = 0; a < 3; ++a)
        key[a] = static_cast<::octomap::key_type>(static_cast<int>(v[a]) + first[a] + centre_key);
      tree.updateNode(key, true, true);
    }
    tree.updateInnerOccupancy();
  }
  ::octomap::OcTree tree;
  std::array<int, 3> first;
  octree::cube root;
  double beyond; ///< how far behind the root a ray ends
  int side;
  ::octomap::KeyRay keys;
};

template <>
peer<octomap>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<octomap>::~peer() = default;

namespace {

struct segment {
  octree::vec3 from, to; ///< in single precision
};

::octomap::point3d point(const octree::vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/// computeRayKeys leaves out the cell of the end: the ray ends outside of the root, two voxels
/// after it has left it on some axis.
std::optional<segment> segment_of(const octree::ray& r, const octree::cube& root, double beyond) {
  const octree::vec3 &o = r.origin(), &d = r.direction();
  double end = std::numeric_limits<double>::infinity();
  for (unsigned a = 0; a < 3; ++a)
    if (d[a] != 0)
      end = std::min(
          end,
          ((d[a] > 0 ? root.hi(static_cast<int>(a)) + beyond : root.lo[a] - beyond) - o[a]) / d[a]);
  if (end < 0)
    return std::nullopt;
  return segment{single(o),
                 single(octree::vec3{o[0] + end * d[0], o[1] + end * d[1], o[2] + end * d[2]})};
}

} // namespace

template <> std::optional<octree::ray> peer<octomap>::received(const octree::ray& r) const {
  const structure& s = *structure_;
  const auto part = segment_of(r, s.root, s.beyond);
  ::octomap::OcTreeKey from, to;
  if (!part || !s.tree.coordToKeyChecked(point(part->from), from) ||
      !s.tree.coordToKeyChecked(point(part->to), to))
    return std::nullopt;
  int cells = 0; // its buffer of keys holds 100,000, and nothing checks that in a release build
  for (unsigned a = 0; a < 3; ++a)
    cells += std::abs(static_cast<int>(from[a]) - static_cast<int>(to[a])) + 2;
  if (cells > 99'000)
    return std::nullopt;
  return ray_by_points(part->from, part->to);
}

template <> void peer<octomap>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  structure& s = *structure_;
  const auto part = segment_of(r, s.root, s.beyond);
  if (!part || !s.tree.computeRayKeys(point(part->from), point(part->to), s.keys))
    return;
  for (const ::octomap::OcTreeKey& key : s.keys) {
    // Most cells outside of the root cost a look-up otherwise.
    voxel_index v{};
    bool inside = true;
    for (unsigned a = 0; a < 3; ++a) {
      const int cell = static_cast<int>(key[a]) - centre_key - s.first[a];
      inside = inside && cell >= 0 && cell < s.side;
      v[a] = static_cast<std::uint32_t>(cell);
    }
    if (!inside)
      continue;
    if (const auto* node = s.tree.search(key); node != nullptr && s.tree.isNodeOccupied(node))
      found.push_back(key_of(v));
  }
}

} // namespace graze::bench
