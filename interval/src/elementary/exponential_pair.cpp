#include "exponential_pair.hpp"
#include "exponential_table.hpp"
#if defined(__x86_64__)
#include <cstdint>
#include <immintrin.h>

namespace graze::elementary {

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
//   2^-61
//     (the product low u is within; its rounding is 2^-106).
// Hence |e^x / 2^m - (high + v)| < 2^-60 + 2^-66, and high + v = a + b exactly with a = RN(high +
// v).
bool __attribute__((target("avx2,fma"))) exponential_pair(const bounds& x, bounds& result) {
  const __m128d ends = _mm_set_pd(x.hi, x.lo);

  // To nearest, 1 + 2^-60 and 1 - 2^-60 are 1; in any other mode one of them is not.
  __m128d one = _mm_set1_pd(1), tiny = _mm_set1_pd(0x1p-60);
  asm("" : "+x"(one), "+x"(tiny));
  const __m128d unmoved = _mm_cmpeq_pd(_mm_addsub_pd(one, tiny), one);
  // As integers, since a comparison with NaN, or an infinite product below, would raise a flag.
  const __m128i magnitude = _mm_and_si128(_mm_castpd_si128(ends), _mm_set1_epi64x(INT64_MAX));
  const __m128i usual = _mm_cmpgt_epi64(_mm_castpd_si128(_mm_set1_pd(708)), magnitude);
  if (_mm_movemask_pd(_mm_and_pd(unmoved, _mm_castsi128_pd(usual))) != 3)
    return false;

  // Beside 1.5 2^52 the unit is 1: the sum's last bits are k.
  const __m128d shift = _mm_set1_pd(0x1.8p+52);
  const __m128d shifted =
      _mm_add_pd(_mm_mul_pd(ends, _mm_set1_pd(0x1.71547652b82fep+7)), shift); // 1/L
  const __m128d k = _mm_sub_pd(shifted, shift);
  const __m128i bits = _mm_castpd_si128(shifted);
  const __m128i within = _mm_set1_epi64x(127);
  const __m128i i = _mm_and_si128(bits, within);
  const __m128i scale = _mm_slli_epi64(_mm_andnot_si128(within, bits), 52 - 7); // m, as an exponent

  const __m128d rest = _mm_fnmadd_pd(k, _mm_set1_pd(0x1.62e42fefcp-8), ends);   // x - k L1
  const __m128d correction = _mm_mul_pd(k, _mm_set1_pd(0x1.c610ca86c3899p-44)); // -k L2
  const __m128d z = _mm_add_pd(rest, correction);
  const __m128d z2 = _mm_mul_pd(z, z);
  const __m128d high_terms = _mm_fmadd_pd(
      z2, _mm_set1_pd(1.0 / 720), _mm_fmadd_pd(z, _mm_set1_pd(1.0 / 120), _mm_set1_pd(1.0 / 24)));
  const __m128d low_terms = _mm_fmadd_pd(z, _mm_set1_pd(1.0 / 6), _mm_set1_pd(0.5));
  const __m128d p = _mm_mul_pd(z2, _mm_fmadd_pd(z2, high_terms, low_terms));
  const __m128d u = _mm_add_pd(rest, _mm_add_pd(correction, p));

  const __m128d first = _mm_load_pd(&powers_of_two[_mm_cvtsi128_si64(i)].high);
  const __m128d second = _mm_load_pd(&powers_of_two[_mm_extract_epi64(i, 1)].high);
  const __m128d high = _mm_unpacklo_pd(first, second), low = _mm_unpackhi_pd(first, second);
  const __m128d v = _mm_fmadd_pd(high, u, _mm_fmadd_pd(low, u, low));
  const __m128d a = _mm_add_pd(high, v), b = _mm_sub_pd(v, _mm_sub_pd(a, high));

  // The value is beyond a by more than 0 and less than the step to the next double, on b's side.
  const __m128d error = _mm_set1_pd(0x1.04p-60);
  const __m128d decided = _mm_cmpgt_pd(_mm_andnot_pd(_mm_set1_pd(-0.0), b), error);
  if (_mm_movemask_pd(decided) != 3)
    return false;
  // One step down at lo if b < 0, one up at hi if b > 0. Doubles above 0 are ordered as integers.
  const __m128d towards = _mm_xor_pd(b, _mm_set_pd(-0.0, 0.0));
  const __m128i beyond = _mm_castpd_si128(_mm_cmplt_pd(towards, _mm_setzero_pd())); // -1 or 0
  const __m128i upper = _mm_set_epi64x(-1, 0);
  const __m128i step =
      _mm_sub_epi64(_mm_xor_si128(beyond, upper), upper); // -1, 0 at lo; 0, 1 at hi
  const __m128d bound =
      _mm_castsi128_pd(_mm_add_epi64(_mm_add_epi64(_mm_castpd_si128(a), scale), step));
  result = {_mm_cvtsd_f64(bound), _mm_cvtsd_f64(_mm_unpackhi_pd(bound, bound))};
  return true;
}

} // namespace graze::elementary
#endif
