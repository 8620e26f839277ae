#pragma once
/// Comparisons and tests of IEEE 1788.1 (10.5.9, 10.5.10, 10.6.3), for bounds, intervals and
/// decorated intervals. All are exact, in any environment. A decorated one with a NaI is false
/// (is_nai apart).
#include <graze/needs_cxx20.hpp>

#include <graze/bounds.hpp>
#include <graze/decorated_bounds.hpp>

namespace graze {

namespace detail {
using rounding::exact::less;
using rounding::exact::less_equal;
/// x < y, or both the same infinity: the order of which `interior` and `strict_less` are made.
constexpr bool below(double x, double y) {
  return less(x, y) || (x == y && (x == checking::infinity || x == -checking::infinity));
}
} // namespace detail

constexpr bool is_empty(const bounds& x) { return x.is_empty(); }
constexpr bool is_entire(const bounds& x) {
  return x.lo == -checking::infinity && x.hi == checking::infinity;
}
/// Exactly one member.
constexpr bool is_singleton(const bounds& x) { return rounding::exact::equal(x.lo, x.hi); }
/// Bounded and not empty.
constexpr bool is_common_interval(const bounds& x) { return x.is_common(); }
/// Is the real number m in x? Infinities and NaN are none.
constexpr bool is_member(double m, const bounds& x) {
  return detail::less_equal(x.lo, m) && detail::less_equal(m, x.hi) && -checking::infinity < m &&
         m < checking::infinity;
}

/// x = y as sets.
constexpr bool equal(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.is_empty()
                      : rounding::exact::equal(x.lo, y.lo) && rounding::exact::equal(x.hi, y.hi);
}
/// Every member of x is one of y.
constexpr bool subset(const bounds& x, const bounds& y) {
  return x.is_empty() || (detail::less_equal(y.lo, x.lo) && detail::less_equal(x.hi, y.hi));
}
/// x lies in the topological interior of y.
constexpr bool interior(const bounds& x, const bounds& y) {
  return x.is_empty() || (detail::below(y.lo, x.lo) && detail::below(x.hi, y.hi));
}
/// Each member of x is <= some member of y, and each of y is >= some of x.
constexpr bool less(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.is_empty()
                      : detail::less_equal(x.lo, y.lo) && detail::less_equal(x.hi, y.hi);
}
/// less, with < in place of <=.
constexpr bool strict_less(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.is_empty() : detail::below(x.lo, y.lo) && detail::below(x.hi, y.hi);
}
/// No member of x is greater than one of y.
constexpr bool precedes(const bounds& x, const bounds& y) {
  return x.is_empty() || y.is_empty() || detail::less_equal(x.hi, y.lo);
}
/// Every member of x is less than every one of y.
constexpr bool strict_precedes(const bounds& x, const bounds& y) {
  return x.is_empty() || y.is_empty() || detail::less(x.hi, y.lo);
}
/// No common member.
constexpr bool disjoint(const bounds& x, const bounds& y) {
  return x.is_empty() || y.is_empty() || detail::less(x.hi, y.lo) || detail::less(y.hi, x.lo);
}

constexpr bool is_nai(const decorated_bounds& x) { return x.is_nai(); }

#define GRAZE_UNARY_TEST(name)                                                                     \
  constexpr bool name(const decorated_bounds& x) { return !x.is_nai() && name(x.part); }           \
  template <Real N, Policies P> bool name(const interval_of<P, N>& x) { return name(to_bounds(x)); }
GRAZE_UNARY_TEST(is_empty)
GRAZE_UNARY_TEST(is_entire)
GRAZE_UNARY_TEST(is_singleton)
GRAZE_UNARY_TEST(is_common_interval)
#undef GRAZE_UNARY_TEST

constexpr bool is_member(double m, const decorated_bounds& x) { return is_member(m, x.part); }
template <Real N, Policies P> bool is_member(double m, const interval_of<P, N>& x) {
  return is_member(m, to_bounds(x));
}

#define GRAZE_BINARY_TEST(name)                                                                    \
  constexpr bool name(const decorated_bounds& x, const decorated_bounds& y) {                      \
    return !x.is_nai() && !y.is_nai() && name(x.part, y.part);                                     \
  }                                                                                                \
  template <Real N, Policies P>                                                                    \
  bool name(const interval_of<P, N>& x, const interval_of<P, N>& y) {                              \
    return name(to_bounds(x), to_bounds(y));                                                       \
  }
GRAZE_BINARY_TEST(equal)
GRAZE_BINARY_TEST(subset)
GRAZE_BINARY_TEST(interior)
GRAZE_BINARY_TEST(less)
GRAZE_BINARY_TEST(strict_less)
GRAZE_BINARY_TEST(precedes)
GRAZE_BINARY_TEST(strict_precedes)
GRAZE_BINARY_TEST(disjoint)
#undef GRAZE_BINARY_TEST

} // namespace graze
