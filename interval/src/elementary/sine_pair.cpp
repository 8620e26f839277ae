#include "sine_pair.hpp"
#include "pairs.hpp"
#include "sine_table.hpp"
#if defined(__x86_64__)

namespace graze::elementary {

namespace {
using namespace pairs;
constexpr both_doubles least_size(0x1p-12), greatest_size(1024), inverse(0x1.45f306dc9c883p+6),
    step_high(0x1.921fb5444p-7), step_middle(0x1.68c234c5p-46), step_low(-0x1.cceba3f91f197p-81),
    minus_half(-0.5), reciprocal_24(0x1.5555555555555p-5),
    minus_reciprocal_720(-0x1.6c16c16c16c17p-10), minus_sixth(-0x1.5555555555555p-3),
    reciprocal_120(0x1.1111111111111p-7), minus_reciprocal_5040(-0x1.a01a01a01a01ap-13),
    error(0x1p-66), least(0x1p-11), tangent_error(0x1.03p-66), two_55(0x1p55);

// With L = pi/256, x = k L + r, |r| < (1/2 + 2^-34) L < 2^-7.34, S = sin(k L), C = cos(k L):
//   sin x = S + C r + S (cos r - 1) + C (sin r - r); cos x the same, with k + 128 in S and C.
// Everything is to nearest; the errors are absolute. |k| < 2^17.
//   L = L1 + L2 + L3 of 36, 33 and 53 bits, multiples of 2^-42 and 2^-78;
//     |L2| < 2^-45, |L3| < 2^-80.
//   t = x - k L1 is exact: for k = 0 trivially; else |x| > 2^-7.4, both terms are multiples of
//     2^-60, and |t| < 2^-7. w = k L2, below 2^-28, is exact.
//   r0 + d = t - w exactly: if |t| < |w|, t - w is a multiple of 2^-78 (or, for k = 0, t) below
//     2^-27.
//   r1 = d - k L3: |r1| < 2^-61 + 2^-63, with an error below 2^-113. |r - r0 - r1| < 2^-112.
//   A + B = S0 + C0 r0 exactly but for the product's rest, which P is:
//     S0 = 0 or |S0| > 0.0122 > |C0 r0|.
//   S = S0 + S1, C = C0 + C1, |S1|, |C1| <= 2^-54, to 2^-107 each.
//   small = P + (C0 r1 + (C1 r0 + S1)): below 2^-52, 2^-104.
//   cos r - 1 and sin r - r are taken at r0: S (cos r0 - cos r) < |r r1| < 2^-67.9; the other
//     2^-75.
//   q = r0^2 (-1/2 + r0^2/24 - r0^4/720), |q| < 2^-15.68: r0^2 2^-53 relatively, 2^-68.68; the
//     bracket below 1/2 2^-55 (and 2^-65): 2^-69.6; the product 2^-69; truncated
//     r^8/40320 < 2^-74.
//   c = r0^3 (-1/6 + r0^2/120 - r0^4/5040), |c| < 2^-24.6: 2^-75 in all; truncated 2^-84.
//   v = S0 q + C0 c, |v| < 2^-15.6: 2^-69 (and S1 q, C1 c: 2^-69.6). B + small, |.| < 2^-51:
//     2^-104. Their sum with v 2^-69.
// In all 2^-67.9 + 2^-68.68 + 2^-69.6 + 2^-69 + 2^-69 + 2^-69.6 + 2^-69 + 5 2^-75 < 2^-66 =
// `error`.
struct reduced {
  __m128d r0, r1;
  __m128i k; ///< in the last 51 bits, two's complement
};
GRAZE_FUSED_INLINE reduced reduce(__m128d x) {
  const __m128d shifted = _mm_fmadd_pd(x, inverse, shift);
  const __m128d k = _mm_sub_pd(shifted, shift);
  const __m128d t = _mm_fnmadd_pd(k, step_high, x), w = _mm_mul_pd(k, step_middle);
  const __m128d r0 = _mm_sub_pd(t, w), d = _mm_sub_pd(_mm_sub_pd(t, r0), w);
  return {r0, _mm_fnmadd_pd(k, step_low, d), _mm_castpd_si128(shifted)};
}

struct high_and_low {
  __m128d high, low;
};
/// sin((k + offset) L).
GRAZE_FUSED_INLINE high_and_low sines_of(__m128i k, int offset) {
  const std::int64_t i = _mm_cvtsi128_si64(k) + offset, j = _mm_extract_epi64(k, 1) + offset;
  const __m128d s = _mm_load_pd(&sines[i & 511].high), t = _mm_load_pd(&sines[j & 511].high);
  return {_mm_unpacklo_pd(s, t), _mm_unpackhi_pd(s, t)};
}

/// sin(x + offset L) = a + b within `error`, a = RN(a + b).
GRAZE_FUSED_INLINE void evaluate(const reduced& x, int offset, __m128d& a, __m128d& b) {
  const high_and_low s = sines_of(x.k, offset), c = sines_of(x.k, offset + 128);
  const __m128d r = x.r0, product = _mm_mul_pd(c.high, r);
  const __m128d product_rest = _mm_fmsub_pd(c.high, r, product);
  __m128d sum, sum_rest;
  fast_two_sum(s.high, product, sum, sum_rest);
  const __m128d small =
      _mm_add_pd(product_rest, _mm_fmadd_pd(c.high, x.r1, _mm_fmadd_pd(c.low, r, s.low)));
  const __m128d r2 = _mm_mul_pd(r, r);
  const __m128d q = _mm_mul_pd(
      r2, _mm_fmadd_pd(r2, _mm_fmadd_pd(r2, minus_reciprocal_720, reciprocal_24), minus_half));
  const __m128d cubic = _mm_mul_pd(
      _mm_mul_pd(r, r2),
      _mm_fmadd_pd(r2, _mm_fmadd_pd(r2, minus_reciprocal_5040, reciprocal_120), minus_sixth));
  const __m128d v = _mm_fmadd_pd(s.high, q, _mm_mul_pd(c.high, cubic));
  fast_two_sum(sum, _mm_add_pd(v, _mm_add_pd(sum_rest, small)), a, b);
}

/// Both ends' sizes within [2^-12, 1024], and the mode to nearest. Compared as integers: a
/// comparison with NaN would raise a flag, as an underflow would.
GRAZE_FUSED_INLINE bool moderate(__m128d x) {
  const __m128i bits = _mm_castpd_si128(size(x));
  const __m128i beyond =
      _mm_or_si128(_mm_cmpgt_epi64(bits, _mm_castpd_si128(__m128d(greatest_size))),
                   _mm_cmpgt_epi64(_mm_castpd_si128(__m128d(least_size)), bits));
  return _mm_movemask_pd(_mm_or_pd(not_to_nearest(), _mm_castsi128_pd(beyond))) == 0;
}

/// floor(2x/pi) of both. For k no multiple of 128 that is floor(k/128); else the sign of r decides,
/// which is r0's where |r| > 2^-60. Where it is less, x is within 2^-60 of a multiple of pi/2:
/// one of sin x and cos x is below `least`, and the other within 2^-119 of +-1, hence not decided.
GRAZE_FUSED_INLINE void quarters(const reduced& x, std::int64_t& first, std::int64_t& second) {
  const auto k = [](std::int64_t bits) {
    return static_cast<std::int64_t>(std::uint64_t(bits) << 13) >> 13;
  };
  const int negative = _mm_movemask_pd(x.r0);
  first = (k(_mm_cvtsi128_si64(x.k)) - (negative & 1)) >> 7;
  second = (k(_mm_extract_epi64(x.k, 1)) - (negative >> 1)) >> 7;
}

} // namespace

GRAZE_FUSED bounds wave_if_decided(double lo, double hi, int shift_by) {
  const __m128d ends = points(lo, hi);
  if (!moderate(ends))
    return bounds::empty();
  const reduced x = reduce(ends);
  __m128d a, b;
  evaluate(x, shift_by * 128, a, b);
  asm volatile("" : "+x"(a), "+x"(b));
  if (!decided(a, b, error, least))
    return bounds::empty();
  std::int64_t first, second;
  quarters(x, first, second);
  // Of an interval in one quarter or with one extreme, the other bounds are at its ends.
  const __m128d down = neighbour(a, b, _mm_setzero_si128());
  const __m128d up = neighbour(a, b, _mm_set1_epi64x(-1));
  bounds range{_mm_cvtsd_f64(_mm_min_sd(down, _mm_unpackhi_pd(down, down))),
               _mm_cvtsd_f64(_mm_max_sd(up, _mm_unpackhi_pd(up, up)))};
  // Extremes are where quarter 0 of sin ends (the greatest) and where quarter 2 ends (the least).
  const std::int64_t crossed = second - first, quarter = first + shift_by;
  if (__builtin_expect(crossed != 0, 0)) {
    if ((-quarter & 3) < crossed)
      range.hi = 1;
    if (((2 - quarter) & 3) < crossed)
      range.lo = -1;
  }
  return range;
}

// With sin = s + s' and cos = c + c' as above, each within E = 2^-66 and none below 2^-11, and T =
// RN(s/c): the quotient of the sums is T + (s - T c + s' - T c') / (c + c'). s - T c is exact. The
// second term is below 2^-51 |T|; its roundings, and c for c + c', are each 2^-53 of that. E moves
// the quotient by at most E (1 + |tan|) / |c + c' - E|. `error` below is 1.01 of E (1 + |T|) / |c|,
// the difference more than all the rest.
GRAZE_FUSED bounds tangent_if_decided(double lo, double hi) {
  const __m128d ends = points(lo, hi);
  if (!moderate(ends))
    return bounds::empty();
  const reduced x = reduce(ends);
  __m128d s, s_rest, c, c_rest, a, b;
  evaluate(x, 0, s, s_rest);
  evaluate(x, 128, c, c_rest);
  const __m128d t = _mm_div_pd(s, c), reciprocal = _mm_div_pd(one, c);
  const __m128d rest = _mm_fnmadd_pd(t, c, s);
  const __m128d second = _mm_mul_pd(reciprocal, _mm_add_pd(rest, _mm_fnmadd_pd(t, c_rest, s_rest)));
  fast_two_sum(t, second, a, b);
  __m128d doubt = _mm_mul_pd(size(reciprocal), _mm_fmadd_pd(size(t), tangent_error, tangent_error));
  asm volatile("" : "+x"(a), "+x"(b), "+x"(doubt));
  const __m128d both_large = _mm_cmpge_pd(_mm_min_pd(size(s), size(c)), least);
  if (_mm_movemask_pd(both_large) != 3)
    return bounds::empty();
  // Poles are where quarters 0 and 2 end.
  std::int64_t first, last;
  quarters(x, first, last);
  if (last - first >= 2 || (last != first && (first & 1) == 0))
    return bounds::entire();
  if (!decided(a, b, doubt, _mm_mul_pd(doubt, two_55)))
    return bounds::empty();
  return outward(a, b);
}

} // namespace graze::elementary
#endif
