#pragma once
/// `switching`: sets the mode around every operation and restores it: the slow reference.
#include <graze/rounding/hardware.hpp>

namespace graze::rounding {

struct switching {
  using number = double;
  static constexpr const char* name = "switching";

  /// Every operation sets the mode that it needs and restores the one that it found; what compares
  /// bounds between them does it here, where subnormal numbers are not taken for zeros.
  class scope : hardware::mode_scope {
  public:
    scope() : mode_scope(hardware::mode::nearest) {}
  };

  static double add_down(double x, double y) { return in(down, hardware::add, x, y); }
  static double sub_down(double x, double y) { return in(down, hardware::sub, x, y); }
  static double mul_down(double x, double y) { return in(down, hardware::mul, x, y); }
  static double div_down(double x, double y) { return in(down, hardware::div, x, y); }
  static double sqrt_down(double x) { return in(down, hardware::sqrt, x); }
  static double add_up(double x, double y) { return in(up, hardware::add, x, y); }
  static double sub_up(double x, double y) { return in(up, hardware::sub, x, y); }
  static double mul_up(double x, double y) { return in(up, hardware::mul, x, y); }
  static double div_up(double x, double y) { return in(up, hardware::div, x, y); }
  static double sqrt_up(double x) { return in(up, hardware::sqrt, x); }

private:
  static constexpr auto down = hardware::mode::down, up = hardware::mode::up;

  template <class Operation, class... Numbers>
  static double in(hardware::mode m, Operation operation, Numbers... x) {
    const hardware::mode_scope set(m);
    return operation(x...);
  }
};

#if __cplusplus > 201703L
static_assert(Backend<switching>);
#endif

} // namespace graze::rounding
