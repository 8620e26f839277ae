#pragma once
/// The sound ray/octant test. One definition a line, over any Backend and its number: these names
/// are the ones that the proofs use.
///
/// Multiplying the ray's parameter t by |dx||dy||dz| (zero components counted as 1) turns "reaches
/// the plane x = p" into Cx (p - ox), a product without a division: the paper's section 2.4. The
/// paper rounds Cx once; here it is rounded both ways and each bound takes the side that keeps it a
/// bound.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <graze/octree/cube.hpp>
#include <graze/octree/ray.hpp>
#include <graze/rounding/backend.hpp>
#if defined(__x86_64__)
#include <graze/rounding/packed.hpp>
#endif
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

#if defined(__x86_64__)
/// Operations on pairs are in hardware, rounded up.
template <class B>
inline constexpr bool rounds_pairs_up =
    requires { requires std::same_as<typename B::pair_operations, rounding::packed::hardware_up>; };
#endif

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
    return B::mul_down(choose(u < number(0), a.c_up, a.c_down), u);
  }
  /// uppb(p, q) >= C (p - q); uppb(p, q) = -lowb(q, p) bit for bit.
  static number uppb(const axis& a, number p, number q) {
    const number u = B::sub_up(p, q);
    return B::mul_up(choose(number(0) < u, a.c_up, a.c_down), u);
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
      return choose(p <= a.origin, -infinity, infinity);
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
      return choose(C == convention::closed ? a.origin <= p : a.origin < p, infinity, -infinity);
    }
  }

  /// Both bounds at the plane p: {enter_at, leave_at}.
  template <convention C> static interval at_plane(const axis& a, number p) {
#if defined(__x86_64__)
    // as -lowb(p, q) = uppb(q, p), both are uppb in one register
    if constexpr (rounds_pairs_up<B>) {
      using namespace rounding::packed;
      if (a.direction != heading::across) [[likely]] {
        const pair from{a.origin, p}, to{p, a.origin};
        const bool forward = a.direction == heading::forward;
        const pair u = hardware_up::sub(forward ? from : to, forward ? to : from);
        const auto positive = (bits)(pair{0, 0} < u);
        const pair bound = hardware_up::mul(select(positive, both(a.c_up), both(a.c_down)), u);
        return interval_of(flip_first(bound));
      }
      // -infinity to enter where p <= o, and to leave where not o <= p (closed), o < p (owned)
      const bits not_above = (bits)(both(p) <= both(a.origin));
      const bits below = (bits)(both(p) < both(a.origin));
      const bits past =
          C == convention::owned ? not_above : (not_above & bits{-1, 0}) | (below & bits{0, -1});
      return interval_of((pair)((bits)both(infinity) ^
                                (past & bits{rounding::packed::sign, rounding::packed::sign})));
    }
#endif
    return {enter_at(a, p), leave_at<C>(a, p)};
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

  /// The part of `whole` beyond the plane, or before it. The side is a coin toss: no branch.
  static interval part(bool beyond, const interval& plane, const interval& whole) {
#if defined(__x86_64__)
    if constexpr (rounds_pairs_up<B>) {
      using namespace rounding::packed;
      alignas(16) static constexpr long long of_plane[2][2]{{0, -1}, {-1, 0}};
      const auto mask = (bits)_mm_load_si128(reinterpret_cast<const __m128i*>(of_plane[beyond]));
      return interval_of(select(mask, pair_of(plane), pair_of(whole)));
    }
#endif
    return {choose(beyond, plane.enter, whole.enter), choose(beyond, whole.leave, plane.leave)};
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
#if defined(__x86_64__)
    if constexpr (rounds_pairs_up<B>) {
      using namespace rounding::packed;
      // NaN as in common()
      const auto all = [&](auto least) { return least(pair_of(z), least(pair_of(y), pair_of(x))); };
      const pair enter = max(all([](pair p, pair q) { return max(p, q); }), pair{0, 0});
      const pair leave = all([](pair p, pair q) { return min(p, q); });
      return !(leave[1] < enter[0]);
    }
#endif
    return passes(common(x, y), z);
  }

  /// The ray/octant test: never false on a box that the ray touches.
  /// Source: docs/definitions.md, "The ray/octant test"; the paper, section 2.4.
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

private:
#if defined(__x86_64__)
  // not std::bit_cast, which gcc 12 gets wrong for vectors
  static rounding::packed::pair pair_of(const interval& t) { return _mm_loadu_pd(&t.enter); }
  static interval interval_of(rounding::packed::pair t) {
    interval r;
    _mm_storeu_pd(&r.enter, t);
    return r;
  }
#endif
};

} // namespace graze::octree
