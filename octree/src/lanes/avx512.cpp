// The kernels of the path avx512, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/asterisk_eight.hpp>
#include <graze/octree/lane_kernels_of_path.hpp>

namespace graze::octree::detail {
constinit const lane_tables avx512_lanes{
    make_lane_kernels<batch::avx512, octree::spheres>(),
    make_lane_kernels<batch::avx512, octree::quartdef>(),
    make_lane_kernels<batch::avx512, octree::tanglecube>(),
    make_lane_kernels<batch::avx512, octree::holesrot>(),
    make_lane_kernels<batch::avx512, octree::asterisk<3, 4>>(),
    make_lane_kernels<batch::avx512, octree::asterisk<9, 18>>(),
};
} // namespace graze::octree::detail
