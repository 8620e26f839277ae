#pragma once
/// SSE2, which every x86-64 has: two lanes, rounding upward by the mode in force (scope).
#include <graze/needs_cxx20.hpp>

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
  using fma_scope = nearest_scope;

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
  /// SSE2 has no fused operation. In round to nearest, by the argument of rounding::fma_up
  /// (interval/src/functions/fused.cpp), in both lanes if both lie where it holds, else one at a time.
  GRAZE_BATCH_OPERATION vector fma_up(vector x, vector y, vector z) {
    const vector p = mul(x, y), size = abs(p), operands = max_or_second(abs(x), abs(y));
    const mask safe = both(
        both(less_equal(broadcast(0x1p-900), size), less_equal(size, broadcast(0x1p1000))),
        both(less_equal(operands, broadcast(0x1p990)), less_equal(abs(z), broadcast(0x1p1000))));
    if (bits(safe) != 3) [[unlikely]]
      return fma_up_one_by_one(x, y, z);
    // Dekker's product, then Knuth's sums
    const vector xh = upper_half(x), xl = sub(x, xh), yh = upper_half(y), yl = sub(y, yh);
    const vector p_error =
        add(add(add(sub(mul(xh, yh), p), mul(xh, yl)), mul(xl, yh)), mul(xl, yl));
    vector s_error, t_error, u_error;
    const vector s = sum(p, z, s_error), t = sum(s_error, p_error, t_error);
    const vector u = sum(s, t, u_error);
    const vector rest = select(equal(u_error, zero()), t_error, u_error);
    // the successor: as an integer one more, or one less below zero
    const __m128i step = _mm_or_si128(_mm_castpd_si128(less(u, zero())), _mm_set1_epi64x(1));
    const __m128i taken = _mm_and_si128(_mm_castpd_si128(less(zero(), rest)), step);
    return _mm_castsi128_pd(_mm_add_epi64(_mm_castpd_si128(u), taken));
  }
  GRAZE_BATCH_OPERATION vector fma_down(vector x, vector y, vector z) {
    return neg(fma_up(neg(x), y, neg(z)));
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
  GRAZE_BATCH_OPERATION vector select(mask m, vector p, vector q) {
    return _mm_or_pd(_mm_and_pd(m, p), _mm_andnot_pd(m, q));
  }
  GRAZE_BATCH_OPERATION unsigned bits(mask m) { return static_cast<unsigned>(_mm_movemask_pd(m)); }

  /// Two registers (a0 b0 a1 b1 ...) to and from one of the a and one of the b; the lanes' order in
  /// between is the processor's.
  GRAZE_BATCH_OPERATION vector firsts(vector p, vector q) { return _mm_unpacklo_pd(p, q); }
  GRAZE_BATCH_OPERATION vector seconds(vector p, vector q) { return _mm_unpackhi_pd(p, q); }

private:
  GRAZE_BATCH_OPERATION vector fma_up_one_by_one(vector x, vector y, vector z) {
    double a[width], b[width], c[width];
    store(a, x), store(b, y), store(c, z);
    for (std::size_t i = 0; i < width; ++i)
      c[i] = rounding::fma_up(a[i], b[i], c[i]);
    return load(c);
  }
  /// Veltkamp: the upper 26 bits.
  GRAZE_BATCH_OPERATION vector upper_half(vector x) {
    const vector scaled = mul(broadcast(0x1p27 + 1), x);
    return sub(scaled, sub(scaled, x));
  }
  GRAZE_BATCH_OPERATION vector sum(vector x, vector y, vector& error) {
    const vector s = add(x, y), part = sub(s, x);
    error = add(sub(x, sub(s, part)), sub(y, part));
    return s;
  }
#undef GRAZE_BATCH_OPERATION
};

struct sse2 : upward_path<sse2_registers> {
  static constexpr const char* name = "sse2";
};

} // namespace graze::batch
