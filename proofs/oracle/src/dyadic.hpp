#pragma once
/// Doubles as integers times powers of two, and GMP's integers.
#include <bit>
#include <cstdint>
#include <gmp.h>

namespace graze::oracle {

/// |x| = significand * 2^exponent with an odd significand; 0 has significand 0.
struct dyadic {
  std::uint64_t significand;
  int exponent;
  bool negative;
};

// From the bits, so that neither the rounding mode nor flushing has a say.
inline dyadic split(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t significand = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased != 0)
    significand |= std::uint64_t{1} << 52;
  if (significand == 0)
    return {0, 0, false};
  const int zeros = std::countr_zero(significand);
  return {significand >> zeros, (biased != 0 ? biased : 1) - 1075 + zeros, (bits >> 63) != 0};
}

struct integer {
  integer() { mpz_init(value); }
  ~integer() { mpz_clear(value); }
  integer(const integer&) = delete;
  integer& operator=(const integer&) = delete;
  mpz_t value;
};

} // namespace graze::oracle
