#pragma once
/// The bounds of a closed set of real numbers, without policies: what the compiled functions take
/// and give, and what other languages see.
#include <graze/needs_cxx20.hpp>

#include <graze/interval_type.hpp>
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

template <Policies P> bounds to_bounds(const interval_of<P>& x) {
  const double lo = x.lower(), hi = x.upper();
  // not so for a NaN, for lo > hi, nor (inf - inf) for [inf, inf] and [-inf, -inf]
  return hi - lo >= 0 ? bounds{lo, hi} : bounds::empty();
}
template <Policies P> interval_of<P> to_interval(const bounds& x) {
  return interval_of<P>(x.lo, x.hi, true);
}

} // namespace graze
