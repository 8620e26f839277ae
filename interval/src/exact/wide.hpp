#pragma once
/// Positive numbers of N 64-bit limbs, in integers alone: no rounding mode, no flag of the compiler
/// and no library of functions changes a result. All operations truncate; their errors are stated
/// in ulps, which here are units of the last of the 64 N bits.
#include <array>
#include <bit>
#include <cstdint>
#include <graze/rounding/exact.hpp>
#include <type_traits>

namespace graze::wide {

using rounding::exact::uint128;

/// Least significant first. The loops over limbs are short and unrolled.
template <int N> using limbs = std::array<std::uint64_t, N>;

constexpr std::uint64_t low(uint128 x) { return static_cast<std::uint64_t>(x); }
constexpr std::uint64_t high(uint128 x) { return static_cast<std::uint64_t>(x >> 64); }

template <int N> constexpr uint128 top_two(const limbs<N>& a) {
  return uint128{a[N - 1]} << 64 | a[N - 2];
}

/// a += b; the carry.
template <int N> constexpr bool add(limbs<N>& a, const limbs<N>& b) {
  std::uint64_t carry = 0;
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) {
    const uint128 sum = uint128{a[i]} + b[i] + carry;
    a[i] = low(sum), carry = high(sum);
  }
  return carry != 0;
}
template <int N> constexpr bool add(limbs<N>& a, std::uint64_t b) {
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) {
    a[i] += b;
    b = a[i] < b ? 1 : 0;
  }
  return b != 0;
}

/// a -= b; the borrow.
template <int N> constexpr bool subtract(limbs<N>& a, const limbs<N>& b) {
  std::uint64_t borrow = 0;
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) {
    const uint128 difference = uint128{a[i]} - b[i] - borrow;
    a[i] = low(difference), borrow = high(difference) & 1;
  }
  return borrow != 0;
}
template <int N> constexpr bool subtract(limbs<N>& a, std::uint64_t b) {
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) {
    const bool borrow = a[i] < b;
    a[i] -= b;
    b = borrow ? 1 : 0;
  }
  return b != 0;
}

template <int N> constexpr limbs<N> shifted_right(const limbs<N>& a, std::int64_t shift) {
  limbs<N> r{};
  if (shift >= 64 * N)
    return r;
  const int whole = static_cast<int>(shift / 64), bits = static_cast<int>(shift % 64);
  for (int i = 0; i + whole < N; ++i) {
    r[i] = a[i + whole] >> bits;
    if (bits != 0 && i + whole + 1 < N)
      r[i] |= a[i + whole + 1] << (64 - bits);
  }
  return r;
}
template <int N> constexpr limbs<N> doubled(const limbs<N>& a) {
  limbs<N> r{};
  for (int i = N - 1; i >= 0; --i)
    r[i] = a[i] << 1 | (i > 0 ? a[i - 1] >> 63 : 0);
  return r;
}
/// shift < 64 N.
template <int N> constexpr limbs<N> shifted_left(const limbs<N>& a, int shift) {
  limbs<N> r{};
  const int whole = shift / 64, bits = shift % 64;
  for (int i = N - 1; i >= whole; --i) {
    r[i] = a[i - whole] << bits;
    if (bits != 0 && i - whole > 0)
      r[i] |= a[i - whole - 1] >> (64 - bits);
  }
  return r;
}

/// a * b / 2^(64 N), low by less than N + 1 ulps: the products a[i] b[j] with i + j < N - 1 are
/// left out, each N - 1 of which on the highest such column weigh less than an ulp, and the last
/// column is truncated.
template <int N> constexpr limbs<N> high_product(const limbs<N>& a, const limbs<N>& b) {
  if constexpr (N == 2) {
    const uint128 sum =
        uint128{a[1]} * b[1] + high(uint128{a[1]} * b[0]) + high(uint128{a[0]} * b[1]);
    return {low(sum), high(sum)};
  } else {
    std::array<std::uint64_t, N + 1> r{};
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) {
      std::uint64_t carry = 0;
#pragma GCC unroll 8
      for (int j = N - 1 - i; j < N; ++j) {
        const uint128 t = uint128{a[i]} * b[j] + r[i + j - (N - 1)] + carry;
        r[i + j - (N - 1)] = low(t), carry = high(t);
      }
      r[i + 1] = carry;
    }
    limbs<N> result{};
    for (int i = 0; i < N; ++i)
      result[i] = r[i + 1];
    return result;
  }
}
/// a * b / 2^64, low by less than an ulp.
template <int N> constexpr limbs<N> high_product(const limbs<N>& a, std::uint64_t b) {
  limbs<N> r{};
  std::uint64_t carry = high(uint128{a[0]} * b);
#pragma GCC unroll 8
  for (int i = 1; i < N; ++i) {
    const uint128 t = uint128{a[i]} * b + carry;
    r[i - 1] = low(t), carry = high(t);
  }
  r[N - 1] = carry;
  return r;
}

/// (head * 2^64 + tail) / d for head < d, and the rest.
struct digit_and_rest {
  std::uint64_t digit, rest;
};
constexpr digit_and_rest divided(std::uint64_t head, std::uint64_t tail, std::uint64_t d) {
#if defined(__x86_64__)
  if (!std::is_constant_evaluated()) { // one instruction, where the compiler would call a function
    digit_and_rest r{tail, head};
    asm("divq %2" : "+a"(r.digit), "+d"(r.rest) : "r"(d) : "cc");
    return r;
  }
#endif
  const uint128 n = uint128{head} << 64 | tail;
  return {low(n / d), low(n % d)};
}

/// a /= d, truncated.
template <int N> constexpr void divide(limbs<N>& a, std::uint64_t d) {
  std::uint64_t rest = 0;
  for (int i = N - 1; i >= 0; --i) {
    const digit_and_rest r = divided(rest, a[i], d);
    a[i] = r.digit, rest = r.rest;
  }
}

/// floor(n / d) in M limbs, for d >= 2^(64 N - 1) and n < d 2^(64 M).
/// Source: Knuth, The Art of Computer Programming, vol. 2, 4.3.1, algorithm D.
template <int M, int N>
constexpr limbs<M> quotient(std::array<std::uint64_t, M + N> n, const limbs<N>& d) {
  static_assert(N >= 2);
  limbs<M> q{};
  for (int j = M - 1; j >= 0; --j) {
    uint128 digit = ~std::uint64_t{0};
    uint128 rest = uint128{n[j + N - 1]} + d[N - 1]; // where the heads are equal
    if (n[j + N] < d[N - 1]) {
      const digit_and_rest r = divided(n[j + N], n[j + N - 1], d[N - 1]);
      digit = r.digit, rest = r.rest;
    }
    while (high(rest) == 0 && digit * d[N - 2] > (rest << 64 | n[j + N - 2])) {
      --digit;
      rest += d[N - 1];
    }
    std::uint64_t carry = 0, borrow = 0;
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) {
      const uint128 t = digit * d[i] + carry;
      const uint128 difference = uint128{n[j + i]} - low(t) - borrow;
      carry = high(t);
      n[j + i] = low(difference), borrow = high(difference) & 1;
    }
    const uint128 difference = uint128{n[j + N]} - carry - borrow;
    n[j + N] = low(difference);
    if ((high(difference) & 1) != 0) { // the digit was one too large
      --digit;
      std::uint64_t back = 0;
      for (int i = 0; i < N; ++i) {
        const uint128 sum = uint128{n[j + i]} + d[i] + back;
        n[j + i] = low(sum), back = high(sum);
      }
      n[j + N] += back;
    }
    q[j] = low(digit);
  }
  return q;
}

/// The same for M = N = 2, where the rest of a digit's division is that of two limbs at once.
constexpr limbs<2> quotient_of_two(const std::array<std::uint64_t, 4>& n, const limbs<2>& d) {
  limbs<2> q{};
  uint128 rest = uint128{n[3]} << 64 | n[2];
  for (int j = 1; j >= 0; --j) {
    if (high(rest) == d[1])
      return quotient<2, 2>(n, d);
    const digit_and_rest r = divided(high(rest), low(rest), d[1]);
    // the digit for the head of d is at most two too large for d
    uint128 part = uint128{r.rest} << 64 | n[j], product = uint128{r.digit} * d[0];
    std::uint64_t digit = r.digit;
    while (product > part) {
      --digit;
      product -= d[0];
      part += uint128{d[1]} << 64;
      if (high(part) < d[1]) // beyond 2^128, hence beyond the product
        break;
    }
    rest = part - product;
    q[j] = digit;
  }
  return q;
}

/// significand * 2^(exponent - 64 N), the top bit of the significand set: in
/// [2^(exponent - 1), 2^exponent).
template <int N> struct number {
  limbs<N> significand;
  std::int64_t exponent;
};

/// The same value with the top bit set; not 0.
template <int N> constexpr number<N> normalised(const limbs<N>& a, std::int64_t exponent) {
  if ((a[N - 1] >> 63) != 0)
    return {a, exponent};
  int zeros = 0;
  for (int i = N - 1; i >= 0; --i) {
    if (a[i] != 0) {
      zeros += std::countl_zero(a[i]);
      break;
    }
    zeros += 64;
  }
  return {shifted_left<N>(a, zeros), exponent - zeros};
}

/// |x|, exact, for x finite and not 0.
template <int N> constexpr number<N> from_double(double x) {
  const rounding::exact::magnitude m = rounding::exact::take_apart(x);
  limbs<N> a{};
  a[N - 1] = m.significand << 11;
  return {a, m.exponent + 53};
}

template <int N>
inline constexpr number<N> one = [] {
  limbs<N> a{};
  a[N - 1] = std::uint64_t{1} << 63;
  return number<N>{a, 1};
}();

/// As a double, truncated to 53 bits, for estimates; the exponent within that of normal doubles.
template <int N> constexpr double estimate(const number<N>& a) {
  return std::bit_cast<double>((static_cast<std::uint64_t>(a.exponent + 1021) << 52) +
                               (a.significand[N - 1] >> 11));
}

/// Low by a relative error below 4 (N + 1) 2^(-64 N).
template <int N> constexpr number<N> operator*(const number<N>& a, const number<N>& b) {
  return normalised<N>(high_product<N>(a.significand, b.significand), a.exponent + b.exponent);
}

/// Low by a relative error below 8 * 2^(-64 N).
template <int N> constexpr number<N> operator/(const number<N>& a, const number<N>& b) {
  std::array<std::uint64_t, 2 * N> n{};
  n[N - 1] = a.significand[0] << 63; // a / 2 < b
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i)
    n[N + i] = a.significand[i] >> 1 | (i + 1 < N ? a.significand[i + 1] << 63 : 0);
  if constexpr (N == 2)
    return normalised<N>(quotient_of_two(n, b.significand), a.exponent - b.exponent + 1);
  else
    return normalised<N>(quotient<N, N>(n, b.significand), a.exponent - b.exponent + 1);
}

/// Low by less than two ulps.
template <int N> constexpr number<N> sum(const number<N>& a, const number<N>& b) {
  const bool a_first = a.exponent >= b.exponent;
  const number<N>&large = a_first ? a : b, &small = a_first ? b : a;
  limbs<N> r = large.significand;
  if (!add<N>(r, shifted_right<N>(small.significand, large.exponent - small.exponent)))
    return {r, large.exponent};
  r = shifted_right<N>(r, 1);
  r[N - 1] |= std::uint64_t{1} << 63;
  return {r, large.exponent + 1};
}

/// a - b: its sign and, unless that is 0, its magnitude, with an absolute error below an ulp of the
/// greater of a and b; exact where the two have no more than 64 N bits together.
template <int N> struct signed_number {
  int sign;
  number<N> magnitude;
};
template <int N> constexpr signed_number<N> difference(const number<N>& a, const number<N>& b) {
  const bool a_first = a.exponent >= b.exponent;
  const number<N>&large = a_first ? a : b, &small = a_first ? b : a;
  int sign = a_first ? 1 : -1;
  limbs<N> r = large.significand;
  if (subtract<N>(r, shifted_right<N>(small.significand, large.exponent - small.exponent))) {
    limbs<N> negated{};
    subtract<N>(negated, r);
    r = negated, sign = -sign;
  }
  if (r == limbs<N>{})
    return {0, large};
  return {sign, normalised<N>(r, large.exponent)};
}

} // namespace graze::wide
