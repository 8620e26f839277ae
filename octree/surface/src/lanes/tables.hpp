#pragma once
/// The kernels of the six surfaces: constants, so that nothing of a path's file runs before a path
/// has been chosen.
#include <graze/batch/per_path.hpp>
#include <graze/octree/lane_kernels.hpp>

namespace graze::octree::detail {

struct lane_tables {
  lane_kernels<octree::spheres> spheres;
  lane_kernels<octree::quartdef> quartdef;
  lane_kernels<octree::tanglecube> tanglecube;
  lane_kernels<octree::holesrot> holesrot;
  lane_kernels<octree::asterisk<3, 4>> asterisk_3_4;
  lane_kernels<octree::asterisk<9, 18>> asterisk_9_18;
};

GRAZE_DECLARE_ON_PATHS(lane_tables, lanes);

} // namespace graze::octree::detail
