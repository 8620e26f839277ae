#pragma once
/// e^x at both ends of an interval. Internal.
#include <graze/bounds.hpp>

namespace graze::elementary {

/// {RD(e^lo), RU(e^hi)}, each by its correctly rounded function; empty for NaN.
bounds exponential_each(double lo, double hi);

#if defined(__x86_64__)
/// The same for processors with AVX2 and fused operations, in about half the time: both at once,
/// and each only where that cannot decide the rounding (1 in 60 intervals), an end is beyond +-708
/// or NaN, or the mode is not to nearest.
bounds exponential_pair(double lo, double hi);
/// Its fast part alone: empty where it does not decide. For tests.
bounds exponential_if_decided(double lo, double hi);
#endif

} // namespace graze::elementary
