#pragma once
/// Doubles seen as bit patterns: neighbours, number of significant bits, hex floats.
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace graze::fuzz {

/// The n-th double above x (below for n < 0); -0 and +0 are one place. Stops at the largest finite
/// double of either sign.
inline double step_ulps(double x, int n) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  std::int64_t place = bits < 0 ? INT64_MIN - bits : bits;
  constexpr std::int64_t last = 0x7fefffffffffffff;
  place += n;
  if (place > last)
    place = last;
  if (place < -last)
    place = -last;
  return std::bit_cast<double>(place < 0 ? INT64_MIN - place : place);
}

/// The number of bits from the highest to the lowest set bit of a finite x; 0 for 0.
inline int significant_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  std::uint64_t significand = bits & 0xfffffffffffffu;
  if ((bits >> 52 & 0x7ff) != 0)
    significand |= std::uint64_t{1} << 52;
  if (significand == 0)
    return 0;
  return 64 - std::countl_zero(significand) - std::countr_zero(significand);
}

/// x with all but its n highest significant bits cleared (towards 0), n >= 1.
inline double keep_bits(double x, int n) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  int length = 53;
  if ((bits >> 52 & 0x7ff) == 0)
    length = 64 - std::countl_zero(bits & 0xfffffffffffffu);
  if (n >= length)
    return x;
  return std::bit_cast<double>(bits >> (length - n) << (length - n));
}

/// std::ldexp, by one multiplication where 2^exponent is a normal double.
inline double scaled(double x, int exponent) {
  if (exponent < -1022 || exponent > 1023)
    return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// The exact spelling of x, "0x1.8p-3".
std::string hex(double x);

/// The 64 bits of x, sign first, as 16 hex digits: "3ff8000000000000" for 1.5.
std::string bits_of(double x);
/// The number of 16 hex digits, infinities and NaNs included; nothing for any other text.
std::optional<double> number_of_bits(std::string_view text);

/// Reads a whole string as a finite number: 16 hex digits are its bits; any other text a hex float or a
/// decimal. Nothing else is accepted.
std::optional<double> parse_number(std::string_view text);

} // namespace graze::fuzz
