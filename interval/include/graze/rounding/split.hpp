#pragma once
/// `split`: lower bounds on SSE2 under round-down, upper bounds on the x87 under round-up, with no
/// change of mode between them: the paper's scheme. x86-64 only.
#if !defined(__x86_64__)
#error "graze: the split backend needs SSE2 and the x87 (x86-64)"
#endif
#include <graze/rounding/hardware.hpp>

namespace graze::rounding {

namespace detail {

/// Restores an x87 control word that leaves exceptions unmasked. Upper bounds have raised flags
/// since (inexact, nearly always), which would trap at the next x87 instruction: they are put back
/// to the `flags` found, through the environment, the only way in.
[[gnu::cold, gnu::noinline]] inline void restore_x87_trapping(unsigned short control,
                                                              unsigned short flags) {
  struct {
    unsigned short control, unused1, status, unused2;
    unsigned rest[5];
  } environment;
  constexpr unsigned exceptions = 0xff; // six exceptions, stack fault, summary
  asm volatile("fnstenv %0" : "=m"(environment) : : "memory");
  environment.control = control;
  environment.status =
      static_cast<unsigned short>((environment.status & ~exceptions) | (flags & exceptions));
  asm volatile("fldenv %1" : "+m"(hardware::control_words) : "m"(environment) : "memory");
}

} // namespace detail

struct split {
  using number = double;
  static constexpr const char* name = "split";

  /// MXCSR: round down; x87: round up, to 53 bits; all exceptions masked, no flushing. Restores
  /// both control words (MXCSR's flags too) as found. While it lives, `long double` (printf of a
  /// double included) has 53 bits and rounds up, and fesetround would make the bounds unsound.
  class scope {
  public:
    scope() : sse_(hardware::mode::down), control_(hardware::x87_control()) {
      asm volatile("fnstsw %0" : "=m"(flags_));
      hardware::set_x87_control(up_53_bits);
    }
    ~scope() {
      constexpr unsigned masks = 0x3f;
      if (__builtin_expect((control_ & masks) == masks, true))
        hardware::set_x87_control(control_);
      else
        detail::restore_x87_trapping(control_, flags_);
    }
    scope(const scope&) = delete;
    scope& operator=(const scope&) = delete;

  private:
    // RC = 10b (up), PC = 10b (53 bits), all exceptions masked, bit 6 reserved as 1
    static constexpr unsigned short up_53_bits = 0x0a7f;
    hardware::mode_scope sse_;
    unsigned short control_, flags_;
  };

  static double add_down(double x, double y) { return hardware::add(x, y); }
  static double sub_down(double x, double y) { return hardware::sub(x, y); }
  static double mul_down(double x, double y) { return hardware::mul(x, y); }
  static double div_down(double x, double y) { return hardware::div(x, y); }
  static double sqrt_down(double x) { return hardware::sqrt(x); }

  // Every result goes through a double in memory: the x87's registers have 15 bits of exponent, so
  // that (2^-600 * 1.5 * 2^-500) * 2^80 kept in one would not be what double arithmetic gives. The
  // store rounds a second time, up again and onto a coarser grid, which changes nothing:
  // RU_double(RU_x87(t)) = RU_double(t). Operands are references since the x87 loads from memory: a
  // parameter by value would be copied to the stack first. The clobbers make the compiler leave the
  // stack free.
#define GRAZE_X87_CLOBBERS "st", "st(1)", "st(2)", "st(3)", "st(4)", "st(5)", "st(6)", "st(7)"
#define GRAZE_X87_BINARY(instruction)                                                              \
  double result;                                                                                   \
  asm("fldl %1\n\t" instruction " %2\n\tfstpl %0"                                                  \
      : "=m"(result)                                                                               \
      : "m"(x), "m"(y), "m"(hardware::control_words)                                               \
      : GRAZE_X87_CLOBBERS);                                                                       \
  return result
  static double add_up(const double& x, const double& y) { GRAZE_X87_BINARY("faddl"); }
  static double sub_up(const double& x, const double& y) { GRAZE_X87_BINARY("fsubl"); }
  static double mul_up(const double& x, const double& y) { GRAZE_X87_BINARY("fmull"); }
  static double div_up(const double& x, const double& y) { GRAZE_X87_BINARY("fdivl"); }
  static double sqrt_up(const double& x) {
    double result;
    asm("fldl %1\n\tfsqrt\n\tfstpl %0"
        : "=m"(result)
        : "m"(x), "m"(hardware::control_words)
        : GRAZE_X87_CLOBBERS);
    return result;
  }
#undef GRAZE_X87_BINARY
#undef GRAZE_X87_CLOBBERS
};

#if __cplusplus > 201703L
static_assert(Backend<split>);
#endif

} // namespace graze::rounding
