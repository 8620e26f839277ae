#pragma once
/// e^x at both ends of an interval at once. Internal.
#include <graze/bounds.hpp>

namespace graze::elementary {

#if defined(__x86_64__)
/// {RD(e^x.lo), RU(e^x.hi)} into `result`, in about half the time of two calls of a correctly
/// rounded function; false, and no result, for about 1 in 60 intervals whose rounding it cannot
/// decide, where an end is beyond +-708 or NaN, and in any mode but to nearest. For processors with
/// AVX2 and fused operations. Error: 0 ulp.
bool exponential_pair(const bounds& x, bounds& result);
#endif

} // namespace graze::elementary
