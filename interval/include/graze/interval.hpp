#pragma once
/// Intervals with bounds that hold: graze::interval<Backend>, its arithmetic, comparisons, text,
/// and every function of IEEE 1788.1 (but for `overlap`, which is another function in
/// Boost.Interval: graze/overlap.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/boolean.hpp>
#include <graze/decorated_functions.hpp>
#include <graze/interval_type.hpp>
#include <graze/numeric.hpp>
#include <graze/text.hpp>
#include <version>
#if defined(__cpp_lib_format)
#include <graze/format.hpp>
#endif

namespace graze {
// graze::pow(x, 7) and graze::pow(x, 2.5) beside the power of two intervals
using boost::numeric::fmod;
using boost::numeric::pow;
} // namespace graze
