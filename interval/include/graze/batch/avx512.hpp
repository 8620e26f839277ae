#pragma once
/// AVX-512: eight lanes, and the direction of rounding is in the instruction. No mode but FTZ and
/// DAZ off.
#include <graze/needs_cxx20.hpp>

#if !defined(__AVX512F__) || !defined(__AVX512DQ__)
#error "graze: this path is for a file compiled with -mavx512f -mavx512dq"
#endif
#include <graze/batch/path.hpp>
#include <immintrin.h>

namespace graze::batch {

struct avx512 {
  static constexpr const char* name = "avx512";
  static constexpr std::size_t width = 8;
  using vector = __m512d;
  using mask = __mmask8;
  /// Embedded rounding does not look at the mode, but does obey FTZ and DAZ.
  using scope = nearest_scope;
  using fma_scope = empty_scope;

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  /// As asm, so that a value used twice is not loaded twice: unaligned loads cost two accesses.
  GRAZE_BATCH_OPERATION vector load(const double* p) {
    vector x;
    asm("vmovupd %1, %0" : "=v"(x) : "m"(*reinterpret_cast<const double(*)[width]>(p)));
    return x;
  }
  GRAZE_BATCH_OPERATION void store(double* p, vector x) { _mm512_storeu_pd(p, x); }
  GRAZE_BATCH_OPERATION vector broadcast(double x) { return _mm512_set1_pd(x); }
  GRAZE_BATCH_OPERATION vector zero() { return _mm512_setzero_pd(); }

  // Written as asm: what an instruction rounds is known to nobody but the processor. Not volatile:
  // with the direction in the instruction, any order is right.
#define GRAZE_BATCH_BINARY(name, instruction)                                                      \
  GRAZE_BATCH_OPERATION vector name(vector x, vector y) {                                          \
    asm(instruction ", %0" : "=v"(x) : "v"(x), "v"(y));                                            \
    return x;                                                                                      \
  }
  GRAZE_BATCH_BINARY(add_down, "vaddpd %{rd-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(add_up, "vaddpd %{ru-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(sub_down, "vsubpd %{rd-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(sub_up, "vsubpd %{ru-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(mul_down, "vmulpd %{rd-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(mul_up, "vmulpd %{ru-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(div_down, "vdivpd %{rd-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(div_up, "vdivpd %{ru-sae%}, %2, %1")
  GRAZE_BATCH_BINARY(max_or_second, "vmaxpd %2, %1")
  GRAZE_BATCH_BINARY(min_or_second, "vminpd %2, %1")
  // 4 is the lesser and 5 the greater, with its own sign
  GRAZE_BATCH_BINARY(min_number, "vrangepd $4, %2, %1")
  GRAZE_BATCH_BINARY(max_number, "vrangepd $5, %2, %1")
  // 11 is the greater of the magnitudes, with the sign +
  GRAZE_BATCH_BINARY(greater_magnitude, "vrangepd $11, %2, %1")
  // Two registers (a0 b0 a1 b1 ...) to and from one of the a and one of the b; the lanes' order in
  // between is the processor's.
  GRAZE_BATCH_BINARY(firsts, "vunpcklpd %2, %1")
  GRAZE_BATCH_BINARY(seconds, "vunpckhpd %2, %1")
#undef GRAZE_BATCH_BINARY
  GRAZE_BATCH_OPERATION vector fma_down(vector x, vector y, vector z) {
    asm("vfmadd231pd %{rd-sae%}, %2, %1, %0" : "+v"(z) : "v"(x), "v"(y));
    return z;
  }
  GRAZE_BATCH_OPERATION vector fma_up(vector x, vector y, vector z) {
    asm("vfmadd231pd %{ru-sae%}, %2, %1, %0" : "+v"(z) : "v"(x), "v"(y));
    return z;
  }
  GRAZE_BATCH_OPERATION vector sqrt_down(vector x) {
    asm("vsqrtpd %{rd-sae%}, %1, %0" : "=v"(x) : "v"(x));
    return x;
  }
  GRAZE_BATCH_OPERATION vector sqrt_up(vector x) {
    asm("vsqrtpd %{ru-sae%}, %1, %0" : "=v"(x) : "v"(x));
    return x;
  }

  GRAZE_BATCH_OPERATION vector neg(vector x) { return _mm512_xor_pd(x, broadcast(-0.0)); }
  GRAZE_BATCH_OPERATION vector abs(vector x) { return _mm512_andnot_pd(broadcast(-0.0), x); }

  // By a table of responses, four bits for each class of the operand: quiet and signalling NaN,
  // zero, one, the infinities, negative, positive. 0 is the first vector here, 1 the operand, 3 a
  // quiet NaN. No mask register is needed.
  GRAZE_BATCH_OPERATION vector number_or(vector p, vector q) {
    return _mm512_fixupimm_pd(q, p, _mm512_set1_epi64(0x11111100), 0);
  }
  GRAZE_BATCH_OPERATION vector nan_for_zero(vector p) {
    return _mm512_fixupimm_pd(p, p, _mm512_set1_epi64(0x11111311), 0);
  }

  GRAZE_BATCH_OPERATION mask less(vector p, vector q) {
    return _mm512_cmp_pd_mask(p, q, _CMP_LT_OQ);
  }
  GRAZE_BATCH_OPERATION mask less_equal(vector p, vector q) {
    return _mm512_cmp_pd_mask(p, q, _CMP_LE_OQ);
  }
  GRAZE_BATCH_OPERATION mask equal(vector p, vector q) {
    return _mm512_cmp_pd_mask(p, q, _CMP_EQ_OQ);
  }
  GRAZE_BATCH_OPERATION mask either_nan(vector p, vector q) {
    return _mm512_cmp_pd_mask(p, q, _CMP_UNORD_Q);
  }
  GRAZE_BATCH_OPERATION mask both(mask m, mask n) { return static_cast<mask>(m & n); }
  GRAZE_BATCH_OPERATION mask either(mask m, mask n) { return static_cast<mask>(m | n); }
  /// m and not n.
  GRAZE_BATCH_OPERATION vector select(mask m, vector p, vector q) {
    return _mm512_mask_blend_pd(m, q, p);
  }
  GRAZE_BATCH_OPERATION unsigned bits(mask m) { return m; }
#undef GRAZE_BATCH_OPERATION
};

} // namespace graze::batch
