#include "../border.hpp"
#include <algorithm>
#include <cmath>
#include <graze/functions/remainder.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::functions {

namespace {

using rounding::exact::direction;

/// floor(x / y) for x >= 0 and y > 0, as long as it is below 2^53; at least 2^53 if it is not.
double whole_quotient(double x, double y) {
  if (y == checking::infinity)
    return x == checking::infinity ? checking::infinity : 0;
  return std::floor(rounding::exact::div(x, y, direction::down));
}

/// The range over 0 <= a <= x <= b and 0 <= c <= y <= d, 0 < y. Let n be the least quotient,
/// floor(a / d). Where it is the only one, x - n y is continuous, and its bounds are those of two
/// corners, exact as fmod is. Where not, the line x = m y, m = n + 1, meets the box: on it the
/// remainder is 0, and as x / y grows towards m it tends to y, whose greatest value on the line is
/// d or b / m.
///
/// From 2^53 on there is always such a line unless x and y are single numbers: an ulp of a or d
/// moves the quotient by 1 or more. The upper bound is d then, also as b / m, rounded up.
bounds of_positive(double a, double b, double c, double d) {
  if (a == b && c == d)
    return {std::fmod(a, d), std::fmod(a, d)};
  const double n = whole_quotient(a, d);
  if (n < 0x1p53 && c > 0 && whole_quotient(b, c) == n)
    return {std::fmod(a, d), std::fmod(b, c)};
  if (n >= 0x1p53 || whole_quotient(b, d) > n)
    return {0, d};
  return {0, rounding::exact::div(b, n + 1, direction::up)};
}

bounds range(bounds x, bounds y) {
  if (x.is_empty() || y.is_empty() || (y.lo == 0 && y.hi == 0))
    return bounds::empty();
  const double c = std::max({0.0, y.lo, -y.hi}), d = std::max(-y.lo, y.hi);
  bounds r = bounds::empty();
  if (x.hi >= 0)
    r = of_positive(std::max(0.0, x.lo), x.hi, c, d);
  if (x.lo < 0) {
    const bounds left = of_positive(std::max(0.0, -x.hi), -x.lo, c, d);
    r = {-left.hi, r.is_empty() ? -left.lo : r.hi};
  }
  return r;
}

} // namespace

bounds fmod::value(bounds x, bounds y) { return at_border<range>(x, y); }

} // namespace graze::functions
