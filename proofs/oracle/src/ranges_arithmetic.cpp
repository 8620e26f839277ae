#include <cmath>
#include <gmpxx.h>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/oracle/roots.hpp>

namespace graze::oracle::ranges {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The hull of a monotone operation's limits at the corners of a box; NaN is no limit.
template <class Corner> bounds hull_of_corners(const bounds& x, const bounds& y, Corner corner) {
  bounds hull{infinity, -infinity};
  for (const double a : {x.lo, x.hi})
    for (const double b : {y.lo, y.hi}) {
      hull.lo = std::fmin(hull.lo, corner(a, b, MPFR_RNDD));
      hull.hi = std::fmax(hull.hi, corner(a, b, MPFR_RNDU));
    }
  return hull;
}

double product(double a, double b, mpfr_rnd_t to) {
  return a == 0 || b == 0 ? 0 : rounded(mpfr_mul, to, a, b);
}
/// b is a bound of a box to one side of 0; where it is 0, the quotient is unbounded towards the
/// side that the caller's box lies on.
double quotient(double a, double b, bool negative, mpfr_rnd_t to) {
  if (a == 0)
    return 0;
  return rounded(mpfr_div, to, a, b == 0 ? (negative ? -0.0 : 0.0) : b);
}

/// x y + z at a corner; 0 times an infinite bound is 0.
double fused(double a, double b, double c, mpfr_rnd_t to) {
  if (a == 0 || b == 0)
    return c;
  return rounded(mpfr_fma, to, a, b, c);
}

bool none(const bounds& x, const bounds& y) { return x.is_empty() || y.is_empty(); }

/// An increasing step function: its values are doubles.
bounds step(const bounds& x, int (*function)(mpfr_ptr, mpfr_srcptr)) {
  if (x.is_empty())
    return x;
  const auto at = [function](double t) {
    number n(t);
    function(n, n);
    return mpfr_get_d(n, MPFR_RNDN);
  };
  return {at(x.lo), at(x.hi)};
}

} // namespace

bounds pos(const bounds& x) { return x; }
bounds neg(const bounds& x) { return {-x.hi, -x.lo}; }
bounds add(const bounds& x, const bounds& y) {
  if (none(x, y))
    return bounds::empty();
  return {rounded_down(mpfr_add, x.lo, y.lo), rounded_up(mpfr_add, x.hi, y.hi)};
}
bounds sub(const bounds& x, const bounds& y) {
  if (none(x, y))
    return bounds::empty();
  return {rounded_down(mpfr_sub, x.lo, y.hi), rounded_up(mpfr_sub, x.hi, y.lo)};
}
bounds mul(const bounds& x, const bounds& y) {
  return none(x, y) ? bounds::empty() : hull_of_corners(x, y, product);
}
bounds div(const bounds& x, const bounds& y) {
  if (none(x, y) || (y.lo == 0 && y.hi == 0))
    return bounds::empty();
  if (y.lo < 0 && 0 < y.hi) {
    const bounds left = div(x, {y.lo, 0}), right = div(x, {0, y.hi});
    return {std::fmin(left.lo, right.lo), std::fmax(left.hi, right.hi)};
  }
  const bool negative = y.lo < 0;
  return hull_of_corners(x, y, [&](double a, double b, mpfr_rnd_t to) {
    return quotient(a, b, negative, to); // inf / inf: NaN, between the other corners
  });
}
bounds recip(const bounds& x) { return div({1, 1}, x); }
bounds sqr(const bounds& x) {
  if (x.is_empty())
    return x;
  const bounds ends = hull_of_corners(
      x, {1, 1}, [](double a, double, mpfr_rnd_t to) { return rounded(mpfr_sqr, to, a); });
  return x.contains(0) ? bounds{0, ends.hi} : ends;
}
bounds sqrt(const bounds& x) {
  if (x.is_empty() || x.hi < 0)
    return bounds::empty();
  return {x.lo > 0 ? rounded_down(mpfr_sqrt, x.lo) : 0, rounded_up(mpfr_sqrt, x.hi)};
}
bounds fma(const bounds& x, const bounds& y, const bounds& z) {
  if (none(x, y) || z.is_empty())
    return bounds::empty();
  const auto ends = [&](double c) {
    return hull_of_corners(x, y,
                           [c](double a, double b, mpfr_rnd_t to) { return fused(a, b, c, to); });
  };
  // an unbounded product does not meet an end of z of the other sign
  return {z.lo == -infinity ? z.lo : ends(z.lo).lo, z.hi == infinity ? z.hi : ends(z.hi).hi};
}
bounds abs(const bounds& x) {
  if (x.is_empty())
    return x;
  const double a = std::fabs(x.lo), b = std::fabs(x.hi);
  return {x.contains(0) ? 0 : std::fmin(a, b), std::fmax(a, b)};
}
bounds min(const bounds& x, const bounds& y) {
  return none(x, y) ? bounds::empty() : bounds{std::fmin(x.lo, y.lo), std::fmin(x.hi, y.hi)};
}
bounds max(const bounds& x, const bounds& y) {
  return none(x, y) ? bounds::empty() : bounds{std::fmax(x.lo, y.lo), std::fmax(x.hi, y.hi)};
}

bounds sign(const bounds& x) {
  return step(x, [](mpfr_ptr r, mpfr_srcptr a) { return mpfr_set_si(r, mpfr_sgn(a), MPFR_RNDN); });
}
bounds ceil(const bounds& x) { return step(x, mpfr_ceil); }
bounds floor(const bounds& x) { return step(x, mpfr_floor); }
bounds trunc(const bounds& x) { return step(x, mpfr_trunc); }
bounds round_ties_to_even(const bounds& x) {
  return step(x, [](mpfr_ptr r, mpfr_srcptr a) { return mpfr_roundeven(r, a); });
}
bounds round_ties_to_away(const bounds& x) { return step(x, mpfr_round); }

bounds intersection(const bounds& x, const bounds& y) {
  if (none(x, y) || x.hi < y.lo || y.hi < x.lo)
    return bounds::empty();
  return {std::fmax(x.lo, y.lo), std::fmin(x.hi, y.hi)};
}
bounds convex_hull(const bounds& x, const bounds& y) {
  return {std::fmin(x.lo, y.lo), std::fmax(x.hi, y.hi)}; // NaN is no number to fmin and fmax
}
bounds cancel_minus(const bounds& x, const bounds& y) {
  if (x.is_empty() && (y.is_empty() || y.is_common()))
    return bounds::empty();
  if (!x.is_common() || !y.is_common())
    return bounds::entire();
  const mpq_class lower = mpq_class(x.lo) - mpq_class(y.lo),
                  upper = mpq_class(x.hi) - mpq_class(y.hi);
  if (lower > upper)
    return bounds::entire();
  return {double_below(lower), double_above(upper)};
}
bounds cancel_plus(const bounds& x, const bounds& y) { return cancel_minus(x, neg(y)); }

} // namespace graze::oracle::ranges
