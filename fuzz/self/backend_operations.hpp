#pragma once
/// The ten operations of a backend of directed rounding, by number, and their judge.
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// A backend's operation `n` of ten.
template <class B> double backend_operation(int n, const double& x, const double& y) {
  switch (n) {
  case 0:
    return B::add_down(x, y);
  case 1:
    return B::add_up(x, y);
  case 2:
    return B::sub_down(x, y);
  case 3:
    return B::sub_up(x, y);
  case 4:
    return B::mul_down(x, y);
  case 5:
    return B::mul_up(x, y);
  case 6:
    return B::div_down(x, y);
  case 7:
    return B::div_up(x, y);
  case 8:
    return B::sqrt_down(x);
  default:
    return B::sqrt_up(x);
  }
}
inline constexpr std::array<const char*, 10> backend_operations{
    "add_down", "add_up",   "sub_down", "sub_up",    "mul_down",
    "mul_up",   "div_down", "div_up",   "sqrt_down", "sqrt_up"};

/// Adds what is wrong with operation n's result: each has the bits that MPFR gives, signed zeros
/// too (a NaN is a NaN).
void compare_operation(int n, double x, double y, double got, observations& out);

} // namespace graze::fuzz::self
