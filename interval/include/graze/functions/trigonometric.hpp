#pragma once
/// Trigonometric functions of intervals and their inverses, in radians, for arguments of any size.
/// Each is the tightest enclosure, 0 ulp per endpoint, of its range over the members of x that are
/// in its domain; empty if there is none. Source: CORE-MATH or CRlibm (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

GRAZE_FOR_EACH_TRIGONOMETRIC(GRAZE_FUNCTION_OF_ONE)
struct atan2 {
  static bounds value(bounds y, bounds x);
  static decoration local(bounds y, bounds x);
  static bool continuous_around(bounds y, bounds x); ///< not on the negative x axis
};

} // namespace functions

/// Domains: sin, cos, atan all numbers; tan all but odd multiples of pi/2 (entire if x holds one); asin,
/// acos |t| <= 1.
GRAZE_FOR_EACH_TRIGONOMETRIC(GRAZE_BESIDE_BOOST)
/// Encloses { the angle in (-pi, pi] of the point (s, t) : s in x, t in y, (s, t) != (0, 0) }. On
/// the negative x axis the angle is pi: a box that holds a part of it and points below is mapped to
/// [-pi, pi].
template <Real N, Policies P>
interval_of<P, N> atan2(const interval_of<P, N>& y, const interval_of<P, N>& x) {
  return apply<functions::atan2>(y, x);
}

} // namespace graze
