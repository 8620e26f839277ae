#pragma once
/// Where a node's planes come from: a policy, with
///   tabled                   they are loaded, or else computed
///   choose(state, axis, d)   before a walk, what depends on the ray's direction
///   level                    of nodes, made from the state
#include <graze/batch/path.hpp>
#include <graze/octree/voxel_rays_state.hpp>

namespace graze::octree::detail {
namespace {

/// Octants of a root cube: a node's lower corner and multiples of a size, all of them exact.
struct computed_planes {
  static constexpr bool tabled = false;
  static GRAZE_BATCH_INLINE void choose(voxel_rays_state&, unsigned, double) {}
  struct level {
    double size;
    GRAZE_BATCH_INLINE level(const voxel_rays_state& s, unsigned d) : size(s.sizes[d]) {}
  };
};

/// Voxels of a grid: its planes from arrays, one for each level of nodes. Slab i of an axis is
/// entered by enter[i] and left by leave[i].
struct tabled_planes {
  static constexpr bool tabled = true;

  /// Along an axis without motion, where planes that are no doubles lie between two neighbours: p
  /// <= o where the upper one is, and o <= p where the lower one is. o < p is next(o) <= p, which
  /// is so where next(o) <= the upper one.
  static GRAZE_BATCH_INLINE void choose(voxel_rays_state& s, unsigned a, double d) {
    const bool backward = d < 0, still = d == 0;
    const auto &early = backward || still ? s.upper : s.lower,
               &late = backward || (still && !s.owned) ? s.lower : s.upper;
    for (unsigned k = 0; k < s.depth; ++k) {
      s.enter.of_level[k][a] = early.of_level[k][a] + (backward ? 1 : 0);
      s.leave.of_level[k][a] = late.of_level[k][a] + (backward ? 0 : 1);
    }
  }

  struct level {
    const double *enter[3], *leave[3];
    unsigned shift;
    GRAZE_BATCH_INLINE level(const voxel_rays_state& s, unsigned d) : shift(s.shift[d]) {
      for (unsigned a = 0; a < 3; ++a) {
        enter[a] = s.enter.of_level[d][a];
        leave[a] = s.leave.of_level[d][a];
      }
    }
    /// The place of a node's first plane on an axis.
    [[nodiscard]] GRAZE_BATCH_INLINE std::size_t first(const voxel_rays_entry& e,
                                                       unsigned axis) const {
      return (e.packed >> (21 * axis) & 0x1f'ffff) >> shift;
    }
  };
};

} // namespace
} // namespace graze::octree::detail
