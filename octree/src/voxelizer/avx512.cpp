// The voxelizer's kernels of the path avx512, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/voxelizer_kernels_of_path.hpp>

namespace graze::octree::detail {
constinit const voxelizer_tables avx512_voxelizer{
    make_voxelizer_kernels<batch::avx512, octree::spheres>(),
    make_voxelizer_kernels<batch::avx512, octree::quartdef>(),
    make_voxelizer_kernels<batch::avx512, octree::tanglecube>(),
    make_voxelizer_kernels<batch::avx512, octree::holesrot>(),
};
} // namespace graze::octree::detail
