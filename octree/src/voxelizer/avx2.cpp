// The voxelizer's kernels of the path avx2, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/voxelizer_kernels_of_path.hpp>

namespace graze::octree::detail {
constinit const voxelizer_tables avx2_voxelizer{
    make_voxelizer_kernels<batch::avx2, octree::spheres>(),
    make_voxelizer_kernels<batch::avx2, octree::quartdef>(),
    make_voxelizer_kernels<batch::avx2, octree::tanglecube>(),
    make_voxelizer_kernels<batch::avx2, octree::holesrot>(),
};
} // namespace graze::octree::detail
