#pragma once
/// Directed rounding in integers: every finite input, no floating-point instruction, constexpr. It
/// serves `nearest` where the error of a rounded result is not itself a double, and gives the same
/// in every environment: any rounding mode, subnormal numbers flushed or not.
#include <cstdint>
#include <graze/rounding/standard.hpp>
#include <limits>

namespace graze::rounding::exact {

enum class direction { down, up };

__extension__ using uint128 = unsigned __int128;

/// |x| = significand * 2^exponent, 2^52 <= significand < 2^53, for x finite and not 0.
struct magnitude {
  std::uint64_t significand;
  int exponent;
};

// Never emitted: a file compiled for a path's instructions may give away nothing that the linker could
// choose for another (batch/path.hpp).
#define GRAZE_EXACT_INLINE [[gnu::always_inline]] constexpr

inline constexpr std::uint64_t sign_bit = 0x8000000000000000;
inline constexpr std::uint64_t hidden_bit = 0x0010000000000000; // 2^52

[[gnu::always_inline]] inline void hide(std::uint64_t& n) { asm("" : "+r"(n)); }
GRAZE_EXACT_INLINE std::uint64_t bits_of(double x) { return bit_cast<std::uint64_t>(x); }
GRAZE_EXACT_INLINE bool negative(double x) { return (bit_cast<std::uint64_t>(x) & sign_bit) != 0; }
GRAZE_EXACT_INLINE bool finite(double x) {
  return (bit_cast<std::uint64_t>(x) & 0x7ff0000000000000) != 0x7ff0000000000000;
}
/// Of either sign. (x == 0 holds for subnormal numbers too, where operands are flushed: DAZ.) clang
/// makes x == 0 of an integer comparison of a double's bits; of bits it cannot see, it does not.
GRAZE_EXACT_INLINE bool is_zero(double x) {
  std::uint64_t size = bit_cast<std::uint64_t>(x) & ~sign_bit;
  if (!__builtin_is_constant_evaluated())
    hide(size);
  return size == 0;
}
/// x < 0 and x > 0, for x not NaN, likewise.
GRAZE_EXACT_INLINE bool below_zero(double x) { return bit_cast<std::uint64_t>(x) > sign_bit; }
GRAZE_EXACT_INLINE bool above_zero(double x) { return bit_cast<std::int64_t>(x) > 0; }
/// The order of doubles as integers; -0 and +0 are one. Not for NaN.
GRAZE_EXACT_INLINE std::int64_t rank(double x) {
  const auto bits = bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
/// x < y, x <= y and x == y in any environment; false for a NaN, as the operators are.
GRAZE_EXACT_INLINE bool less(double x, double y) { return x == x && y == y && rank(x) < rank(y); }
GRAZE_EXACT_INLINE bool less_equal(double x, double y) {
  return x == x && y == y && rank(x) <= rank(y);
}
GRAZE_EXACT_INLINE bool equal(double x, double y) { return x == x && y == y && rank(x) == rank(y); }
constexpr double zero(bool is_negative) {
  return bit_cast<double>(is_negative ? sign_bit : std::uint64_t{0});
}

/// For products and quotients in which a zero, an infinity or a NaN decides: 1 or -1 for any other
/// number, which flushing might take for a zero.
constexpr double sign_if_number(double x) {
  if (!finite(x) || is_zero(x))
    return x;
  return negative(x) ? -1.0 : 1.0;
}

constexpr magnitude take_apart(double x) {
  const std::uint64_t bits = bit_cast<std::uint64_t>(x) & ~sign_bit;
  const int field = static_cast<int>(bits >> 52);
  if (field != 0)
    return {(bits & (hidden_bit - 1)) | hidden_bit, field - 1075};
  const int shift = leading_zeros(bits) - 11;
  return {bits << shift, -1074 - shift};
}

constexpr int bit_length(uint128 n) {
  const auto high = static_cast<std::uint64_t>(n >> 64);
  return high != 0 ? 128 - leading_zeros(high) : 64 - leading_zeros(static_cast<std::uint64_t>(n));
}

/// Rounds +-(n + f) * 2^exponent, where n > 0, 0 < f < 1 if `more` and f = 0 if not. If `more`, n
/// has at least 54 bits or the last bit of n is below 2^-1074, so that f never decides alone.
constexpr double round(bool is_negative, uint128 n, int exponent, bool more, direction d) {
  int quantum = exponent + bit_length(n) - 53; // of the last of 53 bits
  if (quantum < -1074)
    quantum = -1074;
  const int shift = quantum - exponent;
  std::uint64_t kept = 0;
  if (shift >= 128) {
    more = true;
  } else if (shift > 0) {
    kept = static_cast<std::uint64_t>(n >> shift);
    more = more || (n & ((uint128{1} << shift) - 1)) != 0;
  } else {
    kept = static_cast<std::uint64_t>(n) << -shift;
  }
  const bool away = (d == direction::up) != is_negative;
  if (more && away && ++kept == 2 * hidden_bit) {
    kept = hidden_bit;
    ++quantum;
  }
  const std::uint64_t sign = is_negative ? sign_bit : 0;
  if (kept >= hidden_bit && quantum > 971) // 2^971 is the last bit of the largest double
    return bit_cast<double>(sign | (away ? 0x7ff0000000000000 : 0x7fefffffffffffff));
  // below 2^52, kept is the significand of a subnormal double; the hidden bit adds 1 to the field
  const std::uint64_t field =
      kept >= hidden_bit ? static_cast<std::uint64_t>(quantum + 1074) << 52 : 0;
  return bit_cast<double>(sign | (field + kept));
}

/// x + y rounded towards d. NaN and infinite operands as IEEE 754 has it.
constexpr double add(double x, double y, direction d) {
  if (!finite(x) || !finite(y))
    return x + y;
  if (is_zero(x) && is_zero(y))
    return negative(x) == negative(y) ? x : zero(d == direction::down);
  if (is_zero(x))
    return y;
  if (is_zero(y))
    return x;
  if (bit_cast<std::uint64_t>(x) == (bit_cast<std::uint64_t>(y) ^ sign_bit))
    return zero(d == direction::down);
  magnitude large = take_apart(x), small = take_apart(y);
  bool is_negative = negative(x);
  if (large.exponent < small.exponent ||
      (large.exponent == small.exponent && large.significand < small.significand)) {
    const magnitude other = large;
    large = small;
    small = other;
    is_negative = negative(y);
  }
  // Aligned at 64 bits below large's last bit, or at small's. Where small lies deeper than that, it
  // is less than 2^-11 of large's last bit, and 2^-64 of that bit rounds to the same double.
  const int gap = large.exponent - small.exponent;
  const bool deep = gap > 64;
  const int shift = deep ? 64 : gap;
  const uint128 a = uint128{large.significand} << shift;
  const uint128 b = deep ? uint128{1} : uint128{small.significand};
  return round(is_negative, negative(x) == negative(y) ? a + b : a - b, large.exponent - shift,
               false, d);
}

/// x * y rounded towards d.
constexpr double mul(double x, double y, direction d) {
  if (!finite(x) || !finite(y) || is_zero(x) || is_zero(y))
    return sign_if_number(x) * sign_if_number(y);
  const magnitude a = take_apart(x), b = take_apart(y);
  return round(negative(x) != negative(y), uint128{a.significand} * b.significand,
               a.exponent + b.exponent, false, d);
}

/// x / y rounded towards d.
constexpr double div(double x, double y, direction d) {
  if (!finite(x) || !finite(y) || is_zero(x) || is_zero(y))
    return sign_if_number(x) / sign_if_number(y);
  const magnitude a = take_apart(x), b = take_apart(y);
  const uint128 dividend = uint128{a.significand} << 64; // the quotient has at least 64 bits
  const uint128 quotient = dividend / b.significand;
  return round(negative(x) != negative(y), quotient, a.exponent - b.exponent - 64,
               quotient * b.significand != dividend, d);
}

/// The square root of x rounded towards d, for x > 0 finite.
constexpr double sqrt_of_positive(double x, direction d) {
  const magnitude a = take_apart(x);
  const int shift = (a.exponent & 1) != 0 ? 65 : 64; // leaves an even exponent
  uint128 rest = uint128{a.significand} << shift;
  uint128 root = 0;
  for (uint128 bit = uint128{1} << 118; bit != 0; bit >>= 2) { // digit by digit; a 59-bit root
    if (rest >= root + bit) {
      rest -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return round(false, root, (a.exponent - shift) / 2, rest != 0, d);
}

} // namespace graze::rounding::exact
