#pragma once
/* The elementary functions of one argument, listed once, for C as well: structs and overloads, functions at
 * a point, functions in C and tests are made of these lists. A new function is a name here, its value at a
 * point (interval/src/elementary/correctly_rounded.hpp, or a file of interval/src/functions where CORE-MATH
 * lacks it) and its range (interval/src/functions). */

/* clang-format off */
#define GRAZE_FOR_EACH_EXPONENTIAL(f) \
  f(exp) f(exp2) f(exp10) f(expm1) f(log) f(log2) f(log10) f(logp1)
#define GRAZE_FOR_EACH_TRIGONOMETRIC(f) \
  f(sin) f(cos) f(tan) f(asin) f(acos) f(atan)
#define GRAZE_FOR_EACH_HYPERBOLIC(f) \
  f(sinh) f(cosh) f(tanh) f(asinh) f(acosh) f(atanh)
#define GRAZE_FOR_EACH_RECIPROCAL_TRIGONOMETRIC(f) \
  f(cot) f(sec) f(csc) f(acot)
#define GRAZE_FOR_EACH_RECIPROCAL_HYPERBOLIC(f) \
  f(coth) f(sech) f(csch) f(acoth)

/* From CORE-MATH. */
#define GRAZE_FOR_EACH_POINT(f) \
  GRAZE_FOR_EACH_EXPONENTIAL(f) GRAZE_FOR_EACH_TRIGONOMETRIC(f) GRAZE_FOR_EACH_HYPERBOLIC(f) f(cbrt)
/* What CORE-MATH lacks. */
#define GRAZE_FOR_EACH_POINT_RARE(f) \
  GRAZE_FOR_EACH_RECIPROCAL_TRIGONOMETRIC(f) GRAZE_FOR_EACH_RECIPROCAL_HYPERBOLIC(f)
#define GRAZE_FOR_EACH_ELEMENTARY(f) GRAZE_FOR_EACH_POINT(f) GRAZE_FOR_EACH_POINT_RARE(f)

/* Those that Boost.Interval has. */
#define GRAZE_FOR_EACH_OF_BOOST(f) \
  f(exp) f(log) GRAZE_FOR_EACH_TRIGONOMETRIC(f) GRAZE_FOR_EACH_HYPERBOLIC(f)
/* clang-format on */
