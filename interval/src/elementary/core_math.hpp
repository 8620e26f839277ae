#pragma once
/// CORE-MATH's functions under the names that the archive gives them: for any x86-64, and for
/// processors with FMA.
#include <graze/functions/names.h>

#define GRAZE_BINARY_FUNCTIONS(X) X(atan2) X(hypot) X(pow)

extern "C" {
#define GRAZE_DECLARE(name) double graze_cr_##name(double), graze_cr_##name##_fma(double);
GRAZE_FOR_EACH_POINT(GRAZE_DECLARE)
#undef GRAZE_DECLARE
#define GRAZE_DECLARE(name)                                                                        \
  double graze_cr_##name(double, double), graze_cr_##name##_fma(double, double);
GRAZE_BINARY_FUNCTIONS(GRAZE_DECLARE)
#undef GRAZE_DECLARE
}
