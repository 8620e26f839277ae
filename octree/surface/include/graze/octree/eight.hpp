#pragma once
/// Formulas of surfaces over eight boxes at once: what interval8 needs beside its own operations.
#include <graze/needs_cxx20.hpp>

#include <graze/interval8.hpp>
#include <graze/octree/formula.hpp>
#include <graze/octree/lanewise.hpp>

namespace graze::octree {

template <class Path> struct constants<interval8<Path>> {
  template <std::int64_t P, std::int64_t Q> static GRAZE_BATCH_INLINE interval8<Path> rational() {
    constexpr rational_bounds value = enclose_rational(P, Q);
    return interval8<Path>(value.lo, value.hi);
  }
  static GRAZE_BATCH_INLINE interval8<Path> exact(double x) { return interval8<Path>(x); }
};

template <class Path> struct lanewise<interval8<Path>> {
  using path = Path;
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE interval8<Path> apply(const Operands&... x) {
    return interval8<Path>::template lanewise<Operation>(x...);
  }
  template <auto Predicate, class... Operands>
  static GRAZE_BATCH_INLINE bool everywhere(const Operands&... x) {
    return interval8<Path>::template lanes_where<Predicate>(x...).all();
  }
};

namespace detail {
/// cube_minus_identity of formula.hpp for the lanes of a register: the same operations, so the same
/// bounds.
template <class P> struct cube_minus_identity_lanes {
  using vector = typename P::vector;
  using mask = typename P::mask;

  /// Bounds of t^3 - t at a double.
  struct value {
    vector down, up;
    GRAZE_BATCH_INLINE explicit value(vector x) {
      const vector one = P::broadcast(1), m = P::abs(x);
      const mask small = P::less(m, one);
      const vector greater = P::select(small, one, m), lesser = P::select(small, m, one);
      const vector least =
          P::mul_down(P::mul_down(m, P::sub_down(greater, lesser)), P::add_down(m, one));
      const vector most = P::mul_up(P::mul_up(m, P::sub_up(greater, lesser)), P::add_up(m, one));
      const mask not_negative =
          P::either(P::less_equal(one, x),
                    P::both(P::less_equal(x, P::zero()), P::less_equal(P::neg(one), x)));
      down = P::select(not_negative, least, P::neg(most));
      up = P::select(not_negative, most, P::neg(least));
    }
  };

  static GRAZE_BATCH_INLINE batch::part<P> range(const batch::part<P>& x) {
    // the turning point 1/sqrt(3) lies between these neighbours; 2/(3 sqrt(3)) rounded up
    const vector turn_down = P::broadcast(0x1.279a74590331cp-1),
                 turn_up = P::broadcast(0x1.279a74590331dp-1),
                 extremum_up = P::broadcast(0x1.8a2345cc04426p-2);
    const vector a = x.lo, b = x.hi;
    const value at_a(a), at_b(b);
    const mask has_maximum =
        P::both(P::less_equal(a, P::neg(turn_down)), P::less_equal(P::neg(turn_up), b));
    const mask has_minimum = P::both(P::less_equal(a, turn_up), P::less_equal(turn_down, b));
    const mask falls = P::both(P::less(P::neg(turn_down), a), P::less(b, turn_up));
    const mask turns = P::either(has_maximum, has_minimum);
    const vector lesser = P::min_or_second(at_a.down, at_b.down),
                 greater = P::max_or_second(at_a.up, at_b.up);
    const vector minimum = P::neg(extremum_up);
    const vector lo = P::select(has_minimum, P::min_or_second(lesser, minimum), lesser);
    const vector hi = P::select(has_maximum, P::max_or_second(greater, extremum_up), greater);
    return {P::select(turns, lo, P::select(falls, at_b.down, at_a.down)),
            P::select(turns, hi, P::select(falls, at_a.up, at_b.up))};
  }
};
} // namespace detail

/// Encloses { t^3 - t : t in x } in each lane, with the scalar function's bounds; empty for empty.
template <class Path> struct cube_minus_identity_of<interval8<Path>> {
  static GRAZE_BATCH_INLINE interval8<Path> value(const interval8<Path>& x) {
    return interval8<Path>::template lanewise<&detail::cube_minus_identity_lanes<Path>::range>(x);
  }
};

} // namespace graze::octree
