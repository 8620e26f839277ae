// Which path's kernels.
#include "tables.hpp"

namespace graze::octree {
namespace {

const detail::lane_tables& tables_of(batch::path p) {
  using namespace detail;
  return GRAZE_ALL_PATHS(lane_tables, lanes).on(p);
}

} // namespace

template <> const lane_kernels<spheres>& lane_kernels_of<spheres>(batch::path p) {
  return tables_of(p).spheres;
}
template <> const lane_kernels<quartdef>& lane_kernels_of<quartdef>(batch::path p) {
  return tables_of(p).quartdef;
}
template <> const lane_kernels<tanglecube>& lane_kernels_of<tanglecube>(batch::path p) {
  return tables_of(p).tanglecube;
}
template <> const lane_kernels<holesrot>& lane_kernels_of<holesrot>(batch::path p) {
  return tables_of(p).holesrot;
}
template <> const lane_kernels<asterisk<3, 4>>& lane_kernels_of<asterisk<3, 4>>(batch::path p) {
  return tables_of(p).asterisk_3_4;
}
template <> const lane_kernels<asterisk<9, 18>>& lane_kernels_of<asterisk<9, 18>>(batch::path p) {
  return tables_of(p).asterisk_9_18;
}

} // namespace graze::octree
