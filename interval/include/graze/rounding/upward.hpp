#pragma once
/// `upward`: one rounding mode (towards +inf); lower bounds by negation.
#include <graze/rounding/backend.hpp>
#include <xmmintrin.h>

namespace graze::rounding {

struct upward {
  using number = double;
  static constexpr const char* name = "upward";

  /// Rounds up, all exceptions masked, no flushing, for the scope's life; restores the MXCSR found.
  class scope {
  public:
    scope() : saved_(_mm_getcsr()) { asm volatile("ldmxcsr %0" : : "m"(mode) : "memory"); }
    ~scope() { asm volatile("ldmxcsr %0" : : "m"(saved_) : "memory"); }
    scope(const scope&) = delete;
    scope& operator=(const scope&) = delete;

  private:
    static constexpr unsigned mode = 0x5f80;
    unsigned saved_;
  };

  static double add_up(double x, double y) { asm volatile("addsd %1, %0" : "+x"(x) : "x"(y)); return x; }
  static double sub_up(double x, double y) { asm volatile("subsd %1, %0" : "+x"(x) : "x"(y)); return x; }
  static double mul_up(double x, double y) { asm volatile("mulsd %1, %0" : "+x"(x) : "x"(y)); return x; }
  static double div_up(double x, double y) { asm volatile("divsd %1, %0" : "+x"(x) : "x"(y)); return x; }
  static double sqrt_up(double x) { double r; asm volatile("sqrtsd %1, %0" : "=x"(r) : "x"(x)); return r; }
  static double add_down(double x, double y) { return -add_up(-x, -y); }
  static double sub_down(double x, double y) { return -sub_up(y, x); }
  static double mul_down(double x, double y) { return -mul_up(-x, y); }
  static double div_down(double x, double y) { return -div_up(-x, y); }
  static double sqrt_down(double x);
};

} // namespace graze::rounding
