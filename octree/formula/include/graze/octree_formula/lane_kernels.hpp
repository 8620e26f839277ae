#pragma once
/// Formulas by the kernels of octree/lane_kernels.hpp: voxelize_in_lanes, lane_judge and
/// lane_traversal take a formula_surface like a surface of the scenes.
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree_formula.hpp>

namespace graze::octree {

template <> const lane_kernels<formula_surface>& lane_kernels_of<formula_surface>(batch::path p);

} // namespace graze::octree
