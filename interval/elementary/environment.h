/* Included before each source of CORE-MATH. */
#include <fenv.h>

/* glibc's fegetround() on x86-64 reads the x87's control word. Graze sets the mode in MXCSR alone,
   where the arithmetic is: with glibc's, CORE-MATH would round subnormal powers to nearest. */
#if defined(__x86_64__)
#include <xmmintrin.h>
static inline int graze_core_math_rounding(void) {
  switch (_mm_getcsr() & 0x6000) {
  case 0x2000:
    return FE_DOWNWARD;
  case 0x4000:
    return FE_UPWARD;
  case 0x6000:
    return FE_TOWARDZERO;
  default:
    return FE_TONEAREST;
  }
}
#define fegetround graze_core_math_rounding
#endif

/* The status flags are discarded by the scope around every call. Raising one costs more than the
   function. */
#define feraiseexcept(flags) ((void)(flags))
