// The kernels of the built-in surfaces, compiled for each path.
#include "tables.hpp"
#include <graze/octree/asterisk_eight.hpp>
#include <graze/octree/lane_kernels_of_path.hpp>

namespace graze::octree::detail {
using batch::this_path;
constinit const lane_tables GRAZE_ON_PATH(lanes){
    make_lane_kernels<this_path, octree::spheres>(),
    make_lane_kernels<this_path, octree::quartdef>(),
    make_lane_kernels<this_path, octree::tanglecube>(),
    make_lane_kernels<this_path, octree::holesrot>(),
    make_lane_kernels<this_path, octree::asterisk<3, 4>>(),
    make_lane_kernels<this_path, octree::asterisk<9, 18>>(),
};
} // namespace graze::octree::detail
