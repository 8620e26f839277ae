#pragma once
/// The file in which MPFR's results wait for the replays: a plain array of expectation, native
/// order.
#include <array>
#include <cstddef>

namespace graze::test {

inline constexpr std::size_t operation_count = 10;
inline constexpr std::array<const char*, operation_count> operation_names{
    "add_down", "add_up",   "sub_down", "sub_up",    "mul_down",
    "mul_up",   "div_down", "div_up",   "sqrt_down", "sqrt_up"};

struct expectation {
  double x, y;
  std::array<double, operation_count> results; ///< in the order of operation_names
};

/// The ten operations of a backend, in the order of operation_names; sqrt is that of x.
template <class B> void all_operations(double x, double y, std::array<double, operation_count>& r) {
  r[0] = B::add_down(x, y);
  r[1] = B::add_up(x, y);
  r[2] = B::sub_down(x, y);
  r[3] = B::sub_up(x, y);
  r[4] = B::mul_down(x, y);
  r[5] = B::mul_up(x, y);
  r[6] = B::div_down(x, y);
  r[7] = B::div_up(x, y);
  r[8] = B::sqrt_down(x);
  r[9] = B::sqrt_up(x);
}

/// Operation `i` (a constant) alone.
template <class B, std::size_t i> double operation(double x, double y) {
  if constexpr (i == 0)
    return B::add_down(x, y);
  if constexpr (i == 1)
    return B::add_up(x, y);
  if constexpr (i == 2)
    return B::sub_down(x, y);
  if constexpr (i == 3)
    return B::sub_up(x, y);
  if constexpr (i == 4)
    return B::mul_down(x, y);
  if constexpr (i == 5)
    return B::mul_up(x, y);
  if constexpr (i == 6)
    return B::div_down(x, y);
  if constexpr (i == 7)
    return B::div_up(x, y);
  if constexpr (i == 8)
    return B::sqrt_down(x);
  if constexpr (i == 9)
    return B::sqrt_up(x);
}

} // namespace graze::test
