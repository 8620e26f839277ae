// The walk through a voxel set, compiled for each path.
#include "narrow.hpp"
#include "registers.hpp"
#include <graze/batch/per_path.hpp>

namespace graze::octree::detail {
using batch::this_path;

namespace {
template <class Planes> using test = node_test<this_path, Planes>;
template <class Planes>
constexpr voxel_rays_walk walk_through{
    begin<this_path, test<Planes>>, fill<this_path, test<Planes>>, count<this_path, test<Planes>>};
} // namespace

constinit const voxel_rays_table GRAZE_ON_PATH(voxel_rays){walk_through<computed_planes>,
                                                           walk_through<tabled_planes>};
} // namespace graze::octree::detail
