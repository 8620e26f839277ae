#pragma once
/// The kernels of formulas: constants, so that nothing of a path's file runs before a path has been
/// chosen.
#include <graze/octree_formula/lane_kernels.hpp>

namespace graze::octree::detail {

extern const lane_kernels<formula_surface> baseline_formula_lanes;
#if defined(__x86_64__)
extern const lane_kernels<formula_surface> avx2_formula_lanes, avx512_formula_lanes;
#endif

} // namespace graze::octree::detail
