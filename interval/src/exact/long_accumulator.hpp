#pragma once
/// Exact sums of doubles and of products of two doubles. Source: U. Kulisch, "Computer Arithmetic
/// and Validity" (2008), chapter 8: a fixed-point number long enough for every such sum.
#include <array>
#include <bit>
#include <cstdint>
#include <graze/reductions.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::detail {

class long_accumulator {
public:
  /// Finite operands.
  void add(double x) {
    const raw a(x);
    add(rounding::exact::negative(x), a.significand, a.exponent);
  }
  void add_product(double x, double y) {
    const raw a(x), b(y);
    add(rounding::exact::negative(x) != rounding::exact::negative(y),
        uint128{a.significand} * b.significand, a.exponent + b.exponent);
  }

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const {
    if (negative())
      return -1;
    for (const std::uint64_t word : words_)
      if (word != 0)
        return 1;
    return 0;
  }

  [[nodiscard]] double round(rounded to) const;

private:
  using uint128 = rounding::exact::uint128;

  /// x = +-significand * 2^exponent, exponent >= -1074.
  struct raw {
    std::uint64_t significand;
    int exponent;
    explicit raw(double x) {
      const auto bits = std::bit_cast<std::uint64_t>(x) & ~rounding::exact::sign_bit;
      const int field = static_cast<int>(bits >> 52);
      significand = field == 0
                        ? bits
                        : (bits & (rounding::exact::hidden_bit - 1)) | rounding::exact::hidden_bit;
      exponent = (field == 0 ? 1 : field) - 1075;
    }
  };

  // Bit 0 is 2^-2148, that of the product of the least doubles; the greatest product is below
  // 2^2048. 68 words leave 155 bits for carries and the sign (two's complement): more terms than
  // any memory holds.
  static constexpr int last_bit = -2148;
  static constexpr int length = 68;

  [[nodiscard]] bool negative() const { return (words_.back() >> 63) != 0; }

  void add(bool is_negative, uint128 n, int exponent) {
    const int position = exponent - last_bit;
    const int shift = position % 64;
    auto word = static_cast<unsigned>(position / 64);
    const std::array<std::uint64_t, 3> parts{
        static_cast<std::uint64_t>(n << shift), static_cast<std::uint64_t>((n << shift) >> 64),
        shift == 0 ? 0 : static_cast<std::uint64_t>(n >> (128 - shift))};
    std::uint64_t carry = 0;
    for (unsigned i = 0; word < length && (i < 3 || carry != 0); ++i, ++word) {
      const std::uint64_t part = i < 3 ? parts[i] : 0;
      const std::uint64_t old = words_[word];
      if (is_negative) {
        const std::uint64_t less = old - part;
        words_[word] = less - carry;
        carry = static_cast<std::uint64_t>(old < part) | static_cast<std::uint64_t>(less < carry);
      } else {
        const std::uint64_t more = old + part;
        words_[word] = more + carry;
        carry = static_cast<std::uint64_t>(more < old) |
                static_cast<std::uint64_t>(words_[word] < carry);
      }
    }
  }

  std::array<std::uint64_t, length> words_{};
};

} // namespace graze::detail
