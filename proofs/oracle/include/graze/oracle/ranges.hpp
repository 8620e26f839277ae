#pragma once
/// The judge of functions of intervals: the tightest enclosure of each range over a box, its bounds
/// by MPFR at points where the range ends. Which points these are is found apart from the code
/// under test: corners, zeros, and extrema and poles located by MPFR in full. Named as in
/// graze::functions. Empty and unbounded operands are taken; a zero bound is of either sign.
#include <graze/bounds.hpp>
#include <graze/decoration.hpp>
#include <mpfr.h>

namespace graze::oracle::ranges {

// Arithmetic: src/ranges_arithmetic.cpp.
bounds pos(const bounds& x);
bounds neg(const bounds& x);
bounds add(const bounds& x, const bounds& y);
bounds sub(const bounds& x, const bounds& y);
bounds mul(const bounds& x, const bounds& y);
bounds div(const bounds& x, const bounds& y);
bounds recip(const bounds& x);
bounds sqr(const bounds& x);
bounds sqrt(const bounds& x);
bounds fma(const bounds& x, const bounds& y, const bounds& z);
bounds abs(const bounds& x);
bounds min(const bounds& x, const bounds& y);
bounds max(const bounds& x, const bounds& y);
bounds sign(const bounds& x);
bounds ceil(const bounds& x);
bounds floor(const bounds& x);
bounds trunc(const bounds& x);
bounds round_ties_to_even(const bounds& x);
bounds round_ties_to_away(const bounds& x);
bounds intersection(const bounds& x, const bounds& y);
bounds convex_hull(const bounds& x, const bounds& y);
/// Compares widths by rationals. Source: IEEE 1788-2015, 12.12.5.
bounds cancel_minus(const bounds& x, const bounds& y);
bounds cancel_plus(const bounds& x, const bounds& y);

// Elementary functions: src/ranges_elementary.cpp.
bounds exp(const bounds& x);
bounds exp2(const bounds& x);
bounds exp10(const bounds& x);
bounds expm1(const bounds& x);
bounds log(const bounds& x);
bounds log2(const bounds& x);
bounds log10(const bounds& x);
bounds logp1(const bounds& x);
bounds sin(const bounds& x);
bounds cos(const bounds& x);
bounds tan(const bounds& x);
bounds asin(const bounds& x);
bounds acos(const bounds& x);
bounds atan(const bounds& x);
bounds atan2(const bounds& y, const bounds& x);
bounds sinh(const bounds& x);
bounds cosh(const bounds& x);
bounds tanh(const bounds& x);
bounds asinh(const bounds& x);
bounds acosh(const bounds& x);
bounds atanh(const bounds& x);
bounds cbrt(const bounds& x);
bounds hypot(const bounds& x, const bounds& y);
bounds pow(const bounds& x, const bounds& y);

/// A range, and what should be said of the function on the box (trv or dac).
struct decorated {
  bounds value;
  decoration local;
};

// Reciprocal functions and integer powers: src/ranges_reciprocal.cpp.
decorated cot(const bounds& x);
decorated sec(const bounds& x);
decorated csc(const bounds& x);
decorated acot(const bounds& x);
decorated coth(const bounds& x);
decorated sech(const bounds& x);
decorated csch(const bounds& x);
decorated acoth(const bounds& x);
decorated pown(const bounds& x, int n);
decorated rootn(const bounds& x, int n);

/// acoth x = log1p(2/(x - 1))/2 for x > 1, odd; NaN for |x| <= 1. Correctly rounded by Ziv's
/// strategy.
int mpfr_acoth(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to);
/// acot x = atan2(1, x), in (0, pi).
int mpfr_acot(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t to);

} // namespace graze::oracle::ranges
