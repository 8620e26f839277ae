// Which path's kernels run, and what they do not do themselves: set up a walk, decide exactly.
#include <graze/batch/per_path.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/rounding/hardware.hpp>

namespace graze::octree::detail {

const voxel_rays_table& voxel_rays_kernels() {
  return GRAZE_ALL_PATHS(voxel_rays_table, voxel_rays).on(batch::path_in_use());
}

void prepare(voxel_rays_state& s, const voxel_set& set, convention rule, exactness certainty,
             const ray_segment& segment, bool soonest) {
  // sizes may be subnormal
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  s.masks = set.masks();
  s.firsts = set.firsts();
  const cube& root = set.root().root_octant();
  for (unsigned a = 0; a < 3; ++a)
    s.root_lo[a] = root.lo[a];
  s.root_size = root.size;
  s.level = set.level();
  s.depth = static_cast<unsigned>(set.depth());
  for (int d = 0; d < set.depth(); ++d) {
    const int level = set.level() - 2 * (set.depth() - 1 - d);
    s.sizes[d] = std::ldexp(root.size, -level);
    s.shift[d] = static_cast<unsigned char>(set.level() - level);
  }
  s.first = segment.first();
  s.last = segment.last();
  s.owned = rule == convention::owned;
  s.exact = certainty == exactness::exact;
  s.most_queued = soonest ? 64 : voxel_rays_state::queue;
}

bool voxel_rays_meet(const voxel_rays_state& s, std::uint64_t packed) {
  const auto r = ray::make({s.origin[0], s.origin[1], s.origin[2]},
                           {s.direction[0], s.direction[1], s.direction[2]});
  const auto segment = ray_segment::make(s.first, s.last);
  const voxel v{packed, 0};
  const double size = s.sizes[s.depth - 1];
  cube c{{}, size};
  unsigned far = 0;
  for (int a = 0; a < 3; ++a) {
    c.lo[static_cast<unsigned>(a)] = s.root_lo[a] + static_cast<double>(v.index(a)) * size;
    if (v.index(a) + 1 == std::uint32_t{1} << s.level)
      far |= 1u << a;
  }
  const exact_touch touch(*r);
  return s.owned ? segment_meets<convention::owned>(touch, *r, *segment, c, far)
                 : segment_meets<convention::closed>(touch, *r, *segment, c, far);
}

} // namespace graze::octree::detail
