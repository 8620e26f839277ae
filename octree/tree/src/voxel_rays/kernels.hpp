#pragma once
/// The walk, written once over what opens a node: a class N of a path, made from a started state,
/// with
///   planes                   where a node's planes come from (planes.hpp)
///   void open(entry, level)  tests a node's 64 octants
///   mask()                   bit x + 4 y + 16 z: the ray, or its segment, may touch that octant
///   enter, leave             of its slabs, [4 axis + slab], after keep()
/// Everything here has internal linkage: each path's file is compiled with flags of its own.
#include "planes.hpp"
#include <cmath>
#include <graze/batch/path.hpp>
#include <graze/octree/scaled_direction.hpp>
#include <graze/octree/voxel.hpp>
#include <graze/octree/voxel_rays_state.hpp>
#include <limits>

namespace graze::octree::detail {
namespace {

/// |d| of each axis, between bounds; 1 on an axis along which the ray does not move.
struct speeds {
  double down[3], up[3];
  double of_parameter; ///< what the ray's t is to be multiplied by: d was divided by it
};

/// The scaled time's constants (ray_bounds.hpp), for each axis: the products of the two other
/// components' magnitudes, rounded down and up.
template <class P> GRAZE_BATCH_INLINE void products(const double* m, double* down, double* up) {
  alignas(64) double x[8], y[8];
  for (unsigned i = 0; i < 8; ++i) {
    x[i] = m[(i + 1) % 3];
    y[i] = m[(i + 2) % 3];
  }
  alignas(64) double lo[8], hi[8];
  for (unsigned i = 0; i < (P::width < 4 ? 4 : P::width); i += P::width) {
    P::store(lo + i, P::mul_down(P::load(x + i), P::load(y + i)));
    P::store(hi + i, P::mul_up(P::load(x + i), P::load(y + i)));
  }
  for (unsigned a = 0; a < 3; ++a) {
    down[a] = lo[a];
    up[a] = hi[a];
  }
}

/// RD(RD(c0 m) RD(t of_parameter)), and the same with RU: t scaled.
template <class P>
GRAZE_BATCH_INLINE void scaled(double c_down, double c_up, double m_down, double m_up,
                               double of_parameter, double t, double& down, double& up) {
  alignas(64) double x[8];
  const auto parameter = P::broadcast(of_parameter);
  P::store(x, P::mul_down(P::mul_down(P::broadcast(c_down), P::broadcast(m_down)),
                          P::mul_down(P::broadcast(t), parameter)));
  down = x[0];
  P::store(x, P::mul_up(P::mul_up(P::broadcast(c_up), P::broadcast(m_up)),
                        P::mul_up(P::broadcast(t), parameter)));
  up = x[0];
}

/// Scales a direction that is not ordinary; returns the factor of the ray's parameter.
[[gnu::noinline, gnu::cold]] double scale(double* direction) {
  const scaling factors = scaling_of(direction[0], direction[1], direction[2]);
  for (unsigned a = 0; a < 3; ++a)
    direction[a] *= factors.of_direction;
  return factors.of_parameter;
}

/// factor (to - from), of the one sign that it has, between bounds.
template <class P>
GRAZE_BATCH_INLINE void difference(double from, double to, double factor, double& down,
                                   double& up) {
  alignas(64) double x[8];
  const auto f = P::broadcast(factor), p = P::broadcast(from), q = P::broadcast(to);
  P::store(x, P::sub_down(P::mul_down(q, f), P::mul_up(p, f)));
  const double least = x[0];
  P::store(x, P::sub_up(P::mul_up(q, f), P::mul_down(p, f)));
  down = to < from ? -x[0] : least;
  up = to < from ? -least : x[0];
}

/// The difference of two points times a power of two, where it is not ordinary, or beyond the
/// doubles.
template <class P>
[[gnu::noinline, gnu::cold]] void scale_difference(voxel_rays_state& s, speeds& m) {
  double factor = 1;
  for (unsigned a = 0; a < 3; ++a)
    if (!(m.up[a] <= 0x1p1022))
      factor = 0.25;
  double size[3];
  for (unsigned a = 0; a < 3; ++a) {
    difference<P>(s.origin[a], s.direction[a], factor, m.down[a], m.up[a]);
    size[a] = m.up[a];
  }
  const scaling factors = scaling_of(size[0], size[1], size[2]);
  for (unsigned a = 0; a < 3; ++a) {
    alignas(64) double x[8];
    const auto by = P::broadcast(factors.of_direction);
    P::store(x, P::mul_down(P::broadcast(m.down[a]), by));
    m.down[a] = x[0];
    P::store(x, P::mul_up(P::broadcast(m.up[a]), by));
    m.up[a] = x[0];
  }
  m.of_parameter = factors.of_parameter / factor;
}

/// |d|, or 1 on an axis along which the ray does not move.
GRAZE_BATCH_INLINE double magnitude(double d) { return d == 0 ? 1 : (d < 0 ? -d : d); }

/// The same of the difference of two points, and numbers of its signs.
template <class P>
GRAZE_BATCH_INLINE speeds speeds_between(voxel_rays_state& s, double* direction) {
  speeds m;
  m.of_parameter = 1;
  for (unsigned a = 0; a < 3; ++a)
    difference<P>(s.origin[a], s.direction[a], 1, m.down[a], m.up[a]);
  if (!is_ordinary(m.up[0], m.up[1], m.up[2]))
    scale_difference<P>(s, m);
  for (unsigned a = 0; a < 3; ++a) {
    const double from = s.origin[a], to = s.direction[a];
    direction[a] = to < from ? -1 : (from < to ? 1 : 0);
    if (direction[a] == 0)
      m.down[a] = m.up[a] = 1;
  }
  return m;
}

template <class P, class Planes, bool BetweenPoints>
GRAZE_BATCH_INLINE void start_line(voxel_rays_state& s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double direction[3] = {s.direction[0], s.direction[1], s.direction[2]}, down[3], up[3];
  double of_parameter = 1;
  [[maybe_unused]] speeds between;
  if constexpr (BetweenPoints) {
    between = speeds_between<P>(s, direction);
    of_parameter = between.of_parameter;
    double unused[3];
    products<P>(between.down, down, unused);
    products<P>(between.up, unused, up);
  } else {
    if (!is_ordinary(direction[0], direction[1], direction[2])) [[unlikely]]
      of_parameter = scale(direction);
    double m[3];
    for (unsigned a = 0; a < 3; ++a)
      m[a] = magnitude(direction[a]);
    products<P>(m, down, up);
  }
  double greatest = 0;     // magnitude of any scaled time that decides
  double least = infinity; // constant
  double blurred = 0;      // what planes that are no doubles add
  s.flip = 0;
  for (unsigned a = 0; a < 3; ++a) {
    voxel_rays_axis& x = s.axes[a];
    const double o = s.origin[a], d = direction[a], lo = s.lo[a], hi = s.hi[a];
    Planes::choose(s, a, d);
    if (d == 0) {
      x.sign = 1;
      x.enter_origin = x.leave_origin = o;
      // With an infinite constant an arrival is infinite, of the difference's sign; at o itself it
      // is NaN, which the clipping to the segment turns to no bound. In `owned` the ray has left
      // where p <= o, that is, where p lies before the next number; but the root's far face is
      // closed.
      x.c_down = x.c_up = infinity;
      if (s.owned && o != s.far_plane[a])
        x.leave_origin =
            o < 0 || o > 0
                ? __builtin_bit_cast(double, __builtin_bit_cast(std::int64_t, o) + (o > 0 ? 1 : -1))
                : 0x1p-1074;
      continue;
    }
    x.c_down = down[a];
    x.c_up = up[a];
    // by integers: a jump on the direction's sign is mispredicted half of the time
    const std::uint64_t back = __builtin_bit_cast(std::uint64_t, d) & std::uint64_t{1} << 63;
    x.sign = __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, 1.0) | back);
    x.enter_origin = x.leave_origin =
        __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, o) ^ back);
    s.flip |= static_cast<unsigned>(back >> 63) * 3u << (2 * a);
    // the greatest of the differences, not a magnitude: upward, lo - o may be the least double where it
    // overflows, and o - lo is then infinite
    const double to_lo = o - lo < lo - o ? lo - o : o - lo,
                 to_hi = o - hi < hi - o ? hi - o : o - hi;
    const double reach = to_lo < to_hi ? to_hi : to_lo;
    const double far = reach <= 0x1p1023 ? reach * up[a] : infinity; // else a bound may overflow
    greatest = far > greatest ? far : greatest;
    if constexpr (Planes::tabled) {
      const double blur = s.plane_width[a] * up[a];
      blurred = blur > blurred ? blur : blurred;
    }
    least = down[a] < least ? down[a] : least;
  }
  s.from = 0;
  s.to = infinity;
  if (s.first > 0 || s.last < infinity) {
    const double m_down = BetweenPoints ? between.down[0] : magnitude(direction[0]),
                 m_up = BetweenPoints ? between.up[0] : m_down;
    double down_of, up_of;
    if (s.first > 0) {
      scaled<P>(down[0], up[0], m_down, m_up, of_parameter, s.first, s.from, up_of);
      greatest = up_of > greatest ? up_of : greatest;
    }
    if (s.last == 0) {
      s.to = 0;
    } else if (s.last < infinity) {
      scaled<P>(down[0], up[0], m_down, m_up, of_parameter, s.last, down_of, s.to);
      greatest = s.to > greatest ? s.to : greatest;
    }
    least = down[0] < least ? down[0] : least;
    least = down[0] * m_down < least ? down[0] * m_down : least;
  }
  // Each bound is off by three roundings, by five where the direction is a difference of points:
  // 2^-49 of it at most, where nothing underflows but the last product; and by what its plane is
  // off. Two bounds make an overlap. 2^-46 of the greatest, and twice what two planes add, leave
  // room for the rounding of this number and of the overlap. Where a constant may have lost bits, or
  // a bound may be infinite, nothing is certain.
  s.certain = least < 0x1p-900 || !(greatest <= 0x1p1023)
                  ? infinity
                  : greatest * 0x1p-46 + blurred * 4 + 0x1p-1000;

  s.opened = 0;
  s.at = 0;
  s.head[0] = 0;
  s.tail[0] = 1;
  voxel_rays_entry& root = s.entries[0][0];
  if constexpr (!Planes::tabled)
    for (unsigned a = 0; a < 3; ++a)
      root.lo[a] = s.axes[a].sign * s.lo[a];
  root.packed = 0;
  root.node = 0;
}

template <class P, class Planes> GRAZE_BATCH_INLINE void start_within_scope(voxel_rays_state& s) {
  if (s.between_points) [[unlikely]]
    start_line<P, Planes, true>(s);
  else
    start_line<P, Planes, false>(s);
}

/// Each axis of `flip` reversed: bit i of the result is bit i ^ flip of m.
GRAZE_BATCH_INLINE std::uint64_t reversed(std::uint64_t m, unsigned flip) {
  constexpr std::uint64_t x1 = 0x5555'5555'5555'5555, x2 = 0x3333'3333'3333'3333,
                          y1 = 0x0f0f'0f0f'0f0f'0f0f, y2 = 0x00ff'00ff'00ff'00ff,
                          z1 = 0x0000'ffff'0000'ffff;
  if ((flip & 1) != 0) {
    m = (m >> 1 & x1) | (m & x1) << 1;
    m = (m >> 2 & x2) | (m & x2) << 2;
  }
  if ((flip & 4) != 0) {
    m = (m >> 4 & y1) | (m & y1) << 4;
    m = (m >> 8 & y2) | (m & y2) << 8;
  }
  if ((flip & 16) != 0) {
    m = (m >> 16 & z1) | (m & z1) << 16;
    m = m >> 32 | m << 32;
  }
  return m;
}

GRAZE_BATCH_INLINE std::uint64_t packed_of(unsigned octant) {
  return (octant & 3) | std::uint64_t{octant >> 2 & 3} << 21 | std::uint64_t{octant >> 4} << 42;
}

/// Where each axis's sign is applied to an octant's index in its node.
struct corner {
  double x[4], y[4], z[4];
  GRAZE_BATCH_INLINE explicit corner(const voxel_rays_state& s) {
    for (int i = 0; i < 4; ++i) {
      x[i] = s.axes[0].sign * i;
      y[i] = s.axes[1].sign * i;
      z[i] = s.axes[2].sign * i;
    }
  }
};

/// Queues the octants of a node that the ray may touch.
template <class N>
GRAZE_BATCH_INLINE void open_inner(voxel_rays_state& s, N& test, const corner& at, unsigned d,
                                   unsigned limit) {
  unsigned head = s.head[d], tail = 0;
  const unsigned end = s.tail[d];
  const typename N::planes::level level(s, d);
  const unsigned shift = s.shift[d];
  voxel_rays_entry* const out = s.entries[d + 1];
  for (; head != end && tail + 64 <= limit; ++head) {
    const voxel_rays_entry& e = s.entries[d][head];
    const std::uint64_t occupied = s.masks[e.node];
    const std::uint32_t first = s.firsts[e.node];
    test.open(e, level);
    std::uint64_t m = reversed(test.mask() & occupied, s.flip);
    [[maybe_unused]] const double x = e.lo[0], y = e.lo[1], z = e.lo[2];
    const std::uint64_t packed = e.packed;
    const unsigned count = static_cast<unsigned>(__builtin_popcountll(m));
    // Four at a time, wanted or not: what lies past the tail is overwritten, and the number of
    // octants seldom decides a jump.
    for (unsigned k = 0; k < count; k += 4) {
      for (unsigned j = k; j < k + 4; ++j) {
        const unsigned octant =
            (static_cast<unsigned>(__builtin_ctzll(m | std::uint64_t{1} << 63)) ^ s.flip);
        m &= m - 1;
        voxel_rays_entry& c = out[tail + j];
        if constexpr (!N::planes::tabled) {
          c.lo[0] = x + at.x[octant & 3] * level.size;
          c.lo[1] = y + at.y[octant >> 2 & 3] * level.size;
          c.lo[2] = z + at.z[octant >> 4] * level.size;
        }
        c.packed = packed + (packed_of(octant) << shift);
        c.node = first + static_cast<unsigned>(
                             __builtin_popcountll(occupied & ((std::uint64_t{1} << octant) - 1)));
        __builtin_prefetch(s.masks + c.node);
      }
    }
    tail += count;
    ++s.opened;
  }
  s.head[d] = head;
  s.head[d + 1] = 0;
  s.tail[d + 1] = tail;
}

/// Reports the voxels of the last queue, or counts them where `out` is null.
template <bool Exact, bool Count, class N>
GRAZE_BATCH_INLINE std::size_t open_last(voxel_rays_state& s, N& test, unsigned d, voxel* out,
                                         std::size_t found, std::size_t capacity) {
  unsigned head = s.head[d];
  const unsigned end = s.tail[d];
  const typename N::planes::level level(s, d);
  for (; head != end && (Count || found + 64 <= capacity); ++head) {
    const voxel_rays_entry& e = s.entries[d][head];
    const std::uint64_t occupied = s.masks[e.node];
    test.open(e, level);
    std::uint64_t m = test.mask() & occupied;
    ++s.opened;
    if (Count && !Exact) {
      found += static_cast<unsigned>(__builtin_popcountll(m));
      continue;
    }
    if (m == 0)
      continue;
    if constexpr (Exact)
      test.keep();
    if constexpr (!Count)
      m = reversed(m, s.flip);
    const std::uint32_t first = Count ? 0 : s.firsts[e.node];
    do {
      const unsigned octant = static_cast<unsigned>(__builtin_ctzll(m)) ^ (Count ? 0 : s.flip);
      m &= m - 1;
      const std::uint64_t packed = e.packed + packed_of(octant);
      if constexpr (Exact) {
        const double ex = test.enter(octant & 3), ey = test.enter(4 + (octant >> 2 & 3)),
                     ez = test.enter(8 + (octant >> 4));
        const double lx = test.leave(octant & 3), ly = test.leave(4 + (octant >> 2 & 3)),
                     lz = test.leave(8 + (octant >> 4));
        const double exy = ex < ey ? ey : ex, lxy = ly < lx ? ly : lx;
        const double overlap = (lz < lxy ? lz : lxy) - (exy < ez ? ez : exy);
        // not by a jump over nothing: NaN and an infinite `certain` go to the exact test
        if (!(overlap > s.certain)) [[unlikely]]
          if (!voxel_rays_meet(s, packed))
            continue;
      }
      if constexpr (!Count)
        out[found] = {packed, first + static_cast<std::uint32_t>(__builtin_popcountll(
                                          occupied & ((std::uint64_t{1} << octant) - 1)))};
      ++found;
    } while (m != 0);
  }
  s.head[d] = head;
  return found;
}

template <bool Exact, bool Count, class N>
GRAZE_BATCH_INLINE std::size_t walk(voxel_rays_state& s, voxel* out, std::size_t capacity) {
  N test(s);
  const corner at(s);
  const unsigned last = s.depth - 1, limit = s.most_queued;
  std::size_t found = 0;
  unsigned d = s.at;
  for (;;) {
    if (s.head[d] == s.tail[d]) {
      if (d == 0)
        break;
      --d;
    } else if (d == last) {
      found = open_last<Exact, Count>(s, test, d, out, found, capacity);
      if (s.head[d] != s.tail[d] || (!Count && found + 64 > capacity))
        break; // full
    } else {
      open_inner(s, test, at, d, limit);
      ++d;
    }
  }
  s.at = d;
  return found;
}

template <class P, class N>
std::size_t begin(voxel_rays_state& s, voxel* out, std::size_t capacity) {
  const typename P::scope scope;
  start_within_scope<P, typename N::planes>(s);
  return s.exact ? walk<true, false, N>(s, out, capacity) : walk<false, false, N>(s, out, capacity);
}
template <class P, class N>
std::size_t fill(voxel_rays_state& s, voxel* out, std::size_t capacity) {
  const typename P::scope scope;
  return s.exact ? walk<true, false, N>(s, out, capacity) : walk<false, false, N>(s, out, capacity);
}
template <class P, class N> std::uint32_t count(voxel_rays_state& s) {
  const typename P::scope scope;
  start_within_scope<P, typename N::planes>(s);
  return static_cast<std::uint32_t>(s.exact ? walk<true, true, N>(s, nullptr, 0)
                                            : walk<false, true, N>(s, nullptr, 0));
}

} // namespace
} // namespace graze::octree::detail
