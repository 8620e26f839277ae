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
  const polynomial& of = p.polynomials.data()[index];
  return {p.constants.data() + of.first_coefficient, of.degree, p.turns.data() + of.first_turn,
          of.turns};
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

/// Each is the tightest enclosure of the range over the operands' members at which the function is
/// defined, empty if there is none; but for powers and polynomials, whose bounds are off by the
/// roundings of their multiplications.
template <class Policies> struct operations<boost::numeric::interval<double, Policies>> {
  using interval = boost::numeric::interval<double, Policies>;

  static interval number(const constant& c) { return interval(c.lo, c.hi); }
  static interval div(const interval& x, const interval& y) { return x / y; }
  static interval recip(const interval& x) { return interval(1.0) / x; }
  static interval sqrt(const interval& x) { return graze::sqrt(x); }
  static interval abs(const interval& x) {
    const bounds b = to_bounds(x);
    if (b.is_empty())
      return x;
    return interval(std::max({0.0, b.lo, -b.hi}), std::max(-b.lo, b.hi));
  }
  static interval min(const interval& x, const interval& y) {
    const bounds a = to_bounds(x), b = to_bounds(y);
    if (a.is_empty() || b.is_empty())
      return interval::empty();
    return interval(std::min(a.lo, b.lo), std::min(a.hi, b.hi));
  }
  static interval max(const interval& x, const interval& y) {
    const bounds a = to_bounds(x), b = to_bounds(y);
    if (a.is_empty() || b.is_empty())
      return interval::empty();
    return interval(std::max(a.lo, b.lo), std::max(a.hi, b.hi));
  }
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

  /// By its monotone pieces: the range runs between the values at x's ends and in the turns that x
  /// meets.
  static interval polynomial(const polynomial_view& p, const interval& x) {
    const bounds at = to_bounds(x);
    if (at.is_empty())
      return x;
    if (!at.is_common())
      return interval::whole();
    interval first = horner(p, interval(at.lo));
    double lo = first.lower(), hi = first.upper();
    if (at.lo != at.hi) {
      const interval last = horner(p, interval(at.hi));
      lo = std::min(lo, last.lower());
      hi = std::max(hi, last.upper());
      for (std::uint32_t i = 0; i < p.turn_count; ++i)
        if (const turn& t = p.turns[i]; at.lo <= t.hi && t.lo <= at.hi) {
          lo = std::min(lo, t.least);
          hi = std::max(hi, t.greatest);
        }
    }
    return interval(lo, hi, true);
  }

  // For derivatives.

  /// A slope, or what is known of one that nothing is known of.
  static interval known(const interval& slope) {
    return to_bounds(slope).is_empty() ? interval::whole() : slope;
  }
  /// A slope that is known to be in [-1, 1].
  static interval within_one(const interval& slope) {
    const bounds b = to_bounds(slope);
    return b.is_empty() ? interval(-1.0, 1.0)
                        : interval(std::clamp(b.lo, -1.0, 1.0), std::clamp(b.hi, -1.0, 1.0));
  }
  /// The slopes of |x|.
  static interval abs_slope(const interval& x) {
    const bool up = x.lower() >= 0, down = x.upper() <= 0;
    return interval(up && !down ? 1.0 : -1.0, down && !up ? -1.0 : 1.0);
  }
  /// Of what has one value where a <= b for sure and another where b <= a: both where neither is.
  static interval of_lesser(const interval& a, const interval& b, const interval& if_a,
                            const interval& if_b) {
    if (a.upper() <= b.lower())
      return if_a;
    if (b.upper() <= a.lower())
      return if_b;
    return interval(std::min(if_a.lower(), if_b.lower()), std::max(if_a.upper(), if_b.upper()),
                    true);
  }
};

} // namespace graze::octree::tape
