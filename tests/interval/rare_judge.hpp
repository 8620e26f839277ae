#pragma once
/// The judge of the rare functions: MPFR at points, and ranges put together from points with poles
/// and extrema located by MPFR in full, apart from the code under test.
#include "rare_inputs.hpp"
#include <graze/oracle/elementary.hpp>
#include <graze/point_rare.hpp>
#include <iomanip>
#include <sstream>

namespace graze::test {

/// acoth x = log1p(2/(x - 1))/2 for x > 1, odd; correctly rounded by Ziv's strategy.
inline int judge_acoth(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) {
  if (mpfr_inf_p(x) != 0)
    return mpfr_set_zero(r, mpfr_sgn(x)), 0;
  if (mpfr_cmpabs_ui(x, 1) <= 0)
    return mpfr_set_nan(r), 0;
  for (mpfr_prec_t precision = 160;; precision *= 2) {
    oracle::number excess(mpfr_prec_t{1200}), t(precision);
    mpfr_abs(excess, x, MPFR_RNDN);
    mpfr_sub_ui(excess, excess, 1, MPFR_RNDN); // exact
    mpfr_ui_div(t, 2, excess, MPFR_RNDN);
    mpfr_log1p(t, t, MPFR_RNDN);
    mpfr_div_2ui(t, t, 1, MPFR_RNDN);
    mpfr_setsign(t, t, mpfr_sgn(x) < 0 ? 1 : 0, MPFR_RNDN);
    // never a double: beyond 1074 bits, no result of this precision is within its error of one
    if (mpfr_can_round(t, precision - 8, MPFR_RNDN, to, 53) != 0)
      return mpfr_set(r, t, to);
  }
}

/// acot x = atan2(1, x), in (0, pi).
inline int judge_acot(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) {
  oracle::number one(1.0);
  return mpfr_atan2(r, one, x, to);
}

template <class Function> point::directed judged(Function f, double x) {
  return {oracle::rounded_down(f, x), oracle::rounded_up(f, x)};
}
inline point::directed judged_power(double x, int n) {
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) { return mpfr_pow_si(r, a, n, to); };
  return judged(f, x);
}
inline point::directed judged_root(double x, int n) {
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) {
    return mpfr_rootn_si(r, a, n, to);
  };
  return judged(f, x);
}

inline bool same(double a, double b) { return a == b || (a != a && b != b); }
inline bool same(const bounds& a, const bounds& b) { return same(a.lo, b.lo) && same(a.hi, b.hi); }
inline bool same(const point::directed& a, const point::directed& b) {
  return same(a.down, b.down) && same(a.up, b.up);
}

/// Counts and prints the first differences.
class verdicts {
public:
  explicit verdicts(std::string name) : name_(std::move(name)) {}

  void see(double x, const point::directed& got, const point::directed& want, int n = 0) {
    if (!same(got, want))
      report({x, x}, n, {got.down, got.up}, {want.down, want.up});
  }
  void see(const bounds& x, const bounds& got, const bounds& want, int n = 0) {
    if (!same(got, want))
      report(x, n, got, want);
  }
  /// Empty if all was right.
  [[nodiscard]] std::string text() const { return text_.str(); }

private:
  void report(const bounds& x, int n, const bounds& got, const bounds& want) {
    if (++wrong_ <= 10) {
      text_ << std::hexfloat << name_ << "[" << x.lo << ", " << x.hi << "] n = " << n << ": got ["
            << got.lo << ", " << got.hi << "], MPFR [" << want.lo << ", " << want.hi << "]"
            << (want.within(got) ? " loose" : " UNSOUND") << "\n";
    }
  }
  std::string name_;
  std::ostringstream text_;
  std::size_t wrong_ = 0;
};

} // namespace graze::test
