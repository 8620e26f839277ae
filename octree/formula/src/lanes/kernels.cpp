// The kernels of formulas, compiled for each path.
#include "tables.hpp"
#include <graze/octree/lane_kernels_of_path.hpp>
#include <graze/octree_formula/operations_eight.hpp>

namespace graze::octree::detail {
constinit const lane_kernels<formula_surface>
    GRAZE_ON_PATH(formula_lanes) = make_lane_kernels<batch::this_path, formula_surface>();
} // namespace graze::octree::detail
