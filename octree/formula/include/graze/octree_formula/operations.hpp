#pragma once
/// What a tape asks of a number type beside + - * and sqr: for doubles and for intervals. Duals are
/// in derivatives.hpp, eight intervals at once in operations_eight.hpp.
#include <algorithm>
#include <cmath>
#include <graze/batch/path.hpp>
#include <graze/functions/arithmetic.hpp>
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/integer_power.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/reciprocal_hyperbolic.hpp>
#include <graze/functions/reciprocal_trigonometric.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/octree/formula.hpp>
#include <graze/octree/lanewise.hpp>
#include <graze/octree_formula/tape.hpp>

namespace graze::octree::tape {

/// A polynomial with the arrays that it is a part of.
struct polynomial_view {
  const constant* coefficients; ///< the highest first
  std::uint32_t degree;
  const turn* turns;
  std::uint32_t turn_count;
};
GRAZE_BATCH_INLINE polynomial_view view(const program& p, std::uint32_t index) {
  const polynomial& entry = p.polynomials.data()[index];
  return {p.constants.data() + entry.first_coefficient, entry.degree,
          p.turns.data() + entry.first_turn, entry.turns};
}

template <class N> struct operations;

/// The polynomial by Horner's rule; for intervals, tight only at a point.
template <class N> N horner(const polynomial_view& p, const N& x) {
  N r = operations<N>::number(p.coefficients[0]);
  for (std::uint32_t i = 1; i <= p.degree; ++i) {
    const constant& c = p.coefficients[i];
    r = r * x;
    if (c.lo != 0 || c.hi != 0)
      r = r + operations<N>::number(c);
  }
  return r;
}

/// x^n, n > 0, each multiplication rounded; for intervals tight but for that, where x >= 0.
template <class N> N power_by_squaring(const N& x, int n) {
  int bit = 1;
  while (n >> 1 >= bit)
    bit *= 2;
  N r = x;
  for (bit /= 2; bit != 0; bit /= 2) {
    r = sqr(r);
    if ((n & bit) != 0)
      r = r * x;
  }
  return r;
}

/// Beyond it a power is graze::pown's, at 0 ulp, rather than by multiplication, which is quicker.
inline constexpr int most_multiplied = 32;

/// Encloses { t^n : t in x }, 2 < n <= most_multiplied. The odd power of t is that of its positive
/// part less that of its negative part, one of which is 0: no variable has two influences.
template <class N> N multiplied_power(const N& x, int n) {
  using o = operations<N>;
  if (n % 2 == 0)
    return power_by_squaring(o::abs(x), n);
  const N zero = o::number({0, 0, 0});
  return power_by_squaring(o::max(x, zero), n) - power_by_squaring(o::max(-x, zero), n);
}

/// In doubles, rounded to nearest, without a bound: for shading.
template <> struct operations<double> {
  static double number(const constant& c) { return c.nearest; }
  static double div(double x, double y) { return x / y; }
  static double recip(double x) { return 1 / x; }
  static double sqrt(double x) { return std::sqrt(x); }
  static double abs(double x) { return std::fabs(x); }
  static double min(double x, double y) { return y < x ? y : x; }
  static double max(double x, double y) { return x < y ? y : x; }
  static double pown(double x, int n) { return std::pow(x, n); }
  static double rootn(double x, int n) {
    if (n % 2 == 0 || x >= 0)
      return std::pow(x, 1.0 / n);
    return -std::pow(-x, 1.0 / n);
  }
  static double polynomial(const polynomial_view& p, double x) { return horner(p, x); }
  static double pow(double x, double y) { return std::exp(y * std::log(x)); }
  static double hypot(double x, double y) { return std::hypot(x, y); }
  static double atan2(double y, double x) { return std::atan2(y, x); }
  static double select(double a, double if_positive, double if_not) {
    return a > 0 ? if_positive : (a <= 0 ? if_not : a);
  }

  static double cbrt(double x) { return std::cbrt(x); }
  static double exp(double x) { return std::exp(x); }
  static double exp2(double x) { return std::exp2(x); }
  static double exp10(double x) { return std::pow(10.0, x); }
  static double expm1(double x) { return std::expm1(x); }
  static double log(double x) { return std::log(x); }
  static double log2(double x) { return std::log2(x); }
  static double log10(double x) { return std::log10(x); }
  static double logp1(double x) { return std::log1p(x); }
  static double sin(double x) { return std::sin(x); }
  static double cos(double x) { return std::cos(x); }
  static double tan(double x) { return std::tan(x); }
  static double cot(double x) { return 1 / std::tan(x); }
  static double sec(double x) { return 1 / std::cos(x); }
  static double csc(double x) { return 1 / std::sin(x); }
  static double asin(double x) { return std::asin(x); }
  static double acos(double x) { return std::acos(x); }
  static double atan(double x) { return std::atan(x); }
  static double acot(double x) { return std::atan2(1.0, x); }
  static double sinh(double x) { return std::sinh(x); }
  static double cosh(double x) { return std::cosh(x); }
  static double tanh(double x) { return std::tanh(x); }
  static double coth(double x) { return 1 / std::tanh(x); }
  static double sech(double x) { return 1 / std::cosh(x); }
  static double csch(double x) { return 1 / std::sinh(x); }
  static double asinh(double x) { return std::asinh(x); }
  static double acosh(double x) { return std::acosh(x); }
  static double atanh(double x) { return std::atanh(x); }
  static double acoth(double x) { return std::atanh(1 / x); }
  static double sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }
  static double floor(double x) { return std::floor(x); }
  static double ceil(double x) { return std::ceil(x); }
  static double trunc(double x) { return std::trunc(x); }

  // For derivatives: at a kink that of one side.
  static double known(double slope) { return slope; }
  static double within_one(double slope) { return slope; }
  static double abs_slope(double x) { return x < 0 ? -1 : 1; }
  static double of_lesser(double a, double b, double if_a, double if_b) {
    return b < a ? if_b : if_a;
  }
};

namespace detail {

/// What a tape asks of intervals beside arithmetic and functions, over the lanes of a register.
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
  /// x, or nothing where it is a point: the value there is tighter than those in a turn.
  static GRAZE_BATCH_INLINE part stretch(const part& x) {
    const mask longer = P::less(x.lo, x.hi);
    const vector nan = P::broadcast(checking::nan());
    return {P::select(longer, x.lo, nan), P::select(longer, x.hi, nan)};
  }
  static GRAZE_BATCH_INLINE mask is_point(const part& x) { return P::equal(x.lo, x.hi); }
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
  /// The hull of both where the sign of a is not decided; nothing where a is empty.
  static GRAZE_BATCH_INLINE part select(const part& a, const part& if_positive,
                                        const part& if_not) {
    const vector zero = P::zero();
    const mask yes = P::less(zero, a.lo), no = P::less_equal(a.hi, zero);
    // the second where either is empty
    const vector lo = P::min_or_second(if_positive.lo, if_not.lo),
                 hi = P::max_or_second(if_positive.hi, if_not.hi);
    const mask alone = P::either_nan(if_not.lo, if_not.hi);
    const part hull = {P::select(alone, if_positive.lo, lo), P::select(alone, if_positive.hi, hi)};
    const mask is_empty = P::either_nan(a.lo, a.hi);
    return {P::select(is_empty, a.lo,
                      P::select(yes, if_positive.lo, P::select(no, if_not.lo, hull.lo))),
            P::select(is_empty, a.hi,
                      P::select(yes, if_positive.hi, P::select(no, if_not.hi, hull.hi)))};
  }
  static GRAZE_BATCH_INLINE part defined(const part& x) {
    const mask is_empty = P::either_nan(x.lo, x.hi);
    const vector one = P::broadcast(1);
    return {P::select(is_empty, one, x.lo), P::select(is_empty, one, x.hi)};
  }
};

/// Operations of intervals and of eight intervals, written once.
template <class I> struct interval_operations {
  using path = typename lanewise<I>::path;
  using formulas = batch::formulas<path>;
  using per_lane = tape_lanes<path>;
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE I each(const Operands&... x) {
    return lanewise<I>::template apply<Operation>(x...);
  }

  static GRAZE_BATCH_INLINE I number(const constant& c) { return I(c.lo, c.hi); }
  static GRAZE_BATCH_INLINE I div(const I& x, const I& y) { return x / y; }
  static GRAZE_BATCH_INLINE I recip(const I& x) { return I(1.0) / x; }
  static GRAZE_BATCH_INLINE I abs(const I& x) { return each<&formulas::abs>(x); }
  static GRAZE_BATCH_INLINE I min(const I& x, const I& y) { return each<&formulas::min>(x, y); }
  static GRAZE_BATCH_INLINE I max(const I& x, const I& y) { return each<&formulas::max>(x, y); }
  static GRAZE_BATCH_INLINE I select(const I& a, const I& if_positive, const I& if_not) {
    return each<&per_lane::select>(a, if_positive, if_not);
  }

  /// By its monotone pieces: the range runs between the values at x's ends and in the turns that x
  /// meets.
  static I polynomial(const polynomial_view& p, const I& x) {
    const I first = horner(p, each<&per_lane::lower_end>(x));
    if (lanewise<I>::template everywhere<&per_lane::is_point>(x))
      return each<&per_lane::between>(x, first, first);
    const I last = horner(p, each<&per_lane::upper_end>(x));
    I r = each<&per_lane::between>(x, first, last);
    const I stretch = each<&per_lane::stretch>(x);
    for (std::uint32_t i = 0; i < p.turn_count; ++i) {
      const turn& t = p.turns[i];
      r = each<&per_lane::turned>(stretch, r, I(t.lo, t.hi), I(t.least, t.greatest));
    }
    return r;
  }

  // For derivatives.

  /// A slope, or what is known of one that nothing is known of.
  static GRAZE_BATCH_INLINE I known(const I& slope) { return each<&per_lane::known>(slope); }
  /// A slope that is known to be in [-1, 1].
  static GRAZE_BATCH_INLINE I within_one(const I& slope) {
    return each<&per_lane::within_one>(slope);
  }
  /// The slopes of |x|.
  static GRAZE_BATCH_INLINE I abs_slope(const I& x) { return each<&per_lane::abs_slope>(x); }
  /// Of what has one value where a <= b for sure and another where b <= a: both where neither is.
  static GRAZE_BATCH_INLINE I of_lesser(const I& a, const I& b, const I& if_a, const I& if_b) {
    return each<&per_lane::of_lesser>(a, b, if_a, if_b);
  }
};

} // namespace detail

/// Each is the tightest enclosure of the range over the operands' members at which the function is
/// defined, empty if there is none; but for powers and polynomials, whose bounds are off by the
/// roundings of their multiplications.
template <class Policies>
struct operations<boost::numeric::interval<double, Policies>>
    : detail::interval_operations<boost::numeric::interval<double, Policies>> {
  using interval = boost::numeric::interval<double, Policies>;

  static interval sqrt(const interval& x) { return graze::sqrt(x); }
  static interval pown(const interval& x, int n) {
    if (n > 2 && n <= most_multiplied)
      return multiplied_power(x, n);
    return apply<functions::pown>(x, n);
  }
  static interval rootn(const interval& x, int n) { return apply<functions::rootn>(x, n); }
  static interval pow(const interval& x, const interval& y) { return apply<functions::pow>(x, y); }
  static interval hypot(const interval& x, const interval& y) {
    return apply<functions::hypot>(x, y);
  }
  static interval atan2(const interval& y, const interval& x) {
    return apply<functions::atan2>(y, x);
  }
#define GRAZE_TAPE_FUNCTION(name)                                                                  \
  static interval name(const interval& x) { return apply<functions::name>(x); }
  GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_FUNCTION)
#undef GRAZE_TAPE_FUNCTION
};

} // namespace graze::octree::tape
