#pragma once
/// graze::interval<Backend> and its arithmetic, without the functions (graze/interval.hpp has
/// both). Every operation here, and those of Boost.Interval that it lists, gives the tightest
/// enclosure of the range over the operands' real members: 0 ulp per endpoint.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <graze/boost_functions.hpp>
#include <graze/comparison.hpp>
#include <graze/policies.hpp>
#include <graze/rounding/nearest.hpp>

#if defined(__x86_64__)
#include <graze/packed_interval.hpp>
#endif

namespace graze {

namespace detail {
template <class B> struct interval_policies {
  using type = policies<B>;
};
#if defined(__x86_64__)
template <class B>
  requires PackedPolicies<policies<B>>
struct interval_policies<B> {
  using type = outward_policies<B>;
};
#endif
} // namespace detail

/// With the default backend every operation may be inlined anywhere and sets no mode. The others
/// set and restore their mode in every operation; see `unprotected`. Boost's class with
/// policies<B>, or with outward_policies<B> where B has instructions on pairs.
template <rounding::Backend B = rounding::nearest>
using interval = boost::numeric::interval<double, typename detail::interval_policies<B>::type>;

/// For inner loops: the operations assume that the caller holds a `typename B::scope`.
template <rounding::Backend B> using unprotected = interval<rounding::held_once<B>>;

// Found beside the overloads below whether called by name or by argument. Tightest as they are:
// -x, x + y, x - y, x * y, sqrt, square, abs, min, max of intervals.
using boost::numeric::abs;
using boost::numeric::empty;
using boost::numeric::hull;
using boost::numeric::intersect;
using boost::numeric::max;
using boost::numeric::min;
using boost::numeric::sqrt;
using boost::numeric::square;
using boost::numeric::subset;
using boost::numeric::width;

// Sums need no test for empty operands, which Boost's own make: a NaN reaches a bound, and where
// infinities of the empty [inf, inf] go, no non-empty set comes out.
template <Policies P> interval_of<P> operator+(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] typename P::rounding rnd;
  return interval_of<P>(rnd.add_down(x.lower(), y.lower()), rnd.add_up(x.upper(), y.upper()), true);
}
template <Policies P> interval_of<P> operator-(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] typename P::rounding rnd;
  return interval_of<P>(rnd.sub_down(x.lower(), y.upper()), rnd.sub_up(x.upper(), y.lower()), true);
}

// Mixed operations (boost_functions.hpp has those with other numbers than double and int): a number
// stands for the interval that holds it alone, so that NaN and
// infinities, which are no real numbers, give the empty set. (Boost multiplies by infinity as if it
// were a number: inf * [-1, 1] would be entire, inf * [0, 1] a NaN.)
template <Policies P> interval_of<P> operator+(const interval_of<P>& x, const double& y) {
  return x + interval_of<P>(y);
}
template <Policies P> interval_of<P> operator+(const double& x, const interval_of<P>& y) {
  return interval_of<P>(x) + y;
}
template <Policies P> interval_of<P> operator-(const interval_of<P>& x, const double& y) {
  return x - interval_of<P>(y);
}
template <Policies P> interval_of<P> operator-(const double& x, const interval_of<P>& y) {
  return interval_of<P>(x) - y;
}
template <Policies P> interval_of<P> operator*(const double& x, const interval_of<P>& y) {
  using I = interval_of<P>;
  if (empty(y) || empty(I(x)))
    return I::empty();
  typename P::rounding rnd;
  if (rounding::exact::below_zero(x))
    return I(rnd.mul_down(x, y.upper()), rnd.mul_up(x, y.lower()), true);
  if (rounding::exact::is_zero(x))
    return I(0.0, 0.0, true);
  return I(rnd.mul_down(x, y.lower()), rnd.mul_up(x, y.upper()), true);
}
template <Policies P> interval_of<P> operator*(const interval_of<P>& x, const double& y) {
  return y * x;
}

// What serves every backend. Bounds are compared with 0 and with each other as integers: the
// comparisons are right in any environment, wherever the compiler moves them.
namespace detail {
using rounding::exact::above_zero, rounding::exact::below_zero, rounding::exact::is_zero;

constexpr double lesser(double x, double y) { return rounding::exact::less(y, x) ? y : x; }
constexpr double greater(double x, double y) { return rounding::exact::less(x, y) ? y : x; }

/// Encloses { s t : s in x, t in y }.
template <Policies P> interval_of<P> multiply(const interval_of<P>& x, const interval_of<P>& y) {
  using I = interval_of<P>;
  if (empty(x) || empty(y))
    return I::empty();
  const double a = x.lower(), b = x.upper(), c = y.lower(), d = y.upper();
  const bool x_below = below_zero(a), x_above = above_zero(b);
  const bool y_below = below_zero(c), y_above = above_zero(d);
  if (!(x_below || x_above) || !(y_below || y_above))
    return I(0.0, 0.0, true);
  typename P::rounding rnd;
  if (x_below && x_above) {
    if (y_below && y_above)
      return I(lesser(rnd.mul_down(a, d), rnd.mul_down(b, c)),
               greater(rnd.mul_up(a, c), rnd.mul_up(b, d)), true);
    return y_below ? I(rnd.mul_down(b, c), rnd.mul_up(a, c), true)
                   : I(rnd.mul_down(a, d), rnd.mul_up(b, d), true);
  }
  if (x_below)
    return I(rnd.mul_down(y_above ? a : b, d), rnd.mul_up(y_below ? a : b, c), true);
  return I(rnd.mul_down(y_below ? b : a, c), rnd.mul_up(y_above ? b : a, d), true);
}

/// Encloses { a / b : a in x, b in y, b != 0 }; empty for y = [0, 0]. Where y reaches 0 from one
/// side and x ends at 0, Boost's own operator gives entire: [-1, 0] / [0, 1] is [-inf, 0].
template <Policies P> interval_of<P> divide(const interval_of<P>& x, const interval_of<P>& y) {
  using I = interval_of<P>;
  if (empty(x) || empty(y))
    return I::empty();
  const double a = x.lower(), b = x.upper(), c = y.lower(), d = y.upper();
  if (is_zero(c) && is_zero(d))
    return I::empty();
  if (is_zero(a) && is_zero(b))
    return I(0.0, 0.0, true);
  if (below_zero(c) && above_zero(d))
    return I::whole();
  typename P::rounding rnd;
  constexpr double infinity = checking::infinity;
  const bool from_zero = is_zero(c), to_zero = is_zero(d);
  if (!below_zero(c)) { // y within [0, inf]
    if (!below_zero(a))
      return I(rnd.div_down(a, d), from_zero ? infinity : rnd.div_up(b, c), true);
    if (!above_zero(b))
      return I(from_zero ? -infinity : rnd.div_down(a, c), rnd.div_up(b, d), true);
    return from_zero ? I::whole() : I(rnd.div_down(a, c), rnd.div_up(b, c), true);
  }
  if (!below_zero(a))
    return I(to_zero ? -infinity : rnd.div_down(b, d), rnd.div_up(a, c), true);
  if (!above_zero(b))
    return I(rnd.div_down(b, c), to_zero ? infinity : rnd.div_up(a, d), true);
  return to_zero ? I::whole() : I(rnd.div_down(b, d), rnd.div_up(a, d), true);
}

/// Encloses { t^2 : t in x }.
template <Policies P> interval_of<P> squared(const interval_of<P>& x) {
  using I = interval_of<P>;
  if (empty(x))
    return I::empty();
  const double a = x.lower(), b = x.upper();
  const double far = greater(-a, b), near = below_zero(b) ? -b : above_zero(a) ? a : 0;
  typename P::rounding rnd;
  return I(rnd.mul_down(near, near), rnd.mul_up(far, far), true);
}

/// Encloses { sqrt t : t in x, t >= 0 }.
template <Policies P> interval_of<P> root(const interval_of<P>& x) {
  using I = interval_of<P>;
  if (empty(x) || below_zero(x.upper()))
    return I::empty();
  typename P::rounding rnd;
  return I(above_zero(x.lower()) ? rnd.sqrt_down(x.lower()) : 0.0, rnd.sqrt_up(x.upper()), true);
}
} // namespace detail

template <Policies P> interval_of<P> operator*(const interval_of<P>& x, const interval_of<P>& y) {
  return detail::multiply(x, y);
}
template <Policies P> interval_of<P> square(const interval_of<P>& x) { return detail::squared(x); }
template <Policies P> interval_of<P> sqrt(const interval_of<P>& x) { return detail::root(x); }
template <Policies P> interval_of<P> operator/(const interval_of<P>& x, const interval_of<P>& y) {
  return detail::divide(x, y);
}
template <Policies P> interval_of<P> operator/(const interval_of<P>& x, const double& y) {
  return x / interval_of<P>(y);
}
template <Policies P> interval_of<P> operator/(const double& x, const interval_of<P>& y) {
  return interval_of<P>(x) / y;
}

/// x^2: for an interval the tightest enclosure of { t^2 : t in x }, for a double x * x. One formula
/// serves both.
template <Real N, Policies P> interval_of<P, N> sqr(const interval_of<P, N>& x) {
  return square(x);
}
constexpr double sqr(double x) { return x * x; }

/// The least number (double or float, as the bounds are) >= upper - lower; NaN for the empty set.
template <Real N, Policies P> N width(const interval_of<P, N>& x) {
  if (empty(x))
    return std::numeric_limits<N>::quiet_NaN();
  typename P::rounding rnd;
  return rnd.sub_up(x.upper(), x.lower());
}

} // namespace graze

namespace boost::numeric {
using graze::width;
/// Is the number x a member of y? Infinities are none.
template <graze::Real N, graze::Policies P> bool in(const N& x, const interval<N, P>& y) {
  return -graze::checking::infinity < x && x < graze::checking::infinity && !empty(y) &&
         y.lower() <= x && x <= y.upper();
}
} // namespace boost::numeric

#if defined(__x86_64__)
#include <graze/packed_arithmetic.hpp>
#endif
#include <graze/float_interval.hpp>
