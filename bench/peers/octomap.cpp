#include "peers.hpp"
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

template <> void peer<octomap>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  structure& s = *structure_;
  const octree::vec3 &o = r.origin(), &d = r.direction();
  // computeRayKeys leaves out the cell of the end: the ray ends outside of the root, two voxels
  // after it has left it on some axis.
  double end = std::numeric_limits<double>::infinity();
  for (unsigned a = 0; a < 3; ++a)
    if (d[a] != 0)
      end = std::min(
          end, ((d[a] > 0 ? s.root.hi(static_cast<int>(a)) + s.beyond : s.root.lo[a] - s.beyond) -
                o[a]) /
                   d[a]);
  if (end < 0)
    return;
  const auto single = [](double x, double y, double z) {
    return ::octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  if (!s.tree.computeRayKeys(single(o[0], o[1], o[2]),
                             single(o[0] + end * d[0], o[1] + end * d[1], o[2] + end * d[2]),
                             s.keys))
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
