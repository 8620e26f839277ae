#pragma once
/// CORE-MATH's functions under the names that the archive gives them: for any x86-64, and for
/// processors with FMA.

// clang-format off
#define GRAZE_UNARY_FUNCTIONS(X)                                                                   \
  X(exp) X(exp2) X(exp10) X(expm1) X(log) X(log2) X(log10) X(log1p) X(sin) X(cos) X(tan) X(asin)   \
  X(acos) X(atan) X(sinh) X(cosh) X(tanh) X(asinh) X(acosh) X(atanh) X(cbrt)
// clang-format on
#define GRAZE_BINARY_FUNCTIONS(X) X(atan2) X(hypot) X(pow)

extern "C" {
#define GRAZE_DECLARE(name) double graze_cr_##name(double), graze_cr_##name##_fma(double);
GRAZE_UNARY_FUNCTIONS(GRAZE_DECLARE)
#undef GRAZE_DECLARE
#define GRAZE_DECLARE(name)                                                                        \
  double graze_cr_##name(double, double), graze_cr_##name##_fma(double, double);
GRAZE_BINARY_FUNCTIONS(GRAZE_DECLARE)
#undef GRAZE_DECLARE
}
