#pragma once
/// Cube root, length of a vector, and the real power of intervals. Each is the tightest enclosure,
/// 0 ulp per endpoint, of its range over the members of the operands that are in its domain; empty
/// if there is none. Source: CORE-MATH (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

GRAZE_FUNCTION_OF_ONE(cbrt)
struct hypot {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};
struct pow {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};

} // namespace functions

/// Encloses { the real cube root of t : t in x }.
GRAZE_BESIDE_BOOST(cbrt)
/// Encloses { sqrt(s^2 + t^2) : s in x, t in y }.
template <Real N, Policies P>
interval_of<P, N> hypot(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return apply<functions::hypot>(x, y);
}
/// Encloses { s^t : s in x, t in y, s > 0 or (s = 0 and t > 0) }: e^(t log s), and 0 for s = 0. For
/// integer powers of negative numbers see pown.
GRAZE_BESIDE_BOOST_2(pow)

} // namespace graze
