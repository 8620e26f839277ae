// Which path's kernels run, and what they do not do themselves: set up a walk, decide exactly.
#include <graze/batch/per_path.hpp>
#include <graze/octree/exact_line.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/rounding/hardware.hpp>

namespace graze::octree::detail {

const voxel_rays_walk& voxel_rays_kernels(const voxel_set& set) {
  const voxel_rays_table& path =
      GRAZE_ALL_PATHS(voxel_rays_table, voxel_rays).on(batch::path_in_use());
  return set.planes() != nullptr ? path.in_grid : path.in_root;
}

void prepare(voxel_rays_state& s, const voxel_set& set, convention rule, exactness certainty,
             const ray_segment& segment, bool soonest) {
  // sizes may be subnormal
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  s.masks = set.masks();
  s.firsts = set.firsts();
  s.planes = set.planes();
  s.level = set.level();
  s.depth = static_cast<unsigned>(set.depth());
  for (int d = 0; d < set.depth(); ++d)
    s.shift[d] = static_cast<unsigned char>(2 * (set.depth() - 1 - d));
  if (s.planes != nullptr) {
    for (unsigned a = 0; a < 3; ++a) {
      const int axis = static_cast<int>(a);
      const std::uint32_t n = s.planes->count(axis);
      s.lo[a] = s.planes->lower(axis, 0);
      s.hi[a] = s.planes->upper(axis, n);
      s.far_plane[a] =
          s.planes->lower(axis, n) == s.hi[a] ? s.hi[a] : std::numeric_limits<double>::quiet_NaN();
      s.plane_width[a] = s.planes->plane_width(axis);
      for (unsigned d = 0; d < s.depth; ++d) {
        s.lower.of_level[d][a] = set.lower_planes(d, a);
        s.upper.of_level[d][a] = set.upper_planes(d, a);
      }
    }
  } else {
    const cube& root = set.root().root_octant();
    for (unsigned a = 0; a < 3; ++a) {
      s.lo[a] = root.lo[a];
      s.far_plane[a] = s.hi[a] = root.hi(static_cast<int>(a));
    }
    s.root_size = root.size;
    for (unsigned d = 0; d < s.depth; ++d)
      s.sizes[d] = std::ldexp(root.size, s.shift[d] - s.level);
  }
  s.between_points = false;
  s.first = segment.first();
  s.last = segment.last();
  s.owned = rule == convention::owned;
  s.exact = certainty == exactness::exact;
  s.most_queued = soonest ? 64 : voxel_rays_state::queue;
}

bool voxel_rays_meet(const voxel_rays_state& s, std::uint64_t packed) {
  const voxel v{packed, 0};
  const vec3 origin{s.origin[0], s.origin[1], s.origin[2]},
      toward{s.direction[0], s.direction[1], s.direction[2]};
  cube c{};
  unsigned far = 0;
  if (s.planes == nullptr) {
    c.size = s.sizes[s.depth - 1];
    for (int a = 0; a < 3; ++a) {
      c.lo[static_cast<unsigned>(a)] = s.lo[a] + static_cast<double>(v.index(a)) * c.size;
      if (v.index(a) + 1 == std::uint32_t{1} << s.level)
        far |= 1u << a;
    }
    if (!s.between_points) {
      const auto r = ray::make(origin, toward);
      const auto segment = ray_segment::make(s.first, s.last);
      const exact_touch touch(*r);
      return s.owned ? segment_meets<convention::owned>(touch, *r, *segment, c, far)
                     : segment_meets<convention::closed>(touch, *r, *segment, c, far);
    }
  }
  const exact_line line = s.between_points ? exact_line(*segment::make(origin, toward))
                                           : exact_line(*ray::make(origin, toward),
                                                        *ray_segment::make(s.first, s.last));
  const slabs cell = s.planes == nullptr ? slabs(closed_box(c), far)
                                         : s.planes->voxel({v.index(0), v.index(1), v.index(2)});
  return s.owned ? line.owns(cell) : line.touches(cell);
}

} // namespace graze::octree::detail
