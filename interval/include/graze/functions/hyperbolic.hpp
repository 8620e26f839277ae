#pragma once
/// Hyperbolic functions of intervals and their inverses. Each is the tightest enclosure, 0 ulp per
/// endpoint, of its range { f(t) : t in x } over the members of x that are in its domain; empty if there
/// is none. Domains: sinh, cosh, tanh, asinh all numbers; acosh t >= 1; atanh |t| < 1.
/// Source: CORE-MATH or CRlibm (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {
GRAZE_FOR_EACH_HYPERBOLIC(GRAZE_FUNCTION_OF_ONE)
}
GRAZE_FOR_EACH_HYPERBOLIC(GRAZE_BESIDE_BOOST)
} // namespace graze
