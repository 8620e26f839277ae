#pragma once
/// The kernels of a path, for a file compiled for its instructions, with optimization: functions
/// that are not templates over the path must not be emitted there (see batch/path.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/octree/certified_eight.hpp>
#include <graze/octree/descent_eight.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/voxelizer_eight.hpp>

namespace graze::octree {

template <class Path, Surface F> consteval lane_kernels<F> make_lane_kernels() {
  return {
      [](const F& f, const box& domain, const sparse_octree& octree, int level, const ray& r,
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
      [](const F& f, const box& domain, const ray* rays, std::size_t count, certified_hit* hits,
         std::uint64_t* steps) { certified_hits_eight<Path>(f, domain, rays, count, hits, steps); },
      [](const F& f, const box& domain, const cube& cell) {
        eight_octant<Path> o(cell);
        return eight_judge<Path, F>(f, domain).open(o);
      },
      [](const F& f, const box& domain, const cube& cell) {
        eight_octant<Path> o(cell);
        return eight_judge<Path, F>(f, domain).leaves(o);
      },
      [](const F& f, const box& domain, const cube& cell, int level, int last_level,
         sparse_octree::builder& out) {
        const eight_judge<Path, F> judge(f, domain);
        return detail::voxelization<eight_judge<Path, F>>(judge, last_level, out)
            .node(eight_octant<Path>(cell), level);
      }};
}

} // namespace graze::octree
