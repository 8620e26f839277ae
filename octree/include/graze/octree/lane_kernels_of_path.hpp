#pragma once
/// The kernels of a path, for a file compiled for its instructions, with optimization: functions
/// that are not templates over the path must not be emitted there (see batch/path.hpp).
#include <graze/octree/descent_eight.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/voxelizer_eight.hpp>

namespace graze::octree {

template <class Path, Surface F> consteval lane_kernels<F> make_lane_kernels() {
  return {[](const F& f, const box& domain, const sparse_octree& octree, int level, const ray& r,
             traversal_counts* counts) {
            using method = sound_eight<Path, convention::owned>;
            return surface_traversal<F, method, backend_beside<Path>>::accepted(f, domain, octree,
                                                                                level)
                .first_hit(r, counts);
          },
          [](const F& f, const box& domain, const sparse_octree& octree, int level, const ray* rays,
             std::size_t count, surface_hit* hits, traversal_counts* counts) {
            first_hits_eight<Path>(f, domain, octree, level, rays, count, hits, counts);
          },
          [](const F& f, const box& domain, const cube& root, int level, sparse_octree::room& out) {
            const typename backend_beside<Path>::scope scope;
            return detail::voxelization_eight<Path, F>(f, domain, level, out).whole(root);
          }};
}

} // namespace graze::octree
