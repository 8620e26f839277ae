#pragma once
/// The elementary functions at a point, rounded down (the greatest double that is not above the
/// value) and up, for every double. At infinities, at zeros of either sign, at poles and outside of
/// the domain: the values of C's functions of the same names (Annex F), such as log(0) = -inf,
/// log(-1) = NaN, atan2(0, -1) = pi, pow(0, 0) = 1. Error: 0 ulp. Each works in any rounding mode
/// and restores the mode and the exception flags that it found; no errno. Source: CORE-MATH, or
/// CRlibm where Graze is configured so (GRAZE_ELEMENTARY) and it has the function.
#include <graze/functions/names.h>

namespace graze::point {

#define GRAZE_DECLARE(name) double name##_down(double x), name##_up(double x);
/// exp_down(x), exp_up(x), ...; expm1 is e^x - 1, logp1 log(1 + x).
GRAZE_FOR_EACH_POINT(GRAZE_DECLARE)
#undef GRAZE_DECLARE

/// The angle of (x, y), in [-pi, pi].
double atan2_down(double y, double x);
double atan2_up(double y, double x);
/// sqrt(x^2 + y^2).
double hypot_down(double x, double y);
double hypot_up(double x, double y);
/// x^y, as C's: (-2)^3 = -8.
double pow_down(double x, double y);
double pow_up(double x, double y);

/// "CORE-MATH" or "CRlibm": what serves the functions that both have.
const char* source();

} // namespace graze::point
