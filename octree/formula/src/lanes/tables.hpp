#pragma once
/// The kernels of formulas: constants, so that nothing of a path's file runs before a path has been
/// chosen.
#include <graze/batch/per_path.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

namespace graze::octree::detail {

GRAZE_DECLARE_ON_PATHS(lane_kernels<formula_surface>, formula_lanes);

} // namespace graze::octree::detail
