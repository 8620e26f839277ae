#pragma once
/// Exponentials and logarithms of intervals. Each is the tightest enclosure, 0 ulp per endpoint, of
/// its range over the members of x that are in its domain; empty if there is none.
///
/// | function        | encloses                             |
/// |-----------------|--------------------------------------|
/// | exp exp2 exp10  | { e^t, 2^t, 10^t : t in x }          |
/// | expm1           | { e^t - 1 : t in x }                 |
/// | log log2 log10  | { log t to that base : t in x, t > 0 } |
/// | logp1           | { log(1 + t) : t in x, t > -1 }      |
///
/// Source: CORE-MATH or CRlibm (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {
GRAZE_FOR_EACH_EXPONENTIAL(GRAZE_FUNCTION_OF_ONE)
}
GRAZE_FOR_EACH_EXPONENTIAL(GRAZE_BESIDE_BOOST)
} // namespace graze
