#pragma once
/// The sign of a 2x2 determinant whose first column is a difference of doubles: the one decision
/// that the exact ray/octant test is made of.
///
/// A ray on axis a reaches the plane p after t = |p - o_a| / |d_a|. Which of two planes comes first
/// is the sign of |p_1 - o_1| |d_2| - |p_2 - o_2| |d_1|, without a division. A filter in doubles
/// decides most signs; what it leaves goes to integers. Every result is the same in every rounding
/// mode and under every compiler flag that backend.hpp lets through. Nothing is allocated.
#include <graze/needs_cxx20.hpp>

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

/// True only if (x.greater - x.less) x_factor > (y.greater - y.less) y_factor is proven, given both
/// products as doubles: two roundings each, in any mode. Each difference is >= 0 and its rounded
/// value at most 2^1023; the factors are exact and >= 0, or NaN, which proves nothing.
///
/// Let e = 2^-52, which bounds the relative error of one operation in every rounding mode. A
/// difference of doubles is never inexact below the normal range, and it did not overflow where its
/// rounded value is at most 2^1023 (an overflow gives at least the largest double): it is
/// D (1 + d), |d| <= e. Where x <= 2^1000, neither product overflowed, so that the exact products
/// lie within x / (1 +- e)^2 and y / (1 +- e)^2, hence within 1 +- 3e of x and y, widened by
/// 2^-1021 where a product leaves the normal range (by 2^-1074, or by what flushing to zero takes
/// away). Let k = 1 + 16e. If fl(fl(y k) + 2^-1000) < x, then
///     x (1 - 3e) > (y k + 2^-1000) (1 - e)^2 (1 - 3e) > y (1 + 3e) + 2 * 2^-1021,
/// since (1 + 16e) (1 - e)^2 (1 - 3e) > 1 + 10e. If the compiler contracts the sum, one rounding
/// falls away.
inline bool certainly_greater(double x, double y) {
  constexpr double margin = 0x1.000000000001p+0; // k = 1 + 16 * 2^-52
  constexpr double tiny = 0x1p-1000, most = 0x1p+1000;
  return (y * margin + tiny < x) & (x <= most);
}
/// The largest rounded distance for which certainly_greater holds.
inline constexpr double certain_distance = 0x1p+1023;

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

/// The sign of the sum of at most four terms in units of 2^lowest, in two's complement of 512 bits.
/// lowest <= exponent <= lowest + 403, so that they fit: the sum is below 4 * 2^106 * 2^403 =
/// 2^511.
inline int sign_of_close_sum(const dyadic_term* terms, int count, int lowest) {
  constexpr unsigned limbs = 8;
  std::array<std::uint64_t, limbs> sum{};
  for (int i = 0; i < count; ++i) {
    const dyadic_term& t = terms[i];
    const auto shift = static_cast<unsigned>(t.exponent - lowest);
    const unsigned bit = shift % 64;
    const auto low = static_cast<std::uint64_t>(t.magnitude);
    const auto high = static_cast<std::uint64_t>(t.magnitude >> 64);
    std::array<std::uint64_t, limbs + 1> placed{}; // shift / 64 <= 6
    std::uint64_t* const at = placed.data() + shift / 64;
    at[0] = low << bit;
    at[1] = high << bit | (low >> 1 >> (63 - bit));
    at[2] = high >> 1 >> (63 - bit);
    const std::uint64_t flip = t.negative ? ~std::uint64_t{0} : 0; // -x = ~x + 1
    std::uint64_t carry = flip & 1;
    for (unsigned j = 0; j < limbs; ++j) {
      const uint128 s = static_cast<uint128>(sum[j]) + (placed[j] ^ flip) + carry;
      sum[j] = static_cast<std::uint64_t>(s);
      carry = static_cast<std::uint64_t>(s >> 64);
    }
  }
  if (sum[limbs - 1] >> 63 != 0)
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
inline int sign_of_sum(dyadic_term* terms, int count) {
  constexpr int gap = 108;
  std::sort(terms, terms + count,
            [](const dyadic_term& x, const dyadic_term& y) { return x.exponent > y.exponent; });
  for (int first = 0; first < count;) {
    int last = first;
    while (last + 1 < count && terms[last].exponent - terms[last + 1].exponent < gap)
      ++last;
    if (const int sign = sign_of_close_sum(terms + first, last + 1 - first, terms[last].exponent);
        sign != 0)
      return sign;
    first = last + 1;
  }
  return 0;
}

/// The determinant as a sum of four products: for operands of any exponents.
[[gnu::noinline, gnu::cold]] inline int determinant_sign_of_any(const exact_distance& x,
                                                                double x_factor,
                                                                const exact_distance& y,
                                                                double y_factor) {
  std::array<dyadic_term, 4> terms;
  unsigned count = 0;
  const auto add = [&](double a, double b, bool negative) {
    const double_parts u(a), v(b);
    if (const auto product = static_cast<uint128>(u.significand) * v.significand; product != 0)
      terms[count++] = {product, u.exponent + v.exponent, negative != u.negative};
  };
  add(x.greater, x_factor, false);
  add(x.less, x_factor, true);
  add(y.greater, y_factor, true);
  add(y.less, y_factor, false);
  return sign_of_sum(terms.data(), static_cast<int>(count));
}

/// (greater - less) factor = (high 2^128 + low) 2^exponent, below 2^170 in those units, where the
/// difference's operands are within 2^63 of each other or 0; else `fits` is false.
struct wide_product {
  std::uint64_t high;
  uint128 low;
  int exponent;
  bool fits;

  wide_product(const exact_distance& distance, const double_parts& factor) {
    const double_parts g(distance.greater), l(distance.less);
    // zero has any exponent
    const int of_g = g.significand != 0 ? g.exponent : l.exponent;
    const int of_l = l.significand != 0 ? l.exponent : g.exponent;
    const int lower = std::min(of_g, of_l);
    const auto by_g = static_cast<unsigned>(of_g - lower),
               by_l = static_cast<unsigned>(of_l - lower);
    fits = (by_g | by_l) < 64;
    const auto signed_part = [](const double_parts& p, unsigned shift) {
      const uint128 flip = uint128{0} - uint128{p.negative};
      return ((static_cast<uint128>(p.significand) << (shift & 63)) ^ flip) - flip;
    };
    const uint128 difference = signed_part(g, by_g) - signed_part(l, by_l); // 0 <= it < 2^117
    const uint128 bottom =
        static_cast<uint128>(static_cast<std::uint64_t>(difference)) * factor.significand;
    const uint128 top =
        static_cast<uint128>(static_cast<std::uint64_t>(difference >> 64)) * factor.significand +
        static_cast<std::uint64_t>(bottom >> 64);
    low = top << 64 | static_cast<std::uint64_t>(bottom);
    high = static_cast<std::uint64_t>(top >> 64);
    exponent = lower + factor.exponent;
  }

  /// The 256-bit number times 2^shift, shift < 86, in halves.
  struct halves {
    uint128 high, low;
  };
  [[nodiscard]] halves shifted(unsigned shift) const {
    return {static_cast<uint128>(high) << shift | (low >> 1 >> (127 - shift)), low << shift};
  }
};

} // namespace detail

/// The sign of (x.greater - x.less) x_factor - (y.greater - y.less) y_factor, exactly, for all
/// finite doubles. The signs of the factors are ignored.
inline int determinant_sign(const exact_distance& x, double x_factor, const exact_distance& y,
                            double y_factor) {
  const detail::wide_product a(x, detail::double_parts(x_factor));
  const detail::wide_product b(y, detail::double_parts(y_factor));
  const int above = a.exponent - b.exponent;
  if (!a.fits || !b.fits || above >= 86 || above <= -86) [[unlikely]]
    return detail::determinant_sign_of_any(x, x_factor, y, y_factor);
  const auto p = a.shifted(static_cast<unsigned>(std::max(above, 0)));
  const auto q = b.shifted(static_cast<unsigned>(std::max(-above, 0)));
  const int by_high = (q.high < p.high) - (p.high < q.high);
  const int by_low = (q.low < p.low) - (p.low < q.low);
  return by_high != 0 ? by_high : by_low;
}

} // namespace graze::octree
