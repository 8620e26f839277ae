#pragma once
/// Sums of products of doubles, not rounded: their signs, and their magnitudes to 63 bits. In
/// integers, so that neither rounding mode nor flushing has a say; nothing is allocated. For the
/// few decisions that no filter makes, and for what is asked for with its last bit.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <graze/rounding/exact.hpp>

namespace graze::octree::detail {

using rounding::exact::direction;
using rounding::exact::uint128;

/// Bounds of a number >= 0: [lo, hi] 2^exponent, 2^62 <= lo <= hi <= 2^63, or both 0. A
/// quotient, product or root of such bounds is wider by 2^-61 of the number at the most.
struct magnitude_bounds {
  std::uint64_t lo, hi;
  int exponent;

  /// [lo, hi] 2^exponent, of as many bits as there are.
  static magnitude_bounds of_wide(uint128 lo, uint128 hi, int exponent) {
    if (hi == 0)
      return {0, 0, 0};
    const int shift = rounding::exact::bit_length(hi) - 63;
    if (shift <= 0)
      return {static_cast<std::uint64_t>(lo << -shift), static_cast<std::uint64_t>(hi << -shift),
              exponent + shift};
    const uint128 rest = (uint128{1} << shift) - 1;
    return {static_cast<std::uint64_t>(lo >> shift),
            static_cast<std::uint64_t>((hi >> shift) + ((hi & rest) != 0 ? 1 : 0)),
            exponent + shift};
  }
  [[nodiscard]] double down() const {
    return lo == 0 ? 0 : rounding::exact::round(false, lo, exponent, false, direction::down);
  }
  [[nodiscard]] double up() const {
    return hi == 0 ? 0 : rounding::exact::round(false, hi, exponent, false, direction::up);
  }
};
inline magnitude_bounds product(const magnitude_bounds& x, const magnitude_bounds& y) {
  return magnitude_bounds::of_wide(uint128{x.lo} * y.lo, uint128{x.hi} * y.hi,
                                   x.exponent + y.exponent);
}
/// y not 0.
inline magnitude_bounds quotient(const magnitude_bounds& x, const magnitude_bounds& y) {
  const uint128 least = (uint128{x.lo} << 64) / y.hi, dividend = uint128{x.hi} << 64;
  const uint128 most = dividend / y.lo;
  return magnitude_bounds::of_wide(least, most + (most * y.lo != dividend ? 1 : 0),
                                   x.exponent - y.exponent - 64);
}
inline magnitude_bounds square_root(const magnitude_bounds& x) {
  const bool odd = (x.exponent & 1) != 0;
  const auto root = [](uint128 n) { // the greatest integer not above
    uint128 rest = n, result = 0;
    for (uint128 bit = uint128{1} << 126; bit != 0; bit >>= 2)
      if (rest >= result + bit) {
        rest -= result + bit;
        result = (result >> 1) + bit;
      } else {
        result >>= 1;
      }
    return result;
  };
  const int shift = odd ? 61 : 62; // leaves an even exponent, and 126 bits at the most
  const uint128 lo = uint128{x.lo} << shift, hi = uint128{x.hi} << shift, most = root(hi);
  return magnitude_bounds::of_wide(root(lo), most + (most * most != hi ? 1 : 0),
                                   (x.exponent - shift) / 2);
}

/// The sum of at most 24 terms: x, x y, or x y times an integer below 2^22; x and y finite.
class exact_sum {
public:
  void add_product(double x, double y, std::uint32_t times = 1, bool negative = false) {
    using rounding::exact::is_zero;
    if (is_zero(x) || is_zero(y) || times == 0)
      return;
    assert(count_ < terms_.size() && times < 1u << 22);
    const parts a(x), b(y);
    terms_[count_++] = {uint128{a.significand} * b.significand * times, a.exponent + b.exponent,
                        negative != (a.negative != b.negative)};
  }
  void add(double x, std::uint32_t times = 1, bool negative = false) {
    add_product(x, 1, times, negative);
  }

  [[nodiscard]] int sign() const {
    const wide_number n(*this);
    return n.sign();
  }
  /// Of the magnitude; lo = hi where 63 bits hold it.
  [[nodiscard]] magnitude_bounds magnitude() const {
    wide_number n(*this);
    return n.magnitude();
  }
  /// The nearest double, ties to even.
  [[nodiscard]] double nearest() const {
    wide_number n(*this);
    return n.nearest();
  }
  [[nodiscard]] double rounded(direction d) const {
    wide_number n(*this);
    const bool negative = n.sign() < 0;
    const magnitude_bounds m = n.magnitude();
    const double size = (d == direction::up) != negative ? m.up() : m.down();
    return negative ? -size : size;
  }

private:
  struct term {
    uint128 magnitude;
    unsigned exponent; ///< in units of 2^-2148
    bool negative;
  };
  struct parts {
    std::uint64_t significand;
    unsigned exponent; ///< of the lowest bit, in units of 2^-1074
    bool negative;
    explicit parts(double x) {
      const std::uint64_t b = rounding::exact::bits_of(x);
      const auto e = static_cast<unsigned>(b >> 52 & 0x7ff);
      significand = (b & 0xf'ffff'ffff'ffff) | (e == 0 ? 0 : std::uint64_t{1} << 52);
      exponent = e == 0 ? 0 : e - 1;
      negative = b >> 63 != 0;
    }
  };

  /// Two's complement, from the word of the lowest term to one above the highest term's.
  class wide_number {
  public:
    explicit wide_number(const exact_sum& s) {
      unsigned least = ~0u, most = 0;
      for (unsigned i = 0; i < s.count_; ++i) {
        least = std::min(least, s.terms_[i].exponent / 64);
        most = std::max(most, s.terms_[i].exponent / 64);
      }
      if (s.count_ == 0)
        least = 0;
      lowest_ = least;
      used_ = most - least + 4; // a term has 128 bits at the most and 63 of shift; a word for sums
      std::fill_n(words_.begin(), used_, 0);
      for (unsigned i = 0; i < s.count_; ++i)
        accumulate(s.terms_[i]);
    }
    [[nodiscard]] int sign() const {
      if (words_[used_ - 1] >> 63 != 0)
        return -1;
      for (unsigned i = 0; i < used_; ++i)
        if (words_[i] != 0)
          return 1;
      return 0;
    }
    [[nodiscard]] magnitude_bounds magnitude() {
      if (sign() < 0) { // -x = ~x + 1
        unsigned carry = 1;
        for (unsigned i = 0; i < used_; ++i) {
          words_[i] = ~words_[i] + carry;
          carry = carry != 0 && words_[i] == 0 ? 1 : 0;
        }
      }
      unsigned top = used_;
      while (top > 0 && words_[top - 1] == 0)
        --top;
      if (top == 0)
        return {0, 0, 0};
      // 63 bits from the highest one set
      const std::uint64_t high = words_[top - 1], low = top > 1 ? words_[top - 2] : 0;
      const int zeros = rounding::leading_zeros(high);
      const uint128 both = (uint128{high} << 64 | low) << zeros;
      bool more = (both & ((uint128{1} << 65) - 1)) != 0;
      for (unsigned i = 0; i + 2 < top; ++i)
        more |= words_[i] != 0;
      const auto lead = static_cast<std::uint64_t>(both >> 65);
      return {lead, lead + (more ? 1 : 0),
              static_cast<int>(64 * (lowest_ + top)) - zeros - 63 - 2148};
    }
    [[nodiscard]] double nearest() {
      const bool negative = sign() < 0;
      const magnitude_bounds m = magnitude();
      double result = m.down();
      if (const double above = m.up(); rounding::exact::less(result, above)) {
        // of the last bit of the result, half is 2^(quantum - 1)
        const int quantum = std::max(m.exponent + 63 - 53, -1074), shift = quantum - m.exponent;
        const std::uint64_t half = shift <= 64 ? std::uint64_t{1} << (shift - 1) : 0,
                            rest = shift <= 63 ? m.lo & ((std::uint64_t{1} << shift) - 1) : m.lo;
        const bool more = m.hi != m.lo, odd = (rounding::exact::bits_of(result) & 1) != 0;
        if (half != 0 && (rest > half || (rest == half && (more || odd))))
          result = above;
      }
      return negative ? -result : result;
    }

  private:
    void accumulate(const term& t) {
      const unsigned bit = t.exponent % 64;
      unsigned i = t.exponent / 64 - lowest_;
      const std::array<std::uint64_t, 3> placed{
          static_cast<std::uint64_t>(t.magnitude << bit),
          static_cast<std::uint64_t>(t.magnitude >> 1 >> (63 - bit)),
          static_cast<std::uint64_t>(t.magnitude >> 64 >> 1 >> (63 - bit))};
      unsigned carry = 0; // or what is borrowed
      for (unsigned k = 0; i < used_; ++i, ++k) {
        if (k >= 3 && carry == 0)
          break;
        const std::uint64_t w = k < 3 ? placed[k] : 0, before = words_[i];
        if (t.negative) {
          words_[i] = before - w - carry;
          carry = before < w || (before == w && carry != 0) ? 1 : 0;
        } else {
          words_[i] = before + w + carry;
          carry = words_[i] < before || (words_[i] == before && carry != 0) ? 1 : 0;
        }
      }
    }
    unsigned lowest_, used_;
    std::array<std::uint64_t, 72> words_; ///< 2 * 2046 / 64 + 4 of them at the most
  };

  std::array<term, 24> terms_;
  unsigned count_ = 0;
};

} // namespace graze::octree::detail
