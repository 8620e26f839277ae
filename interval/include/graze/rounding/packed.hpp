#pragma once
/// Two doubles in one register, both rounded up by one instruction. An interval [lo, hi] held as
/// (-lo, hi) needs nothing else: -RD(t) = RU(-t). x86-64 only.
#include <emmintrin.h>
#include <graze/rounding/hardware.hpp>
#if defined(__SSE4_1__)
#include <smmintrin.h>
#endif

namespace graze::rounding::packed {

#define GRAZE_INLINE inline __attribute__((always_inline))

/// Vectors of the compiler's own: what it knows of their moves and sign changes, it simplifies;
/// rounded operations it does not see.
using pair = double __attribute__((vector_size(16)));
using bits = long long __attribute__((vector_size(16)));

inline constexpr long long sign = static_cast<long long>(0x8000000000000000ull);

GRAZE_INLINE pair both(double x) { return pair{x, x}; }
GRAZE_INLINE pair swapped(pair x) { return _mm_shuffle_pd(x, x, 1); }
/// (x0, x1) -> (-x0, x1): between [lo, hi] and (-lo, hi).
GRAZE_INLINE pair flip_first(pair x) { return (pair)((bits)x ^ bits{sign, 0}); }
GRAZE_INLINE pair negated(pair x) { return (pair)((bits)x ^ bits{sign, sign}); }
GRAZE_INLINE pair magnitude(pair x) { return (pair)((bits)x & bits{~sign, ~sign}); }
/// The second operand where either is NaN, and where both are zero.
GRAZE_INLINE pair max(pair x, pair y) { return _mm_max_pd(x, y); }
GRAZE_INLINE pair min(pair x, pair y) { return _mm_min_pd(x, y); }
/// `mask` is all ones or all zeros in each half.
GRAZE_INLINE pair select(bits mask, pair chosen, pair other) {
#if defined(__SSE4_1__)
  return _mm_blendv_pd(other, chosen, (pair)mask);
#else
  return (pair)(((bits)chosen & mask) | ((bits)other & ~mask));
#endif
}
/// True where both halves of the mask are set: by their sign bits.
GRAZE_INLINE bool all(bits mask) { return _mm_movemask_pd((pair)mask) == 3; }

/// A rounded pair, and where it can be trusted; elsewhere the general operation must serve.
struct result {
  pair value;
  bits good;
};

#if defined(__AVX__)
#define GRAZE_PACKED(instruction, x, y)                                                            \
  pair r;                                                                                          \
  asm("v" instruction " %2, %1, %0" : "=x"(r) : "x"(x), "x"(y), "m"(hardware::control_words));     \
  return r
#else
#define GRAZE_PACKED(instruction, x, y)                                                            \
  asm(instruction " %1, %0" : "+x"(x) : "x"(y), "m"(hardware::control_words));                     \
  return x
#endif

/// The operations in the mode in force, which must be upward: correct on every input.
struct hardware_up {
  static GRAZE_INLINE result add(pair x, pair y) { return {add_instruction(x, y), bits{-1, -1}}; }
  /// (x0 - y0, x1 + y1)
  static GRAZE_INLINE result sub_add(pair x, pair y) {
#if defined(__SSE3__)
    return {sub_add_instruction(x, y), bits{-1, -1}};
#else
    return add(x, flip_first(y));
#endif
  }
  static GRAZE_INLINE pair sub(pair x, pair y) { GRAZE_PACKED("subpd", x, y); }
  static GRAZE_INLINE pair mul(pair x, pair y) { GRAZE_PACKED("mulpd", x, y); }
  static GRAZE_INLINE pair div(pair x, pair y) { GRAZE_PACKED("divpd", x, y); }
  /// (RD(sqrt x0), RU(sqrt x1)). The lower one as upward::sqrt_down has it.
  static GRAZE_INLINE pair sqrt_outward(pair x) {
    const pair root = sqrt_instruction(x);
    const bits too_large = (bits)_mm_cmpgt_pd(mul(root, root), x);
    return (pair)((bits)root + (too_large & bits{-1, 0}));
  }
  /// Where operands must be for mul, for div, and for sqrt_outward: anywhere.
  static GRAZE_INLINE bits mul_range(pair) { return bits{-1, -1}; }
  static GRAZE_INLINE bits div_range(pair) { return bits{-1, -1}; }
  static GRAZE_INLINE bits sqrt_range(pair) { return bits{-1, -1}; }

private:
  static GRAZE_INLINE pair add_instruction(pair x, pair y) { GRAZE_PACKED("addpd", x, y); }
#if defined(__SSE3__)
  static GRAZE_INLINE pair sub_add_instruction(pair x, pair y) { GRAZE_PACKED("addsubpd", x, y); }
#endif
  static GRAZE_INLINE pair sqrt_instruction(pair x) {
#if defined(__AVX__)
    asm("vsqrtpd %1, %0" : "=x"(x) : "x"(x), "m"(hardware::control_words));
#else
    asm("sqrtpd %0, %0" : "+x"(x) : "m"(hardware::control_words));
#endif
    return x;
  }
};

#undef GRAZE_PACKED

} // namespace graze::rounding::packed
