// The walk through a voxel set, compiled for each path.
#include "narrow.hpp"
#include "registers.hpp"
#include <graze/batch/per_path.hpp>

namespace graze::octree::detail {
using batch::this_path;
constinit const voxel_rays_table GRAZE_ON_PATH(voxel_rays){start<this_path, node_test<this_path>>,
                                                           fill<this_path, node_test<this_path>>,
                                                           count<this_path, node_test<this_path>>};
} // namespace graze::octree::detail
