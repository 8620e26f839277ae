#pragma once
/// graze::boost_rounding<>: the rounding policy to swap into code over Boost.Interval:
///
///   boost::numeric::interval<double, boost::numeric::interval_lib::policies<
///                                        graze::boost_rounding<>, your_checking>>
///
/// C++17 or later; link graze::interval. It names nothing of Boost, so that a Boost of any place
/// and namespace may be used. <graze/boost_functions.hpp> has what is to be included beside it for
/// the tightest functions. docs/migrating.md tells what changes.
#include <cmath>
#include <graze/conversion.hpp>
#include <graze/point.hpp>
#if defined(__clang__) && __cplusplus <= 201703L
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wc++20-attribute-extensions" // [[unlikely]]
#endif
#include <graze/rounding/held.hpp>
#include <graze/rounding/narrow.hpp>
#include <graze/rounding/nearest.hpp>
#if defined(__clang__) && __cplusplus <= 201703L
#pragma clang diagnostic pop
#endif
#include <limits>
#include <type_traits>

namespace graze {

namespace detail {
/// T, for the number types whose intervals would have to be rounded to a format of neither float
/// nor double.
template <class T>
using other_format =
    std::enable_if_t<is_real<T> && !std::is_same_v<T, double> && !std::is_same_v<T, float>, T>;
template <class> inline constexpr bool has_bounds = false;
#define GRAZE_REFUSE_FORMAT(T)                                                                     \
  static_assert(detail::has_bounds<T>, "graze: bounds hold for intervals of double and of float; " \
                                       "use interval<double, ...>")
} // namespace detail

/// A number's bound in one direction, for an interval of doubles or of floats.
template <float (*narrow)(double)> struct converted {
  double bound;
  operator double() const { return bound; }
  operator float() const { return narrow(bound); }
  template <class T, class = detail::other_format<T>> operator T() const {
    GRAZE_REFUSE_FORMAT(T);
    return {};
  }
};

/// The Rounding concept of Boost.Interval on a backend: the object is the scope, its members are
/// the operations, each the correctly rounded result. Source: Boost.Interval, "Rounding policies".
template <GRAZE_BACKEND B = rounding::nearest> struct boost_rounding : private B::scope {
  using backend = B;
  /// How this class, and what is derived from it, is recognized.
  using graze_rounding = boost_rounding;
  /// For code that holds a `boost_rounding<B>` (or a scope of B) already.
  using unprotected_rounding = boost_rounding<rounding::held_once<B>>;

// Operands are references: see split, which loads from memory. Any other format that reaches an
// operation is refused: a double's bound, converted to it, would be rounded to nearest.
#define GRAZE_REFUSE_OTHERS(name)                                                                  \
  template <class T> static detail::other_format<T> name(const T&) {                               \
    GRAZE_REFUSE_FORMAT(T);                                                                        \
    return {};                                                                                     \
  }                                                                                                \
  template <class T> static detail::other_format<T> name(const T&, const T&) {                     \
    GRAZE_REFUSE_FORMAT(T);                                                                        \
    return {};                                                                                     \
  }
// Floats: the operation on doubles, narrowed (graze/rounding/narrow.hpp has why it is tightest).
#define GRAZE_BINARY(name, direction)                                                              \
  static double name##_##direction(const double& x, const double& y) {                             \
    return B::name##_##direction(x, y);                                                            \
  }                                                                                                \
  static float name##_##direction(const float& x, const float& y) {                                \
    return rounding::narrow_##direction(                                                           \
        B::name##_##direction(rounding::widened(x), rounding::widened(y)));                        \
  }                                                                                                \
  GRAZE_REFUSE_OTHERS(name##_##direction)
  GRAZE_BINARY(add, down)
  GRAZE_BINARY(add, up)
  GRAZE_BINARY(sub, down)
  GRAZE_BINARY(sub, up)
  GRAZE_BINARY(mul, down)
  GRAZE_BINARY(mul, up)
  GRAZE_BINARY(div, down)
  GRAZE_BINARY(div, up)
#undef GRAZE_BINARY

#define GRAZE_UNARY(name, direction, function)                                                     \
  static double name##_##direction(const double& x) { return function(x); }                        \
  static float name##_##direction(const float& x) {                                                \
    return rounding::narrow_##direction(function(rounding::widened(x)));                           \
  }                                                                                                \
  GRAZE_REFUSE_OTHERS(name##_##direction)
  GRAZE_UNARY(sqrt, down, B::sqrt_down)
  GRAZE_UNARY(sqrt, up, B::sqrt_up)
  GRAZE_UNARY(int, down, std::floor)
  GRAZE_UNARY(int, up, std::ceil)

// In any rounding mode: graze/point.hpp.
#define GRAZE_FUNCTION(name)                                                                       \
  GRAZE_UNARY(name, down, point::name##_down)                                                      \
  GRAZE_UNARY(name, up, point::name##_up)
  GRAZE_FOR_EACH_OF_BOOST(GRAZE_FUNCTION)
#undef GRAZE_FUNCTION
#undef GRAZE_UNARY

  GRAZE_REFUSE_OTHERS(median)
#undef GRAZE_REFUSE_OTHERS
#undef GRAZE_REFUSE_FORMAT

  /// (x + y) / 2 in the rounding mode in force, within [x, y] and never -0; 0 for [-inf, inf], the
  /// last finite double for half-lines.
  static double median(const double& x, const double& y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double largest = std::numeric_limits<double>::max();
    if (x == -infinity && y == infinity)
      return 0;
    if (x == -infinity)
      return -largest;
    if (y == infinity)
      return largest;
    // Half of a sum is rounded once: it is exact where it is normal, and a smaller sum is exact
    // itself. Where the sum might overflow, halves do not and are exact.
    double middle = x / 2 + y / 2;
    if (-0x1p1022 <= middle && middle <= 0x1p1022)
      middle = (x + y) / 2;
    return middle == 0 ? 0 : middle;
  }
  /// The same of floats, to nearest.
  static float median(const float& x, const float& y) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float largest = std::numeric_limits<float>::max();
    if (x == -infinity && y == infinity)
      return 0;
    if (x == -infinity)
      return -largest;
    if (y == infinity)
      return largest;
    const double middle = (rounding::widened(x) + rounding::widened(y)) / 2;
    return middle == 0 ? 0 : rounding::narrow_to_nearest(middle);
  }

  /// The greatest double (float) <= v and the least >= v, for any number, in any mode.
  template <class Number> static converted<rounding::narrow_down> conv_down(const Number& v) {
    return {detail::round_down(v)};
  }
  template <class Number> static converted<rounding::narrow_up> conv_up(const Number& v) {
    return {detail::round_up(v)};
  }
};

} // namespace graze
