#pragma once
/// What a path is: a way to do directed arithmetic on the lanes of one register. Every formula over
/// intervals is written once, over a path (formulas.hpp).
///
///   vector, mask, width      a register of `width` doubles, and a truth value for each of them
///   scope                    sets the modes that the operations need; restores MXCSR as found
///   fma_scope                a mode that fma_down and fma_up need inside scope, or none
///   add_down ... sqrt_up, fma_down, fma_up
///                            each lane correctly rounded, with the zeros' signs of
///                            graze::rounding::Backend, the same on every path
///   max_or_second(p, q)      p > q ? p : q, so q where either is NaN; min_or_second likewise
///   min_number, max_number   the number where the other is NaN; -0 < +0
///   greater_magnitude(p, q)  the greater of |p| and |q|; NaN where both are
///   number_or(p, q)          p, or q where p is NaN
///   nan_for_zero(p)          NaN where p is a zero, else p
///   select(m, p, q)          p where m, else q
///   bits(m)                  lane i is bit i
///
/// Everything is always_inline: a function compiled for AVX that were emitted out of line could be
/// chosen by the linker for a caller on a machine without AVX.
#include <graze/needs_cxx20.hpp>

#include <cstddef>
#include <graze/rounding/backend.hpp>

#define GRAZE_BATCH_INLINE inline __attribute__((always_inline))

namespace graze::batch {

#if defined(__x86_64__)
/// Sets MXCSR for its life: all exceptions masked, no flushing, this rounding; then restores what
/// it found, flags included. Loads after its begin and stores before its end stay between them.
template <unsigned Mxcsr> class mxcsr_scope {
public:
  GRAZE_BATCH_INLINE mxcsr_scope() {
    asm volatile("stmxcsr %0" : "=m"(found_));
    const unsigned wanted = Mxcsr;
    asm volatile("ldmxcsr %0" : : "m"(wanted) : "memory");
  }
  GRAZE_BATCH_INLINE ~mxcsr_scope() { asm volatile("ldmxcsr %0" : : "m"(found_) : "memory"); }
  mxcsr_scope(const mxcsr_scope&) = delete;
  mxcsr_scope& operator=(const mxcsr_scope&) = delete;

private:
  unsigned found_;
};
using nearest_scope = mxcsr_scope<0x1f80>;
using upward_scope = mxcsr_scope<0x5f80>;
#endif

/// No change of mode.
struct empty_scope {
  GRAZE_BATCH_INLINE empty_scope() {}
};

/// The lanes of one register of intervals: both NaN where empty.
template <class Path> struct part {
  typename Path::vector lo, hi;
};

} // namespace graze::batch
