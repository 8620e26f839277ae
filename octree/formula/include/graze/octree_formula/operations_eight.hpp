#pragma once
/// What a tape asks of eight intervals at once. For files compiled for the path's instructions. The
/// bounds are the scalar type's. Arithmetic, powers and polynomials are done in the lanes; of the
/// elementary functions each lane asks the library, unless a lane before it had the same operands,
/// as of an octant's children half have on each axis.
#include <graze/octree/eight.hpp>
#include <graze/octree_formula/evaluate.hpp>

namespace graze::octree::tape {

namespace detail {

/// Bounds of eight intervals.
struct eight_bounds {
  alignas(64) double lo[8], hi[8];
  template <class Path> GRAZE_BATCH_INLINE explicit eight_bounds(const interval8<Path>& x) {
    x.store(lo, hi);
  }
  GRAZE_BATCH_INLINE bounds lane(unsigned i) const { return {lo[i], hi[i]}; }
  GRAZE_BATCH_INLINE bool same(unsigned i, unsigned j) const {
    return lo[i] == lo[j] && hi[i] == hi[j]; // not so of empty ones
  }
};

/// The operations on the lanes of one register that interval8 lacks.
template <class P> struct tape_lanes {
  using vector = typename P::vector;
  using mask = typename P::mask;
  using part = batch::part<P>;

  static GRAZE_BATCH_INLINE part lower_end(const part& x) { return {x.lo, x.lo}; }
  static GRAZE_BATCH_INLINE part upper_end(const part& x) { return {x.hi, x.hi}; }
  /// The range from the values at both ends; entire where x is unbounded, empty where it is empty.
  static GRAZE_BATCH_INLINE part between(const part& x, const part& first, const part& last) {
    const vector infinity = P::broadcast(checking::infinity);
    const mask bounded = P::both(P::less(P::neg(infinity), x.lo), P::less(x.hi, infinity));
    const vector lo = P::select(bounded, P::min_or_second(first.lo, last.lo), P::neg(infinity));
    const vector hi = P::select(bounded, P::max_or_second(first.hi, last.hi), infinity);
    const mask is_empty = P::either_nan(x.lo, x.hi);
    return {P::select(is_empty, x.lo, lo), P::select(is_empty, x.lo, hi)};
  }
  /// r, with the values in a turn where x meets it.
  static GRAZE_BATCH_INLINE part turned(const part& x, const part& r, const part& turn,
                                        const part& values) {
    const mask meets = P::both(P::less_equal(x.lo, turn.hi), P::less_equal(turn.lo, x.hi));
    return {P::select(meets, P::min_or_second(r.lo, values.lo), r.lo),
            P::select(meets, P::max_or_second(r.hi, values.hi), r.hi)};
  }
  static GRAZE_BATCH_INLINE part known(const part& slope) {
    const mask is_empty = P::either_nan(slope.lo, slope.hi);
    const vector infinity = P::broadcast(checking::infinity);
    return {P::select(is_empty, P::neg(infinity), slope.lo),
            P::select(is_empty, infinity, slope.hi)};
  }
  static GRAZE_BATCH_INLINE part within_one(const part& slope) {
    const mask is_empty = P::either_nan(slope.lo, slope.hi);
    const vector one = P::broadcast(1), minus = P::broadcast(-1);
    return {P::select(is_empty, minus, P::min_or_second(P::max_or_second(slope.lo, minus), one)),
            P::select(is_empty, one, P::min_or_second(P::max_or_second(slope.hi, minus), one))};
  }
  static GRAZE_BATCH_INLINE part abs_slope(const part& x) {
    const vector zero = P::zero(), one = P::broadcast(1), minus = P::broadcast(-1);
    const mask up = P::less_equal(zero, x.lo), down = P::less_equal(x.hi, zero);
    return {P::select(up, P::select(down, minus, one), minus),
            P::select(down, P::select(up, one, minus), one)};
  }
  static GRAZE_BATCH_INLINE part of_lesser(const part& a, const part& b, const part& if_a,
                                           const part& if_b) {
    const mask is_a = P::less_equal(a.hi, b.lo), is_b = P::less_equal(b.hi, a.lo);
    const vector lo = P::min_or_second(if_b.lo, if_a.lo), hi = P::max_or_second(if_b.hi, if_a.hi);
    return {P::select(is_a, if_a.lo, P::select(is_b, if_b.lo, lo)),
            P::select(is_a, if_a.hi, P::select(is_b, if_b.hi, hi))};
  }
  static GRAZE_BATCH_INLINE part defined(const part& x) {
    const mask is_empty = P::either_nan(x.lo, x.hi);
    const vector one = P::broadcast(1);
    return {P::select(is_empty, one, x.lo), P::select(is_empty, one, x.hi)};
  }
};

} // namespace detail

template <class Path> struct operations<interval8<Path>> {
  using I = interval8<Path>;
  using lanes = detail::tape_lanes<Path>;

  static GRAZE_BATCH_INLINE I number(const constant& c) { return I(c.lo, c.hi); }
  static GRAZE_BATCH_INLINE I div(const I& x, const I& y) { return x / y; }
  static GRAZE_BATCH_INLINE I recip(const I& x) { return I(1.0) / x; }
  static GRAZE_BATCH_INLINE I sqrt(const I& x) { return root(x); }
  static GRAZE_BATCH_INLINE I abs(const I& x) { return magnitude(x); }
  static GRAZE_BATCH_INLINE I min(const I& x, const I& y) { return lesser(x, y); }
  static GRAZE_BATCH_INLINE I max(const I& x, const I& y) {
    return I::template lanewise<&batch::formulas<Path>::max>(x, y);
  }
  static I pown(const I& x, int n) {
    if (n > 2 && n <= most_multiplied)
      return multiplied_power(x, n);
    return by_lane(x, [n](const bounds& t) { return functions::pown::value(t, n); });
  }
  static I rootn(const I& x, int n) {
    return by_lane(x, [n](const bounds& t) { return functions::rootn::value(t, n); });
  }
  static I pow(const I& x, const I& y) { return by_lane<&functions::pow::value>(x, y); }
  static I hypot(const I& x, const I& y) { return by_lane<&functions::hypot::value>(x, y); }
  static I atan2(const I& y, const I& x) { return by_lane<&functions::atan2::value>(y, x); }
#define GRAZE_TAPE_FUNCTION(name)                                                                  \
  static I name(const I& x) {                                                                      \
    return by_lane(x, [](const bounds& t) { return functions::name::value(t); });                  \
  }
  GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_FUNCTION)
#undef GRAZE_TAPE_FUNCTION

  static I polynomial(const polynomial_view& p, const I& x) {
    const I first = horner(p, I::template lanewise<&lanes::lower_end>(x)),
            last = horner(p, I::template lanewise<&lanes::upper_end>(x));
    I r = I::template lanewise<&lanes::between>(x, first, last);
    for (std::uint32_t i = 0; i < p.turn_count; ++i) {
      const turn& t = p.turns[i];
      r = I::template lanewise<&lanes::turned>(x, r, I(t.lo, t.hi), I(t.least, t.greatest));
    }
    return r;
  }

  static GRAZE_BATCH_INLINE I known(const I& slope) {
    return I::template lanewise<&lanes::known>(slope);
  }
  static GRAZE_BATCH_INLINE I within_one(const I& slope) {
    return I::template lanewise<&lanes::within_one>(slope);
  }
  static GRAZE_BATCH_INLINE I abs_slope(const I& x) {
    return I::template lanewise<&lanes::abs_slope>(x);
  }
  static GRAZE_BATCH_INLINE I of_lesser(const I& a, const I& b, const I& if_a, const I& if_b) {
    return I::template lanewise<&lanes::of_lesser>(a, b, if_a, if_b);
  }

private:
  // interval8's own, found by their operands, which the members' names hide
  static GRAZE_BATCH_INLINE I root(const I& x) {
    return I::template lanewise<&batch::formulas<Path>::sqrt>(x);
  }
  static GRAZE_BATCH_INLINE I magnitude(const I& x) {
    return I::template lanewise<&batch::formulas<Path>::abs>(x);
  }

  template <class Function> static I by_lane(const I& x, Function f) {
    detail::eight_bounds b(x);
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i) {
      unsigned j = 0;
      while (j < i && !b.same(i, j))
        ++j;
      const bounds v = j < i ? r.lane(j) : f(b.lane(i));
      r.lo[i] = v.lo;
      r.hi[i] = v.hi;
    }
    return I::load(r.lo, r.hi);
  }
  template <auto Function> static I by_lane(const I& x, const I& y) {
    detail::eight_bounds a(x), b(y);
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i) {
      unsigned j = 0;
      while (j < i && !(a.same(i, j) && b.same(i, j)))
        ++j;
      const bounds v = j < i ? r.lane(j) : Function(a.lane(i), b.lane(i));
      r.lo[i] = v.lo;
      r.hi[i] = v.hi;
    }
    return I::load(r.lo, r.hi);
  }
};

template <class Path> struct continuity<interval8<Path>> {
  using I = interval8<Path>;
  static constexpr unsigned everywhere = 0xff;
  static unsigned of(opcode op, const I& a, const I& b, int n) {
    const detail::eight_bounds first(a), second(b);
    unsigned lanes = 0;
    for (unsigned i = 0; i < 8; ++i)
      if (continuous_on(op, first.lane(i), second.lane(i), n))
        lanes |= 1u << i;
    return lanes;
  }
  static GRAZE_BATCH_INLINE I defined(const I& x) {
    return I::template lanewise<&detail::tape_lanes<Path>::defined>(x);
  }
  static I where(unsigned continuous, const I& x) {
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i)
      if ((continuous >> i & 1) == 0) {
        r.lo[i] = -checking::infinity;
        r.hi[i] = checking::infinity;
      }
    return I::load(r.lo, r.hi);
  }
};

} // namespace graze::octree::tape
