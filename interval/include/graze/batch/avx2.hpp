#pragma once
/// AVX2 and FMA: four lanes, rounding upward by the mode in force (scope).
#include <graze/needs_cxx20.hpp>

#if !defined(__AVX2__) || !defined(__FMA__)
#error "graze: this path is for a file compiled with -mavx2 -mfma"
#endif
#include <graze/batch/upward_path.hpp>
#include <immintrin.h>

namespace graze::batch {

/// Arithmetic is written as volatile asm: nothing is folded, merged or moved across the scope.
struct avx2_registers {
  static constexpr std::size_t width = 4;
  using vector = __m256d;
  using mask = __m256d;
  using fma_scope = empty_scope;

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  GRAZE_BATCH_OPERATION vector load(const double* p) { return _mm256_loadu_pd(p); }
  GRAZE_BATCH_OPERATION void store(double* p, vector x) { _mm256_storeu_pd(p, x); }
  GRAZE_BATCH_OPERATION vector broadcast(double x) { return _mm256_set1_pd(x); }
  GRAZE_BATCH_OPERATION vector zero() { return _mm256_setzero_pd(); }

#define GRAZE_BATCH_BINARY(name)                                                                   \
  GRAZE_BATCH_OPERATION vector name(vector x, vector y) {                                          \
    asm volatile("v" #name "pd %2, %1, %0" : "=x"(x) : "x"(x), "x"(y));                            \
    return x;                                                                                      \
  }
  GRAZE_BATCH_BINARY(add)
  GRAZE_BATCH_BINARY(sub)
  GRAZE_BATCH_BINARY(mul)
  GRAZE_BATCH_BINARY(div)
#undef GRAZE_BATCH_BINARY
  GRAZE_BATCH_OPERATION vector sqrt(vector x) {
    asm volatile("vsqrtpd %1, %0" : "=x"(x) : "x"(x));
    return x;
  }
  GRAZE_BATCH_OPERATION vector fma_up(vector x, vector y, vector z) {
    asm volatile("vfmadd231pd %2, %1, %0" : "+x"(z) : "x"(x), "x"(y));
    return z;
  }
  GRAZE_BATCH_OPERATION vector fma_down(vector x, vector y, vector z) {
    asm volatile("vfnmsub231pd %2, %1, %0" : "+x"(z) : "x"(x), "x"(y)); // -(x y) - z
    return neg(z);
  }

  GRAZE_BATCH_OPERATION vector neg(vector x) { return _mm256_xor_pd(x, broadcast(-0.0)); }
  GRAZE_BATCH_OPERATION vector abs(vector x) { return _mm256_andnot_pd(broadcast(-0.0), x); }
  GRAZE_BATCH_OPERATION vector max_or_second(vector p, vector q) { return _mm256_max_pd(p, q); }
  GRAZE_BATCH_OPERATION vector min_or_second(vector p, vector q) { return _mm256_min_pd(p, q); }
  GRAZE_BATCH_OPERATION vector bits_or(vector p, vector q) { return _mm256_or_pd(p, q); }
  GRAZE_BATCH_OPERATION vector bits_and(vector p, vector q) { return _mm256_and_pd(p, q); }
  GRAZE_BATCH_OPERATION vector predecessor_where(mask m,
                                                 vector x) { // a true lane is the integer -1
    return _mm256_castsi256_pd(_mm256_add_epi64(_mm256_castpd_si256(x), _mm256_castpd_si256(m)));
  }

  GRAZE_BATCH_OPERATION mask less(vector p, vector q) { return _mm256_cmp_pd(p, q, _CMP_LT_OQ); }
  GRAZE_BATCH_OPERATION mask less_equal(vector p, vector q) {
    return _mm256_cmp_pd(p, q, _CMP_LE_OQ);
  }
  GRAZE_BATCH_OPERATION mask equal(vector p, vector q) { return _mm256_cmp_pd(p, q, _CMP_EQ_OQ); }
  GRAZE_BATCH_OPERATION mask either_nan(vector p, vector q) {
    return _mm256_cmp_pd(p, q, _CMP_UNORD_Q);
  }
  GRAZE_BATCH_OPERATION mask both(mask m, mask n) { return _mm256_and_pd(m, n); }
  GRAZE_BATCH_OPERATION mask either(mask m, mask n) { return _mm256_or_pd(m, n); }
  GRAZE_BATCH_OPERATION vector select(mask m, vector p, vector q) {
    return _mm256_blendv_pd(q, p, m);
  }
  GRAZE_BATCH_OPERATION unsigned bits(mask m) {
    return static_cast<unsigned>(_mm256_movemask_pd(m));
  }

  /// Two registers (a0 b0 a1 b1 ...) to and from one of the a and one of the b; the lanes' order in
  /// between is the processor's.
  GRAZE_BATCH_OPERATION vector firsts(vector p, vector q) { return _mm256_unpacklo_pd(p, q); }
  GRAZE_BATCH_OPERATION vector seconds(vector p, vector q) { return _mm256_unpackhi_pd(p, q); }
#undef GRAZE_BATCH_OPERATION
};

struct avx2 : upward_path<avx2_registers> {
  static constexpr const char* name = "avx2";
};

} // namespace graze::batch
