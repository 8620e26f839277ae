#pragma once
/// The sign of a 2x2 determinant whose first column is a difference of doubles: the one decision
/// that the exact ray/octant test is made of.
///
/// A ray on axis a reaches the plane p after t = |p - o_a| / |d_a|. Which of two planes comes first
/// is the sign of |p_1 - o_1| |d_2| - |p_2 - o_2| |d_1|, without a division. A filter in doubles
/// decides most signs; what it leaves goes to integers. Every result is the same in every rounding
/// mode and under every compiler flag that backend.hpp lets through. Nothing is allocated.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <graze/rounding/backend.hpp>

namespace graze::octree {

/// A distance greater - less >= 0 along an axis, not rounded; both finite.
struct exact_distance {
  double greater, less;
};

/// Decides, most often, the sign of (x.greater - x.less) x_factor - (y.greater - y.less) y_factor:
/// +1 or -1 if that is proven, else 0. x_distance and y_distance are the differences after one
/// rounding in any mode; the factors are finite and >= 0, or NaN, which decides nothing.
///
/// Let e = 2^-52, which bounds the relative error of one operation in every rounding mode. A
/// difference of doubles is never inexact below the normal range, and it did not overflow if its
/// rounded value is at most 2^1023 (an overflow gives at least the largest double): D = fl(D) (1 +
/// d), |d| <= e. Let X, Y be the rounded products. Where X <= 2^1000 it did not overflow, so that
/// the exact products lie within X / (1 +- e)^2, hence within X (1 +- 3e), widened by 2^-1021 where
/// a product leaves the normal range (2^-1074, or what flushing to zero takes away).
/// Let k = 1 + 16e. If fl(fl(Y k) + 2^-1000) < X, then
///     X (1 - 3e) > (Y k + 2^-1000) (1 - e)^2 (1 - 3e) > Y (1 + 3e) + 2 * 2^-1021,
/// since (1 + 16e) (1 - e)^2 (1 - 3e) >= 1 + 10e: the exact difference is positive. A contraction
/// of the sum into one operation takes a rounding away. Y itself is finite, as it is less than X.
inline int filtered_sign(double x_distance, double x_factor, double y_distance, double y_factor) {
  constexpr double margin = 0x1.000000000001p+0; // k = 1 + 16 * 2^-52
  constexpr double tiny = 0x1p-1000, most = 0x1p+1000, far = 0x1p+1023;
  const double x = x_distance * x_factor;
  const double y = y_distance * y_factor;
  const bool within = (x_distance <= far) & (y_distance <= far);
  if (within & (y * margin + tiny < x) & (x <= most))
    return 1;
  if (within & (x * margin + tiny < y) & (y <= most))
    return -1;
  return 0;
}

namespace detail {

__extension__ using uint128 = unsigned __int128;

/// magnitude * 2^exponent, or its negative; magnitude < 2^106.
struct dyadic_term {
  uint128 magnitude;
  int exponent;
  bool negative;
};

/// |x| = significand * 2^exponent. From the bits, so that neither mode nor flushing has a say.
struct double_parts {
  std::uint64_t significand;
  int exponent;
  bool negative;
  explicit double_parts(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto field = static_cast<int>(bits >> 52 & 0x7ff);
    significand =
        (bits & ((std::uint64_t{1} << 52) - 1)) | (field != 0 ? std::uint64_t{1} << 52 : 0);
    exponent = (field != 0 ? field : 1) - 1075;
    negative = bits >> 63 != 0;
  }
};

/// The sign of the sum of `count` terms in units of 2^lowest, in two's complement of 64 * Limbs
/// bits. Every exponent is at least `lowest` and at most lowest + 64 * Limbs - 109, so that four
/// terms fit: their sum is below 4 * 2^106 * 2^(64 * Limbs - 109) = 2^(64 * Limbs - 1).
template <int Limbs> int sign_of_sum(const dyadic_term* terms, int count, int lowest) {
  std::array<std::uint64_t, Limbs> sum{};
  for (int i = 0; i < count; ++i) {
    const dyadic_term& t = terms[i];
    const auto shift = static_cast<unsigned>(t.exponent - lowest);
    const unsigned bit = shift % 64;
    const auto low = static_cast<std::uint64_t>(t.magnitude);
    const auto high = static_cast<std::uint64_t>(t.magnitude >> 64);
    // the magnitude at its place; two limbs more, since its own highest limbs may be empty
    std::array<std::uint64_t, Limbs + 2> placed{};
    std::uint64_t* const at = placed.data() + shift / 64;
    at[0] = low << bit;
    at[1] = high << bit | (low >> 1 >> (63 - bit));
    at[2] = high >> 1 >> (63 - bit);
    const std::uint64_t flip = t.negative ? ~std::uint64_t{0} : 0; // -x = ~x + 1
    std::uint64_t carry = flip & 1;
    for (unsigned j = 0; j < Limbs; ++j) {
      const uint128 s = static_cast<uint128>(sum[j]) + (placed[j] ^ flip) + carry;
      sum[j] = static_cast<std::uint64_t>(s);
      carry = static_cast<std::uint64_t>(s >> 64);
    }
  }
  if (sum[Limbs - 1] >> 63 != 0)
    return -1;
  std::uint64_t any = 0;
  for (const std::uint64_t limb : sum)
    any |= limb;
  return any != 0 ? 1 : 0;
}

/// The sign of a sum of at most four terms, magnitudes not 0, whatever the gaps of their exponents.
/// Highest exponents first: where the next exponent is 108 or more below 2^e, the unit of the sum
/// so far, the rest is below 3 * 2^106 * 2^(e - 108) < 2^e, and cannot change the sign of a sum
/// that is not 0. Terms closer together than that span at most 3 * 107 bits.
[[gnu::noinline, gnu::cold]] inline int sign_of_scattered_sum(dyadic_term* terms, int count) {
  constexpr int gap = 108;
  std::sort(terms, terms + count,
            [](const dyadic_term& x, const dyadic_term& y) { return x.exponent > y.exponent; });
  for (int first = 0; first < count;) {
    int last = first;
    while (last + 1 < count && terms[last].exponent - terms[last + 1].exponent < gap)
      ++last;
    if (const int sign = sign_of_sum<8>(terms + first, last + 1 - first, terms[last].exponent);
        sign != 0)
      return sign;
    first = last + 1;
  }
  return 0;
}

} // namespace detail

/// The sign of (x.greater - x.less) x_factor - (y.greater - y.less) y_factor, exactly, for all
/// finite doubles. The signs of the factors are ignored.
[[gnu::noinline]] inline int determinant_sign(const exact_distance& x, double x_factor,
                                              const exact_distance& y, double y_factor) {
  using detail::double_parts;
  std::array<detail::dyadic_term, 4> terms;
  int count = 0, lowest = 1 << 20, highest = -(1 << 20);
  const auto add = [&](const double_parts& a, const double_parts& b, bool negative) {
    const auto product = static_cast<detail::uint128>(a.significand) * b.significand;
    const int exponent = a.exponent + b.exponent;
    if (product == 0)
      return;
    terms[static_cast<unsigned>(count++)] = {product, exponent, negative != a.negative};
    lowest = std::min(lowest, exponent);
    highest = std::max(highest, exponent);
  };
  const double_parts by_x(x_factor), by_y(y_factor);
  add(double_parts(x.greater), by_x, false);
  add(double_parts(x.less), by_x, true);
  add(double_parts(y.greater), by_y, true);
  add(double_parts(y.less), by_y, false);
  if (highest - lowest <= 4 * 64 - 109)
    return detail::sign_of_sum<4>(terms.data(), count, lowest);
  return detail::sign_of_scattered_sum(terms.data(), count);
}

} // namespace graze::octree
