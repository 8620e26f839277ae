#pragma once
/// The walk, written once over what opens a node: a class N of a path, made from a started state,
/// with
///   void open(lo, size)      tests a node's 64 octants
///   mask()                   bit x + 4 y + 16 z: the ray, or its segment, may touch that octant
///   enter, leave             of its slabs, [4 axis + slab], after keep()
/// Everything here has internal linkage: each path's file is compiled with flags of its own.
#include <cmath>
#include <graze/batch/path.hpp>
#include <graze/octree/scaled_direction.hpp>
#include <graze/octree/voxel.hpp>
#include <graze/octree/voxel_rays_state.hpp>
#include <limits>

namespace graze::octree::detail {
namespace {

/// The scaled time's constants (ray_bounds.hpp), for each axis: the products of the two other
/// components' magnitudes, rounded down and up; lane 3 holds the product of all three.
template <class P> GRAZE_BATCH_INLINE void products(const double* d, double* down, double* up) {
  alignas(64) double m[3], x[8], y[8];
  for (unsigned a = 0; a < 3; ++a)
    m[a] = d[a] == 0 ? 1 : (d[a] < 0 ? -d[a] : d[a]);
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
GRAZE_BATCH_INLINE void scaled(double c_down, double c_up, double m, double of_parameter, double t,
                               double& down, double& up) {
  alignas(64) double x[8];
  P::store(x, P::mul_down(P::mul_down(P::broadcast(c_down), P::broadcast(m)),
                          P::mul_down(P::broadcast(t), P::broadcast(of_parameter))));
  down = x[0];
  P::store(x, P::mul_up(P::mul_up(P::broadcast(c_up), P::broadcast(m)),
                        P::mul_up(P::broadcast(t), P::broadcast(of_parameter))));
  up = x[0];
}

/// Scales a direction that is not ordinary; returns the factor of the ray's parameter.
[[gnu::noinline, gnu::cold]] double scale(double* direction) {
  const scaling factors = scaling_of(direction[0], direction[1], direction[2]);
  for (unsigned a = 0; a < 3; ++a)
    direction[a] *= factors.of_direction;
  return factors.of_parameter;
}

template <class P> GRAZE_BATCH_INLINE void start_within_scope(voxel_rays_state& s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double direction[3] = {s.direction[0], s.direction[1], s.direction[2]}, down[3], up[3];
  double of_parameter = 1;
  if (!is_ordinary(direction[0], direction[1], direction[2])) [[unlikely]]
    of_parameter = scale(direction);
  products<P>(direction, down, up);
  double greatest = 0;     // magnitude of any scaled time that decides
  double least = infinity; // constant
  s.flip = 0;
  for (unsigned a = 0; a < 3; ++a) {
    voxel_rays_axis& x = s.axes[a];
    const double o = s.origin[a], d = direction[a], lo = s.root_lo[a], hi = lo + s.root_size;
    x.sign = 1;
    x.enter_origin = x.leave_origin = o;
    if (d == 0) {
      // With an infinite constant an arrival is infinite, of the difference's sign; at o itself it
      // is NaN, which the clipping to the segment turns to no bound. In `owned` the ray has left
      // where p <= o, that is, where p lies before the next number; but the root's far face is
      // closed.
      x.c_down = x.c_up = infinity;
      if (s.owned && o != hi)
        x.leave_origin =
            o < 0 || o > 0
                ? __builtin_bit_cast(double, __builtin_bit_cast(std::int64_t, o) + (o > 0 ? 1 : -1))
                : 0x1p-1074;
      continue;
    }
    x.c_down = down[a];
    x.c_up = up[a];
    if (d < 0) {
      x.sign = -1;
      x.enter_origin = x.leave_origin = -o;
      s.flip |= 3u << (2 * a);
    }
    const double to_lo = lo < o ? o - lo : lo - o, to_hi = hi < o ? o - hi : hi - o;
    const double far = (to_lo < to_hi ? to_hi : to_lo) * up[a];
    greatest = far > greatest ? far : greatest;
    least = down[a] < least ? down[a] : least;
  }
  s.from = 0;
  s.to = infinity;
  if (s.first > 0 || s.last < infinity) {
    const double m = direction[0] == 0 ? 1 : (direction[0] < 0 ? -direction[0] : direction[0]);
    double down_of, up_of;
    if (s.first > 0) {
      scaled<P>(down[0], up[0], m, of_parameter, s.first, s.from, up_of);
      greatest = up_of > greatest ? up_of : greatest;
    }
    if (s.last == 0) {
      s.to = 0;
    } else if (s.last < infinity) {
      scaled<P>(down[0], up[0], m, of_parameter, s.last, down_of, s.to);
      greatest = s.to > greatest ? s.to : greatest;
    }
    least = down[0] < least ? down[0] : least;
    least = down[0] * m < least ? down[0] * m : least;
  }
  // Each bound is off by three roundings, 2^-50 of it at most, where nothing underflows but the
  // last product; two bounds make an overlap. 2^-46 of the greatest leaves room for the rounding of
  // this number and of the overlap. Where a constant may have lost bits, nothing is certain.
  s.certain = least < 0x1p-900 ? infinity : greatest * 0x1p-46 + 0x1p-1000;

  s.opened = 0;
  s.at = 0;
  s.head[0] = 0;
  s.tail[0] = 1;
  voxel_rays_entry& root = s.entries[0][0];
  for (unsigned a = 0; a < 3; ++a)
    root.lo[a] = s.axes[a].sign * s.root_lo[a];
  root.packed = 0;
  root.node = 0;
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
  const double size = s.sizes[d];
  const unsigned shift = s.shift[d];
  voxel_rays_entry* const out = s.entries[d + 1];
  for (; head != end && tail + 64 <= limit; ++head) {
    const voxel_rays_entry& e = s.entries[d][head];
    const std::uint64_t occupied = s.masks[e.node];
    const std::uint32_t first = s.firsts[e.node];
    test.open(e.lo, size);
    std::uint64_t m = reversed(test.mask() & occupied, s.flip);
    const double x = e.lo[0], y = e.lo[1], z = e.lo[2];
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
        c.lo[0] = x + at.x[octant & 3] * size;
        c.lo[1] = y + at.y[octant >> 2 & 3] * size;
        c.lo[2] = z + at.z[octant >> 4] * size;
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
  const double size = s.sizes[d];
  for (; head != end && (Count || found + 64 <= capacity); ++head) {
    const voxel_rays_entry& e = s.entries[d][head];
    const std::uint64_t occupied = s.masks[e.node];
    test.open(e.lo, size);
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

template <class P, class N> void start(voxel_rays_state& s) {
  const typename P::scope scope;
  start_within_scope<P>(s);
}
template <class P, class N>
std::size_t fill(voxel_rays_state& s, voxel* out, std::size_t capacity) {
  const typename P::scope scope;
  return s.exact ? walk<true, false, N>(s, out, capacity) : walk<false, false, N>(s, out, capacity);
}
template <class P, class N> std::uint32_t count(voxel_rays_state& s) {
  const typename P::scope scope;
  start_within_scope<P>(s);
  return static_cast<std::uint32_t>(s.exact ? walk<true, true, N>(s, nullptr, 0)
                                            : walk<false, true, N>(s, nullptr, 0));
}

} // namespace
} // namespace graze::octree::detail
