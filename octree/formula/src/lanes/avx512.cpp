// The kernels of the path avx512, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/lane_kernels_of_path.hpp>
#include <graze/octree_formula/operations_eight.hpp>

namespace graze::octree::detail {
constinit const lane_kernels<formula_surface> avx512_formula_lanes =
    make_lane_kernels<batch::avx512, formula_surface>();
} // namespace graze::octree::detail
