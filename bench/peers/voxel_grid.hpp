#pragma once
/// What every peer is built from and what it reports: occupied voxels of one level of a root cube.
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <vector>

namespace graze::bench {

using voxel_index = std::array<std::uint32_t, 3>;

/// x + 2^21 y + 2^42 z.
using voxel_key = std::uint64_t;
[[nodiscard]] constexpr voxel_key key_of(const voxel_index& v) {
  return v[0] | static_cast<std::uint64_t>(v[1]) << 21 | static_cast<std::uint64_t>(v[2]) << 42;
}
[[nodiscard]] constexpr voxel_index index_of(voxel_key key) {
  return {static_cast<std::uint32_t>(key & 0x1f'ffff),
          static_cast<std::uint32_t>(key >> 21 & 0x1f'ffff), static_cast<std::uint32_t>(key >> 42)};
}

/// The occupied voxels: octants of root.level() <= 21, each named once. Peers count cells from
/// coordinate 0, some in single precision: the root's size is a power of two, and its lower corner
/// a multiple of the voxel's size, so that none of them has to round a voxel's corner.
struct voxel_grid {
  octree::root_cube root;
  std::vector<voxel_index> voxels;

  [[nodiscard]] int level() const { return root.level(); }
  [[nodiscard]] double voxel_size() const { return std::ldexp(root.box().size, -level()); }
  /// The root's lower corner in voxels.
  [[nodiscard]] std::array<int, 3> first_cell() const {
    std::array<int, 3> cell{};
    for (unsigned a = 0; a < 3; ++a) {
      const double in_voxels = root.box().lo[a] / voxel_size();
      cell[a] = static_cast<int>(in_voxels);
      assert(cell[a] == in_voxels);
    }
    return cell;
  }
  [[nodiscard]] octree::vec3 centre(const voxel_index& v) const {
    octree::vec3 c{};
    for (unsigned a = 0; a < 3; ++a)
      c[a] = root.box().lo[a] + (v[a] + 0.5) * voxel_size();
    return c;
  }
};

} // namespace graze::bench
