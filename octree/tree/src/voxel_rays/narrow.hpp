#pragma once
/// A node's test on a path whose registers hold one to four doubles: its twelve slabs in turn.
#include "kernels.hpp"

namespace graze::octree::detail {
namespace {

template <class P, class Planes> class narrow_test {
  static_assert(P::width <= 4);

public:
  using planes = Planes;

  GRAZE_BATCH_INLINE explicit narrow_test(const voxel_rays_state& s) : from_(s.from), to_(s.to) {
    for (unsigned k = 0; k < 12; ++k) {
      const voxel_rays_axis& a = s.axes[k / 4];
      const bool forward = a.sign > 0;
      if constexpr (Planes::tabled) {
        enter_steps_[k] = a.sign;
      } else {
        enter_steps_[k] = a.sign * (k % 4 + (forward ? 0 : 1));
        leave_steps_[k] = a.sign * (k % 4 + (forward ? 1 : 0));
      }
      enter_origin_[k] = a.enter_origin;
      leave_origin_[k] = a.leave_origin;
      c_down_[k] = a.c_down;
      c_up_[k] = a.c_up;
    }
  }

  GRAZE_BATCH_INLINE void open(const voxel_rays_entry& entry, const typename Planes::level& at) {
    const V zero = P::zero(), from = P::broadcast(from_), to = P::broadcast(to_);
    for (unsigned k = 0; k < 12; k += P::width) {
      const V down = P::load(c_down_ + k), up = P::load(c_up_ + k);
      V p, q;
      planes_at(entry, at, k, p, q);
      const V u = P::sub_down(p, P::load(enter_origin_ + k));
      const V e = P::select(P::less(u, zero), P::mul_down(up, u), P::mul_down(down, u));
      P::store(enter_ + k, P::max_or_second(e, from));
      const V v = P::sub_up(q, P::load(leave_origin_ + k));
      const V l = P::select(P::less(zero, v), P::mul_up(up, v), P::mul_up(down, v));
      P::store(leave_ + k, P::min_or_second(l, to));
    }
  }

  /// Three intervals have a common point if and only if any two have.
  [[nodiscard]] GRAZE_BATCH_INLINE std::uint64_t mask() const {
    static constexpr std::uint16_t four_each[16]{0x0000, 0x000f, 0x00f0, 0x00ff, 0x0f00, 0x0f0f,
                                                 0x0ff0, 0x0fff, 0xf000, 0xf00f, 0xf0f0, 0xf0ff,
                                                 0xff00, 0xff0f, 0xfff0, 0xffff};
    const std::uint64_t xy = pairs(0, 4), xz = pairs(0, 8), yz = pairs(4, 8);
    std::uint64_t m = xy * 0x0001'0001'0001'0001;
    std::uint64_t other = 0;
    for (unsigned z = 0; z < 4; ++z)
      other |= ((xz >> (4 * z) & 15) * 0x1111 & four_each[yz >> (4 * z) & 15]) << (16 * z);
    return m & other;
  }

  GRAZE_BATCH_INLINE void keep() {}
  [[nodiscard]] GRAZE_BATCH_INLINE double enter(unsigned k) const { return enter_[k]; }
  [[nodiscard]] GRAZE_BATCH_INLINE double leave(unsigned k) const { return leave_[k]; }

private:
  using V = typename P::vector;

  /// The planes by which slabs k, k + 1, ... are entered and left; exact, in any rounding.
  GRAZE_BATCH_INLINE void planes_at(const voxel_rays_entry& entry, const typename Planes::level& at,
                                    unsigned k, V& enter, V& leave) const {
    const V steps = P::load(enter_steps_ + k);
    if constexpr (Planes::tabled) {
      const std::size_t first = at.first(entry, k / 4) + k % 4;
      enter = P::mul_up(steps, P::load(at.enter[k / 4] + first));
      leave = P::mul_up(steps, P::load(at.leave[k / 4] + first));
    } else {
      const V corner = P::broadcast(entry.lo[k / 4]), h = P::broadcast(at.size);
      enter = P::add_up(corner, P::mul_up(steps, h));
      leave = P::add_up(corner, P::mul_up(P::load(leave_steps_ + k), h));
    }
  }

  /// Bit i + 4 j: slab i of the axis at a and slab j of the axis at b have a common time.
  [[nodiscard]] GRAZE_BATCH_INLINE std::uint64_t pairs(unsigned a, unsigned b) const {
    std::uint64_t m = 0;
    for (unsigned i = 0; i < 4; i += P::width) {
      const V e = P::load(enter_ + a + i), l = P::load(leave_ + a + i);
      for (unsigned j = 0; j < 4; ++j)
        m |= std::uint64_t{P::bits(P::both(P::less_equal(e, P::broadcast(leave_[b + j])),
                                           P::less_equal(P::broadcast(enter_[b + j]), l)))}
             << (i + 4 * j);
    }
    return m;
  }

  double from_, to_;
  alignas(32) double enter_steps_[12], leave_steps_[12], enter_origin_[12],
      leave_origin_[12], c_down_[12], c_up_[12], enter_[12], leave_[12];
};

/// The node's test of a path.
template <class P, class Planes> struct node_test_on {
  using type = narrow_test<P, Planes>;
};
template <class P, class Planes> using node_test = typename node_test_on<P, Planes>::type;

} // namespace
} // namespace graze::octree::detail
