#pragma once
/// Powers of doubles in two limbs, in four, and, for small exponents, in a few multiplications.
#include "wide_rounding.hpp"

namespace graze::wide {

/// m * 2^(exponent - 128), 2^127 <= m < 2^128: number<2> in a register pair, for speed.
struct two_limbs {
  uint128 m;
  std::int64_t exponent;

  constexpr void normalise() { // after a product, which is at least 2^126
    const int shift = (high(m) >> 63) != 0 ? 0 : 1;
    m <<= shift;
    exponent -= shift;
  }
};

/// Low by less than 2 units of 2^126 or more, hence by a relative error below 8 * 2^-128.
constexpr two_limbs squared(const two_limbs& a) {
  const std::uint64_t h = high(a.m), l = low(a.m);
  two_limbs r{uint128{h} * h + (uint128{h} * l >> 63), 2 * a.exponent};
  r.normalise();
  return r;
}
/// As above for a number of one limb s * 2^(exponent - 64).
constexpr two_limbs times(const two_limbs& a, std::uint64_t s, std::int64_t exponent) {
  two_limbs r{uint128{high(a.m)} * s + high(uint128{low(a.m)} * s), a.exponent + exponent};
  r.normalise();
  return r;
}

/// (s 2^(exponent - 64))^n, n > 0, low by a relative error below 8 (n - 1) 2^-128: the error of a
/// product is at most the sum of its factors' and that of the truncation, and induction.
constexpr two_limbs power(std::uint64_t s, std::int64_t exponent, std::uint32_t n) {
  two_limbs r{uint128{s} << 64, exponent};
  for (int bit = std::bit_width(n) - 2; bit >= 0; --bit) {
    r = squared(r);
    if ((n >> bit & 1) != 0)
      r = times(r, s, exponent);
  }
  return r;
}
/// The same with four limbs: low by a relative error below 20 (n - 1) 2^-256.
constexpr number<4> power_of_four_limbs(double x, std::uint32_t n) {
  const number<4> base = from_double<4>(x);
  number<4> r = base;
  for (int bit = std::bit_width(n) - 2; bit >= 0; --bit) {
    r = r * r;
    if ((n >> bit & 1) != 0)
      r = r * base;
  }
  return r;
}
constexpr number<2> as_number(const two_limbs& a) { return {{low(a.m), high(a.m)}, a.exponent}; }

constexpr std::uint32_t absolute(int n) {
  return n < 0 ? 0 - static_cast<std::uint32_t>(n) : static_cast<std::uint32_t>(n);
}
/// Of the odd part of a significand of 53 bits.
constexpr std::uint64_t bits_of(std::uint64_t significand) {
  return 53 - static_cast<std::uint64_t>(std::countr_zero(significand));
}
/// Is the power in two limbs exact? For an odd part of b bits the n-th power has at most n b; the
/// products left out are then 0. Where it is not, b > 1 and n b > 128, the power has more than
/// n (b - 1) >= n b / 2 > 53 bits: it is no double, whatever its exponent.
constexpr bool is_exact(std::uint64_t bits, std::uint32_t n) {
  return bits == 1 || n * bits <= 128;
}

constexpr directed rounded_exactly(const two_limbs& a) {
  if (-1021 <= a.exponent && a.exponent <= 1024) {
    const std::uint64_t result =
        (static_cast<std::uint64_t>(a.exponent + 1021) << 52) + (high(a.m) >> 11);
    const bool more = (high(a.m) & 0x7ff) != 0 || low(a.m) != 0;
    return {std::bit_cast<double>(result), std::bit_cast<double>(result + (more ? 1 : 0))};
  }
  const int exponent = clamped(a.exponent) - 128;
  return {rounding::exact::round(false, a.m, exponent, false, rounding::exact::direction::down),
          rounding::exact::round(false, a.m, exponent, false, rounding::exact::direction::up)};
}

/// s^N / 2^(64 N - 128) without normalisation, at least 2^(128 - N), low by less than 2 (N - 1):
/// each product adds two truncations to the sum of its factors' errors, which, the factors being
/// below 2^128, is all that it passes on.
template <int N> constexpr uint128 unrolled_power(std::uint64_t s) {
  static_assert(2 <= N && N <= 8);
  if constexpr (N == 2) {
    return uint128{s} * s;
  } else if constexpr (N % 2 == 0) {
    const uint128 r = unrolled_power<N / 2>(s);
    const std::uint64_t h = high(r), l = low(r);
    return uint128{h} * h + (uint128{h} * l >> 63);
  } else {
    const uint128 r = unrolled_power<N - 1>(s);
    return uint128{high(r)} * s + high(uint128{low(r)} * s);
  }
}

/// |x|^N where the double below it follows from 128 bits without further ado: x and the result
/// normal, and the bits after the 53 that are kept not so close to 0 or 1 that the error of less
/// than 2^12 ulps matters. `down` as bits; `up` is the next double.
struct quick_power {
  std::uint64_t down;
  bool valid;
};
template <int N> constexpr quick_power quick(std::uint64_t magnitude_bits) {
  const std::uint64_t s = magnitude_bits << 11 | rounding::exact::sign_bit;
  const uint128 p = unrolled_power<N>(s);
  const int zeros = std::countl_zero(high(p)); // at most N
  // p << zeros, but for the bits that move to the upper half: at most 8, below the 53 kept there
  const std::uint64_t normal_low = low(p) << zeros, normal_high = high(p) << zeros;
  const std::int64_t exponent = static_cast<std::int64_t>(magnitude_bits >> 52);
  // value in [2^(e - 1), 2^e) with e = N (exponent - 1022) - zeros; the field of a double is e +
  // 1022
  const std::int64_t field = N * exponent - N * 1022 - zeros + 1022;
  // low by at most 2 (N - 1) 2^N ulps < 2^12; 0 may stand for an exact power
  const bool decided = normal_low - 1 < ~std::uint64_t{0} - 4096;
  const bool usual = static_cast<std::uint64_t>(exponent - 1) < 2046 &&
                     static_cast<std::uint64_t>(field - 1) < 2046;
  return {(static_cast<std::uint64_t>(field - 1) << 52) + (normal_high >> 11), decided && usual};
}

} // namespace graze::wide
