#pragma once
/// log x at both ends of an interval. Internal.
#include <graze/bounds.hpp>

namespace graze::elementary {

/// {RD(log lo), RU(log hi)} of [lo, hi] cut to x > 0, each by its correctly rounded function.
bounds logarithm_each(double lo, double hi);

#if defined(__x86_64__)
/// The same for processors with AVX2 and fused operations: both at once, and each only where that
/// cannot decide the rounding (1 in 1,000 intervals), |log| < 2^-11, an end is not normal and
/// positive, or the mode is not to nearest.
bounds logarithm_pair(double lo, double hi);
/// Its fast part alone: empty where it does not decide. For tests.
bounds logarithm_if_decided(double lo, double hi);
#endif

} // namespace graze::elementary
