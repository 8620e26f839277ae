#pragma once
/// `upward`: one rounding mode (towards +inf); lower bounds by negation.
#include <cstdint>
#include <graze/rounding/hardware.hpp>
#if defined(__x86_64__)
#include <graze/rounding/packed.hpp>
#endif

namespace graze::rounding {

struct upward {
  using number = double;
  static constexpr const char* name = "upward";

  /// Rounds up, all exceptions masked, no flushing, for the scope's life; restores the MXCSR found.
  class scope : hardware::mode_scope {
  public:
    scope() : mode_scope(hardware::mode::up) {}
    // emitted nowhere, as files compiled for a path's instructions need it (batch/path.hpp)
    [[gnu::always_inline]] ~scope() {} // NOLINT(modernize-use-equals-default)
  };

#if defined(__x86_64__)
  using pair_operations = packed::hardware_up;
#endif

  static double add_up(double x, double y) { return hardware::add(x, y); }
  static double sub_up(double x, double y) { return hardware::sub(x, y); }
  static double mul_up(double x, double y) { return hardware::mul(x, y); }
  static double div_up(double x, double y) { return hardware::div(x, y); }
  static double sqrt_up(double x) { return hardware::sqrt(x); }

  // RD(t) = -RU(-t), signed zeros included: RU(x - x) = +0, and so RD(x - x) = -0.
  static double add_down(double x, double y) { return -add_up(-x, -y); }
  static double sub_down(double x, double y) { return -sub_up(y, x); }
  static double mul_down(double x, double y) { return -mul_up(-x, y); }
  static double div_down(double x, double y) { return -div_up(-x, y); }

  /// Let s = RU(sqrt x), x > 0 finite. Then s^2 >= x. If s = sqrt x, then RU(s^2) = x. Otherwise
  /// s^2 > x, hence RU(s^2) >= s^2 > x, also where s^2 is subnormal or overflows; and the next
  /// double below s is below sqrt x, so that it is RD(sqrt x). s is normal (at least 2^-537): its
  /// predecessor is one less as an integer. +-0 and +inf are their own roots and squares here; for
  /// x < 0 and NaN the comparison is false and the NaN is returned.
  static double sqrt_down(double x) {
    const double s = sqrt_up(x);
    if (!(mul_up(s, s) > x))
      return s;
    return bit_cast<double>(bit_cast<std::int64_t>(s) - 1);
  }
};

#if __cplusplus > 201703L
static_assert(Backend<upward>);
#endif

} // namespace graze::rounding
