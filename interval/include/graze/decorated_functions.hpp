#pragma once
/// The one list of functions: every family's header, and a macro that names each function that it
/// declares. A new family is one include and one line.
#include <graze/functions/arithmetic.hpp>
#include <graze/functions/sets.hpp>
#if __has_include(<graze/functions/exponential.hpp>)
#include <graze/functions/exponential.hpp>
#define GRAZE_EXPONENTIAL(f) f(exp) f(exp2) f(exp10) f(expm1) f(log) f(log2) f(log10) f(logp1)
#else
#define GRAZE_EXPONENTIAL(f)
#endif
#if __has_include(<graze/functions/trigonometric.hpp>)
#include <graze/functions/trigonometric.hpp>
#define GRAZE_TRIGONOMETRIC(f) f(sin) f(cos) f(tan) f(asin) f(acos) f(atan) f(atan2)
#else
#define GRAZE_TRIGONOMETRIC(f)
#endif
#if __has_include(<graze/functions/hyperbolic.hpp>)
#include <graze/functions/hyperbolic.hpp>
#define GRAZE_HYPERBOLIC(f) f(sinh) f(cosh) f(tanh) f(asinh) f(acosh) f(atanh)
#else
#define GRAZE_HYPERBOLIC(f)
#endif
#if __has_include(<graze/functions/power.hpp>)
#include <graze/functions/power.hpp>
#define GRAZE_POWER(f) f(cbrt) f(hypot) f(pow)
#else
#define GRAZE_POWER(f)
#endif
#if __has_include(<graze/functions/integer_power.hpp>)
#include <graze/functions/integer_power.hpp>
#define GRAZE_INTEGER_POWER(f) f(pown) f(rootn)
#else
#define GRAZE_INTEGER_POWER(f)
#endif
#if __has_include(<graze/functions/reciprocal_trigonometric.hpp>)
#include <graze/functions/reciprocal_trigonometric.hpp>
#define GRAZE_RECIPROCAL_TRIGONOMETRIC(f) f(cot) f(sec) f(csc) f(acot)
#else
#define GRAZE_RECIPROCAL_TRIGONOMETRIC(f)
#endif
#if __has_include(<graze/functions/reciprocal_hyperbolic.hpp>)
#include <graze/functions/reciprocal_hyperbolic.hpp>
#define GRAZE_RECIPROCAL_HYPERBOLIC(f) f(coth) f(sech) f(csch) f(acoth)
#else
#define GRAZE_RECIPROCAL_HYPERBOLIC(f)
#endif
#if __has_include(<graze/functions/reverse.hpp>)
#include <graze/functions/reverse.hpp>
#define GRAZE_REVERSE(f)                                                                           \
  f(sqr_rev) f(abs_rev) f(pown_rev) f(sin_rev) f(cos_rev) f(tan_rev) f(cosh_rev) f(mul_rev)        \
      f(pow_rev1) f(pow_rev2)
#else
#define GRAZE_REVERSE(f)
#endif

#define GRAZE_ARITHMETIC(f)                                                                        \
  f(pos) f(neg) f(add) f(sub) f(mul) f(div) f(recip) f(sqr) f(sqrt) f(fma) f(abs) f(min) f(max)    \
      f(sign) f(ceil) f(floor) f(trunc) f(round_ties_to_even) f(round_ties_to_away)
#define GRAZE_SETS(f) f(intersection) f(convex_hull) f(cancel_plus) f(cancel_minus)

/// f(name) for every struct of graze::functions whose value() gives one set of bounds.
#define GRAZE_FOR_EACH_FUNCTION(f)                                                                 \
  GRAZE_ARITHMETIC(f)                                                                              \
  GRAZE_SETS(f)                                                                                    \
  GRAZE_EXPONENTIAL(f)                                                                             \
  GRAZE_TRIGONOMETRIC(f)                                                                           \
  GRAZE_HYPERBOLIC(f)                                                                              \
  GRAZE_POWER(f)                                                                                   \
  GRAZE_INTEGER_POWER(f)                                                                           \
  GRAZE_RECIPROCAL_TRIGONOMETRIC(f)                                                                \
  GRAZE_RECIPROCAL_HYPERBOLIC(f)                                                                   \
  GRAZE_REVERSE(f)
