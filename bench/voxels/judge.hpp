#pragma once
/// What a peer reports on a ray against the exact answer, by graze::oracle.
#include "mask_tree.hpp"
#include <graze/octree/ray.hpp>

namespace graze::bench {

struct touched_octant {
  octant_key key;
  bool crossed; ///< the ray meets its open interior
};

/// The occupied octants that a ray touches.
class exact_octants {
public:
  explicit exact_octants(const occupied_octants& octants)
      : tree_(octants), root_(*octree::root_cube::make(octants.root, octants.level)),
        level_(static_cast<unsigned>(octants.level)) {}

  /// Sorted by key.
  [[nodiscard]] std::vector<touched_octant> touched(const octree::ray& r) const;

private:
  void descend(const octree::ray& r, unsigned level, std::uint32_t node, const octant_index& at,
               std::vector<touched_octant>& found) const;
  mask_tree tree_;
  octree::root_cube root_;
  unsigned level_;
};

/// Sums over rays.
struct verdict {
  std::size_t rays = 0;
  std::size_t touched = 0;  ///< octants that the rays touch: what is to be reported
  std::size_t crossed = 0;  ///< those of them whose interior the ray meets
  std::size_t missed = 0;   ///< touched and not reported: misses of the convention `closed`
  std::size_t gaps = 0;     ///< crossed and not reported: wrong in every convention
  std::size_t spurious = 0; ///< reported and not touched
  std::size_t doubles = 0;  ///< reported again
  std::size_t bad_rays = 0; ///< rays with a gap

  /// One ray; `found` is sorted.
  void add(const std::vector<touched_octant>& exact, std::vector<octant_key>& found);
};

} // namespace graze::bench
