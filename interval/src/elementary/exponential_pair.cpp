#include "exponential_pair.hpp"
#include "exponential_table.hpp"
#include "pairs.hpp"
#if defined(__x86_64__)

namespace graze::elementary {

namespace {
using namespace pairs;
constexpr both_integers seven_bits(127);
constexpr both_doubles limit(708), inverse(0x1.71547652b82fep+7), step_high(0x1.62e42fefcp-8),
    step_low(0x1.c610ca86c3899p-44), sixth(0x1.5555555555555p-3),
    reciprocal_24(0x1.5555555555555p-5), reciprocal_120(0x1.1111111111111p-7),
    reciprocal_720(0x1.6c16c16c16c17p-10), error(0x1.04p-60);

// With x = k L + r, L = ln2/128, |r| <= (1/2 + 2^-35) L < 2^-8.52, and k = 128 m + i:
//   e^x = 2^m T e^r,  T = 2^(i/128) = high + low in [1, 2).
// Everything is to nearest; the errors are absolute, before the exact scaling by 2^m.
//   L = L1 + L2, L1 of 35 bits, |L2| < 2^-43. |k| < 2^17, so that k L1 is exact. x - k L1 is exact:
//     for k = 0 trivially; else |x| > 2^-8.6, both terms are multiples of 2^-61 and the difference
//     is below 2^-8. k L2 < 2^-26 has an error below 2^-78.
//   z = r rounded: 2^-62. In p below that is 2^-70.
//   p = z^2 (1/2 + z/6 + ... + z^4/720), |p| < 2^-18: truncated 2^-72, rounded 2^-69.
//   s = p - k L2: 2^-71. u = (x - k L1) + s: |u| < 2^-8.5, 2^-62.
//   v = T u + low: |v| < 2^-7.5; T times the errors so far, 2^-61 + 2^-67, and its own rounding,
//     2^-61 (the product low u is within; its rounding is 2^-106).
// Hence |e^x / 2^m - (high + v)| < 2^-60 + 2^-66 = `error`, and high + v = a + b exactly with
// a = RN(high + v) and |b| at most half the step from a to the next double on b's side.
GRAZE_FUSED_INLINE bool decide(double lo, double hi, bounds& result) {
  __m128d ends = _mm_set_pd(hi, lo), tiny = nudge;
  // No operation below may be moved to where another mode is in force.
  asm volatile("" : "+x"(ends), "+x"(tiny));

  // To nearest, 1 + 2^-60 and 1 - 2^-60 are 1; in any other mode one of them is not. The size is
  // compared as integers: a comparison with NaN, or an infinite product below, would raise a flag.
  const __m128d moved = _mm_cmpneq_pd(_mm_addsub_pd(one, tiny), one);
  const __m128i large =
      _mm_cmpgt_epi64(_mm_castpd_si128(_mm_andnot_pd(sign, ends)), _mm_castpd_si128(limit));
  if (_mm_movemask_pd(_mm_or_pd(moved, _mm_castsi128_pd(large))) != 0)
    return false;

  // Beside 1.5 2^52 the unit is 1: the sum's last bits are k.
  const __m128d shifted = _mm_add_pd(_mm_mul_pd(ends, inverse), shift);
  const __m128d k = _mm_sub_pd(shifted, shift);
  const __m128i bits = _mm_castpd_si128(shifted), within = seven_bits;
  const __m128i i = _mm_and_si128(bits, within);
  const __m128i scale = _mm_slli_epi64(_mm_andnot_si128(within, bits), 52 - 7); // m, as an exponent
  const __m128d first = _mm_load_pd(&powers_of_two[_mm_cvtsi128_si64(i)].high);
  const __m128d second = _mm_load_pd(&powers_of_two[_mm_extract_epi64(i, 1)].high);
  const __m128d high = _mm_unpacklo_pd(first, second), low = _mm_unpackhi_pd(first, second);

  const __m128d rest = _mm_fnmadd_pd(k, step_high, ends); // x - k L1
  const __m128d correction = _mm_mul_pd(k, step_low);     // -k L2
  const __m128d z = _mm_add_pd(rest, correction), z2 = _mm_mul_pd(z, z);
  const __m128d high_terms =
      _mm_fmadd_pd(z2, reciprocal_720, _mm_fmadd_pd(z, reciprocal_120, reciprocal_24));
  const __m128d p = _mm_mul_pd(z2, _mm_fmadd_pd(z2, high_terms, _mm_fmadd_pd(z, sixth, half)));
  const __m128d u = _mm_add_pd(rest, _mm_add_pd(correction, p));
  const __m128d v = _mm_fmadd_pd(high, u, _mm_fmadd_pd(low, u, low));
  __m128d a = _mm_add_pd(high, v), b = _mm_sub_pd(v, _mm_sub_pd(a, high));
  asm volatile("" : "+x"(a), "+x"(b));

  // The value is beyond a by more than 0 and less than the step to the next double, on b's side.
  if (_mm_movemask_pd(_mm_cmpgt_pd(_mm_andnot_pd(sign, b), error)) != 3)
    return false;
  // One step down at lo if b < 0, one up at hi if b > 0. Doubles above 0 are ordered as integers.
  const __m128i down_if_negative = _mm_cmpgt_epi64(_mm_setzero_si128(), _mm_castpd_si128(b));
  const __m128i step = _mm_add_epi64(down_if_negative, _mm_set_epi64x(1, 0));
  const __m128d bound =
      _mm_castsi128_pd(_mm_add_epi64(_mm_add_epi64(_mm_castpd_si128(a), scale), step));
  result = to_bounds(bound);
  return true;
}

} // namespace

GRAZE_FUSED bounds exponential_pair(double lo, double hi) {
  bounds result;
  return __builtin_expect(decide(lo, hi, result), 1) ? result : exponential_each(lo, hi);
}

GRAZE_FUSED bounds exponential_if_decided(double lo, double hi) {
  bounds result;
  return decide(lo, hi, result) ? result : bounds::empty();
}

} // namespace graze::elementary
#endif
