#pragma once
/// The one list of functions: a new family is one include and one line.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/arithmetic.hpp>
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/integer_power.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/reciprocal_hyperbolic.hpp>
#include <graze/functions/reciprocal_trigonometric.hpp>
#include <graze/functions/reverse.hpp>
#include <graze/functions/sets.hpp>
#include <graze/functions/trigonometric.hpp>

/// f(name) for every struct of graze::functions whose value() gives one set of bounds.
// clang-format off
#define GRAZE_FOR_EACH_FUNCTION(f)                                                                 \
  f(pos) f(neg) f(add) f(sub) f(mul) f(div) f(recip) f(sqr) f(sqrt) f(fma) f(abs) f(min) f(max)    \
  f(sign) f(ceil) f(floor) f(trunc) f(round_ties_to_even) f(round_ties_to_away)                    \
  f(intersection) f(convex_hull) f(cancel_plus) f(cancel_minus)                                    \
  GRAZE_FOR_EACH_ELEMENTARY(f) f(atan2) f(hypot) f(pow) f(pown) f(rootn)                           \
  f(sqr_rev) f(abs_rev) f(pown_rev) f(sin_rev) f(cos_rev) f(tan_rev) f(cosh_rev) f(mul_rev)        \
  f(pow_rev1) f(pow_rev2)
// clang-format on
