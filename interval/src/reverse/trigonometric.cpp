/// Reverse sine, cosine and tangent, tightest for arguments of any size.
///
/// The least solution at or after a double x is x itself, or else the first t > x where the
/// function crosses an end of c. Its distance from x is computed in double arithmetic from the
/// angle of x, which the correctly rounded functions at x give, whatever the size of x: no
/// reduction by a long pi is needed. The error is below `slack`, so t is known to a few ulps. Which
/// double m is the greatest <= t is then decided exactly: near t the function is monotone, and a
/// correctly rounded value compares with an end of c as the real value does (RD(f(m)) >= q iff f(m)
/// >= q). That m is never equal to t but at 0 (Lindemann: sin, cos and tan of a rational number
/// that is not 0 are no rational numbers), and t near 0 is a correctly rounded value of the inverse
/// function.
#include "../border.hpp"
#include "solution_set.hpp"
#include <graze/functions/reverse.hpp>
#include <graze/point.hpp>

namespace graze::functions {

using solutions::infinity;

namespace {

constexpr double pi = 0x1.921fb54442d18p+1; // RN(pi)

/// Bounds the error of a computed distance: half a dozen operations on numbers below 8, each with a
/// relative error of at most 2^-51, are off by less than 2^-44.
constexpr double slack = 0x1p-40;

/// The greatest double m <= t, where |t - (x + distance)| < slack, t > x, |t| > 1/2, and
/// `not_above(m)` tells whether m <= t for |m - t| < 2 slack.
template <class NotAbove> double round_down(double x, double distance, NotAbove not_above) {
  // Where doubles lie further apart than slack, the distance decides, but for a double that
  // happens to be near t. (m - x is exact enough: m and x are both below 8, or the rounding error
  // is below 2^-52 times a difference below 8, or m - x is greater than 8 and so is its rounding.)
  const auto at_most_t = [&](double m) {
    const double from_x = m - x;
    if (from_x < distance - slack)
      return true;
    return from_x < distance + slack && not_above(m);
  };
  double m = x + distance;
  while (!at_most_t(m))
    m = solutions::before(m);
  for (double next = solutions::after(m); at_most_t(next); next = solutions::after(m))
    m = next;
  return m;
}

/// sin(t + quarters pi/2): sin, cos, -sin, -cos for 0, 1, 2, 3 quarters of a turn. 4 stands for 0.
double wave_down(int quarters, double t) {
  switch (quarters % 4) {
  case 0:
    return point::sin_down(t);
  case 1:
    return point::cos_down(t);
  case 2:
    return -point::sin_up(t);
  default:
    return -point::cos_up(t);
  }
}

/// The first t > x where the wave falls to q, rounded down, for wave(x) > q >= -1, x finite.
double first_fall(int quarters, double q, double x) {
  // The wave's angle at x, between where it last rose through 0 slope and where it next does.
  const double height = wave_down(quarters, x), slope = wave_down(quarters + 1, x);
  double angle = std::atan2(height, slope);
  if (slope < 0 && angle < 0)
    angle += 2 * pi;
  const double distance = (pi - point::asin_down(q)) - angle;

  if (std::abs(x + distance) < 1) {
    // The solutions in (-pi/2, pi/2) are those of the inverse functions. A sine falls in none.
    if (quarters == 1)
      return point::acos_down(q);
    return quarters == 2 ? point::asin_down(-q) : -point::acos_up(-q);
  }
  return round_down(x, distance, [=](double m) {
    const bool higher = wave_down(quarters, m) >= q;
    // Far from its extrema, the wave near t falls. Near one, its slope at m tells on which side of
    // it m lies, and t is on the falling side.
    if (std::abs(q) < 0.99 || wave_down(quarters + 1, m) < 0)
      return higher;
    return wave_down(quarters, m) > 0;
  });
}

/// A lower bound of the solutions.
struct start {
  double bound;
  bool is_solution; ///< the bound is a solution itself, or -inf, and solutions go on that far
};

/// { t >= x : wave(t) in c } for the wave of 0 or 1 quarter, c meeting [-1, 1].
start first_solution(int quarters, const bounds& c, double x) {
  if (x == -infinity)
    return {x, true};
  const double down = wave_down(quarters, x);
  if (down < c.lo)
    return {first_fall(quarters + 2, -c.lo, x), false};
  if (-wave_down(quarters + 2, x) > c.hi)
    return {first_fall(quarters, c.hi, x), false};
  return {x, true};
}

/// The hull from the least solution to the greatest; `first` and `last` are computed from x.lo
/// upwards and from x.hi downwards (`last` mirrored), not regarding the other end of x.
bounds between(const bounds& x, const start& first, const start& last) {
  // If no end of x is a solution, the first one after x.lo, which is no double, is in x iff the
  // double below it is below x.hi.
  if (!first.is_solution && !last.is_solution && first.bound >= x.hi)
    return bounds::empty();
  return {first.bound, -last.bound};
}

bounds mirrored(const bounds& x) { return {-x.hi, -x.lo}; }

} // namespace

namespace inside {
bounds sin_rev(bounds c, bounds x) {
  if (c.is_empty() || x.is_empty() || c.lo > 1 || c.hi < -1)
    return bounds::empty();
  if (c.lo <= -1 && c.hi >= 1)
    return x;
  return between(x, first_solution(0, c, x.lo), first_solution(0, mirrored(c), -x.hi));
}
} // namespace inside
bounds sin_rev::value(bounds c, bounds x) { return at_border<inside::sin_rev>(c, x); }

namespace inside {
bounds cos_rev(bounds c, bounds x) {
  if (c.is_empty() || x.is_empty() || c.lo > 1 || c.hi < -1)
    return bounds::empty();
  if (c.lo <= -1 && c.hi >= 1)
    return x;
  return between(x, first_solution(1, c, x.lo), first_solution(1, c, -x.hi));
}
} // namespace inside
bounds cos_rev::value(bounds c, bounds x) { return at_border<inside::cos_rev>(c, x); }

namespace {

/// { t >= x : tan(t) in c }, c not empty. From tan(x) < c.lo the tangent rises to c.lo; from
/// tan(x) > c.hi it rises to its pole, and then from -inf to c.lo. c.lo = -inf stands for the pole,
/// the end of the solutions after it. (The tangent of a double is finite.)
start first_tangent(const bounds& c, double x) {
  if (x == -infinity)
    return {x, true};
  const double down = point::tan_down(x);
  const bool too_high = point::tan_up(x) > c.hi;
  if (down >= c.lo && !too_high)
    return {x, true};
  const double q = c.lo;
  const double distance = (too_high ? pi : 0) + (point::atan_down(q) - point::atan_down(down));
  if (std::abs(x + distance) < 1)
    return {point::atan_down(q), false};
  const double bound = round_down(x, distance, [=](double m) {
    // No double is a pole. For q >= 0, the nearest pole is that above t, and just above the pole
    // the tangent is below -1; for q < 0 it is that at or below t, with more than 1 just below it.
    if (q >= 0)
      return point::tan_down(m) >= -1 && point::tan_up(m) <= q;
    return !(point::tan_down(m) >= q && point::tan_up(m) <= 1);
  });
  return {bound, false};
}

} // namespace

namespace inside {
bounds tan_rev(bounds c, bounds x) {
  if (c.is_empty() || x.is_empty())
    return bounds::empty();
  return between(x, first_tangent(c, x.lo), first_tangent(mirrored(c), -x.hi));
}
} // namespace inside
bounds tan_rev::value(bounds c, bounds x) { return at_border<inside::tan_rev>(c, x); }

} // namespace graze::functions
