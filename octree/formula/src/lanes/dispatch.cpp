// Which path's kernels.
#include "tables.hpp"

namespace graze::octree {

template <> const lane_kernels<formula_surface>& lane_kernels_of<formula_surface>(batch::path p) {
  using namespace detail;
  return GRAZE_ALL_PATHS(lane_kernels<formula_surface>, formula_lanes).on(p);
}

} // namespace graze::octree
