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
template <class N>
inline constexpr bool other_number =
    is_number<N> && !std::is_same_v<N, double> && !std::is_same_v<N, int>;

template <class I> bool is_none(const I& x) {
  return I::traits_type::checking::is_empty(x.lower(), x.upper());
}
template <class I> graze_interval to_c(const I& x) {
  return is_none(x) ? graze_empty() : graze_interval{x.lower(), x.upper()};
}
/// As the checking of I has it: the empty set and what is unbounded are its own.
template <class I> I from_c(const graze_interval& x) {
  using checking = typename I::traits_type::checking;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(x.inf <= x.sup))
    return I::empty();
  return I(x.inf == -infinity ? checking::neg_inf() : x.inf,
           x.sup == infinity ? checking::pos_inf() : x.sup, true);
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
    if (down == up) {
      whole = std::floor(down) == down;
      odd = whole && std::fmod(down, 2) != 0;
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
  if (down == up && least <= down && up <= greatest)
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

template <class P, bool condition = true>
using rounded_interval =
    std::enable_if_t<graze::detail::rounded<P> && condition, interval<double, P>>;

#define GRAZE_UNARY(name, function)                                                                \
  template <class P> rounded_interval<P> name(const interval<double, P>& x) {                      \
    return graze::detail::from_c<interval<double, P>>(graze_##function(graze::detail::to_c(x)));   \
  }
GRAZE_UNARY(exp, exp)
GRAZE_UNARY(log, log)
GRAZE_UNARY(sin, sin)
GRAZE_UNARY(cos, cos)
GRAZE_UNARY(tan, tan)
GRAZE_UNARY(asin, asin)
GRAZE_UNARY(acos, acos)
GRAZE_UNARY(atan, atan)
GRAZE_UNARY(sinh, sinh)
GRAZE_UNARY(cosh, cosh)
GRAZE_UNARY(tanh, tanh)
GRAZE_UNARY(asinh, asinh)
GRAZE_UNARY(acosh, acosh)
GRAZE_UNARY(atanh, atanh)
#undef GRAZE_UNARY

/// Encloses { t^n : t in x }, t != 0 for n < 0; t^0 = 1.
template <class P> rounded_interval<P> pow(const interval<double, P>& x, int n) {
  return graze::detail::from_c<interval<double, P>>(graze_pown(graze::detail::to_c(x), n));
}
/// The same for an integer n of any type and size; for any other n, { t^n : t in x, t > 0, or t = 0
/// and n > 0 }.
template <class P, class N>
rounded_interval<P, (graze::detail::is_number<N> && !std::is_enum_v<N>)>
pow(const interval<double, P>& x, const N& n) {
  return graze::detail::from_c<interval<double, P>>(
      graze::detail::power(graze::detail::to_c(x), n));
}
/// Encloses { s^t : s in x, t in y, s > 0, or s = 0 and t > 0 }.
template <class P>
rounded_interval<P> pow(const interval<double, P>& x, const interval<double, P>& y) {
  return graze::detail::from_c<interval<double, P>>(
      graze_pow(graze::detail::to_c(x), graze::detail::to_c(y)));
}
/// Encloses { s : s^n in x }, s >= 0 for n even; n > 0.
template <class P> rounded_interval<P> nth_root(const interval<double, P>& x, int n) {
  return graze::detail::from_c<interval<double, P>>(graze_rootn(graze::detail::to_c(x), n));
}

/// Encloses { fmod(s, t) : s in x, t in y, t != 0 }, with C's fmod: s - trunc(s / t) t, of s's
/// sign. Not on unprotect<interval>: there Boost's own, x - n y for one integer n, is what its
/// algorithms need.
template <class P>
rounded_interval<P, (graze::detail::has_remainder<P>)> fmod(const interval<double, P>& x,
                                                            const interval<double, P>& y) {
  return graze::detail::from_c<interval<double, P>>(
      graze_fmod(graze::detail::to_c(x), graze::detail::to_c(y)));
}
template <class P>
rounded_interval<P, (graze::detail::has_remainder<P>)> fmod(const interval<double, P>& x,
                                                            const double& y) {
  return fmod(x, interval<double, P>(y));
}
template <class P>
rounded_interval<P, (graze::detail::has_remainder<P>)> fmod(const double& x,
                                                            const interval<double, P>& y) {
  return fmod(interval<double, P>(x), y);
}

/// Boost's quotient, but for a divisor that reaches 0 from one side and a dividend that ends at 0:
/// [-1, 0] / [0, 1] is [-inf, 0], and not entire.
template <class P>
rounded_interval<P> operator/(const interval<double, P>& x, const interval<double, P>& y) {
  const bool one_side = (y.lower() == 0) != (y.upper() == 0);
  if (one_side && (x.lower() == 0 || x.upper() == 0) && !graze::detail::is_none(x) &&
      !graze::detail::is_none(y))
    return graze::detail::from_c<interval<double, P>>(
        graze_div(graze::detail::to_c(x), graze::detail::to_c(y)));
  return operator/ <double, P>(x, y);
}

namespace interval_lib {
/// The same of Boost's quotient in two parts.
template <class P>
rounded_interval<P> division_part1(const interval<double, P>& x, const interval<double, P>& y,
                                   bool& more) {
  if (y.lower() < 0 && 0 < y.upper())
    return division_part1<double, P>(x, y, more);
  more = false;
  return x / y;
}
} // namespace interval_lib

// x + n and so on for other numbers than double, which Boost has. One that may be no double is the
// tightest interval that holds it; an int is one. (Boost's ext/integer.hpp has int only, and takes
// what converts to it.)
#define GRAZE_MIXED(operation)                                                                     \
  template <class P> rounded_interval<P> operator operation(const interval<double, P>& x, int n) { \
    return x operation static_cast<double>(n);                                                     \
  }                                                                                                \
  template <class P> rounded_interval<P> operator operation(int n, const interval<double, P>& x) { \
    return static_cast<double>(n) operation x;                                                     \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<P, graze::detail::other_number<N>> operator operation(                          \
      const interval<double, P>& x, const N & n) {                                                 \
    return x operation interval<double, P>(n);                                                     \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<P, graze::detail::other_number<N>> operator operation(                          \
      const N & n, const interval<double, P>& x) {                                                 \
    return interval<double, P>(n) operation x;                                                     \
  }                                                                                                \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && graze::detail::other_number<N>,                    \
                   interval<double, P>&> operator operation##=(interval<double, P>& x,             \
                                                               const N & n) {                      \
    return x operation## = interval<double, P>(n);                                                 \
  }
GRAZE_MIXED(+)
GRAZE_MIXED(-)
GRAZE_MIXED(*)
GRAZE_MIXED(/)
#undef GRAZE_MIXED

#define GRAZE_MIXED(name)                                                                          \
  template <class P, class N>                                                                      \
  rounded_interval<P, (graze::detail::is_number<N> && !std::is_same_v<N, double>)> name(           \
      const interval<double, P>& x, const N& n) {                                                  \
    return name(x, interval<double, P>(n));                                                        \
  }                                                                                                \
  template <class P, class N>                                                                      \
  rounded_interval<P, (graze::detail::is_number<N> && !std::is_same_v<N, double>)> name(           \
      const N& n, const interval<double, P>& x) {                                                  \
    return name(interval<double, P>(n), x);                                                        \
  }
GRAZE_MIXED(fmod)
GRAZE_MIXED(hull)
GRAZE_MIXED(max)
GRAZE_MIXED(min)
#undef GRAZE_MIXED

/// Is the number n a member of x?
template <class P, class N>
std::enable_if_t<
    graze::detail::rounded<P> && graze::detail::is_number<N> && !std::is_same_v<N, double>, bool>
in(const N& n, const interval<double, P>& x) {
  return graze::detail::round_down(n) == graze::detail::round_up(n)
             ? in(graze::detail::round_down(n), x)
             : in(graze::detail::round_down(n), x) && in(graze::detail::round_up(n), x);
}

// Boost's comparisons (which throw when unsure) with a number that may be no double: in the double
// next to it that gives the same answer. Policies with comparisons of ours have their own.
#define GRAZE_COMPARE(operation, round)                                                            \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && !graze::detail::compares_by_policy<P> &&           \
                       graze::detail::other_number<N> && !graze::detail::exactly_a_double<N>,      \
                   bool> operator operation(const interval<double, P>& x, const N & n) {           \
    return x.operator operation(graze::detail::round(n));                                          \
  }
GRAZE_COMPARE(<, round_up)
GRAZE_COMPARE(<=, round_down)
GRAZE_COMPARE(>, round_down)
GRAZE_COMPARE(>=, round_up)
#undef GRAZE_COMPARE
#define GRAZE_COMPARE(operation)                                                                   \
  template <class P, class N>                                                                      \
  std::enable_if_t<graze::detail::rounded<P> && !graze::detail::compares_by_policy<P> &&           \
                       graze::detail::other_number<N> && !graze::detail::exactly_a_double<N>,      \
                   bool> operator operation(const interval<double, P>& x, const N & n) {           \
    return x.operator operation(interval<double, P>(n));                                           \
  }
GRAZE_COMPARE(==)
GRAZE_COMPARE(!=)
#undef GRAZE_COMPARE

/// "[1,2]", enclosing: at each end the shortest decimal beyond the bound and before the next
/// double; the bounds themselves under std::hexfloat. "[]" is empty.
template <class Char, class Traits, class P>
std::enable_if_t<graze::detail::rounded<P>, std::basic_ostream<Char, Traits>&>
operator<<(std::basic_ostream<Char, Traits>& out, const interval<double, P>& x) {
  using stream = std::basic_ostream<Char, Traits>;
  const bool hexadecimal =
      (out.flags() & stream::floatfield) == (stream::fixed | stream::scientific);
  std::basic_string<Char, Traits> text;
  for (const char c : graze::detail::to_text(x, hexadecimal))
    text += out.widen(c);
  return out << text;
}

} // namespace GRAZE_BOOST_NAMESPACE::numeric
