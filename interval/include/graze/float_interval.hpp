#pragma once
/// graze::float_interval<Backend>: intervals of floats, in half the memory. Every operation and
/// function is the one of double intervals, rounded outward to floats once, and is thereby tightest
/// among floats (graze/rounding/narrow.hpp has the proof). Part of graze/interval.hpp.
///
/// FTZ and DAZ do not matter to + - * / sqr sqrt and the functions on it: no subnormal float
/// reaches a floating-point instruction, and no result of theirs in double is subnormal.
///
/// Numbers of any type beside float intervals are enclosed, as everywhere: x * 0.1 holds the exact
/// products with the double 0.1. Members of Boost's class that take bounds (assign, set, the static
/// hull) take floats, to which the language converts a double unasked, to nearest.
#include <graze/needs_cxx20.hpp>

#include <graze/interval_type.hpp>
#include <graze/rounding/narrow.hpp>

namespace graze {

/// The same type as boost::numeric::interval<float, policies<B>>, with Boost's layout. For inner
/// loops: float_interval<rounding::held_once<B>>, as `unprotected` is for doubles.
template <rounding::Backend B = rounding::nearest>
using float_interval = boost::numeric::interval<float, policies<B>>;

namespace detail {
/// The same set, with doubles for bounds.
template <Policies P> interval_of<P> widened(const interval_of<P, float>& x) {
  return interval_of<P>(rounding::widened(x.lower()), rounding::widened(x.upper()), true);
}
/// The tightest that holds x.
template <Policies P> interval_of<P, float> narrowed(const interval_of<P>& x) {
  return interval_of<P, float>(rounding::narrow_down(x.lower()), rounding::narrow_up(x.upper()),
                               true);
}
} // namespace detail

#define GRAZE_BINARY(operation)                                                                    \
  template <Policies P>                                                                            \
  interval_of<P, float> operator operation(const interval_of<P, float>& x,                         \
                                           const interval_of<P, float>& y) {                       \
    return detail::narrowed(detail::widened(x) operation detail::widened(y));                      \
  }                                                                                                \
  template <Policies P>                                                                            \
  interval_of<P, float> operator operation(const interval_of<P, float>& x, const float& y) {       \
    return x operation interval_of<P, float>(y);                                                   \
  }                                                                                                \
  template <Policies P>                                                                            \
  interval_of<P, float> operator operation(const float& x, const interval_of<P, float>& y) {       \
    return interval_of<P, float>(x) operation y;                                                   \
  }
GRAZE_BINARY(+)
GRAZE_BINARY(-)
GRAZE_BINARY(*)
GRAZE_BINARY(/)
#undef GRAZE_BINARY

/// Encloses { t^2 : t in x }.
template <Policies P> interval_of<P, float> square(const interval_of<P, float>& x) {
  return detail::narrowed(square(detail::widened(x)));
}
/// Encloses { sqrt t : t in x, t >= 0 }.
template <Policies P> interval_of<P, float> sqrt(const interval_of<P, float>& x) {
  return detail::narrowed(sqrt(detail::widened(x)));
}

} // namespace graze
