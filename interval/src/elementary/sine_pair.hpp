#pragma once
/// sin and cos at both ends of an interval, fast. Internal.
#include <graze/bounds.hpp>

#if defined(__x86_64__)
namespace graze::elementary {

/// The range of sin (shift = 0) or cos (shift = 1) over [lo, hi], for processors with AVX2 and
/// fused operations; empty where that is not decided: for an end NaN or not within 2^-12 and 1024
/// in size, |sin| or |cos| of an end below 2^-11, the mode not to nearest, and the rounding not
/// clear (1 in 500 intervals).
bounds wave_if_decided(double lo, double hi, int shift);
/// The range of tan over [lo, hi], in the same way; not decided where |tan| is beyond 2^10 either.
bounds tangent_if_decided(double lo, double hi);

} // namespace graze::elementary
#endif
