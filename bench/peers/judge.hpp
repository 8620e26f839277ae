#pragma once
/// What a peer reports on a ray against the exact answer, by graze::oracle.
#include "mask_tree.hpp"
#include <graze/octree/ray.hpp>

namespace graze::bench {

/// The occupied voxels that a ray touches.
class exact_voxels {
public:
  explicit exact_voxels(const voxel_grid& grid)
      : tree_(grid), root_(grid.root), level_(static_cast<unsigned>(grid.level())) {}

  struct voxel {
    voxel_key key;
    bool crossed; ///< the ray meets its open interior
  };
  /// Sorted by key.
  [[nodiscard]] std::vector<voxel> on(const octree::ray& r) const;

private:
  void descend(const octree::ray& r, unsigned level, std::uint32_t node, const voxel_index& at,
               std::vector<voxel>& found) const;
  mask_tree tree_;
  octree::root_cube root_;
  unsigned level_;
};

/// Sums over rays.
struct verdict {
  std::size_t rays = 0;
  std::size_t touched = 0;  ///< voxels that the rays touch: what is to be reported
  std::size_t crossed = 0;  ///< those of them whose interior the ray meets
  std::size_t missed = 0;   ///< touched and not reported: misses of the convention `closed`
  std::size_t gaps = 0;     ///< crossed and not reported: wrong in every convention
  std::size_t spurious = 0; ///< reported and not touched
  std::size_t doubles = 0;  ///< reported again
  std::size_t bad_rays = 0; ///< rays with a gap

  /// One ray; `found` is sorted.
  void add(const std::vector<exact_voxels::voxel>& exact, std::vector<voxel_key>& found);
};

} // namespace graze::bench
