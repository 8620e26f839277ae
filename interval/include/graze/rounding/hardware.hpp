#pragma once
/// One floating-point instruction in the mode in force, and scopes that set the mode. Shared by the
/// backends that need a mode; nothing here is known to the optimizer.
///
/// What keeps an operation within its scope is a dependency, not a volatile statement: every asm
/// statement that computes or pins names `control_words` as an input in memory, every one that sets
/// a mode names it as input and output. A compiler may therefore move, merge and drop operations
/// between two changes of mode, as it does with any arithmetic, and never across one, nor across a
/// call of code that it does not see.
#include <graze/rounding/backend.hpp>

#if !defined(__x86_64__)
#include <cfenv>
#include <cmath>
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "graze: double arithmetic must round to double (not with -mfpmath=387)"
#endif

/// At the start of a block whose sums must be computed in the order written. GCC's
/// -fassociative-math is refused by backend.hpp; clang's shows in no macro.
#if defined(__clang__)
#define GRAZE_IN_ORDER_WRITTEN _Pragma("clang fp reassociate(off)")
#else
#define GRAZE_IN_ORDER_WRITTEN
#endif

namespace graze::rounding::hardware {

/// Stands for the processor's control words in the dependencies above. No instruction reads or
/// writes it, so that threads share nothing. `used`: a linker that sees the whole program may not
/// take it for a constant, nor for a variable that other code cannot change. `hidden`: its address
/// needs no instruction in a shared library.
[[gnu::used, gnu::visibility("hidden")]] inline char control_words = 0;

/// Hides a value from the optimizer: what is computed from it is not folded, not contracted into a
/// fused operation with what made it, and not moved across a change of mode.
inline __attribute__((always_inline)) void pin(double& x) {
#if defined(__x86_64__)
  asm("" : "+x"(x) : "m"(control_words));
#elif defined(__aarch64__)
  asm("" : "+w"(x) : "m"(control_words));
#else
  asm("" : "+m"(x) : "m"(control_words));
#endif
}

#if defined(__x86_64__)

inline unsigned mxcsr() {
  unsigned value;
  asm volatile("stmxcsr %0" : "=m"(value));
  return value;
}
inline void set_mxcsr(unsigned value) {
  asm volatile("ldmxcsr %1" : "+m"(control_words) : "m"(value) : "memory");
}

inline unsigned short x87_control() {
  unsigned short value;
  asm volatile("fnstcw %0" : "=m"(value));
  return value;
}
inline void set_x87_control(unsigned short value) {
  asm volatile("fldcw %1" : "+m"(control_words) : "m"(value) : "memory");
}

inline constexpr unsigned mxcsr_rounding = 0x6000;       ///< RC: 0 nearest, 0x2000 down, 0x4000 up
inline constexpr unsigned mxcsr_flush_to_zero = 0x8000;  ///< FTZ: subnormal results become 0
inline constexpr unsigned mxcsr_denormals_zero = 0x0040; ///< DAZ: subnormal operands count as 0

/// MXCSR with all exceptions masked, no flag raised, no flushing, and the rounding named.
enum class mode : unsigned { nearest = 0x1f80, down = 0x3f80, up = 0x5f80 };

/// For assertions.
inline bool rounds_to_nearest() { return (mxcsr() & mxcsr_rounding) == 0; }

/// Sets the SSE mode for its life, then restores the MXCSR found, status flags included. Arithmetic
/// written with plain operators beside a scope may be moved into it by the compiler: within a
/// scope, and in what flows in or out of it, use a backend's operations.
class mode_scope {
public:
  explicit mode_scope(mode m) : found_(mxcsr()) { set_mxcsr(static_cast<unsigned>(m)); }
  [[gnu::always_inline]] ~mode_scope() { set_mxcsr(found_); }
  mode_scope(const mode_scope&) = delete;
  mode_scope& operator=(const mode_scope&) = delete;

private:
  unsigned found_;
};

// The VEX form under AVX: legacy SSE instructions between VEX ones cost a state transition.
#if defined(__AVX__)
#define GRAZE_SSE_BINARY(instruction)                                                              \
  asm("v" instruction " %2, %1, %0" : "=x"(x) : "x"(x), "x"(y), "m"(control_words));               \
  return x
#else
#define GRAZE_SSE_BINARY(instruction)                                                              \
  asm(instruction " %1, %0" : "+x"(x) : "x"(y), "m"(control_words));                               \
  return x
#endif
inline double add(double x, double y) { GRAZE_SSE_BINARY("addsd"); }
inline double sub(double x, double y) { GRAZE_SSE_BINARY("subsd"); }
inline double mul(double x, double y) { GRAZE_SSE_BINARY("mulsd"); }
inline double div(double x, double y) { GRAZE_SSE_BINARY("divsd"); }
#undef GRAZE_SSE_BINARY
inline double sqrt(double x) {
#if defined(__AVX__)
  asm("vsqrtsd %1, %1, %0" : "=x"(x) : "x"(x), "m"(control_words));
#else
  asm("sqrtsd %0, %0" : "+x"(x) : "m"(control_words));
#endif
  return x;
}

#else // any other machine: C's floating-point environment and pinned operands

enum class mode : int { nearest = FE_TONEAREST, down = FE_DOWNWARD, up = FE_UPWARD };

class mode_scope {
public:
  explicit mode_scope(mode m) {
    std::fegetenv(&found_);
    std::fesetenv(FE_DFL_ENV);
    std::fesetround(static_cast<int>(m));
    asm volatile("" : "+m"(control_words) : : "memory");
  }
  ~mode_scope() {
    asm volatile("" : "+m"(control_words) : : "memory");
    std::fesetenv(&found_);
  }
  mode_scope(const mode_scope&) = delete;
  mode_scope& operator=(const mode_scope&) = delete;

private:
  std::fenv_t found_;
};

#define GRAZE_PINNED(expression)                                                                   \
  pin(x), pin(y);                                                                                  \
  double result = (expression);                                                                    \
  pin(result);                                                                                     \
  return result
inline double add(double x, double y) { GRAZE_PINNED(x + y); }
inline double sub(double x, double y) { GRAZE_PINNED(x - y); }
inline double mul(double x, double y) { GRAZE_PINNED(x * y); }
inline double div(double x, double y) { GRAZE_PINNED(x / y); }
inline double sqrt(double x) {
  double y = 0;
  GRAZE_PINNED(std::sqrt(x));
}
#undef GRAZE_PINNED

#endif

} // namespace graze::rounding::hardware
