// The kernels of the path baseline, compiled for its instructions.
#include "tables.hpp"
#include <graze/octree/asterisk_eight.hpp>
#include <graze/octree/lane_kernels_of_path.hpp>

namespace graze::octree::detail {
constinit const lane_tables baseline_lanes{
    make_lane_kernels<batch::baseline, octree::spheres>(),
    make_lane_kernels<batch::baseline, octree::quartdef>(),
    make_lane_kernels<batch::baseline, octree::tanglecube>(),
    make_lane_kernels<batch::baseline, octree::holesrot>(),
    make_lane_kernels<batch::baseline, octree::asterisk<3, 4>>(),
    make_lane_kernels<batch::baseline, octree::asterisk<9, 18>>(),
};
} // namespace graze::octree::detail
