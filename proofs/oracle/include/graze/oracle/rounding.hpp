#pragma once
/// The judge of rounded operations: IEEE 754 binary64 by MPFR, subnormal and overflowing results
/// and signed zeros included. No hardware rounding takes part.
namespace graze::oracle {

/// A Backend (graze/rounding/backend.hpp) whose operations are MPFR's. About 0.1 us each; any
/// thread.
struct mpfr {
  using number = double;
  static constexpr const char* name = "mpfr";
  struct scope {
    scope() {}
  };

  static double add_down(double x, double y);
  static double add_up(double x, double y);
  static double sub_down(double x, double y);
  static double sub_up(double x, double y);
  static double mul_down(double x, double y);
  static double mul_up(double x, double y);
  static double div_down(double x, double y);
  static double div_up(double x, double y);
  static double sqrt_down(double x);
  static double sqrt_up(double x);
};

} // namespace graze::oracle
