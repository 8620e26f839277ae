// coth, sech, csch and acoth.
#include "../border.hpp"
#include "../exact/wide_functions.hpp"
#include "../exact/wide_rounding.hpp"
#include <algorithm>
#include <cmath>
#include <graze/functions/reciprocal_hyperbolic.hpp>

namespace graze {

using namespace wide;

namespace point {

// None of these values is a double, but for sech 0 and the limits: exp is transcendental at
// algebraic numbers other than 0 (Lindemann). For |x| < 2^-60, coth x = (1 + x^2/3 - ...)/x and
// csch x = (1 - x^2/6 + ...)/x are within 2^-121 of 1/x.

namespace inside {
directed coth(double x) {
  const double magnitude = std::fabs(x);
  if (!(0 < magnitude))
    return {not_a_number, not_a_number};
  if (magnitude < 0x1p-60)
    return mirrored(x < 0, near_reciprocal(magnitude, true));
  if (magnitude == infinity)
    return mirrored(x < 0, {1, 1});
  if (magnitude >= 19) // coth x - 1 = 2/(exp(2 x) - 1) < 2^-53
    return mirrored(x < 0, {1, above(1)});
  return mirrored(x < 0, rounded([&]<int N>() {
                    const hyperbolic<N> f = hyperbolic_of<N>(x);
                    return enclosed<N>(f.cosine / f.sine, error_of_quotients, error_of_quotients);
                  }));
}
} // namespace inside
directed coth(double x) { return at_border<inside::coth>(x); }

// 2 exp(-746) < 2^-1074

namespace inside {
directed sech(double x) {
  const double magnitude = std::fabs(x);
  if (x != x)
    return {x, x};
  if (magnitude < 0x1p-27) // 1 - 2^-55 < 1 - x^2/2 < sech x
    return magnitude == 0 ? directed{1, 1} : directed{below(1), 1};
  if (magnitude >= 746)
    return {0, magnitude == infinity ? 0 : smallest};
  return rounded([&]<int N>() {
    const hyperbolic<N> f = hyperbolic_of<N>(x);
    return enclosed<N>(one<N> / f.cosine, error_of_quotients, error_of_quotients);
  });
}
} // namespace inside
directed sech(double x) { return at_border<inside::sech>(x); }

namespace inside {
directed csch(double x) {
  const double magnitude = std::fabs(x);
  if (!(0 < magnitude))
    return {not_a_number, not_a_number};
  if (magnitude < 0x1p-60)
    return mirrored(x < 0, near_reciprocal(magnitude, false));
  if (magnitude >= 746)
    return mirrored(x < 0, {0, magnitude == infinity ? 0 : smallest});
  return mirrored(x < 0, rounded([&]<int N>() {
                    const hyperbolic<N> f = hyperbolic_of<N>(x);
                    return enclosed<N>(one<N> / f.sine, error_of_quotients, error_of_quotients);
                  }));
}
} // namespace inside
directed csch(double x) { return at_border<inside::csch>(x); }

namespace {
/// t = acoth x is where y(t) = 1 for y(m) = (x - 1) sinh(m) exp(m) = (x - 1)/2 (exp(2 m) - 1). y is
/// increasing and convex, y' = (x - 1) + 2 y, and its second derivative 2 y' moves (1 - y)/y' from
/// t - m by a factor of 1 +- 2 |t - m|.
template <int N> residual acoth_residual(double x, double m) {
  const number<N> excess = difference<N>(from_double<N>(x), one<N>).magnitude; // exact: x < 2^61
  const hyperbolic<N> f = hyperbolic_of<N>(m);
  const number<N> y = excess * f.sine * sum<N>(f.cosine, f.sine);
  const signed_number<N> d = difference<N>(one<N>, y);
  // y has a relative error below 2^10 2^(-64 N)
  const std::int64_t greater = std::max<std::int64_t>(1, y.exponent);
  if (d.sign == 0 || d.magnitude.exponent < greater - 64 * N + 12)
    return {0, 0, false};
  return {d.sign, d.sign * estimate(d.magnitude) / (estimate(excess) + 2 * estimate(y)), false};
}
} // namespace

namespace inside {
directed acoth(double x) {
  const double magnitude = std::fabs(x);
  if (!(1 < magnitude))
    return {not_a_number, not_a_number};
  if (magnitude == infinity)
    return {0, 0};
  if (magnitude > 0x1p60) // (1 + 1/(3 x^2) + ...)/x
    return mirrored(x < 0, near_reciprocal(magnitude, true));
  const double guess = 0.5 * std::log1p(2 / (magnitude - 1));
  return mirrored(x < 0, neighbours_of_root(
                             guess, 0x1p-61, 20,
                             [magnitude](double m) {
                               const residual r = acoth_residual<2>(magnitude, m);
                               return sufficient(r) ? r : acoth_residual<4>(magnitude, m);
                             }));
}
} // namespace inside
directed acoth(double x) { return at_border<inside::acoth>(x); }

} // namespace point

namespace functions {

namespace {
bool is_zero(const bounds& x) { return x.lo == 0 && x.hi == 0; }

decoration off_zero(const bounds& x) {
  return x.is_empty() || x.contains(0) ? decoration::trv : decoration::dac;
}

/// f decreasing on each side of a pole at 0.
template <class Function> bounds around_pole(const bounds& x, Function f) {
  if (x.is_empty() || is_zero(x))
    return bounds::empty();
  if (x.lo < 0 && 0 < x.hi)
    return bounds::entire();
  return {x.hi == 0 ? -infinity : f(x.hi).down, x.lo == 0 ? infinity : f(x.lo).up};
}
} // namespace

namespace inside {
bounds coth(bounds x) { return around_pole(x, point::inside::coth); }
} // namespace inside
bounds coth::value(bounds x) { return at_border<inside::coth>(x); }
decoration coth::local(bounds x) { return off_zero(x); }

namespace inside {
bounds csch(bounds x) { return around_pole(x, point::inside::csch); }
} // namespace inside
bounds csch::value(bounds x) { return at_border<inside::csch>(x); }
decoration csch::local(bounds x) { return off_zero(x); }

namespace inside {
bounds sech(bounds x) {
  if (x.is_empty())
    return x;
  const double least = x.contains(0) ? 0 : std::min(std::fabs(x.lo), std::fabs(x.hi));
  return {point::inside::sech(std::max(-x.lo, x.hi)).down, point::inside::sech(least).up};
}
} // namespace inside
bounds sech::value(bounds x) { return at_border<inside::sech>(x); }
decoration sech::local(bounds x) { return x.is_empty() ? decoration::trv : decoration::dac; }

namespace inside {
bounds acoth(bounds x) {
  const bool left = x.lo < -1, right = x.hi > 1;
  if (left && right) // both sides of the gap reach its ends, where acoth is unbounded
    return bounds::entire();
  if (left)
    return {x.hi >= -1 ? -infinity : point::inside::acoth(x.hi).down,
            point::inside::acoth(x.lo).up};
  if (right)
    return {point::inside::acoth(x.hi).down, x.lo <= 1 ? infinity : point::inside::acoth(x.lo).up};
  return bounds::empty();
}
} // namespace inside
bounds acoth::value(bounds x) { return at_border<inside::acoth>(x); }
decoration acoth::local(bounds x) {
  return x.hi < -1 || x.lo > 1 ? decoration::dac : decoration::trv;
}

} // namespace functions
} // namespace graze
