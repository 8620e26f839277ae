#pragma once
/// graze::checking: what Boost.Interval calls a checking policy. C++17.
#include <limits>

namespace graze {

/// Intervals are closed sets of real numbers. The empty set is a value, infinities are ends and not
/// members, and nothing throws. Bounds in the wrong order, NaN, [inf, inf] and [-inf, -inf] hold no
/// real number: they are empty.
struct checking {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static constexpr double pos_inf() { return infinity; }
  static constexpr double neg_inf() { return -infinity; }
  static constexpr double nan() { return std::numeric_limits<double>::quiet_NaN(); }
  static constexpr double empty_lower() { return nan(); }
  static constexpr double empty_upper() { return nan(); }
  template <class Number> static constexpr bool is_nan(const Number& x) { return x != x; }
  static constexpr bool is_empty(double lower, double upper) {
    return !(lower <= upper && lower < infinity && upper > -infinity);
  }
};

} // namespace graze
