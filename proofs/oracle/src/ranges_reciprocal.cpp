#include <algorithm>
#include <cmath>
#include <gmpxx.h>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/ranges.hpp>

namespace graze::oracle::ranges {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr decoration trv = decoration::trv, dac = decoration::dac;

/// The multiples of pi/2 from x.lo to x.hi, ends included: the first and the last.
struct multiples {
  mpz_class first, last;
  [[nodiscard]] bool any(int residue, unsigned modulus) const {
    mpz_class next;
    mpz_fdiv_r_ui(next.get_mpz_t(), mpz_class(residue - first).get_mpz_t(), modulus);
    return first + next <= last;
  }
};
multiples multiples_in(const bounds& x) {
  const auto quotient = [](double t, mpfr_rnd_t to) {
    number q(1300);
    mpfr_const_pi(q, MPFR_RNDN);
    mpfr_d_div(q, t, q, MPFR_RNDN);
    mpfr_mul_2ui(q, q, 1, MPFR_RNDN);
    mpz_class whole;
    mpfr_get_z(whole.get_mpz_t(), q, to);
    return whole;
  };
  return {quotient(x.lo, MPFR_RNDU), quotient(x.hi, MPFR_RNDD)};
}

/// A zero bound is of either sign; the points below are not to see -0, where MPFR's poles differ.
bounds positive_zeros(const bounds& x) { return {x.lo == 0 ? 0 : x.lo, x.hi == 0 ? 0 : x.hi}; }

/// cot, sec, csc: poles at the multiples of pi/2 of one parity; for sec and csc extrema of 1 and -1
/// at the others, the one of value 1 at `top` mod 4.
template <class Function>
decorated circular(Function f, const bounds& x, bool odd_poles, bool extrema, int top) {
  if (x.is_empty())
    return {x, trv};
  if (x.lo == 0 && x.hi == 0)
    return odd_poles ? decorated{{1, 1}, dac} : decorated{bounds::empty(), trv};
  if (!x.is_common())
    return {bounds::entire(), trv};
  const multiples m = multiples_in(x);
  const bool pole = m.any(odd_poles ? 1 : 0, 2);
  const bool at_low = !odd_poles && x.lo == 0, at_high = !odd_poles && x.hi == 0;
  if (pole && !at_low && !at_high)
    return {bounds::entire(), trv};
  if (pole && (at_low ? m.last >= 2 : m.first <= -2)) // another one
    return {bounds::entire(), trv};
  bounds r{infinity, -infinity};
  const auto join = [&r](double low, double high) {
    r = {std::min(r.lo, low), std::max(r.hi, high)};
  };
  if (at_low)
    join(infinity, infinity);
  else
    join(rounded_down(f, x.lo), rounded_up(f, x.lo));
  if (at_high)
    join(-infinity, -infinity);
  else
    join(rounded_down(f, x.hi), rounded_up(f, x.hi));
  if (extrema && m.any(top, 4))
    join(1, 1);
  if (extrema && m.any(top + 2, 4))
    join(-1, -1);
  return {r, pole ? trv : dac};
}

template <class Function> decorated decreasing_off_zero(Function f, const bounds& given) {
  const bounds x = positive_zeros(given);
  if (x.is_empty() || (x.lo == 0 && x.hi == 0))
    return {bounds::empty(), trv};
  if (x.lo < 0 && 0 < x.hi)
    return {bounds::entire(), trv};
  return {
      {x.hi == 0 ? -infinity : rounded_down(f, x.hi), x.lo == 0 ? infinity : rounded_up(f, x.lo)},
      x.contains(0) ? trv : dac};
}

/// { f(t) : t in x } for f even, defined on the positive numbers, monotone there.
template <class Function> decorated even(Function f, const bounds& x, bool rising, double at_zero) {
  if (x.is_empty())
    return {x, trv};
  const double near = x.contains(0) ? 0 : std::min(std::fabs(x.lo), std::fabs(x.hi));
  const double far = std::max(std::fabs(x.lo), std::fabs(x.hi));
  const auto at = [&](double t) {
    return t == 0 ? bounds{at_zero, at_zero} : bounds{rounded_down(f, t), rounded_up(f, t)};
  };
  const bounds n = at(near), r = at(far);
  return {rising ? bounds{n.lo, r.hi} : bounds{r.lo, n.hi}, dac};
}

} // namespace

int mpfr_acoth(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) {
  if (mpfr_inf_p(x) != 0)
    return mpfr_set_zero(r, mpfr_sgn(x)), 0;
  if (mpfr_cmpabs_ui(x, 1) <= 0)
    return mpfr_set_nan(r), 0;
  for (mpfr_prec_t precision = 160;; precision *= 2) {
    number excess(mpfr_prec_t{1200}), t(precision);
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

int mpfr_acot(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to) {
  number one(1.0);
  return mpfr_atan2(r, one, x, to);
}

decorated cot(const bounds& x) { return circular(mpfr_cot, positive_zeros(x), false, false, 0); }
decorated sec(const bounds& x) { return circular(mpfr_sec, positive_zeros(x), true, true, 0); }
decorated csc(const bounds& x) { return circular(mpfr_csc, positive_zeros(x), false, true, 1); }
decorated acot(const bounds& x) {
  return x.is_empty() ? decorated{x, trv} : decorated{decreasing(mpfr_acot, x), dac};
}
decorated coth(const bounds& x) { return decreasing_off_zero(mpfr_coth, x); }
decorated sech(const bounds& x) { return even(mpfr_sech, x, false, 1); }
decorated csch(const bounds& x) { return decreasing_off_zero(mpfr_csch, x); }
decorated acoth(const bounds& x) {
  const bool left = x.lo < -1, right = x.hi > 1;
  if (!left && !right)
    return {bounds::empty(), trv};
  if (left && right)
    return {bounds::entire(), trv};
  const decoration local = x.lo > 1 || x.hi < -1 ? dac : trv;
  if (left)
    return {{x.hi < -1 ? rounded_down(mpfr_acoth, x.hi) : -infinity, rounded_up(mpfr_acoth, x.lo)},
            local};
  return {{rounded_down(mpfr_acoth, x.hi), x.lo > 1 ? rounded_up(mpfr_acoth, x.lo) : infinity},
          local};
}

decorated pown(const bounds& given, int n) {
  const bounds x = positive_zeros(given);
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) { return mpfr_pow_si(r, a, n, to); };
  if (x.is_empty())
    return {x, trv};
  if (n == 0)
    return {{1, 1}, dac};
  if (n % 2 != 0)
    return n > 0 ? decorated{increasing(f, x), dac} : decreasing_off_zero(f, x);
  if (n > 0)
    return even(f, x, true, 0);
  if (x.lo == 0 && x.hi == 0)
    return {bounds::empty(), trv};
  return {even(f, x, false, infinity).value, x.contains(0) ? trv : dac};
}

decorated rootn(const bounds& given, int n) {
  const bounds x = positive_zeros(given);
  const auto f = [n](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) {
    return mpfr_rootn_si(r, a, n, to);
  };
  if (x.is_empty() || n == 0)
    return {bounds::empty(), trv};
  if (n % 2 != 0)
    return n > 0 ? decorated{increasing(f, x), dac} : decreasing_off_zero(f, x);
  const decoration local = x.lo < 0 || (n < 0 && x.lo == 0) ? trv : dac;
  if (x.hi < 0 || (n < 0 && x.hi == 0))
    return {bounds::empty(), trv};
  const double low = x.lo > 0 ? x.lo : 0.0;
  if (n > 0)
    return {increasing(f, {low, x.hi}), local};
  return {{rounded_down(f, x.hi), low == 0 ? infinity : rounded_up(f, low)}, local};
}

} // namespace graze::oracle::ranges
