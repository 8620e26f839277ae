#pragma once
/// The kernels of the surfaces that are built in: constants, so that nothing of a path's file runs
/// before a path has been chosen.
#include <graze/batch/per_path.hpp>
#include <graze/octree/lane_kernels.hpp>

namespace graze::octree::detail {

GRAZE_DECLARE_ON_PATHS(built_in_kernels, surface_kernels);

} // namespace graze::octree::detail
