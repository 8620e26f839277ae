// Which path's voxelizer kernels.
#include "tables.hpp"

namespace graze::octree {
namespace {

const detail::voxelizer_tables& tables_of(batch::path p) {
  switch (p) {
#if defined(__x86_64__)
  case batch::path::avx512:
    return detail::avx512_voxelizer;
  case batch::path::avx2:
    return detail::avx2_voxelizer;
#endif
  default:
    return detail::baseline_voxelizer;
  }
}

} // namespace

template <> const voxelizer_kernels<spheres>& voxelizer_kernels_of<spheres>(batch::path p) {
  return tables_of(p).spheres;
}
template <> const voxelizer_kernels<quartdef>& voxelizer_kernels_of<quartdef>(batch::path p) {
  return tables_of(p).quartdef;
}
template <> const voxelizer_kernels<tanglecube>& voxelizer_kernels_of<tanglecube>(batch::path p) {
  return tables_of(p).tanglecube;
}
template <> const voxelizer_kernels<holesrot>& voxelizer_kernels_of<holesrot>(batch::path p) {
  return tables_of(p).holesrot;
}

} // namespace graze::octree
