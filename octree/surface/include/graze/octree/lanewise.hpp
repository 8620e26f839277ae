#pragma once
/// What is made of comparisons and choices is written once over the lanes of a register
/// (batch/path.hpp) and serves scalar intervals as well, whose register has one lane.
#include <graze/batch/portable.hpp>
#include <graze/interval.hpp>

namespace graze::octree {

/// One lane with the arithmetic of B, called within its scope.
template <rounding::Backend B> struct scalar_path : batch::portable {
  static GRAZE_BATCH_INLINE double add_up(double x, double y) { return B::add_up(x, y); }
  static GRAZE_BATCH_INLINE double mul_up(double x, double y) { return B::mul_up(x, y); }
};

/// How an interval type runs an operation on parts: `path` is the one that the operation is written
/// over. Eight intervals are in eight.hpp.
template <class I> struct lanewise;

/// Operations here compare and choose, and leave arithmetic to the type.
template <class Policies> struct lanewise<boost::numeric::interval<double, Policies>> {
  using interval = boost::numeric::interval<double, Policies>;
  using path = batch::portable;
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE interval apply(const Operands&... x) {
    const batch::part<path> r = Operation(batch::part<path>{x.lower(), x.upper()}...);
    return interval(r.lo, r.hi, true);
  }
  /// It holds in every lane.
  template <auto Predicate, class... Operands>
  static GRAZE_BATCH_INLINE bool everywhere(const Operands&... x) {
    return Predicate(batch::part<path>{x.lower(), x.upper()}...);
  }
};

} // namespace graze::octree
