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

/// 1 for an ordinary direction, whose greatest component is in [2^-64, 2^64). For another, the
/// power of two that takes the greatest component into [1, 2), as far as each component times it is
/// exact. Scaling up always is; it goes up by 2^1022 at the most: subnormal directions end in
/// [2^-52, 1). It goes down by 2^1022 at the most, and only as far as no component but 0 falls
/// below the normal numbers: where components lie further apart than those reach, the greatest
/// stays above 2. In integers, so that no rounding mode matters and no flag for subnormal numbers.
/// Always inline, for files that are compiled for one path's instructions.
[[gnu::always_inline]] inline scaling scaling_of(double x, double y, double z) {
  // twice the bits: no sign, and the order is that of magnitudes
  const std::uint64_t bits[3] = {__builtin_bit_cast(std::uint64_t, x) << 1,
                                 __builtin_bit_cast(std::uint64_t, y) << 1,
                                 __builtin_bit_cast(std::uint64_t, z) << 1};
  std::uint64_t most = bits[0] < bits[1] ? bits[1] : bits[0];
  most = most < bits[2] ? bits[2] : most;
  constexpr std::uint64_t ordinary_from = std::uint64_t{1023 - 64} << 53,
                          ordinary_to = std::uint64_t{1023 + 64} << 53;
  if (most - ordinary_from < ordinary_to - ordinary_from) [[likely]]
    return {1, 1};
  // biased exponents, those of subnormal numbers counted as 1
  const std::int64_t greatest = most >> 53 == 0 ? 1 : static_cast<std::int64_t>(most >> 53);
  std::int64_t least = 1023; // of what may not become subnormal
  for (const std::uint64_t b : bits) {
    const auto e = static_cast<std::int64_t>(b >> 53);
    least = b != 0 && e < least ? (e == 0 ? 1 : e) : least;
  }
  const std::int64_t down = greatest - 1023 < least - 1 ? greatest - 1023 : least - 1;
  return {__builtin_bit_cast(double, (1023 - down) << 52),
          __builtin_bit_cast(double, (1023 + down) << 52)};
}

/// The direction times its scaling, exactly.
[[gnu::always_inline]] inline vec3 scaled_direction(const vec3& d) {
  const double by = scaling_of(d[0], d[1], d[2]).of_direction;
  if (by == 1)
      [[likely]] // the same jump as in scaling_of: no product for ordinary rays to wait for
    return d;
  return {d[0] * by, d[1] * by, d[2] * by};
}

} // namespace graze::octree
