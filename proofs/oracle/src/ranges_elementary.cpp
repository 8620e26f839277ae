#include <algorithm>
#include <cmath>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/ranges.hpp>

namespace graze::oracle::ranges {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Increasing on the domain [lo, hi]; at its ends the value or the limit.
bounds rising(mpfr_function f, const bounds& x, double lo = -infinity, double hi = infinity,
              bool closed = true) {
  const bounds part{std::max(x.lo, lo), std::min(x.hi, hi)};
  const bool none = x.is_empty() || (closed ? part.lo > part.hi : x.hi <= lo || x.lo >= hi);
  return none ? bounds::empty() : increasing(f, part);
}

/// floor(2x/pi + shift), exactly: 1,300 bits leave 200 for the distance to the nearest multiple.
class quarters {
public:
  quarters(double x, int shift) : count_(1300) {
    mpfr_const_pi(count_, MPFR_RNDN);
    mpfr_d_div(count_, x, count_, MPFR_RNDN);
    mpfr_mul_2ui(count_, count_, 1, MPFR_RNDN);
    mpfr_add_si(count_, count_, shift, MPFR_RNDN);
    mpfr_floor(count_, count_);
  }
  /// Is there an integer k with a < k <= b and k mod 4 = residue?
  static bool between(quarters& a, quarters& b, unsigned long residue) {
    number k(1300);
    mpfr_sub_ui(k, b.count_, residue, MPFR_RNDN);
    mpfr_div_ui(k, k, 4, MPFR_RNDN);
    mpfr_floor(k, k);
    mpfr_mul_ui(k, k, 4, MPFR_RNDN);
    mpfr_add_ui(k, k, residue, MPFR_RNDN); // the greatest such k <= b
    return mpfr_greater_p(k, a.count_) != 0;
  }

private:
  number count_;
};

bounds wave(mpfr_function f, int shift, const bounds& x) {
  if (x.is_empty())
    return x;
  if (!x.is_common())
    return bounds{-1, 1};
  const bounds a = enclosed(f, x.lo), b = enclosed(f, x.hi);
  quarters from(x.lo, shift), to(x.hi, shift);
  return bounds{quarters::between(from, to, 3) ? -1 : std::min(a.lo, b.lo),
                quarters::between(from, to, 1) ? 1 : std::max(a.hi, b.hi)};
}

bounds joined(const bounds& a, const bounds& b) {
  if (a.is_empty() || b.is_empty())
    return a.is_empty() ? b : a;
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

} // namespace

bounds exp(const bounds& x) { return rising(mpfr_exp, x); }
bounds exp2(const bounds& x) { return rising(mpfr_exp2, x); }
bounds exp10(const bounds& x) { return rising(mpfr_exp10, x); }
bounds expm1(const bounds& x) { return rising(mpfr_expm1, x); }
bounds log(const bounds& x) { return rising(mpfr_log, x, 0, infinity, false); }
bounds log2(const bounds& x) { return rising(mpfr_log2, x, 0, infinity, false); }
bounds log10(const bounds& x) { return rising(mpfr_log10, x, 0, infinity, false); }
bounds logp1(const bounds& x) { return rising(mpfr_log1p, x, -1, infinity, false); }

bounds sin(const bounds& x) { return wave(mpfr_sin, 0, x); }
bounds cos(const bounds& x) { return wave(mpfr_cos, 1, x); }
bounds tan(const bounds& x) {
  if (x.is_empty())
    return x;
  if (!x.is_common())
    return bounds::entire();
  quarters from(x.lo, 0), to(x.hi, 0);
  if (quarters::between(from, to, 1) || quarters::between(from, to, 3))
    return bounds::entire();
  return increasing(mpfr_tan, x);
}
bounds asin(const bounds& x) { return rising(mpfr_asin, x, -1, 1); }
bounds acos(const bounds& x) {
  const bounds part{std::max(x.lo, -1.0), std::min(x.hi, 1.0)};
  return !x.is_empty() && part.lo <= part.hi ? decreasing(mpfr_acos, part) : bounds::empty();
}
bounds atan(const bounds& x) { return rising(mpfr_atan, x); }

/// The angle takes its extremes at the corners of the parts above and below the x axis. A corner
/// (0, 0) is no point, one at (inf, inf) no limit: the corners beside them have the extremes.
bounds atan2(const bounds& y, const bounds& x) {
  bounds range = bounds::empty();
  if (x.is_empty() || y.is_empty())
    return range;
  const auto corner = [&](double s, double t) {
    if ((s == 0 && t == 0) || (std::fabs(s) == infinity && std::fabs(t) == infinity))
      return;
    range = joined(range, enclosed(mpfr_atan2, s, t));
  };
  for (const double t : {x.lo, x.hi}) {
    if (y.hi >= 0) {
      corner(y.hi == 0 ? 0.0 : y.hi, t);
      corner(y.lo > 0 ? y.lo : 0.0, t);
    }
    if (y.lo < 0) {
      corner(y.lo, t);
      corner(y.hi < 0 ? y.hi : -0.0, t);
    }
  }
  return range;
}

bounds sinh(const bounds& x) { return rising(mpfr_sinh, x); }
bounds cosh(const bounds& x) {
  if (x.is_empty())
    return x;
  const bounds a = enclosed(mpfr_cosh, x.lo), b = enclosed(mpfr_cosh, x.hi);
  return {x.contains(0) ? 1 : std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}
bounds tanh(const bounds& x) { return rising(mpfr_tanh, x); }
bounds asinh(const bounds& x) { return rising(mpfr_asinh, x); }
bounds acosh(const bounds& x) { return rising(mpfr_acosh, x, 1); }
bounds atanh(const bounds& x) { return rising(mpfr_atanh, x, -1, 1, false); }
bounds cbrt(const bounds& x) { return rising(mpfr_cbrt, x); }

bounds hypot(const bounds& x, const bounds& y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  const bounds a = abs(x), b = abs(y);
  return {rounded_down(mpfr_hypot, a.lo, b.lo), rounded_up(mpfr_hypot, a.hi, b.hi)};
}

/// y log x takes its extremes at corners. 0^0 and inf^0 stand for the 1 = s^0 beside them, 1^inf
/// for 1^t.
bounds pow(const bounds& x, const bounds& y) {
  bounds range = bounds::empty();
  if (x.is_empty() || y.is_empty() || x.hi < 0)
    return range;
  if (x.hi == 0)
    return y.hi > 0 ? bounds{0, 0} : range;
  for (const double s : {std::max(x.lo, 0.0), x.hi})
    for (const double t : {y.lo, y.hi})
      range = joined(range, enclosed(mpfr_pow, s == 0 ? 0.0 : s, t));
  return range;
}

} // namespace graze::oracle::ranges
