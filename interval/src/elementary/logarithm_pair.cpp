#include "logarithm_pair.hpp"
#include "logarithm_table.hpp"
#include "pairs.hpp"
#if defined(__x86_64__)

namespace graze::elementary {

namespace {
using namespace pairs;
constexpr both_integers below_normal(0x000fffffffffffff), infinity(0x7ff0000000000000),
    eleven_sixteenths(0x3fe6000000000000), seven_bits(127), exponent_bits(-0x10000000000000),
    two_62(0x4000000000000000);
constexpr struct {
  both_doubles ln2_high{0x1.62e42fefa38p-1}, ln2_low{0x1.ef35793c7673p-45}, two_52{0x1p+52},
      biased{0x1p+52 + 1024}, minus_half{-0.5}, third{0x1.5555555555555p-2}, minus_quarter{-0.25},
      fifth{0x1.999999999999ap-3}, minus_sixth{-0x1.5555555555555p-3},
      seventh{0x1.2492492492492p-3}, minus_eighth{-0.125}, ninth{0x1.c71c71c71c71cp-4},
      error{0x1.28p-66}, least{0x1p-11};
} constants;

// With x = 2^e m, m in [11/16, 11/8), r the table's reciprocal and z = r m - 1, |z| <= 2^-7:
//   log x = (e ln2 - log r) + log(1 + z).
// Everything is to nearest; the errors are absolute.
//   z is exact: r m is a multiple of the unit of r times 2^-53 (m < 1) or 2^-52, in which z is an
//     integer of at most 53 bits (the test of the table).
//   e ln2_high (42 + 11 bits) and e ln2_high + high (multiples of 2^-42 below 2^10) are exact.
//   c = e ln2_low + low, below 2^-33: 2^-85 with the errors of the constants.
//   q = -1/2 + z/3 - ... + z^7/9, |q| < 0.503: 2^-54 each in -1/2 + z/3 and at the end, 2^-62 the
//     rest. z^2 < 2^-14: 2^-68. Of z^2 q: 2^-67 + 2^-76 from q, 2^-69 from z^2, and by truncation
//     (z^10/10 and beyond) 2^-73.
//   s = z^2 q + c: |s| < 2^-14, 2^-68.
//   sum + rest = high + z exactly: high = 0 or |high| >= |z| (the test of the table; for e != 0
//     |high| > 0.3). rest + s: |rest| <= 2^-44, together below 2^-14, 2^-68.
// In all 2^-67 + 2^-69 + 2 2^-68 + 2^-73 + 2^-76 + 2^-85 < 0x1.28p-66 = `error`.
GRAZE_FUSED_INLINE bool decide(double lo, double hi, bounds& result) {
  const auto& constant = in_memory(constants);
  const __m128d ends = points(lo, hi);
  const __m128i bits = _mm_castpd_si128(ends);
  const __m128i normal =
      _mm_and_si128(_mm_cmpgt_epi64(bits, below_normal), _mm_cmpgt_epi64(infinity, bits));
  if (_mm_movemask_pd(_mm_andnot_pd(not_to_nearest(), _mm_castsi128_pd(normal))) != 3)
    return false;

  const __m128i above = _mm_sub_epi64(bits, eleven_sixteenths); // over 11/16
  const __m128i index = _mm_and_si128(_mm_srli_epi64(above, 52 - 7), seven_bits);
  const __m128i exponent = _mm_and_si128(above, exponent_bits); // e 2^52
  const __m128d m = _mm_castsi128_pd(_mm_sub_epi64(bits, exponent));
  // e + 1024 as the last bits of 2^52 + e + 1024.
  const __m128i positive = _mm_srli_epi64(_mm_add_epi64(exponent, two_62), 52);
  const __m128d e =
      _mm_sub_pd(_mm_or_pd(_mm_castsi128_pd(positive), constant.two_52), constant.biased);

  const logarithm_entry& first = logarithms[_mm_cvtsi128_si64(index)];
  const logarithm_entry& second = logarithms[_mm_extract_epi64(index, 1)];
  const __m128d p = _mm_load_pd(&first.reciprocal), q = _mm_load_pd(&second.reciprocal);
  const __m128d low = _mm_loadh_pd(_mm_load_sd(&first.low), &second.low);
  const __m128d z = _mm_fmsub_pd(_mm_unpacklo_pd(p, q), m, one);
  const __m128d high = _mm_fmadd_pd(e, constant.ln2_high, _mm_unpackhi_pd(p, q));
  const __m128d c = _mm_fmadd_pd(e, constant.ln2_low, low);

  const __m128d z2 = _mm_mul_pd(z, z);
  const __m128d t0 = _mm_fmadd_pd(z, constant.third, constant.minus_half);
  const __m128d t1 = _mm_fmadd_pd(z, constant.fifth, constant.minus_quarter);
  const __m128d t2 = _mm_fmadd_pd(z, constant.seventh, constant.minus_sixth);
  const __m128d t3 = _mm_fmadd_pd(z, constant.ninth, constant.minus_eighth);
  const __m128d polynomial = _mm_fmadd_pd(z2, _mm_fmadd_pd(z2, _mm_fmadd_pd(z2, t3, t2), t1), t0);
  const __m128d s = _mm_fmadd_pd(z2, polynomial, c);
  __m128d sum, rest, a, b;
  fast_two_sum(high, z, sum, rest);
  fast_two_sum(sum, _mm_add_pd(rest, s), a, b);
  asm volatile("" : "+x"(a), "+x"(b));
  if (!decided(a, b, constant.error, constant.least))
    return false;
  result = outward(a, b);
  return true;
}
} // namespace

GRAZE_FUSED bounds logarithm_pair(double lo, double hi) {
  bounds result;
  return __builtin_expect(decide(lo, hi, result), 1) ? result : logarithm_each(lo, hi);
}

GRAZE_FUSED bounds logarithm_if_decided(double lo, double hi) {
  bounds result;
  return decide(lo, hi, result) ? result : bounds::empty();
}

} // namespace graze::elementary
#endif
