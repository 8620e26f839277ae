// The path avx2, compiled with its instructions.
#include "lanes.hpp"
#include <graze/batch/avx2.hpp>

namespace graze::octree::detail {
using lanes = batch::avx2;
constinit const voxel_rays_table voxel_rays_avx2{start<lanes, lanes_test<lanes>>,
                                                 fill<lanes, lanes_test<lanes>>,
                                                 count<lanes, lanes_test<lanes>>};
} // namespace graze::octree::detail
