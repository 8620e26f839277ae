#pragma once
/// The elementary functions at a point, rounded down (the greatest double that is not above the
/// value) and up, for every double. At infinities, at zeros of either sign, at poles and outside of
/// the domain: the values of C's functions of the same names (Annex F), such as log(0) = -inf,
/// log(-1) = NaN, atan2(0, -1) = pi, pow(0, 0) = 1. Error: 0 ulp. Each works in any rounding mode
/// and restores the mode and the exception flags that it found; no errno. Source: CORE-MATH, or
/// CRlibm where Graze is configured so (GRAZE_ELEMENTARY) and it has the function.
namespace graze::point {

double exp_down(double x);
double exp_up(double x);
double exp2_down(double x);
double exp2_up(double x);
double exp10_down(double x);
double exp10_up(double x);
/// e^x - 1.
double expm1_down(double x);
double expm1_up(double x);

double log_down(double x);
double log_up(double x);
double log2_down(double x);
double log2_up(double x);
double log10_down(double x);
double log10_up(double x);
/// log(1 + x).
double logp1_down(double x);
double logp1_up(double x);

double sin_down(double x);
double sin_up(double x);
double cos_down(double x);
double cos_up(double x);
double tan_down(double x);
double tan_up(double x);
double asin_down(double x);
double asin_up(double x);
double acos_down(double x);
double acos_up(double x);
double atan_down(double x);
double atan_up(double x);
/// The angle of (x, y), in [-pi, pi].
double atan2_down(double y, double x);
double atan2_up(double y, double x);

double sinh_down(double x);
double sinh_up(double x);
double cosh_down(double x);
double cosh_up(double x);
double tanh_down(double x);
double tanh_up(double x);
double asinh_down(double x);
double asinh_up(double x);
double acosh_down(double x);
double acosh_up(double x);
double atanh_down(double x);
double atanh_up(double x);

double cbrt_down(double x);
double cbrt_up(double x);
/// sqrt(x^2 + y^2).
double hypot_down(double x, double y);
double hypot_up(double x, double y);
/// x^y, as C's: (-2)^3 = -8.
double pow_down(double x, double y);
double pow_up(double x, double y);

/// "CORE-MATH" or "CRlibm": what serves the functions that both have.
const char* source();

} // namespace graze::point
