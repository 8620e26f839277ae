#pragma once
/// A binary float so small that every ray and every box can be tried: the ray/octant test is
/// instantiated with it, unchanged.
#include <cmath>
#include <compare>
#include <limits>
#include <type_traits>
#include <vector>

namespace graze::exhaustive {

/// A float with `Precision` bits of significand and exponents Emin..Emax (of the leading bit),
/// gradual underflow and infinities included. The value is held in a double, in which every sum,
/// difference and product of two such values is exact (so Emax - Emin is at most about 20).
template <int Precision, int Emin, int Emax> struct tiny_float {
  double value = 0;

  constexpr tiny_float() = default;
  constexpr explicit tiny_float(double v) : value(v) {}

  friend constexpr tiny_float operator-(tiny_float x) { return tiny_float(-x.value); }
  friend constexpr auto operator<=>(tiny_float, tiny_float) = default;
  friend constexpr bool operator==(tiny_float, tiny_float) = default;

  /// The spacing of the subnormals, and the largest finite value.
  static constexpr double least = 1.0 / (1 << (Precision - 1 - Emin));
  static double largest() { return std::ldexp(2 - std::ldexp(1.0, 1 - Precision), Emax); }

  /// Rounds a double that is exact in the real sense towards -inf (up = false) or +inf (up = true).
  static tiny_float round(double exact, bool up) {
    if (std::isnan(exact) || std::isinf(exact) || exact == 0)
      return tiny_float(exact);
    const int exponent = std::max(std::ilogb(exact), Emin);
    const double ulp = std::ldexp(1.0, exponent - Precision + 1);
    const double rounded = (up ? std::ceil(exact / ulp) : std::floor(exact / ulp)) * ulp;
    if (rounded > largest())
      return tiny_float(up ? INFINITY : largest());
    if (rounded < -largest())
      return tiny_float(up ? -largest() : -INFINITY);
    return tiny_float(rounded == 0 ? std::copysign(0.0, exact) : rounded);
  }

  /// Every finite value, ascending, without -0.
  static std::vector<tiny_float> finite() {
    std::vector<tiny_float> values;
    for (tiny_float x(-largest()); x.value <= largest(); x = round(x.value + least / 2, true))
      values.push_back(x == tiny_float() ? tiny_float() : x);
    return values;
  }
};

/// Directed operations on T, a tiny_float: a rounding::Backend as far as the ray/octant test uses
/// it (division and square root have no place in the test and are left undefined).
template <class T> struct tiny_backend {
  using number = T;
  static constexpr const char* name = "tiny";
  struct scope {};
  static T add_down(T x, T y) { return T::round(x.value + y.value, false); }
  static T add_up(T x, T y) { return T::round(x.value + y.value, true); }
  static T sub_down(T x, T y) { return T::round(x.value - y.value, false); }
  static T sub_up(T x, T y) { return T::round(x.value - y.value, true); }
  static T mul_down(T x, T y) { return T::round(x.value * y.value, false); }
  static T mul_up(T x, T y) { return T::round(x.value * y.value, true); }
  static T div_down(T, T);
  static T div_up(T, T);
  static T sqrt_down(T);
  static T sqrt_up(T);
};

} // namespace graze::exhaustive

template <int P, int Emin, int Emax>
struct std::numeric_limits<graze::exhaustive::tiny_float<P, Emin, Emax>>
    : std::numeric_limits<double> {
  using tiny = graze::exhaustive::tiny_float<P, Emin, Emax>;
  static constexpr tiny infinity() { return tiny(std::numeric_limits<double>::infinity()); }
};
