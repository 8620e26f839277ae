#pragma once
/// Set operations and cancellative addition of IEEE 1788.1. Their decorated results are `trv`: they
/// are no point functions. Error: 0 ulp per endpoint. Defined in interval/src/functions/sets.cpp.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

/// The points of both x and y.
struct intersection {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};
/// The least interval that holds x and y.
struct convex_hull {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};
/// The tightest z such that y + z encloses x, hence the z that was added to y to make x: [lo(x) -
/// lo(y), hi(x) - hi(y)] where x is at least as wide as y, exactly compared. Empty for an empty x
/// and a bounded y (an empty one included); in every other case there is none: entire.
/// Source: IEEE 1788-2015, 12.12.5.
struct cancel_minus {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};
/// cancel_minus(x, -y).
struct cancel_plus {
  static bounds value(bounds x, bounds y);
  static decoration local(bounds x, bounds y);
};

} // namespace functions

template <Real N, Policies P>
interval_of<P, N> intersection(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return apply<functions::intersection>(x, y);
}
template <Real N, Policies P>
interval_of<P, N> convex_hull(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return apply<functions::convex_hull>(x, y);
}
template <Real N, Policies P>
interval_of<P, N> cancel_minus(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return apply<functions::cancel_minus>(x, y);
}
template <Real N, Policies P>
interval_of<P, N> cancel_plus(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return apply<functions::cancel_plus>(x, y);
}

} // namespace graze
