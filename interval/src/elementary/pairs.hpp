#pragma once
/// What the fast evaluations of two points at once share: lane 0 for the lower bound, lane 1 for
/// the upper one. For processors with AVX2 and fused operations. Internal.
#if defined(__x86_64__)
#include <cstdint>
#include <graze/bounds.hpp>
#include <immintrin.h>

#define GRAZE_FUSED __attribute__((target("avx2,fma")))
#define GRAZE_FUSED_INLINE GRAZE_FUSED __attribute__((always_inline)) inline

namespace graze::elementary {

/// A constant in both lanes, in memory: an operand of the instruction that uses it. Quotients such
/// as 1.0 / 6 would be left to the processor by -frounding-math.
struct alignas(16) both_doubles {
  double value[2];
  constexpr both_doubles(double x) : value{x, x} {}
  GRAZE_FUSED __attribute__((always_inline)) operator __m128d() const { return _mm_load_pd(value); }
  [[nodiscard]] GRAZE_FUSED __attribute__((always_inline)) __m128i bits() const {
    return _mm_castpd_si128(_mm_load_pd(value));
  }
};
/// The same of integers.
struct alignas(16) both_integers {
  std::int64_t value[2];
  constexpr both_integers(std::int64_t x) : value{x, x} {}
  GRAZE_FUSED __attribute__((always_inline)) operator __m128i() const {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(value));
  }
};

namespace pairs {
inline constexpr both_doubles one(1), nudge(0x1p-60), sign(-0.0), half(0.5);
/// Beside 1.5 2^52 the unit is 1: a sum's last bits are the integer nearest.
inline constexpr both_doubles shift(0x1.8p+52);

/// A table of constants that GCC 12 takes from memory, as operands: of ones that it sees it makes
/// an instruction each.
template <class Constants>
GRAZE_FUSED __attribute__((always_inline)) inline const Constants& in_memory(const Constants& x) {
  const Constants* address = &x;
  asm("" : "+r"(address));
  return *address;
}

/// Two points; no operation on them may be moved to where another mode is in force.
GRAZE_FUSED_INLINE __m128d points(double x, double y) {
  __m128d ends = _mm_set_pd(y, x);
  asm volatile("" : "+x"(ends));
  return ends;
}
/// Set in a lane (one of them at least) unless the mode is to nearest: only there 1 + 2^-60 and
/// 1 - 2^-60 are 1.
GRAZE_FUSED_INLINE __m128d not_to_nearest() {
  __m128d tiny = nudge;
  asm volatile("" : "+x"(tiny));
  return _mm_cmpneq_pd(_mm_addsub_pd(one, tiny), one);
}
GRAZE_FUSED_INLINE __m128d size(__m128d x) { return _mm_andnot_pd(sign, x); }

/// a + b = x + y exactly for x = 0, or |x| >= |y|, or x and y multiples of a unit in which x + y is
/// a double (Dekker).
GRAZE_FUSED_INLINE void fast_two_sum(__m128d x, __m128d y, __m128d& a, __m128d& b) {
  a = _mm_add_pd(x, y);
  b = _mm_sub_pd(y, _mm_sub_pd(a, x));
}

/// Of a value a + b + e with a = RN(a + b), |e| < error, |a| >= least and error < 2^-54 least (half
/// the step inwards from a power of two `least`): is |b| > error? Then the value is beyond a on b's
/// side, by less than one step. True if so in both lanes.
GRAZE_FUSED_INLINE bool decided(__m128d a, __m128d b, __m128d error, __m128d least) {
  return _mm_movemask_pd(_mm_and_pd(_mm_cmpgt_pd(size(b), error), _mm_cmpge_pd(size(a), least))) ==
         3;
}
/// Of such values, not 0: a, or the neighbour on the side of b where a lane's bit of `up` (then for
/// b > 0) or of its complement (for b < 0) asks for it.
GRAZE_FUSED_INLINE __m128d neighbour(__m128d a, __m128d b, __m128i up) {
  const __m128i zero = _mm_setzero_si128();
  const __m128i b_negative = _mm_cmpgt_epi64(zero, _mm_castpd_si128(b));
  const __m128i a_negative = _mm_cmpgt_epi64(zero, _mm_castpd_si128(a));
  // Doubles are ordered as integers, those below 0 the other way round. b_negative - up is -1 for a
  // step down, +1 for one up: up is -1 in a lane that rounds up.
  const __m128i step = _mm_sub_epi64(b_negative, up);
  const __m128i signed_step = _mm_sub_epi64(_mm_xor_si128(step, a_negative), a_negative);
  return _mm_castsi128_pd(_mm_add_epi64(_mm_castpd_si128(a), signed_step));
}
/// The lanes as bounds, each in a register: GCC 12 returns them through memory where it sees that
/// they come from one.
GRAZE_FUSED_INLINE bounds to_bounds(__m128d lower_and_upper) {
  __m128d upper = _mm_unpackhi_pd(lower_and_upper, lower_and_upper);
  asm volatile("" : "+x"(lower_and_upper), "+x"(upper));
  return {_mm_cvtsd_f64(lower_and_upper), _mm_cvtsd_f64(upper)};
}
/// {RD, RU} of lanes 0 and 1.
GRAZE_FUSED_INLINE bounds outward(__m128d a, __m128d b) {
  static constexpr struct alignas(16) {
    std::int64_t value[2];
  } up{{0, -1}};
  return to_bounds(neighbour(a, b, _mm_load_si128(reinterpret_cast<const __m128i*>(up.value))));
}
} // namespace pairs
} // namespace graze::elementary
#endif
