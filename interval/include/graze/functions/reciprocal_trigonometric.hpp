#pragma once
/// cot, sec, csc and acot of intervals. Error: 0 ulp per endpoint, for arguments of any size.
///
/// | function | domain               | range                 | monotone                            |
/// |----------|----------------------|-----------------------|-------------------------------------|
/// | cot      | t != k pi            | R                     | decreasing between poles            |
/// | sec      | t != (k + 1/2) pi    | (-inf, -1] u [1, inf) | between multiples of pi/2           |
/// | csc      | t != k pi            | (-inf, -1] u [1, inf) | between multiples of pi/2           |
/// | acot     | R                    | (0, pi)               | decreasing; continuous, also at 0   |
///
/// Source: graze/point_rare.hpp at the endpoints; poles and extrema from the endpoints' quadrants,
/// which are exact, since 0 is the only double that is a multiple of pi/2.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {
GRAZE_FOR_EACH_RECIPROCAL_TRIGONOMETRIC(GRAZE_FUNCTION_OF_ONE)
}
GRAZE_FOR_EACH_RECIPROCAL_TRIGONOMETRIC(GRAZE_BESIDE_BOOST)
} // namespace graze
