#pragma once
/// A voxel of a voxel_set.
#include <graze/needs_cxx20.hpp>

#include <cstdint>

namespace graze::octree {

/// A voxel: its index on each axis at the set's level, and its rank among the set's voxels (0 ..
/// voxel_count() - 1), by which a user finds data of his own.
struct voxel {
  std::uint64_t packed; ///< x + 2^21 y + 2^42 z
  std::uint32_t rank;

  [[nodiscard]] std::uint32_t index(int axis) const {
    return static_cast<std::uint32_t>(packed >> (21 * axis) & 0x1f'ffff);
  }
  friend bool operator==(const voxel&, const voxel&) = default;
};

} // namespace graze::octree
