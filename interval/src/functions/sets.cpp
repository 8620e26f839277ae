#include "../border.hpp"
#include "../exact/long_accumulator.hpp"
#include <algorithm>
#include <graze/functions/arithmetic.hpp>
#include <graze/functions/sets.hpp>
#include <graze/overlap.hpp>

namespace graze {

const char* name_of(overlap_state state) {
  switch (state) {
  case overlap_state::both_empty:
    return "bothEmpty";
  case overlap_state::first_empty:
    return "firstEmpty";
  case overlap_state::second_empty:
    return "secondEmpty";
  case overlap_state::before:
    return "before";
  case overlap_state::meets:
    return "meets";
  case overlap_state::overlaps:
    return "overlaps";
  case overlap_state::starts:
    return "starts";
  case overlap_state::contained_by:
    return "containedBy";
  case overlap_state::finishes:
    return "finishes";
  case overlap_state::equals:
    return "equals";
  case overlap_state::finished_by:
    return "finishedBy";
  case overlap_state::contains:
    return "contains";
  case overlap_state::started_by:
    return "startedBy";
  case overlap_state::overlapped_by:
    return "overlappedBy";
  case overlap_state::met_by:
    return "metBy";
  case overlap_state::after:
    return "after";
  case overlap_state::undefined:
    return "undefined";
  }
  return "undefined";
}

namespace functions {

namespace inside {
bounds intersection(bounds x, bounds y) {
  if (x.is_empty() || y.is_empty() || x.hi < y.lo || y.hi < x.lo)
    return bounds::empty();
  return {std::max(x.lo, y.lo), std::min(x.hi, y.hi)};
}
bounds convex_hull(bounds x, bounds y) {
  if (x.is_empty())
    return y;
  if (y.is_empty())
    return x;
  return {std::min(x.lo, y.lo), std::max(x.hi, y.hi)};
}
} // namespace inside

bounds intersection::value(bounds x, bounds y) { return at_border<inside::intersection>(x, y); }
decoration intersection::local(bounds, bounds) { return decoration::trv; }

bounds convex_hull::value(bounds x, bounds y) { return at_border<inside::convex_hull>(x, y); }
decoration convex_hull::local(bounds, bounds) { return decoration::trv; }

namespace {
/// hi(x) - lo(x) >= hi(y) - lo(y), exactly, for bounded x and y.
bool as_wide(const bounds& x, const bounds& y) {
  using rounding::nearest;
  if (nearest::sub_down(x.hi, x.lo) >= nearest::sub_up(y.hi, y.lo))
    return true;
  if (nearest::sub_up(x.hi, x.lo) < nearest::sub_down(y.hi, y.lo))
    return false;
  detail::long_accumulator difference;
  difference.add(x.hi);
  difference.add(-x.lo);
  difference.add(-y.hi);
  difference.add(y.lo);
  return difference.sign() >= 0;
}
} // namespace

namespace inside {
bounds cancel_minus(bounds x, bounds y) {
  if (x.is_empty() && (y.is_empty() || y.is_common()))
    return bounds::empty();
  if (!x.is_common() || !y.is_common() || !as_wide(x, y))
    return bounds::entire();
  return {rounding::nearest::sub_down(x.lo, y.lo), rounding::nearest::sub_up(x.hi, y.hi)};
}
} // namespace inside

bounds cancel_minus::value(bounds x, bounds y) { return at_border<inside::cancel_minus>(x, y); }
decoration cancel_minus::local(bounds, bounds) { return decoration::trv; }

bounds cancel_plus::value(bounds x, bounds y) { return cancel_minus::value(x, neg::value(y)); }
decoration cancel_plus::local(bounds, bounds) { return decoration::trv; }

} // namespace functions
} // namespace graze
