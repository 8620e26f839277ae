// The path that needs no instruction but those that every machine of the kind has.
#include "lanes.hpp"
#if defined(__x86_64__)
#include <graze/batch/sse2.hpp>
#else
#include <graze/batch/portable.hpp>
#endif

namespace graze::octree::detail {
#if defined(__x86_64__)
using lanes = batch::sse2;
#else
using lanes = batch::portable;
#endif
constinit const voxel_rays_table voxel_rays_baseline{start<lanes, lanes_test<lanes>>,
                                                     fill<lanes, lanes_test<lanes>>,
                                                     count<lanes, lanes_test<lanes>>};
} // namespace graze::octree::detail
