#pragma once
/// A ray's direction times a power of two: the same half-line {o + t d : t >= 0}, in numbers whose
/// products do not underflow or overflow where that can be had for nothing.
///
/// The sound test multiplies two components of the direction, and their product by a distance.
/// With components of 1e-300 or of 1e200 that leaves no bound worth having, though never a wrong
/// one; so bounds are prepared from the scaled direction. Exact decisions, and every t that a user
/// gives or gets, are of the direction as given.
#include <cstdint>
#include <graze/octree/vector.hpp>

namespace graze::octree {

/// Powers of two, one the other's inverse, both normal numbers:
/// o + t d = o + (t of_parameter) (d of_direction).
struct scaling {
  double of_direction;
  double of_parameter;
};

/// The power of two that takes the greatest of |x|, |y|, |z| into [1, 2), where each component
/// times it is exact. Scaling up is always exact. It goes up by 2^1022 at the most: subnormal
/// directions end in [2^-52, 1). It goes down as far as no component but 0 falls below the normal
/// numbers, by 2^1022 at the most: where components lie further apart than the normal numbers
/// reach, the greatest stays above 2.
/// In integers, so that no rounding mode matters, no flag for subnormal numbers, and no component
/// decides a jump. Always inline, for files that are compiled for one path's instructions.
[[gnu::always_inline]] inline scaling scaling_of(double x, double y, double z) {
  const double d[3] = {x, y, z};
  // biased exponents, those of subnormal numbers counted as 1
  std::int64_t greatest = 1, least = 1023;
  for (unsigned a = 0; a < 3; ++a) {
    const std::uint64_t twice = __builtin_bit_cast(std::uint64_t, d[a]) << 1; // no sign
    const auto e = static_cast<std::int64_t>(twice >> 53);
    greatest = greatest < e ? e : greatest;
    const std::int64_t loses_below = twice == 0 ? 1023 : (e == 0 ? 1 : e);
    least = loses_below < least ? loses_below : least;
  }
  const std::int64_t down = greatest - 1023 < least - 1 ? greatest - 1023 : least - 1;
  return {__builtin_bit_cast(double, (1023 - down) << 52),
          __builtin_bit_cast(double, (1023 + down) << 52)};
}

/// The direction times its scale, exactly.
[[gnu::always_inline]] inline vec3 scaled_direction(const vec3& d) {
  const double factor = scaling_of(d[0], d[1], d[2]).of_direction;
  return {d[0] * factor, d[1] * factor, d[2] * factor};
}

} // namespace graze::octree
