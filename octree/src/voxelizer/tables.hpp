#pragma once
/// The voxelizer's kernels of the four surfaces: constants, so that nothing of a path's file runs
/// before a path has been chosen.
#include <graze/octree/voxelizer_kernels.hpp>

namespace graze::octree::detail {

struct voxelizer_tables {
  voxelizer_kernels<octree::spheres> spheres;
  voxelizer_kernels<octree::quartdef> quartdef;
  voxelizer_kernels<octree::tanglecube> tanglecube;
  voxelizer_kernels<octree::holesrot> holesrot;
};

extern const voxelizer_tables baseline_voxelizer;
#if defined(__x86_64__)
extern const voxelizer_tables avx2_voxelizer, avx512_voxelizer;
#endif

} // namespace graze::octree::detail
