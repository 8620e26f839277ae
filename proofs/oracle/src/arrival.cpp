#include "dyadic.hpp"
#include <bit>
#include <cassert>
#include <cmath>
#include <graze/oracle/arrival.hpp>

namespace graze::oracle {
namespace {

__extension__ using uint128 = unsigned __int128;

/// significand * 2^exponent; usable unless it would not fit.
struct wide_difference {
  uint128 significand;
  int exponent;
  bool fits;
};

wide_difference difference(const dyadic& p, const dyadic& o) {
  if (p.significand == 0)
    return {o.significand, o.exponent, true};
  if (o.significand == 0)
    return {p.significand, p.exponent, true};
  const dyadic& fine = p.exponent < o.exponent ? p : o;
  const dyadic& coarse = p.exponent < o.exponent ? o : p;
  const int shift = coarse.exponent - fine.exponent;
  if (shift + std::bit_width(coarse.significand) > 126)
    return {0, 0, false};
  // Both are below 2^126, so that their sum is below 2^127.
  const uint128 x = static_cast<uint128>(coarse.significand) << shift;
  const uint128 y = fine.significand;
  const uint128 magnitude = p.negative != o.negative ? x + y : (x < y ? y - x : x - y);
  return {magnitude, fine.exponent, true};
}

/// A positive number as 192 bits of which the highest is set, times 2^exponent. The representation
/// of a number is unique, hence comparison is lexicographic.
struct wide_product {
  int exponent;
  std::uint64_t high, middle, low;
};

// x < 2^127 and y < 2^53: x y < 2^180 fits.
wide_product product(const wide_difference& x, const dyadic& y) {
  const uint128 lower =
      static_cast<uint128>(static_cast<std::uint64_t>(x.significand)) * y.significand;
  const uint128 upper =
      static_cast<uint128>(static_cast<std::uint64_t>(x.significand >> 64)) * y.significand +
      static_cast<std::uint64_t>(lower >> 64);
  wide_product r{x.exponent + y.exponent, static_cast<std::uint64_t>(upper >> 64),
                 static_cast<std::uint64_t>(upper), static_cast<std::uint64_t>(lower)};
  for (int limb = 0; limb < 2 && r.high == 0; ++limb) {
    r.high = r.middle;
    r.middle = r.low;
    r.low = 0;
    r.exponent -= 64;
  }
  if (const int shift = std::countl_zero(r.high); shift != 0) {
    r.high = r.high << shift | r.middle >> (64 - shift);
    r.middle = r.middle << shift | r.low >> (64 - shift);
    r.low <<= shift;
    r.exponent -= shift;
  }
  return r;
}

template <class T> int sign_of_difference(T x, T y) { return x < y ? -1 : (y < x ? 1 : 0); }

/// The sign of x 2^i - y 2^j; x and y positive.
int compare(uint128 x, int i, uint128 y, int j) {
  const auto to_the_top = [](uint128& significand, int& exponent) {
    const auto high = static_cast<std::uint64_t>(significand >> 64);
    const int zeros = high != 0 ? std::countl_zero(high)
                                : 64 + std::countl_zero(static_cast<std::uint64_t>(significand));
    significand <<= zeros;
    exponent -= zeros;
  };
  to_the_top(x, i);
  to_the_top(y, j);
  return i != j ? sign_of_difference(i, j) : sign_of_difference(x, y);
}

int compare(const wide_product& x, const wide_product& y) {
  if (x.exponent != y.exponent)
    return sign_of_difference(x.exponent, y.exponent);
  if (x.high != y.high)
    return sign_of_difference(x.high, y.high);
  if (x.middle != y.middle)
    return sign_of_difference(x.middle, y.middle);
  return sign_of_difference(x.low, y.low);
}

static_assert(sizeof(unsigned long) == sizeof(std::uint64_t));

/// result = |p - o| * y / 2^exponent; returns the exponent.
int product(mpz_t result, mpz_t scratch, const dyadic& p, const dyadic& o, const dyadic& y) {
  const int grid = p.significand == 0   ? o.exponent
                   : o.significand == 0 ? p.exponent
                                        : std::min(p.exponent, o.exponent);
  const auto load = [grid](mpz_t z, const dyadic& x) {
    mpz_set_ui(z, x.significand);
    if (x.significand != 0)
      mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(x.exponent - grid));
    if (x.negative)
      mpz_neg(z, z);
  };
  load(result, p);
  load(scratch, o);
  mpz_sub(result, result, scratch);
  mpz_abs(result, result);
  mpz_mul_ui(result, result, y.significand);
  return grid + y.exponent;
}

int compare_by_gmp(const dyadic& p_a, const dyadic& o_a, const dyadic& s_a, const dyadic& p_b,
                   const dyadic& o_b, const dyadic& s_b) {
  thread_local integer a, b, scratch;
  const int exponent_a = product(a.value, scratch.value, p_a, o_a, s_b);
  const int exponent_b = product(b.value, scratch.value, p_b, o_b, s_a);
  // Lengths first, so that huge gaps need no huge shift.
  const auto top_a = static_cast<long>(mpz_sizeinbase(a.value, 2)) + exponent_a;
  const auto top_b = static_cast<long>(mpz_sizeinbase(b.value, 2)) + exponent_b;
  if (top_a != top_b)
    return sign_of_difference(top_a, top_b);
  if (exponent_a > exponent_b)
    mpz_mul_2exp(a.value, a.value, static_cast<mp_bitcnt_t>(exponent_a - exponent_b));
  else
    mpz_mul_2exp(b.value, b.value, static_cast<mp_bitcnt_t>(exponent_b - exponent_a));
  return sign_of_difference(mpz_cmp(a.value, b.value), 0);
}

} // namespace

int compare_exactly(const arrival& a, const arrival& b) {
  assert(a.plane != a.origin && b.plane != b.origin && a.speed > 0 && b.speed > 0);
  const dyadic p_a = split(a.plane), o_a = split(a.origin), s_a = split(a.speed);
  const dyadic p_b = split(b.plane), o_b = split(b.origin), s_b = split(b.speed);
  const wide_difference distance_a = difference(p_a, o_a);
  const wide_difference distance_b = difference(p_b, o_b);
  if (distance_a.fits && distance_b.fits) {
    ++decisions.wide;
    if (((distance_a.significand | distance_b.significand) >> 64) == 0)
      return compare(distance_a.significand * s_b.significand, distance_a.exponent + s_b.exponent,
                     distance_b.significand * s_a.significand, distance_b.exponent + s_a.exponent);
    return compare(product(distance_a, s_b), product(distance_b, s_a));
  }
  ++decisions.gmp;
  return compare_by_gmp(p_a, o_a, s_a, p_b, o_b, s_b);
}

} // namespace graze::oracle
