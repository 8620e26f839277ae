#pragma once
/// A ray's direction times a power of two: the same half-line {o + t d : t >= 0}, in numbers whose
/// products do not underflow or overflow where that can be had for nothing.
///
/// The sound test multiplies two components of the direction, and their product by a distance.
/// With components of 1e-300 or of 1e200 that leaves no bound worth having, though never a wrong
/// one; so bounds are prepared from the scaled direction. Exact decisions, and every t that a user
/// gives or gets, are of the direction as given.
#include <graze/needs_cxx20.hpp>

#include <cstdint>
#include <graze/octree/vector.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::octree {

/// Powers of two, one the other's inverse, both normal numbers:
/// o + t d = o + (t of_parameter) (d of_direction).
struct scaling {
  double of_direction;
  double of_parameter;
};

/// The greatest of |x|, |y|, |z| is in [2^-64, 2^64).
[[gnu::always_inline]] inline bool is_ordinary(double x, double y, double z) {
  // twice the bits: no sign, and the order is that of magnitudes
  const std::uint64_t bits_x = __builtin_bit_cast(std::uint64_t, x) << 1,
                      bits_y = __builtin_bit_cast(std::uint64_t, y) << 1,
                      bits_z = __builtin_bit_cast(std::uint64_t, z) << 1;
  const std::uint64_t xy = bits_x < bits_y ? bits_y : bits_x, most = xy < bits_z ? bits_z : xy;
  constexpr std::uint64_t from = std::uint64_t{1023 - 64} << 53,
                          to = std::uint64_t{1023 + 64} << 53;
  return most - from < to - from;
}

/// 1 for an ordinary direction. For another, the power of two that takes the greatest component
/// into [1, 2), as far as each component times it is exact. Scaling up always is; it goes up by
/// 2^1022 at the most: subnormal directions end in [2^-52, 1). It goes down by 2^1022 at the most,
/// and only as far as no component but 0 falls below the normal numbers: where components lie
/// further apart than those reach, the greatest stays above 2.
/// In integers, so that no rounding mode matters and no flag for subnormal numbers. Always inline,
/// for files that are compiled for one path's instructions.
[[gnu::always_inline]] inline scaling scaling_of(double x, double y, double z) {
  if (is_ordinary(x, y, z)) [[likely]]
    return {1, 1};
  // biased exponents, those of subnormal numbers counted as 1
  std::int64_t greatest = 1, least = 1023; // least: of what may not become subnormal
  const double components[3] = {x, y, z};
  for (const double d : components) {
    const std::uint64_t bits = __builtin_bit_cast(std::uint64_t, d) << 1;
    const std::int64_t e = bits >> 53 == 0 ? 1 : static_cast<std::int64_t>(bits >> 53);
    greatest = greatest < e ? e : greatest;
    least = !rounding::exact::is_zero(d) && e < least ? e : least;
  }
  const std::int64_t down = greatest - 1023 < least - 1 ? greatest - 1023 : least - 1;
  return {__builtin_bit_cast(double, (1023 - down) << 52),
          __builtin_bit_cast(double, (1023 + down) << 52)};
}

/// The direction times its scaling, exactly.
[[gnu::always_inline]] inline vec3 scaled_direction(const vec3& d) {
  const double factor = scaling_of(d[0], d[1], d[2]).of_direction;
  // the jump of scaling_of: an ordinary ray waits for no product
  if (factor == 1) [[likely]]
    return d;
  return {d[0] * factor, d[1] * factor, d[2] * factor};
}

} // namespace graze::octree
