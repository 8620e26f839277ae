// Which path's kernels.
#include "tables.hpp"

namespace graze::octree {

template <> const lane_kernels<formula_surface>& lane_kernels_of<formula_surface>(batch::path p) {
  switch (p) {
#if defined(__x86_64__)
  case batch::path::avx512:
    return detail::avx512_formula_lanes;
  case batch::path::avx2:
    return detail::avx2_formula_lanes;
#endif
  default:
    return detail::baseline_formula_lanes;
  }
}

} // namespace graze::octree
