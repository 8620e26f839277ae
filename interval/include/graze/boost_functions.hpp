#pragma once
/// For every boost::numeric::interval<double, P> whose rounding is graze::boost_rounding<B>,
/// whatever its checking: the functions of Boost.Interval, tightest (0 ulp per endpoint) however
/// they are called (boost::numeric::f or f), where Boost's own algorithms lose some ulps (sin, cos,
/// tan, pow, nth_root), give what is no enclosure (fmod, pow of a real exponent) or more than need
/// be (quotients at zero, atanh); operations with numbers of any type, enclosed; and text that
/// encloses. C++17 or later; link graze::interval.
///
/// To be included before the templates that call functions by boost::numeric::f: a qualified name
/// stands for what is declared before it. After them, Boost's algorithms serve: sound, not
/// tightest.
///
/// With a Boost under another namespace, include its headers first and let GRAZE_BOOST_NAMESPACE
/// be that namespace (without ::numeric).
#include <cmath>
#include <graze/boost_rounding.hpp>
#include <graze/graze.h>
#include <iosfwd>
#include <limits>
#include <string>
#include <type_traits>

#if !defined(GRAZE_BOOST_NAMESPACE)
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/utility.hpp>
#define GRAZE_BOOST_NAMESPACE boost
#endif

namespace graze::detail {

template <class P, class = void> inline constexpr bool rounded = false;
template <class P>
inline constexpr bool rounded<P, std::void_t<typename P::rounding::graze_rounding>> = true;
template <class P, class = void> inline constexpr bool compares_by_policy = false;
template <class P>
inline constexpr bool compares_by_policy<P, std::void_t<typename P::comparison>> = true;

/// Is C's fmod given, and not Boost's?
template <class P, class R = typename P::rounding>
inline constexpr bool has_remainder =
    compares_by_policy<P> || !std::is_same_v<R, typename R::unprotected_rounding>;

/// A number type beside intervals for which Boost's own operators would convert it to double
/// unasked.
template <class N, class Bound>
inline constexpr bool other_number =
    is_number<N> && !std::is_same_v<N, Bound> && !std::is_same_v<N, int>;
/// One that may be no Bound.
template <class N, class Bound>
inline constexpr bool inexact_number = is_number<N> && !exactly_a<Bound, N>;

template <class I> bool is_none(const I& x) {
  return I::traits_type::checking::is_empty(x.lower(), x.upper());
}
template <class I> graze_interval to_c(const I& x) {
  return is_none(x) ? graze_empty()
                    : graze_interval{rounding::widened(x.lower()), rounding::widened(x.upper())};
}
/// As the checking of I has it: the empty set and what is unbounded are its own.
template <class I>
[[gnu::cold, gnu::noinline]] I from_c_unbounded(typename I::base_type lower,
                                                typename I::base_type upper) {
  using checking = typename I::traits_type::checking;
  using Bound = typename I::base_type;
  constexpr Bound infinity = std::numeric_limits<Bound>::infinity();
  if (!(lower <= upper))
    return I::empty();
  return I(lower == -infinity ? static_cast<Bound>(checking::neg_inf()) : lower,
           upper == infinity ? static_cast<Bound>(checking::pos_inf()) : upper, true);
}
// Bounds stay in two registers: joined where branches meet, they would go through memory.
template <class I> I from_c(const graze_interval& x) {
  using Bound = typename I::base_type;
  constexpr Bound infinity = std::numeric_limits<Bound>::infinity();
  const Bound lower = round_down_to<Bound>(x.inf), upper = round_up_to<Bound>(x.sup);
  if (-infinity < lower && upper < infinity)
    return I(lower, upper, true);
  return from_c_unbounded<I>(lower, upper);
}
/// What stands for an int in an operation with an I.
template <class I> auto operand(int n) {
  if constexpr (std::is_same_v<typename I::base_type, double>)
    return static_cast<double>(n);
  else
    return I(n);
}

/// By the bits, as flushing (DAZ) does not reach them; infinities are whole and even.
inline bool is_whole(double x) {
  const auto bits = graze::rounding::exact::bits_of(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
  return exponent >= 52 ||
         (exponent >= 0 ? bits << 12 << exponent == 0 : rounding::exact::is_zero(x));
}
/// Of a whole number.
inline bool is_odd(double x) {
  const auto bits = graze::rounding::exact::bits_of(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
  return exponent == 0 || (exponent > 0 && exponent <= 52 && (bits >> (52 - exponent) & 1) != 0);
}

/// Encloses { t^n : t in x } for an integer n in [down, up] beyond int.
inline graze_interval integer_power(const graze_interval& x, double down, double up, bool odd) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const graze_interval n{down, up};
  if (!odd)
    return graze_pow(graze_abs(x), n);
  const graze_interval right = graze_intersection(x, {0, infinity});
  const graze_interval left = graze_neg(graze_intersection(x, {-infinity, 0}));
  return graze_convex_hull(graze_pow(right, n), graze_neg(graze_pow(left, n)));
}
/// Encloses { t^n : t in x }: of all t where n is an integer, else of t > 0, and 0 for n > 0.
template <class N> graze_interval power(const graze_interval& x, const N& n) {
  const double down = round_down(n), up = round_up(n);
  bool whole = true, odd = false;
  if constexpr (is_real<N>) {
    if (rounding::exact::equal(down, up)) {
      whole = is_whole(down);
      odd = whole && is_odd(down);
    } else if (-0x1p125 < down && up < 0x1p125) { // n is no double
      const auto integer = static_cast<int128>(n);
      whole = static_cast<N>(integer) == n;
      odd = whole && integer % 2 != 0;
    }
    if (!whole || n != n)
      return graze_pow(x, {down, up});
  } else {
    odd = n % 2 != 0;
  }
  constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();
  if (rounding::exact::equal(down, up) && least <= down && up <= greatest)
    return graze_pown(x, static_cast<int>(down));
  return integer_power(x, down, up, odd);
}

/// "[1,2]" as Boost writes it, but enclosing: the decimals of graze_interval_to_text.
template <class I> std::string to_text(const I& x, bool hexadecimal) {
  if (is_none(x))
    return "[]";
  const graze_interval bounds = to_c(x);
  char buffer[128];
  graze_interval_to_text(bounds, hexadecimal, buffer, sizeof buffer);
  std::string text = buffer;
  if (text == "[entire]")
    return "[-inf,inf]";
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    return text.substr(0, text.size() - 1) + ',' + text.substr(1);
  return text.erase(comma + 1, text[comma + 1] == ' ' ? 1 : 0);
}

} // namespace graze::detail

namespace GRAZE_BOOST_NAMESPACE::numeric {

template <class, class> class interval;

template <class T, class P, bool condition = true>
using rounded_interval = std::enable_if_t<graze::detail::rounded<P> && condition, interval<T, P>>;

#define GRAZE_BOUND double
#include <graze/boost_functions_of_bound.hpp>
#undef GRAZE_BOUND
#define GRAZE_BOUND float
#include <graze/boost_functions_of_bound.hpp>
#undef GRAZE_BOUND

} // namespace GRAZE_BOOST_NAMESPACE::numeric
