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
#include <graze/rounding/nearest.hpp>
#if defined(__clang__) && __cplusplus <= 201703L
#pragma clang diagnostic pop
#endif
#include <limits>
#include <type_traits>

namespace graze {

namespace detail {
/// T, for the number types whose intervals would have to be rounded to a format other than
/// double's.
template <class T>
using other_format = std::enable_if_t<is_real<T> && !std::is_same_v<T, double>, T>;
template <class> inline constexpr bool has_bounds = false;
} // namespace detail

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
    static_assert(detail::has_bounds<T>,                                                           \
                  "graze: bounds hold for intervals of double; use interval<double, ...>");        \
    return {};                                                                                     \
  }                                                                                                \
  template <class T> static detail::other_format<T> name(const T&, const T&) {                     \
    static_assert(detail::has_bounds<T>,                                                           \
                  "graze: bounds hold for intervals of double; use interval<double, ...>");        \
    return {};                                                                                     \
  }
#define GRAZE_BINARY(name)                                                                         \
  static double name(const double& x, const double& y) { return B::name(x, y); }                   \
  GRAZE_REFUSE_OTHERS(name)
  GRAZE_BINARY(add_down)
  GRAZE_BINARY(add_up)
  GRAZE_BINARY(sub_down)
  GRAZE_BINARY(sub_up)
  GRAZE_BINARY(mul_down)
  GRAZE_BINARY(mul_up)
  GRAZE_BINARY(div_down)
  GRAZE_BINARY(div_up)
#undef GRAZE_BINARY

  static double sqrt_down(const double& x) { return B::sqrt_down(x); }
  static double sqrt_up(const double& x) { return B::sqrt_up(x); }
  GRAZE_REFUSE_OTHERS(sqrt_down)
  GRAZE_REFUSE_OTHERS(sqrt_up)

// In any rounding mode: graze/point.hpp.
#define GRAZE_FUNCTION(name)                                                                       \
  static double name##_down(const double& x) { return point::name##_down(x); }                     \
  static double name##_up(const double& x) { return point::name##_up(x); }                         \
  GRAZE_REFUSE_OTHERS(name##_down)                                                                 \
  GRAZE_REFUSE_OTHERS(name##_up)
  GRAZE_FUNCTION(exp)
  GRAZE_FUNCTION(log)
  GRAZE_FUNCTION(sin)
  GRAZE_FUNCTION(cos)
  GRAZE_FUNCTION(tan)
  GRAZE_FUNCTION(asin)
  GRAZE_FUNCTION(acos)
  GRAZE_FUNCTION(atan)
  GRAZE_FUNCTION(sinh)
  GRAZE_FUNCTION(cosh)
  GRAZE_FUNCTION(tanh)
  GRAZE_FUNCTION(asinh)
  GRAZE_FUNCTION(acosh)
  GRAZE_FUNCTION(atanh)
#undef GRAZE_FUNCTION

  static double int_down(const double& x) { return std::floor(x); }
  static double int_up(const double& x) { return std::ceil(x); }
  GRAZE_REFUSE_OTHERS(int_down)
  GRAZE_REFUSE_OTHERS(int_up)
  GRAZE_REFUSE_OTHERS(median)
#undef GRAZE_REFUSE_OTHERS

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

  /// The greatest double <= v and the least double >= v, for any number, in any mode.
  template <class Number> static double conv_down(const Number& v) { return detail::round_down(v); }
  template <class Number> static double conv_up(const Number& v) { return detail::round_up(v); }
};

} // namespace graze
