// The voxelizer's kernels of the path baseline, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/voxelizer_kernels_of_path.hpp>

namespace graze::octree::detail {
constinit const voxelizer_tables baseline_voxelizer{
    make_voxelizer_kernels<batch::baseline, octree::spheres>(),
    make_voxelizer_kernels<batch::baseline, octree::quartdef>(),
    make_voxelizer_kernels<batch::baseline, octree::tanglecube>(),
    make_voxelizer_kernels<batch::baseline, octree::holesrot>(),
};
} // namespace graze::octree::detail
