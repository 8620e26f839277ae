#pragma once
/// The functions that a formula is written in, beside + - *: each is found for every number type
/// over which a surface is evaluated, and is as tight as that type allows.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <cstdint>
#include <graze/batch/formulas.hpp>
#include <graze/interval.hpp>
#include <graze/octree/lanewise.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::octree {

/// Two doubles, equal or neighbours, that enclose a rational number; and the one nearest to it.
struct rational_bounds {
  double lo, hi, nearest;
};

/// Encloses numerator / denominator by long division in integers, at compile time, so that no
/// rounding mode and no optimizer has a say in it.  Error: 0 ulp. Domain: 0 < |numerator|,
/// denominator < 2^52.
consteval rational_bounds enclose_rational(std::int64_t numerator, std::int64_t denominator) {
  const bool negative = numerator < 0;
  const std::int64_t n = negative ? -numerator : numerator;
  std::int64_t quotient = n / denominator, remainder = n % denominator;
  double unit = 1;
  while (quotient < (std::int64_t{1} << 52)) {
    remainder *= 2;
    quotient = 2 * quotient + (remainder >= denominator ? 1 : 0);
    remainder -= remainder >= denominator ? denominator : 0;
    unit /= 2;
  }
  const double below = static_cast<double>(quotient) * unit;
  const double above = remainder == 0 ? below : static_cast<double>(quotient + 1) * unit;
  const bool up =
      2 * remainder > denominator || (2 * remainder == denominator && quotient % 2 != 0);
  const double nearest = up ? above : below;
  return negative ? rational_bounds{-above, -below, -nearest}
                  : rational_bounds{below, above, nearest};
}

/// How a number type takes the constants of a formula. Specialize it for a type of your own.
/// `rational<P, Q>()`: the real number P/Q as well as the type can say it; `exact(x)`: the double
/// x.
template <class N> struct constants {
  template <std::int64_t P, std::int64_t Q> static N rational() { return N(P) / N(Q); }
  static N exact(double x) { return N(x); }
};
template <> struct constants<double> {
  template <std::int64_t P, std::int64_t Q> static double rational() {
    constexpr double value = enclose_rational(P, Q).nearest;
    return value;
  }
  static double exact(double x) { return x; }
};
template <class Policies> struct constants<boost::numeric::interval<double, Policies>> {
  using interval = boost::numeric::interval<double, Policies>;
  template <std::int64_t P, std::int64_t Q> static interval rational() {
    constexpr rational_bounds value = enclose_rational(P, Q);
    return interval(value.lo, value.hi);
  }
  static interval exact(double x) { return interval(x); }
};

/// x^2: for intervals, of one variable, not of two independent ones.
using graze::sqr;
template <class N> N sqr(const N& x) { return x * x; }

/// The lesser of two numbers; for intervals { min(s, t) : s in a, t in b }, 0 ulp, empty where
/// either is.
template <class N> N lesser(const N& a, const N& b) { return b < a ? b : a; }
template <class Policies>
boost::numeric::interval<double, Policies>
lesser(const boost::numeric::interval<double, Policies>& a,
       const boost::numeric::interval<double, Policies>& b) {
  return lanewise<boost::numeric::interval<double, Policies>>::template apply<
      &batch::formulas<batch::portable>::min>(a, b);
}

/// x^3 - x, for a number type that knows no better. Specialize it for one that does: unlike an
/// overload of a type of another namespace, a specialization is found wherever it is declared
/// before the formula is evaluated.
template <class N> struct cube_minus_identity_of {
  static N value(const N& x) { return x * (x * x - constants<N>::exact(1)); }
};
/// x^3 - x.
template <class N> N cube_minus_identity(const N& x) { return cube_minus_identity_of<N>::value(x); }

namespace detail {
/// Bounds of h(x) = x^3 - x at a double, from |h(x)| = m |m - 1| (m + 1) with m = |x|: three
/// factors, each rounded once, so a few ulps, also beside the zeros -1, 0 and 1, where x^3 - x
/// cancels.
template <class Rounding> struct cube_minus_identity_at {
  Rounding& round;

  double magnitude_down(double m) {
    const double distance = m < 1 ? round.sub_down(1.0, m) : round.sub_down(m, 1.0);
    return round.mul_down(round.mul_down(m, distance), round.add_down(m, 1.0));
  }
  double magnitude_up(double m) {
    const double distance = m < 1 ? round.sub_up(1.0, m) : round.sub_up(m, 1.0);
    return round.mul_up(round.mul_up(m, distance), round.add_up(m, 1.0));
  }
  static bool not_negative(double x) { return x >= 1 || (x <= 0 && x >= -1); }
  double down(double x) {
    const double m = x < 0 ? -x : x;
    return not_negative(x) ? magnitude_down(m) : -magnitude_up(m);
  }
  double up(double x) {
    const double m = x < 0 ? -x : x;
    return not_negative(x) ? magnitude_up(m) : -magnitude_down(m);
  }
};
} // namespace detail

/// Encloses { t^3 - t : t in x } by its monotone pieces: it rises up to -1/sqrt(3), falls to
/// 1/sqrt(3), rises again; the local extrema are +-2/(3 sqrt(3)).
/// Error: at most 3 roundings an endpoint, 1 ulp at an extremum.  Domain: all of R; the empty set
/// is not handled.
template <class Policies>
boost::numeric::interval<double, Policies>
cube_minus_identity(const boost::numeric::interval<double, Policies>& x) {
  using interval = boost::numeric::interval<double, Policies>;
  // 1/sqrt(3) = 0.577350269189625764..., between two neighbouring doubles.
  constexpr double turn_down = 0x1.279a74590331cp-1, turn_up = 0x1.279a74590331dp-1;
  // 2/(3 sqrt(3)) = 0.384900179459750509..., rounded up.
  constexpr double extremum_up = 0x1.8a2345cc04426p-2;
  typename interval::traits_type::rounding round;
  detail::cube_minus_identity_at<decltype(round)> h{round};
  const double a = x.lower(), b = x.upper();
  // On each of the three pieces the range runs between the values at its ends; a piece is known
  // only to one ulp, which the test against both neighbours of the turning point allows for.
  const bool has_maximum = a <= -turn_down && b >= -turn_up;
  const bool has_minimum = a <= turn_up && b >= turn_down;
  if (!has_maximum && !has_minimum)
    return a > -turn_down && b < turn_up ? interval(h.down(b), h.up(a))
                                         : interval(h.down(a), h.up(b));
  const double lo = std::min(h.down(a), h.down(b)), hi = std::max(h.up(a), h.up(b));
  return interval(has_minimum ? std::min(lo, -extremum_up) : lo,
                  has_maximum ? std::max(hi, extremum_up) : hi);
}

} // namespace graze::octree
