#include <algorithm>
#include <cmath>
#include <graze/oracle/mpfr_number.hpp>
#include <graze/oracle/reverse_operands.hpp>
#include <limits>

namespace graze::oracle::reverse {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The least solution at or after x.lo, rounded down; NaN if it is after x.hi. x.lo is finite.
double least(wave f, const bounds& c, const bounds& x) {
  // asin(y) - y is about y^3/6: 2 bits for each by which y is small.
  mpfr_prec_t precision = 300 + (x.lo == 0 ? 0 : std::max(0, std::ilogb(x.lo)));
  for (const double end : {c.lo, c.hi})
    if (end != 0 && std::isfinite(end))
      precision = std::max<mpfr_prec_t>(precision, 300 - 2 * std::ilogb(end));
  number a(precision), b(precision), period(precision), k(precision), lo(precision), hi(precision),
      best(precision);
  mpfr_const_pi(period, MPFR_RNDN);
  bool found = false;
  const auto consider = [&](int branch) {
    // One interval [a, b] of solutions.
    const double from = std::max(c.lo, f == wave::tan ? -infinity : -1.0);
    const double to = std::min(c.hi, f == wave::tan ? infinity : 1.0);
    const auto inverse = f == wave::sin ? mpfr_asin : f == wave::cos ? mpfr_acos : mpfr_atan;
    mpfr_set_d(a, f == wave::cos ? to : from, MPFR_RNDN);
    mpfr_set_d(b, f == wave::cos ? from : to, MPFR_RNDN);
    inverse(a, a, MPFR_RNDN);
    inverse(b, b, MPFR_RNDN);
    if (branch == 1) { // its mirror image: about pi/2 for sin, about 0 for cos
      mpfr_neg(a, a, MPFR_RNDN);
      mpfr_neg(b, b, MPFR_RNDN);
      mpfr_swap(a, b);
      if (f == wave::sin) {
        mpfr_const_pi(k, MPFR_RNDN);
        mpfr_add(a, a, k, MPFR_RNDN);
        mpfr_add(b, b, k, MPFR_RNDN);
      }
    }
    // The first of the intervals moved by k periods that ends at or after x.lo.
    mpfr_d_sub(k, x.lo, b, MPFR_RNDN);
    mpfr_div(k, k, period, MPFR_RNDN);
    mpfr_floor(k, k);
    for (;; mpfr_add_ui(k, k, 1, MPFR_RNDN)) {
      mpfr_fma(hi, k, period, b, MPFR_RNDN);
      if (mpfr_cmp_d(hi, x.lo) >= 0)
        break;
    }
    mpfr_fma(lo, k, period, a, MPFR_RNDN);
    if (mpfr_cmp_d(lo, x.lo) < 0)
      mpfr_set_d(lo, x.lo, MPFR_RNDN);
    if (!found || mpfr_cmp(lo, best) < 0)
      mpfr_set(best, lo, MPFR_RNDN);
    found = true;
  };
  if (f != wave::tan)
    mpfr_mul_2ui(period, period, 1, MPFR_RNDN);
  consider(0);
  if (f != wave::tan)
    consider(1);
  if (mpfr_cmp_d(best, x.hi) > 0)
    return std::numeric_limits<double>::quiet_NaN();
  return mpfr_get_d(best, MPFR_RNDD);
}

bounds solutions(wave f, const bounds& c, const bounds& x) {
  if (c.is_empty() || x.is_empty() || (f != wave::tan && (c.lo > 1 || c.hi < -1)))
    return bounds::empty();
  const bounds mirrored_c = f == wave::cos ? c : bounds{-c.hi, -c.lo};
  const double lo = x.lo == -infinity ? -infinity : least(f, c, x);
  const double hi = x.hi == infinity ? infinity : -least(f, mirrored_c, {-x.hi, -x.lo});
  return lo != lo || hi != hi ? bounds::empty() : bounds{lo, hi};
}

} // namespace

bounds sin_rev(const bounds& c, const bounds& x) { return solutions(wave::sin, c, x); }
bounds cos_rev(const bounds& c, const bounds& x) { return solutions(wave::cos, c, x); }
bounds tan_rev(const bounds& c, const bounds& x) { return solutions(wave::tan, c, x); }

} // namespace graze::oracle::reverse
