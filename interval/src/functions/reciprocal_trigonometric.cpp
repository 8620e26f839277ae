// cot, sec, csc and acot.
#include "../border.hpp"
#include "../exact/wide_functions.hpp"
#include "../exact/wide_rounding.hpp"
#include <cmath>
#include <graze/functions/reciprocal_trigonometric.hpp>
#include <limits>

namespace graze {

using namespace wide;

namespace point {

// None of these values is a double, but for sec 0: sin, cos, tan and their inverses are
// transcendental at algebraic numbers other than 0 (Lindemann). For |x| < 2^-60,
// cot x = (1 - x^2/3 - ...)/x and csc x = (1 + x^2/6 + ...)/x are within 2^-121 of 1/x.

namespace inside {
directed cot(double x) {
  const double magnitude = std::fabs(x);
  if (!(0 < magnitude && magnitude < infinity))
    return {not_a_number, not_a_number};
  if (magnitude < 0x1p-60)
    return mirrored(x < 0, near_reciprocal(magnitude, false));
  bool negative = false;
  const directed d = rounded([&]<int N>() {
    const circular<N> f = circular_of<N>(x);
    negative = f.sine_negative != f.cosine_negative;
    return enclosed<N>(f.cosine / f.sine, error_of_quotients, error_of_quotients);
  });
  return mirrored(negative, d);
}
} // namespace inside
directed cot(double x) { return at_border<inside::cot>(x); }

namespace inside {
directed sec(double x) {
  const double magnitude = std::fabs(x);
  if (!(magnitude < infinity))
    return {not_a_number, not_a_number};
  if (x == 0)
    return {1, 1};
  if (magnitude < 0x1p-27) // sec x = 1 + x^2/2 + ... < 1 + 2^-54
    return {1, above(1)};
  bool negative = false;
  const directed d = rounded([&]<int N>() {
    const circular<N> f = circular_of<N>(x);
    negative = f.cosine_negative;
    return enclosed<N>(one<N> / f.cosine, error_of_quotients, error_of_quotients);
  });
  return mirrored(negative, d);
}
} // namespace inside
directed sec(double x) { return at_border<inside::sec>(x); }

namespace inside {
directed csc(double x) {
  const double magnitude = std::fabs(x);
  if (!(0 < magnitude && magnitude < infinity))
    return {not_a_number, not_a_number};
  if (magnitude < 0x1p-60)
    return mirrored(x < 0, near_reciprocal(magnitude, true));
  bool negative = false;
  const directed d = rounded([&]<int N>() {
    const circular<N> f = circular_of<N>(x);
    negative = f.sine_negative;
    return enclosed<N>(one<N> / f.sine, error_of_quotients, error_of_quotients);
  });
  return mirrored(negative, d);
}
} // namespace inside
directed csc(double x) { return at_border<inside::csc>(x); }

namespace {
constexpr double half_pi_down = 0x1.921fb54442d18p+0; // pi/2 - 6.1e-17
constexpr double pi_down = 0x1.921fb54442d18p+1;      // pi - 1.2e-16

/// With t = acot x, cos m - x sin m = sqrt(1 + x^2) sin(t - m) and x cos m + sin m =
/// sqrt(1 + x^2) cos(t - m): the first tells the sign of t - m and their quotient is tan(t - m).
template <int N> residual acot_residual(double x, double m) {
  const circular<N> f = circular_of<N>(m);
  const number<N> left = f.cosine, right = from_double<N>(x) * f.sine;
  const bool right_negative = x < 0, left_negative = f.cosine_negative;
  if (left_negative != right_negative) { // no cancellation; x and cos m are of unlike signs
    const double along = estimate(f.sine) - std::fabs(x) * estimate(f.cosine);
    const int sign = left_negative ? -1 : 1;
    if (along <= 0) // a poor guess
      return {sign, not_a_number, false};
    return {sign, sign * (estimate(left) + estimate(right)) / along, false};
  }
  const signed_number<N> d = difference<N>(left, right);
  const std::int64_t greater = std::max(left.exponent, right.exponent);
  // both have relative errors below 2^9 2^(-64 N)
  if (d.sign == 0 || d.magnitude.exponent < greater - 64 * N + 12)
    return {0, 0, false};
  const int sign = left_negative ? -d.sign : d.sign;
  const double along = std::fabs(x) * estimate(f.cosine) + estimate(f.sine);
  return {sign, sign * estimate(d.magnitude) / along, false};
}
} // namespace

namespace inside {
directed acot(double x) {
  if (x != x)
    return {x, x};
  if (x > 0x1p60) // (1 - 1/(3 x^2) + ...)/x
    return x == infinity ? directed{0, 0} : near_reciprocal(x, false);
  if (x < -0x1p60) // pi - 2^-60 < acot x < pi
    return {pi_down, above(pi_down)};
  if (std::fabs(x) < 0x1p-60)
    return {half_pi_down, above(half_pi_down)};
  return neighbours_of_root(std::atan2(1.0, x), 0x1p-62, above(pi_down), [x](double m) {
    const residual r = acot_residual<2>(x, m);
    return sufficient(r) ? r : acot_residual<4>(x, m);
  });
}
} // namespace inside
directed acot(double x) { return at_border<inside::acot>(x); }

} // namespace point

namespace functions {

namespace {

/// floor(2/pi x) mod 4 of the points next to x within an interval that x bounds from below or from
/// above: 0 belongs to both quadrants beside it. No other double is a multiple of pi/2.
int quadrant_above(double x) {
  const double magnitude = std::fabs(x);
  const int q = magnitude <= 0.75 ? 0 : reduced_by_half_pi<2>(x).floor_quadrant;
  return x < 0 ? 3 - q : q;
}
int quadrant_below(double x) { return x == 0 ? 3 : quadrant_above(x); }

/// How a bounded or unbounded x, which is not {0}, lies among the multiples of pi/2.
struct quadrants {
  int first;     ///< of the lower end, mod 4
  int crossings; ///< multiples of pi/2 in the interior; -1: more than two, hence all is crossed
};
quadrants quadrants_of(const bounds& x) {
  // wider than pi whatever the mode; else the crossings are at most three
  if (!(x.hi - x.lo < 4))
    return {0, -1};
  const int first = quadrant_above(x.lo), last = quadrant_below(x.hi);
  const int crossings = (last - first) & 3;
  return {first, crossings == 3 ? -1 : crossings};
}
/// Is a multiple i pi/2 in the interior, with i odd or with i even?
bool crosses(const quadrants& q, bool odd) {
  if (q.crossings < 0 || q.crossings == 2)
    return true;
  return q.crossings == 1 && ((q.first & 1) == 0) == odd; // the first crossed is first + 1
}

bool is_zero(const bounds& x) { return x.lo == 0 && x.hi == 0; }

/// sec or csc between two poles, where it is convex and positive or concave and negative: an
/// extremum of 1 or -1 if crossed, else the end that is nearer to it.
bounds between_poles(point::directed lower, point::directed upper, bool extremum) {
  const bool negative = lower.down < 0;
  if (negative)
    return {std::min(lower.down, upper.down), extremum ? -1 : std::max(lower.up, upper.up)};
  return {extremum ? 1 : std::min(lower.down, upper.down), std::max(lower.up, upper.up)};
}

decoration unless(bool pole) { return pole ? decoration::trv : decoration::dac; }

bool holds_multiple_of_pi(const bounds& x) {
  return x.contains(0) || crosses(quadrants_of(x), false);
}

} // namespace

namespace inside {
bounds cot(bounds x) {
  if (x.is_empty() || is_zero(x))
    return bounds::empty();
  if (crosses(quadrants_of(x), false))
    return bounds::entire();
  return {x.hi == 0 ? -infinity : point::inside::cot(x.hi).down,
          x.lo == 0 ? infinity : point::inside::cot(x.lo).up};
}
} // namespace inside
bounds cot::value(bounds x) { return at_border<inside::cot>(x); }
decoration cot::local(bounds x) { return unless(x.is_empty() || holds_multiple_of_pi(x)); }

namespace inside {
bounds csc(bounds x) {
  if (x.is_empty() || is_zero(x))
    return bounds::empty();
  const quadrants q = quadrants_of(x);
  if (crosses(q, false))
    return bounds::entire();
  const bool extremum = q.crossings == 1;
  if (x.lo == 0) // the pole is an end
    return {extremum ? 1 : point::inside::csc(x.hi).down, infinity};
  if (x.hi == 0)
    return {-infinity, extremum ? -1 : point::inside::csc(x.lo).up};
  return between_poles(point::inside::csc(x.lo), point::inside::csc(x.hi), extremum);
}
} // namespace inside
bounds csc::value(bounds x) { return at_border<inside::csc>(x); }
decoration csc::local(bounds x) { return unless(x.is_empty() || holds_multiple_of_pi(x)); }

namespace inside {
bounds sec(bounds x) {
  if (x.is_empty())
    return x;
  if (is_zero(x))
    return {1, 1};
  const quadrants q = quadrants_of(x);
  if (crosses(q, true))
    return bounds::entire();
  return between_poles(point::inside::sec(x.lo), point::inside::sec(x.hi), q.crossings == 1);
}
} // namespace inside
bounds sec::value(bounds x) { return at_border<inside::sec>(x); }
decoration sec::local(bounds x) {
  return unless(x.is_empty() || (!is_zero(x) && crosses(quadrants_of(x), true)));
}

namespace inside {
bounds acot(bounds x) {
  if (x.is_empty())
    return x;
  return {point::inside::acot(x.hi).down, point::inside::acot(x.lo).up};
}
} // namespace inside
bounds acot::value(bounds x) { return at_border<inside::acot>(x); }
decoration acot::local(bounds x) { return unless(x.is_empty()); }

} // namespace functions
} // namespace graze
