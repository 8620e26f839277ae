#pragma once
/// SSE2, which every x86-64 has: two lanes, rounding upward by the mode in force (scope).
#if !defined(__x86_64__)
#error "graze: this path is for x86-64"
#endif
#include <emmintrin.h>
#include <graze/batch/upward_path.hpp>
#include <graze/rounding/fused.hpp>

namespace graze::batch {

/// Arithmetic is written as volatile asm: nothing is folded, merged or moved across the scope.
struct sse2_registers {
  static constexpr std::size_t width = 2;
  using vector = __m128d;
  using mask = __m128d;

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  GRAZE_BATCH_OPERATION vector load(const double* p) { return _mm_loadu_pd(p); }
  GRAZE_BATCH_OPERATION void store(double* p, vector x) { _mm_storeu_pd(p, x); }
  GRAZE_BATCH_OPERATION vector broadcast(double x) { return _mm_set1_pd(x); }
  GRAZE_BATCH_OPERATION vector zero() { return _mm_setzero_pd(); }

// The VEX form under AVX: legacy SSE instructions between VEX ones cost a state transition.
#if defined(__AVX__)
#define GRAZE_BATCH_BINARY(name)                                                                   \
  GRAZE_BATCH_OPERATION vector name(vector x, vector y) {                                          \
    asm volatile("v" #name "pd %2, %1, %0" : "=x"(x) : "x"(x), "x"(y));                            \
    return x;                                                                                      \
  }
#else
#define GRAZE_BATCH_BINARY(name)                                                                   \
  GRAZE_BATCH_OPERATION vector name(vector x, vector y) {                                          \
    asm volatile(#name "pd %1, %0" : "+x"(x) : "x"(y));                                            \
    return x;                                                                                      \
  }
#endif
  GRAZE_BATCH_BINARY(add)
  GRAZE_BATCH_BINARY(sub)
  GRAZE_BATCH_BINARY(mul)
  GRAZE_BATCH_BINARY(div)
#undef GRAZE_BATCH_BINARY
  GRAZE_BATCH_OPERATION vector sqrt(vector x) {
#if defined(__AVX__)
    asm volatile("vsqrtpd %1, %0" : "=x"(x) : "x"(x));
#else
    asm volatile("sqrtpd %1, %0" : "=x"(x) : "x"(x));
#endif
    return x;
  }
  // SSE2 has no fused operation: one number at a time, in the mode that fused.hpp needs.
  GRAZE_BATCH_OPERATION vector fma_up(vector x, vector y, vector z) {
    return fma<&rounding::fma_up>(x, y, z);
  }
  GRAZE_BATCH_OPERATION vector fma_down(vector x, vector y, vector z) {
    return fma<&rounding::fma_down>(x, y, z);
  }

  GRAZE_BATCH_OPERATION vector neg(vector x) { return _mm_xor_pd(x, broadcast(-0.0)); }
  GRAZE_BATCH_OPERATION vector abs(vector x) { return _mm_andnot_pd(broadcast(-0.0), x); }
  GRAZE_BATCH_OPERATION vector max_or_second(vector p, vector q) { return _mm_max_pd(p, q); }
  GRAZE_BATCH_OPERATION vector min_or_second(vector p, vector q) { return _mm_min_pd(p, q); }
  GRAZE_BATCH_OPERATION vector bits_or(vector p, vector q) { return _mm_or_pd(p, q); }
  GRAZE_BATCH_OPERATION vector bits_and(vector p, vector q) { return _mm_and_pd(p, q); }
  GRAZE_BATCH_OPERATION vector predecessor_where(mask m,
                                                 vector x) { // a true lane is the integer -1
    return _mm_castsi128_pd(_mm_add_epi64(_mm_castpd_si128(x), _mm_castpd_si128(m)));
  }

  GRAZE_BATCH_OPERATION mask less(vector p, vector q) { return _mm_cmplt_pd(p, q); }
  GRAZE_BATCH_OPERATION mask less_equal(vector p, vector q) { return _mm_cmple_pd(p, q); }
  GRAZE_BATCH_OPERATION mask equal(vector p, vector q) { return _mm_cmpeq_pd(p, q); }
  GRAZE_BATCH_OPERATION mask either_nan(vector p, vector q) { return _mm_cmpunord_pd(p, q); }
  GRAZE_BATCH_OPERATION mask both(mask m, mask n) { return _mm_and_pd(m, n); }
  GRAZE_BATCH_OPERATION mask either(mask m, mask n) { return _mm_or_pd(m, n); }
  GRAZE_BATCH_OPERATION mask but_not(mask m, mask n) { return _mm_andnot_pd(n, m); }
  GRAZE_BATCH_OPERATION vector select(mask m, vector p, vector q) {
    return _mm_or_pd(_mm_and_pd(m, p), _mm_andnot_pd(m, q));
  }
  GRAZE_BATCH_OPERATION unsigned bits(mask m) { return static_cast<unsigned>(_mm_movemask_pd(m)); }

  /// Two registers (a0 b0 a1 b1 ...) to and from one of the a and one of the b; the lanes' order in
  /// between is the processor's.
  GRAZE_BATCH_OPERATION vector firsts(vector p, vector q) { return _mm_unpacklo_pd(p, q); }
  GRAZE_BATCH_OPERATION vector seconds(vector p, vector q) { return _mm_unpackhi_pd(p, q); }

private:
  template <double (*Fma)(double, double, double)>
  GRAZE_BATCH_OPERATION vector fma(vector x, vector y, vector z) {
    const nearest_scope nearest;
    double a[width], b[width], c[width];
    store(a, x), store(b, y), store(c, z);
    for (std::size_t i = 0; i < width; ++i)
      c[i] = Fma(a[i], b[i], c[i]);
    return load(c);
  }
#undef GRAZE_BATCH_OPERATION
};

struct sse2 : upward_path<sse2_registers> {
  static constexpr const char* name = "sse2";
};

} // namespace graze::batch
