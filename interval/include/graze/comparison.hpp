#pragma once
/// Comparisons of intervals whose policies name certain_comparison: true iff what they say holds
/// for every pair of members (hence for an empty operand). Not x < y does not mean x >= y. Equality
/// is that of sets. (Boost's own throw when unsure.)
///
/// Other policies of a client keep Boost's comparisons. So do these types where a client's code has
/// one of Boost's namespaces of comparisons in force (`using namespace
/// boost::numeric::interval_lib::compare::tribool`): those operators are more specialized.
#include <graze/needs_cxx20.hpp>

#include <graze/policies.hpp>

namespace graze {

namespace detail {

template <class X> inline constexpr bool compares_as_certain = false;
template <Real N, class P>
  requires std::same_as<typename P::comparison, certain_comparison>
inline constexpr bool compares_as_certain<boost::numeric::interval<N, P>> = true;

/// What is compared of an operand.
struct ends {
  double lower, upper;
  bool empty;
};
/// A number is the interval that holds it alone: NaN and infinities are empty. One that is no
/// double lies between two neighbours, and is less than another double where the lower neighbour
/// is, and at most it where the upper one is.
template <class X> ends ends_for_less(const X& x) {
  if constexpr (compares_as_certain<X>) {
    const double lower = rounding::widened(x.lower()), upper = rounding::widened(x.upper());
    return {lower, upper, checking::is_empty(lower, upper)};
  } else {
    const double down = round_down(x), up = round_up(x);
    return {up, down, checking::is_empty(down, up)};
  }
}
template <class X> ends ends_for_at_most(const X& x) {
  if constexpr (compares_as_certain<X>) {
    return ends_for_less(x);
  } else {
    const double down = round_down(x), up = round_up(x);
    return {down, up, checking::is_empty(down, up)};
  }
}

} // namespace detail

/// One is an interval whose comparisons are these, the other one too or a number.
template <class X, class Y>
concept CertainlyCompared =
    (detail::compares_as_certain<X> && (detail::compares_as_certain<Y> || detail::is_number<Y>)) ||
    (detail::is_number<X> && detail::compares_as_certain<Y>);

template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator<(const X& x, const Y& y) {
  const auto a = detail::ends_for_less(x), b = detail::ends_for_less(y);
  return a.empty || b.empty || a.upper < b.lower;
}
template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator<=(const X& x, const Y& y) {
  const auto a = detail::ends_for_at_most(x), b = detail::ends_for_at_most(y);
  return a.empty || b.empty || a.upper <= b.lower;
}
template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator>(const X& x, const Y& y) {
  return y < x;
}
template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator>=(const X& x, const Y& y) {
  return y <= x;
}
template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator==(const X& x, const Y& y) {
  // no interval equals a number that is no double, whose ends for `less` are in the wrong order
  const auto a = detail::ends_for_less(x), b = detail::ends_for_less(y);
  return a.empty || b.empty ? a.empty && b.empty : a.lower == b.lower && a.upper == b.upper;
}
template <class X, class Y>
  requires CertainlyCompared<X, Y>
bool operator!=(const X& x, const Y& y) {
  return !(x == y);
}

} // namespace graze
