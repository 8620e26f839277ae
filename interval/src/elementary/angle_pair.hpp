#pragma once
/// atan2 at two corners of a box, fast. Internal.
#include <graze/bounds.hpp>

#if defined(__x86_64__)
namespace graze::elementary {

/// The range of atan2 over y x x, not empty, y not [0, 0], without points on both sides of the cut;
/// for processors with AVX2 and fused operations. Empty where that is not decided: for a coordinate
/// of a corner that is needed not within 2^-100 and 2^100 in size, an angle below 2^-19, the mode
/// not to nearest, and the rounding not clear (1 in 10^5 boxes).
bounds angle_if_decided(double y_lo, double y_hi, double x_lo, double x_hi);

} // namespace graze::elementary
#endif
