#pragma once
/// The judge of functions: any of MPFR's, or a composition of them, rounded to binary64 (or
/// binary32) in a given direction.
#include <cmath>
#include <graze/bounds.hpp>
#include <graze/oracle/mpfr_number.hpp>
#include <limits>

namespace graze::oracle {

/// f(x...) correctly rounded to a Number (float or double); otherwise as `rounded`.
template <std::floating_point Number, class Function, class... Operands>
Number rounded_to(Function function, mpfr_rnd_t to, Operands... x) {
  const auto evaluate = [&](auto&&... operands) {
    number result(std::numeric_limits<Number>::digits);
    const range_of<Number> range;
    int ternary = function(static_cast<mpfr_ptr>(result), static_cast<mpfr_ptr>(operands)..., to);
    ternary = mpfr_check_range(result, ternary, to);
    mpfr_subnormalize(result, ternary, to);
    return static_cast<Number>(mpfr_get_d(result, to)); // exact
  };
  return evaluate(number(static_cast<double>(x))...);
}

/// f(x...) correctly rounded to a double in the direction `to`, subnormal and overflowing results
/// included; NaN where MPFR says so. `function` is called as function(result, x..., to) and returns
/// MPFR's ternary value, as MPFR's own functions do: rounded(mpfr_exp, MPFR_RNDU, x). Integers are
/// captured: rounded([n](auto r, auto a, auto to) { return mpfr_pow_si(r, a, n, to); }, to, x).
/// Any thread, any rounding mode. From 1 us to, for huge arguments, 100 us.
template <class Function, class... Doubles>
double rounded(Function function, mpfr_rnd_t to, Doubles... x) {
  return rounded_to<double>(function, to, x...);
}
template <class Function, class... Doubles> double rounded_down(Function function, Doubles... x) {
  return rounded(function, MPFR_RNDD, x...);
}
template <class Function, class... Doubles> double rounded_up(Function function, Doubles... x) {
  return rounded(function, MPFR_RNDU, x...);
}

/// Both directions in one evaluation: {f(x...) rounded down, and up}.
template <class Function, class... Doubles> bounds enclosed(Function function, Doubles... x) {
  int inexact = 0;
  const auto observed = [&](mpfr_ptr result, auto... operands) {
    return inexact = function(result, operands...);
  };
  const double below = rounded(observed, MPFR_RNDD, x...);
  // A value that MPFR gives exactly may have no double of its own: below 2^-1022 it is rounded
  // again.
  if (inexact == 0 && (std::fabs(below) >= 0x1p-1021 || below != below))
    return {below, below};
  if (std::fabs(below) < 0x1p-1021)
    return {below, rounded(function, MPFR_RNDU, x...)};
  return {below, std::nextafter(below, std::numeric_limits<double>::infinity())};
}

/// The tightest enclosure of f over x, for f defined and increasing on x (decreasing: exchange the
/// ends); at infinite ends the limits as MPFR has them.
template <class Function> bounds increasing(Function function, const bounds& x) {
  return {rounded_down(function, x.lo), rounded_up(function, x.hi)};
}
template <class Function> bounds decreasing(Function function, const bounds& x) {
  return {rounded_down(function, x.hi), rounded_up(function, x.lo)};
}

} // namespace graze::oracle
