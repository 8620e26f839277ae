#pragma once
/// The sound ray/octant test. One definition a line, over any Backend and its number: these names
/// are the ones that the proofs use.
///
/// Multiplying the ray's parameter t by |dx||dy||dz| (zero components counted as 1) turns "reaches
/// the plane x = p" into Cx (p - ox), a product without a division: the paper's section 2.4. The
/// paper rounds Cx once; here it is rounded both ways and each bound takes the side that keeps it a
/// bound.
#include <algorithm>
#include <array>
#include <graze/octree/cube.hpp>
#include <graze/octree/ray.hpp>
#include <graze/rounding/backend.hpp>
#include <limits>

namespace graze::octree {

/// What "touches" means on an axis along which the ray does not move: the closed box, or the
/// half-open one that owns its lower face.
enum class convention { closed, owned };

enum class heading : signed char { backward = -1, across = 0, forward = 1 };

/// One axis of a prepared ray.
template <class Number> struct axis_bounds {
  Number origin;
  Number c_down; ///< Cdn: the product of the other two axes' mag, rounded down
  Number c_up;   ///< Cup: the same, rounded up
  heading direction;
};

template <rounding::Backend B> struct ray_bounds {
  using number = typename B::number;
  using axis = axis_bounds<number>;
  static constexpr number infinity = std::numeric_limits<number>::infinity();

  /// The interval of scaled t in which the ray is within [lo, hi] on one axis.
  struct interval {
    number enter, leave;
  };

  /// mag(x) = x == 0 ? 1 : |x|
  static constexpr number mag(number x) {
    return x == number(0) ? number(1) : (x < number(0) ? -x : x);
  }

  static axis prepare(number o, number d, number other1, number other2) {
    return {o, B::mul_down(mag(other1), mag(other2)), B::mul_up(mag(other1), mag(other2)),
            d < number(0) ? heading::backward
                          : (number(0) < d ? heading::forward : heading::across)};
  }

  /// lowb(p, q) <= C (p - q). The comparison is strict: with <=, Cup = inf would meet u = 0.
  static number lowb(const axis& a, number p, number q) {
    const number u = B::sub_down(p, q);
    return B::mul_down(u < number(0) ? a.c_up : a.c_down, u);
  }
  /// uppb(p, q) >= C (p - q); uppb(p, q) = -lowb(q, p) bit for bit.
  static number uppb(const axis& a, number p, number q) {
    const number u = B::sub_up(p, q);
    return B::mul_up(number(0) < u ? a.c_up : a.c_down, u);
  }

  /// Lower bound of the scaled t at which the ray passes the plane p (of its entry into p's far
  /// side).
  static number enter_at(const axis& a, number p) {
    switch (a.direction) {
    case heading::forward:
      return lowb(a, p, a.origin);
    case heading::backward:
      return lowb(a, a.origin, p);
    default:
      return p <= a.origin ? -infinity : infinity;
    }
  }
  /// Upper bound of the scaled t at which the ray passes the plane p (of its exit from p's near
  /// side).
  template <convention C> static number leave_at(const axis& a, number p) {
    switch (a.direction) {
    case heading::forward:
      return uppb(a, p, a.origin);
    case heading::backward:
      return uppb(a, a.origin, p);
    default:
      return (C == convention::closed ? a.origin <= p : a.origin < p) ? infinity : -infinity;
    }
  }

  /// The plane that the ray enters by is the lower one unless it goes backward.
  template <convention C> static interval within(const axis& a, number lo, number hi) {
    return a.direction == heading::backward ? interval{enter_at(a, hi), leave_at<C>(a, lo)}
                                            : interval{enter_at(a, lo), leave_at<C>(a, hi)};
  }

  /// Only t that are within [lo, hi], if any: both bounds rounded inwards. The same bounds at the
  /// planes as in within(), each in the other's place.
  template <convention C> static interval certainly_within(const axis& a, number lo, number hi) {
    switch (a.direction) {
    case heading::forward:
      return {leave_at<C>(a, lo), enter_at(a, hi)};
    case heading::backward:
      return {leave_at<C>(a, hi), enter_at(a, lo)};
    default:
      return within<C>(a, lo, hi);
    }
  }

  /// The t that are within both.
  static interval common(const interval& x, const interval& y) {
    return {x.enter < y.enter ? y.enter : x.enter, y.leave < x.leave ? y.leave : x.leave};
  }
  /// False only if no t >= 0 is within both.
  static bool passes(const interval& x, const interval& y) {
    const interval both = common(x, y);
    return !((both.leave < both.enter) | (both.leave < number(0)));
  }
  /// False only if no t >= 0 is within all three intervals.
  static bool passes(const interval& x, const interval& y, const interval& z) {
    return passes(common(x, y), z);
  }

  /// The ray/octant test: never false on a box that the ray touches.
  /// Source: DESIGN, "The algorithm"; the paper, section 2.4.
  static bool touches_box(const std::array<axis, 3>& ray, const std::array<number, 3>& lo,
                          const std::array<number, 3>& hi) {
    constexpr auto closed = convention::closed;
    return passes(within<closed>(ray[0], lo[0], hi[0]), within<closed>(ray[1], lo[1], hi[1]),
                  within<closed>(ray[2], lo[2], hi[2]));
  }

  static std::array<axis, 3> prepare(const std::array<number, 3>& o,
                                     const std::array<number, 3>& d) {
    return {prepare(o[0], d[0], d[1], d[2]), prepare(o[1], d[1], d[2], d[0]),
            prepare(o[2], d[2], d[0], d[1])};
  }
};

} // namespace graze::octree
