#pragma once
/// The judge of float intervals: binary32 by MPFR, subnormal and overflowing results included. It
/// rounds to 24 bits at once; no double takes part.
#include <cmath>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/ranges.hpp>
#include <limits>
#include <optional>
#include <span>

namespace graze::oracle::binary32 {

/// A closed set of reals between two floats.
struct ends {
  float lo, hi;
  bool operator==(const ends&) const = default;
};
/// None: the empty set.
using set = std::optional<ends>;

/// The tightest floats about f(x...), for finite x; none where f has no value, poles included.
/// `function` is called as `rounded` calls it. About 1 us.
template <class Function, class... Floats> set enclosed(Function function, Floats... x) {
  if (!(std::isfinite(x) && ...))
    return {};
  constexpr float infinity = std::numeric_limits<float>::infinity();
  mpfr_clear_divby0();
  int inexact = 0;
  const auto observed = [&](mpfr_ptr result, auto... operands) {
    return inexact = function(result, operands...);
  };
  const float below = rounded_to<float>(observed, MPFR_RNDD, x...);
  if (below != below || mpfr_divby0_p() != 0)
    return {};
  // what is exact to MPFR may have no float of its own below 2^-126, where it is rounded again
  if (std::fabs(below) < 0x1p-125f)
    return ends{below, rounded_to<float>(function, MPFR_RNDU, x...)};
  return ends{below, inexact == 0 ? below : std::nextafter(below, infinity)};
}

/// A function of one argument, named as in graze::functions.
struct unary {
  const char* name;
  mpfr_function function;
};
/// All that IEEE 1788.1 has or recommends and Graze has: 41.
std::span<const unary> unary_functions();

} // namespace graze::oracle::binary32
