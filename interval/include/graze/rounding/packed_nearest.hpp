#pragma once
/// Rounding up of two doubles at once in the mode to-nearest: the sign of each rounded operation's
/// exact error tells whether the next double is the bound. x86-64 only.
///
/// Right whether subnormal numbers are flushed (FTZ, DAZ) or not: quotients and roots look at their
/// operands as integers, and sums at what the processor makes of a subnormal number, so that where it
/// is flushed `nearest` adds. Debug builds assert the mode to-nearest, which
/// rounding::refusal_for_nearest() (environment.hpp) tells a program.
#include <cassert>
#include <graze/rounding/exact.hpp>
#include <graze/rounding/packed.hpp>
#if defined(__FMA__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace graze::rounding::packed {

/// As `nearest`: operands and results are pinned. Where it is not right on every operand, the
/// ranges say where it is; `nearest` serves the rest.
struct emulated_up {
  static GRAZE_INLINE result add(pair x, pair y) {
    GRAZE_IN_ORDER_WRITTEN
#if defined(__AVX512F__)
    return {embedded_add(x, y), keeps_subnormal()};
#else
    assert(hardware::rounds_to_nearest());
    pin(x), pin(y);
    // Knuth's TwoSum: sum + error = x + y exactly unless something overflows, which reaches `error`
    // as an infinity or NaN.
    const pair s = x + y;
    const pair y_part = s - x;
    const pair error = (x - (s - y_part)) + (y - y_part);
    const pair r = up_where(error, s);
    // neither infinite nor NaN, and 0 + subnormal is subnormal; compared as integers
    return {r, is_subnormal((error - error) + (pair)subnormal)};
#endif
  }

  /// (x0 - y0, x1 + y1)
  static GRAZE_INLINE result sub_add(pair x, pair y) { return add(x, flip_first(y)); }

  static GRAZE_INLINE pair mul(pair x, pair y) {
#if defined(__AVX512F__)
    return embedded_mul(x, y);
#else
    pin(x), pin(y);
    const pair p = times(x, y);
    return up_where(product_error(x, y, p), p);
#endif
  }

  /// For y >= 0.
  static GRAZE_INLINE pair div(pair x, pair y) {
    pin(x), pin(y);
    pair q = x / y;
    pin(q);
    return up_where(remainder(x, q, y), q);
  }

  /// (RD(sqrt x0), RU(sqrt x1))
  static GRAZE_INLINE pair sqrt_outward(pair x) {
    pin(x);
    pair root = _mm_sqrt_pd(x);
    pin(root);
    const pair error = remainder(x, root, root);
    const bits down = (bits)_mm_cmplt_pd(error, both(0)) & bits{-1, 0};
    const bits up = (bits)_mm_cmpgt_pd(error, both(0)) & bits{0, -1};
    // a root with an error is positive and normal
    pair r = (pair)((bits)root + down - up);
    pin(r);
    return r;
  }

  // Let every operand be 0 or of a magnitude from 2^-480 to 2^500. Then products and quotients are
  // 0 or lie between 2^-980 and 2^1000, an error is a multiple of 2^-1064 or more, and Veltkamp's
  // factor 2^27 + 1 overflows nowhere: every step of the errors below is exact.
  static GRAZE_INLINE bits mul_range([[maybe_unused]] pair x) {
#if defined(__AVX512F__)
    return keeps_subnormal();
#else
    return div_range(x);
#endif
  }
  // In integers, so that flushing (FTZ, DAZ) takes no subnormal operand for a 0. The sign bit of
  // each half tells, as all() wants it.
  static GRAZE_INLINE bits div_range(pair x) {
    const words size = (words)magnitude(x);
    const words below = size - both_of(0x1p-480), beyond = size + (top_bit - both_of(0x1p500));
    return (bits)((size - 1) | ~(below | beyond));
  }
  /// The root of a negative number is a NaN, which is right, unless the number is flushed.
  static GRAZE_INLINE bits sqrt_range(pair x) {
    const words size = (words)magnitude(x), below = size - both_of(0x1p-480);
    return div_range(x) | (bits)((words)x & ~below);
  }

private:
  using words = unsigned long long __attribute__((vector_size(16)));
  static constexpr unsigned long long top_bit = 0x8000000000000000;
  static GRAZE_INLINE words both_of(double x) {
    return words{exact::bits_of(x), exact::bits_of(x)};
  }

  /// 2^-1023 in each half.
  static constexpr bits subnormal{0x0008000000000000, 0x0008000000000000};
  /// The sign bit of a half tells.
  static GRAZE_INLINE bits is_subnormal(pair x) {
    return (bits)_mm_cmpeq_epi32((__m128i)x, (__m128i)subnormal);
  }

  static GRAZE_INLINE void pin(pair& x) { asm("" : "+x"(x) : "m"(hardware::control_words)); }
  /// Never contracted into a sum.
  static GRAZE_INLINE pair times(pair x, pair y) {
    pair p = x * y;
    pin(p);
    return p;
  }

  /// The double above r where error > 0; pinned. A zero r with an error has its sign.
  static GRAZE_INLINE pair up_where(pair error, pair r) {
    const bits step = (bits)_mm_cmplt_pd(r, both(0)) | bits{1, 1}; // -1 for r < 0: as integers
    const bits moves = (bits)_mm_cmpgt_pd(error, both(0));
    pair up = (pair)((bits)r + (moves & step));
    pin(up);
    return up;
  }

  /// x y - p, where p is x y rounded to nearest.
  static GRAZE_INLINE pair product_error(pair x, pair y, pair p) {
    GRAZE_IN_ORDER_WRITTEN
#if defined(__FMA__)
    return _mm_fmsub_pd(x, y, p);
#else
    const halves a = x, b = y; // Dekker
    return ((times(a.high, b.high) - p) + times(a.high, b.low) + times(a.low, b.high)) +
           times(a.low, b.low);
#endif
  }
  /// x - q y, which is a double where q is x / y rounded to nearest, or q = y the root of x.
  static GRAZE_INLINE pair remainder(pair x, pair q, pair y) {
    GRAZE_IN_ORDER_WRITTEN
#if defined(__FMA__)
    return _mm_fnmadd_pd(q, y, x);
#else
    const pair p = times(q, y);
    return (x - p) - product_error(q, y, p);
#endif
  }

  /// Veltkamp: x = high + low, of 26 bits each.
  struct halves {
    pair high, low;
    GRAZE_INLINE halves(pair x) {
      GRAZE_IN_ORDER_WRITTEN
      const pair shifted = times(both(0x1.0000002p+27), x);
      high = shifted - (shifted - x);
      low = x - high;
    }
  };

#if defined(__AVX512F__)
  /// Neither FTZ nor DAZ. Depends on no operand, so that a loop may ask once.
  static GRAZE_INLINE bits keeps_subnormal() {
    pair sum = (pair)subnormal;
    asm("vaddpd %1, %0, %0" : "+x"(sum) : "x"(both(0)), "m"(hardware::control_words));
    return is_subnormal(sum);
  }
  // The instruction carries its rounding, not the flushing; it exists for whole 512-bit registers.
  static GRAZE_INLINE pair embedded_add(pair x, pair y) {
    pair r;
    asm("vaddpd %{ru-sae%}, %g2, %g1, %g0"
        : "=x"(r)
        : "x"(x), "x"(y), "m"(hardware::control_words));
    return r;
  }
  static GRAZE_INLINE pair embedded_mul(pair x, pair y) {
    pair r;
    asm("vmulpd %{ru-sae%}, %g2, %g1, %g0"
        : "=x"(r)
        : "x"(x), "x"(y), "m"(hardware::control_words));
    return r;
  }
#endif
};

} // namespace graze::rounding::packed
