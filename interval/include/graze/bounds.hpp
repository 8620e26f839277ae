#pragma once
/// The bounds of a closed set of real numbers, without policies: what the compiled functions take
/// and give, and what other languages see.
#include <graze/needs_cxx20.hpp>

#include <graze/interval_type.hpp>
#include <graze/rounding/narrow.hpp>
#include <limits>

namespace graze {

/// { t real : lo <= t <= hi }; lo may be -inf and hi +inf, which are no members. The empty set is
/// {NaN, NaN}; no other bounds hold a NaN, and a zero bound is of either sign.
struct bounds {
  double lo, hi;

  static constexpr bounds empty() {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  static constexpr bounds entire() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] constexpr bool is_empty() const { return lo != lo; }
  /// Neither empty nor unbounded: what a decoration `com` needs.
  [[nodiscard]] constexpr bool is_common() const {
    return -std::numeric_limits<double>::max() <= lo && hi <= std::numeric_limits<double>::max();
  }
  [[nodiscard]] constexpr bool contains(double x) const { return lo <= x && x <= hi; }
  [[nodiscard]] constexpr bool within(const bounds& outer) const {
    return is_empty() || (outer.lo <= lo && hi <= outer.hi);
  }
};

/// Exact.
template <Real N, Policies P> bounds to_bounds(const interval_of<P, N>& x) {
  const double lo = rounding::widened(x.lower()), hi = rounding::widened(x.upper());
  // not so for a NaN, for lo > hi, nor (inf - inf) for [inf, inf] and [-inf, -inf]
  return hi - lo >= 0 ? bounds{lo, hi} : bounds::empty();
}
/// The tightest interval that holds x: of doubles, x.
template <Policies P, Real N = double> interval_of<P, N> to_interval(const bounds& x) {
  if constexpr (std::same_as<N, float>)
    return interval_of<P, N>(rounding::narrow_down(x.lo), rounding::narrow_up(x.hi), true);
  else
    return interval_of<P, N>(x.lo, x.hi, true);
}

} // namespace graze
