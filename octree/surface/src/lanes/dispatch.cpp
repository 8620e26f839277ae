// Which path's kernels.
#include "tables.hpp"

namespace graze::octree::detail {

const built_in_kernels& built_in_kernels_of(batch::path p) {
  return GRAZE_ALL_PATHS(built_in_kernels, surface_kernels).on(p);
}

} // namespace graze::octree::detail
