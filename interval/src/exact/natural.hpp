#pragma once
/// Natural numbers of any size, for exact text. Schoolbook arithmetic: quadratic in the length.
#include <compare>
#include <cstddef>
#include <cstdint>
#include <graze/rounding/exact.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace graze::detail {

class natural {
public:
  natural(std::uint64_t n = 0);
  /// Digits of the base 10 or 16, nothing else; none is 0.
  static natural of_decimal(std::string_view digits);
  static natural of_hexadecimal(std::string_view digits);
  static natural power_of_five(std::uint64_t exponent);

  [[nodiscard]] bool is_zero() const { return limbs_.empty(); }
  [[nodiscard]] bool is_odd() const { return !limbs_.empty() && (limbs_[0] & 1) != 0; }
  /// The least n such that *this < 2^n.
  [[nodiscard]] std::uint64_t bit_length() const;
  /// How many low bits are 0, for a number that is not.
  [[nodiscard]] std::uint64_t trailing_zeros() const;
  [[nodiscard]] std::string decimal() const;

  natural& operator+=(const natural& other);
  /// For other <= *this.
  natural& operator-=(const natural& other);
  natural& operator<<=(std::uint64_t bits);
  natural& operator>>=(std::uint64_t bits);
  friend natural operator*(const natural& x, const natural& y);

  friend bool operator==(const natural& x, const natural& y) = default;
  friend std::strong_ordering operator<=>(const natural& x, const natural& y);

  /// The quotient, below 2^128, and whether there is a remainder. For a divisor that is not 0 and
  /// is at least 2^-128 times *this.
  struct quotient {
    rounding::exact::uint128 value;
    bool remainder;
  };
  [[nodiscard]] quotient divided_by(const natural& divisor) const;

private:
  // base 2^32, the least first, no leading 0
  std::vector<std::uint32_t> limbs_;

  void trim();
  /// *this = *this * factor + addend.
  void multiply_add(std::uint32_t factor, std::uint32_t addend);
  /// *this = *this / divisor; returns the remainder.
  std::uint32_t divide(std::uint32_t divisor);
};

} // namespace graze::detail
