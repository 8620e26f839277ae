#include "angle_pair.hpp"
#include "angle_table.hpp"
#include "pairs.hpp"
#if defined(__x86_64__)

namespace graze::elementary {

namespace {
using namespace pairs;
constexpr both_doubles least_size(0x1p-100), greatest_size(0x1p+100), steps(128), step(0x1p-7),
    half_pi_high(0x1.921fb54442d2p+0), half_pi_low(-0x1.ee59d9cceba4p-50),
    pi_high(0x1.921fb54442d18p+1), pi_low(0x1.1a62633145c07p-53),
    minus_third(-0x1.5555555555555p-2), fifth(0x1.999999999999ap-3),
    minus_seventh(-0x1.2492492492492p-3), error(0x1.4p-74), least(0x1p-19);

// With d >= n > 0 the sizes of x and y, j the integer nearest to t = RN(n/d) times 128, c = j/128:
//   atan(n/d) = atan c + atan w, w = u/v, u = n - c d, v = d + c n,
//   |w| <= |n/d - c| <= 2^-8 + 2^-54,
// and the angle is 0, pi/2 or pi, plus or minus that. All to nearest; the errors of v and w are
// relative, the others absolute.
//   u is exact. For j = 0 it is n. Else t > 1/256 and so is n/d; n and c d are multiples of 2^-8
//     ulp(d). If n >= d/128 they are of 2^-7 ulp(d), and |u| <= (2^-8 + 2^-54) d has 53 bits; else
//     -d/256 < u <= 0, which has.
//   v = v0 + v1: d <= v0 <= 2d, so that d - v0 is exact; v1 <= 2^-53 v0 has an error of 2^-106.
//   w = w0 + w1: w0 = u RN(1/v0) within 2^-52, so that |w1| < 2^-51 |w|; the three roundings, and
//     v0 for v: 2^-102.
//   high = the multiple of pi/2 +- atan c, both multiples of 2^-48 below 4: exact. low, below
//     2^-48: 2^-101 with the errors of the constants.
//   sum + rest = high + w0 exactly: high = 0 or |high| > 2^-7.01 > |w0|.
//   cubic = w0^3 (-1/3 + w0^2/5 - w0^4/7), |cubic| < 2^-25.5: 5 roundings, 2^-76.1; truncated
//     w^9/9 < 2^-75.1; taken at w0 instead of w, w^2 |w1| < 1.5 2^-76.
//   rest + (cubic + (low + w1)): two roundings of values below 2^-25, 2^-78 each.
// In all 2^-76.1 + 2^-75.1 + 1.5 2^-76 + 2^-77 + 2^-100 < 0x1.4p-74 = `error`.
GRAZE_FUSED_INLINE bool decide(__m128d y, __m128d x, bounds& result) {
  const __m128d width = size(x), height = size(y);
  const __m128d d = _mm_max_pd(width, height), n = _mm_min_pd(width, height);
  // Compared as integers: a comparison with NaN would raise a flag.
  const __m128i beyond =
      _mm_or_si128(_mm_or_si128(_mm_cmpgt_epi64(_mm_castpd_si128(width), greatest_size.bits()),
                                _mm_cmpgt_epi64(_mm_castpd_si128(height), greatest_size.bits())),
                   _mm_or_si128(_mm_cmpgt_epi64(least_size.bits(), _mm_castpd_si128(width)),
                                _mm_cmpgt_epi64(least_size.bits(), _mm_castpd_si128(height))));
  if (_mm_movemask_pd(_mm_or_pd(not_to_nearest(), _mm_castsi128_pd(beyond))) != 0)
    return false;

  const __m128d shifted = _mm_fmadd_pd(_mm_div_pd(n, d), steps, shift);
  const __m128d c = _mm_mul_pd(_mm_sub_pd(shifted, shift), step);
  const __m128i j = _mm_castpd_si128(shifted);
  const __m128d p = _mm_load_pd(&angles[_mm_cvtsi128_si64(j) & 255].high);
  const __m128d q = _mm_load_pd(&angles[_mm_extract_epi64(j, 1) & 255].high);

  const __m128d u = _mm_fnmadd_pd(c, d, n), v = _mm_fmadd_pd(c, n, d);
  const __m128d v_rest = _mm_fmadd_pd(c, n, _mm_sub_pd(d, v)), reciprocal = _mm_div_pd(one, v);
  const __m128d w = _mm_mul_pd(u, reciprocal);
  const __m128d w_rest = _mm_mul_pd(reciprocal, _mm_fnmadd_pd(w, v_rest, _mm_fnmadd_pd(w, v, u)));

  // Steep: pi/2 minus the angle from the y axis; left of it, the mirror image.
  const __m128d steep = _mm_cmpgt_pd(height, width), left = _mm_and_pd(x, sign);
  const __m128d turn = _mm_xor_pd(_mm_and_pd(steep, sign), left);
  const __m128d zero = _mm_setzero_pd();
  const __m128d base_high = _mm_blendv_pd(_mm_blendv_pd(zero, pi_high, left), half_pi_high, steep);
  const __m128d base_low = _mm_blendv_pd(_mm_blendv_pd(zero, pi_low, left), half_pi_low, steep);
  const __m128d high = _mm_add_pd(base_high, _mm_xor_pd(_mm_unpacklo_pd(p, q), turn));
  const __m128d low = _mm_add_pd(base_low, _mm_xor_pd(_mm_unpackhi_pd(p, q), turn));
  const __m128d w0 = _mm_xor_pd(w, turn), w1 = _mm_xor_pd(w_rest, turn);

  const __m128d w2 = _mm_mul_pd(w0, w0);
  const __m128d cubic = _mm_mul_pd(
      _mm_mul_pd(w0, w2), _mm_fmadd_pd(w2, _mm_fmadd_pd(w2, minus_seventh, fifth), minus_third));
  __m128d sum, rest, a, b;
  fast_two_sum(high, w0, sum, rest);
  fast_two_sum(sum, _mm_add_pd(rest, _mm_add_pd(cubic, _mm_add_pd(low, w1))), a, b);
  const __m128d below_axis = _mm_and_pd(y, sign);
  a = _mm_xor_pd(a, below_axis), b = _mm_xor_pd(b, below_axis);
  asm volatile("" : "+x"(a), "+x"(b));
  if (!decided(a, b, error, least))
    return false;
  result = outward(a, b);
  return true;
}
} // namespace

// The corners are those of atan2::value. A coordinate that is 0, of either sign, takes the part of
// a number beside it: then a corner that is chosen has a zero coordinate, which is not decided.
GRAZE_FUSED bounds angle_if_decided(double y_lo, double y_hi, double x_lo, double x_hi) {
  const __m128d y = points(y_lo, y_hi), x = points(x_lo, x_hi);
  const __m128d y_swapped = _mm_shuffle_pd(y, y, 1);
  // The lower bound's is the right side unless there are points below the axis; the upper bound's
  // the right side if all are.
  const __m128d left = _mm_unpacklo_pd(x, x);
  const __m128d right = _mm_unpackhi_pd(x, x);
  const __m128d all_other = _mm_xor_pd(y, _mm_set_pd(0.0, -0.0)); // y_lo >= 0, y_hi < 0
  const __m128d at_x = _mm_blendv_pd(left, right, all_other);
  // Right of the y axis the angle increases with y, left of it it decreases.
  const __m128d at_y = _mm_blendv_pd(y, y_swapped, at_x);
  bounds result;
  return decide(at_y, at_x, result) ? result : bounds::empty();
}

} // namespace graze::elementary
#endif
