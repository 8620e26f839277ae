#pragma once
/// graze::policies<Backend>: bounds that hold for boost::numeric::interval<double, ...>.
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/rounding.hpp>
#include <cmath>
#include <concepts>
#include <graze/rounding/backend.hpp>
#include <graze/rounding/held.hpp>
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

/// The Rounding concept of Boost.Interval on a backend: the object is the scope, its members are
/// the operations. Source: Boost.Interval, "Rounding policies".
template <rounding::Backend B> struct boost_rounding : private B::scope {
  using backend = B;
  /// For code that holds a `boost_rounding<B>` (or a scope of B) already.
  using unprotected_rounding = boost_rounding<rounding::held<B>>;

  // references: see split, which loads from memory
  static double add_down(const double& x, const double& y) { return B::add_down(x, y); }
  static double add_up(const double& x, const double& y) { return B::add_up(x, y); }
  static double sub_down(const double& x, const double& y) { return B::sub_down(x, y); }
  static double sub_up(const double& x, const double& y) { return B::sub_up(x, y); }
  static double mul_down(const double& x, const double& y) { return B::mul_down(x, y); }
  static double mul_up(const double& x, const double& y) { return B::mul_up(x, y); }
  static double div_down(const double& x, const double& y) { return B::div_down(x, y); }
  static double div_up(const double& x, const double& y) { return B::div_up(x, y); }
  static double sqrt_down(const double& x) { return B::sqrt_down(x); }
  static double sqrt_up(const double& x) { return B::sqrt_up(x); }

  static double int_down(double x) { return std::floor(x); }
  static double int_up(double x) { return std::ceil(x); }
  /// (x + y) / 2 in the rounding mode in force, within [x, y] and never -0; 0 for [-inf, inf], the
  /// last finite double for half-lines.
  static double median(double x, double y) {
    constexpr double largest = std::numeric_limits<double>::max();
    if (x == -checking::infinity && y == checking::infinity)
      return 0;
    if (x == -checking::infinity)
      return -largest;
    if (y == checking::infinity)
      return largest;
    // Half of a sum is rounded once: it is exact where it is normal, and a smaller sum is exact
    // itself. Where the sum might overflow, halves do not and are exact.
    double middle = x / 2 + y / 2;
    if (-0x1p1022 <= middle && middle <= 0x1p1022)
      middle = (x + y) / 2;
    return middle == 0 ? 0 : middle;
  }

  /// The greatest double <= v and the least double >= v, for any built-in number, in any mode.
  template <class Number> static double conv_down(Number v) {
    if constexpr (exactly_a_double<Number>) {
      return static_cast<double>(v);
    } else {
      const auto near = static_cast<double>(v);
      return above(near, v) ? std::nextafter(near, -checking::infinity) : near;
    }
  }
  template <class Number> static double conv_up(Number v) {
    if constexpr (exactly_a_double<Number>) {
      return static_cast<double>(v);
    } else {
      const auto near = static_cast<double>(v);
      return below(near, v) ? std::nextafter(near, checking::infinity) : near;
    }
  }

private:
  template <class Number>
  static constexpr bool exactly_a_double =
      std::numeric_limits<Number>::digits <= std::numeric_limits<double>::digits &&
      std::numeric_limits<Number>::radix == 2 && sizeof(Number) <= sizeof(double);

  // Comparisons with a 64-bit integer are made in the integer type; 2^63 and 2^64, which do not fit
  // it, are above every value.
  template <class Number> static bool above(double near, Number v) {
    if constexpr (std::floating_point<Number>) {
      return static_cast<Number>(near) > v;
    } else {
      return near >= beyond<Number> || static_cast<Number>(near) > v;
    }
  }
  template <class Number> static bool below(double near, Number v) {
    if constexpr (std::floating_point<Number>) {
      return static_cast<Number>(near) < v;
    } else {
      return near < beyond<Number> && static_cast<Number>(near) < v;
    }
  }
  template <class Number>
  static constexpr double beyond = 2.0 * (std::numeric_limits<Number>::max() / 2 + 1);
};

/// The policies to swap into existing Boost.Interval code:
/// boost::numeric::interval<double, graze::policies<graze::rounding::upward>>.
template <rounding::Backend B> struct policies {
  using rounding = boost_rounding<B>;
  using checking = graze::checking;
  using backend = B;
};

/// Policies of ours, and what Boost's change_rounding and unprotect make of them.
template <class P>
concept Policies = std::same_as<typename P::checking, checking>;

} // namespace graze
