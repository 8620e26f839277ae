#pragma once
/// x * y + z with one rounding, in integers: for machines and instruction sets without a fused
/// operation in the direction wanted.
#include <graze/rounding/exact.hpp>

namespace graze::rounding::exact {

/// x * y + z rounded towards d, for every input; NaN and infinite operands as IEEE 754 has it.
/// Error: 0 ulp.
constexpr double multiply_add(double x, double y, double z, direction d) {
  if (!finite(x) || !finite(y))
    return sign_if_number(x) * sign_if_number(y) + z; // nothing is rounded
  if (!finite(z))
    return z;
  const bool product_negative = negative(x) != negative(y);
  if (is_zero(x) || is_zero(y)) {
    if (!is_zero(z) || negative(z) == product_negative)
      return z;
    return zero(d == direction::down);
  }
  if (is_zero(z))
    return mul(x, y, d);
  // Both terms with 126 bits: at least the last 20 of either are zero, so that a gap of up to 20
  // loses no bit, and after a greater one the difference keeps at least 124 bits.
  const magnitude a = take_apart(x), b = take_apart(y), c = take_apart(z);
  uint128 large = uint128{a.significand} * b.significand;
  const int scale = 126 - bit_length(large);
  large <<= scale;
  int large_exponent = a.exponent + b.exponent - scale;
  uint128 small = uint128{c.significand} << 73;
  int small_exponent = c.exponent - 73;
  bool large_negative = product_negative;
  if (small_exponent > large_exponent || (small_exponent == large_exponent && small > large)) {
    const uint128 term = large;
    large = small;
    small = term;
    const int exponent = large_exponent;
    large_exponent = small_exponent;
    small_exponent = exponent;
    large_negative = negative(z);
  }
  const bool subtract = product_negative != negative(z);
  const int gap = large_exponent - small_exponent;
  const bool lost = gap > 127 || (small & ((uint128{1} << gap) - 1)) != 0;
  small = gap > 127 ? uint128{0} : small >> gap;
  if (!subtract)
    return round(large_negative, large + small, large_exponent, lost, d);
  // what is lost makes the true difference one unit less and a fraction more
  const uint128 difference = large - small - (lost ? 1 : 0);
  if (difference == 0)
    return zero(d == direction::down);
  return round(large_negative, difference, large_exponent, lost, d);
}

} // namespace graze::rounding::exact
