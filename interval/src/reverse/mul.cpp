/// Reverse multiplication: all quotients, the divisor's sign at a time.
#include "../border.hpp"
#include "solution_set.hpp"
#include <graze/functions/reverse.hpp>
#include <graze/rounding/nearest.hpp>

namespace graze::functions {

using namespace solutions;

namespace {

struct solution {
  end lo, hi;
  bool exists;
};

end quotient(double y, double u) {
  return {rounding::nearest::div_down(y, u), rounding::nearest::div_up(y, u)};
}

/// { t : u t in c for a u in b, u > 0 }, for a c that is not empty. b.hi > 0.
solution by_positive(const bounds& b, const bounds& c) {
  // The end y of c, divided by the u that makes it smallest or largest in magnitude. With u without
  // bound, y / u comes as near to 0 as one likes, and with u down to 0, it exceeds any bound.
  const auto smallest = [&b](double y) {
    if (b.hi < infinity)
      return quotient(y, b.hi);
    return y > 0 ? just_above(0) : just_below(0);
  };
  const auto largest_of = [&b](double y) {
    if (y == 0)
      return at(0);
    if (b.lo <= 0 || y - y != 0)
      return y > 0 ? unbounded_above : unbounded_below;
    return quotient(y, b.lo);
  };
  return {c.lo > 0 ? smallest(c.lo) : largest_of(c.lo),
          c.hi < 0 ? smallest(c.hi) : largest_of(c.hi), true};
}

solution by_negative(const bounds& b, const bounds& c) {
  const solution mirrored = by_positive({-b.hi, -b.lo}, c);
  return {-mirrored.hi, -mirrored.lo, true};
}

/// The solutions: everything, or those by a negative u and those by a positive u.
struct all_solutions {
  bool everything;
  solution negative, positive;
};
all_solutions solve(const bounds& b, const bounds& c) {
  const solution none = {at(0), at(0), false};
  if (b.is_empty() || c.is_empty())
    return {false, none, none};
  if (b.contains(0) && c.contains(0))
    return {true, none, none};
  return {false, b.lo < 0 ? by_negative(b, c) : none, b.hi > 0 ? by_positive(b, c) : none};
}

bounds hull(const solution& s) { return s.exists ? bounds{s.lo.down, s.hi.up} : bounds::empty(); }

} // namespace

namespace inside {
bounds mul_rev(bounds b, bounds c, bounds x) {
  const all_solutions s = solve(b, c);
  if (s.everything)
    return x;
  hull_within within(x);
  for (const solution& piece : {s.negative, s.positive})
    if (piece.exists)
      within.add(piece.lo, piece.hi);
  return within.result();
}
} // namespace inside
bounds mul_rev::value(bounds b, bounds c, bounds x) { return at_border<inside::mul_rev>(b, c, x); }

namespace inside {
std::pair<bounds, bounds> mul_rev_to_pair(bounds b, bounds c) {
  const all_solutions s = solve(b, c);
  if (s.everything)
    return {bounds::entire(), bounds::empty()};
  const bounds negative = hull(s.negative), positive = hull(s.positive);
  if (negative.is_empty() || positive.is_empty())
    return {negative.is_empty() ? positive : negative, bounds::empty()};
  // Both signs of u: c lies on one side of 0, hence so does each set of solutions.
  return negative.lo < positive.lo ? std::pair{negative, positive} : std::pair{positive, negative};
}
} // namespace inside
std::pair<bounds, bounds> mul_rev_to_pair::value(bounds b, bounds c) {
  return at_border<inside::mul_rev_to_pair>(b, c);
}

decoration mul_rev_to_pair::local(bounds b, bounds c) {
  return b.is_empty() || c.is_empty() || b.contains(0) ? decoration::trv : decoration::dac;
}

} // namespace graze::functions
