#pragma once
/// coth, sech, csch and acoth of intervals. Error: 0 ulp per endpoint.
///
/// | function | domain    | range                | monotone                          |
/// |----------|-----------|----------------------|-----------------------------------|
/// | coth     | R \ { 0 } | (-inf, -1) u (1, inf) | decreasing on each side of 0     |
/// | sech     | R         | (0, 1]               | increasing to 0, then decreasing  |
/// | csch     | R \ { 0 } | R \ { 0 }            | decreasing on each side of 0      |
/// | acoth    | |x| > 1   | R \ { 0 }            | decreasing on each side           |
///
/// Source: graze/point_rare.hpp at the endpoints.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {
GRAZE_FOR_EACH_RECIPROCAL_HYPERBOLIC(GRAZE_FUNCTION_OF_ONE)
}
GRAZE_FOR_EACH_RECIPROCAL_HYPERBOLIC(GRAZE_BESIDE_BOOST)
} // namespace graze
