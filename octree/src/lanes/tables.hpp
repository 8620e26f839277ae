#pragma once
/// The kernels of the six surfaces: constants, so that nothing of a path's file runs before a path
/// has been chosen.
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

extern const lane_tables baseline_lanes;
#if defined(__x86_64__)
extern const lane_tables avx2_lanes, avx512_lanes;
#endif

} // namespace graze::octree::detail
