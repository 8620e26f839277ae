#pragma once
/// How two intervals lie to each other: the 16 states of IEEE 1788-2015, 10.6.4.
#include <graze/needs_cxx20.hpp>

#include <graze/bounds.hpp>
#include <graze/decorated_bounds.hpp>

namespace graze {

/// Of x to y, for x = [a, b] and y = [c, d] where neither is empty.
enum class overlap_state {
  both_empty,
  first_empty,
  second_empty,
  before,        ///< b < c
  meets,         ///< a < b = c < d
  overlaps,      ///< a < c < b < d
  starts,        ///< a = c, b < d
  contained_by,  ///< c < a, b < d
  finishes,      ///< c < a, b = d
  equals,        ///< a = c, b = d
  finished_by,   ///< a < c, b = d
  contains,      ///< a < c, d < b
  started_by,    ///< a = c, d < b
  overlapped_by, ///< c < a < d < b
  met_by,        ///< c < d = a < b
  after,         ///< d < a
  undefined,     ///< one is NaI
};

/// The standard's name: "bothEmpty", "containedBy", ...
const char* name_of(overlap_state state);

constexpr overlap_state overlap(const bounds& x, const bounds& y) {
  using enum overlap_state;
  if (x.is_empty() || y.is_empty())
    return !y.is_empty() ? first_empty : !x.is_empty() ? second_empty : both_empty;
  // as integers, in any environment
  using rounding::exact::rank;
  const std::int64_t a = rank(x.lo), b = rank(x.hi), c = rank(y.lo), d = rank(y.hi);
  if (b < c)
    return before;
  if (d < a)
    return after;
  if (a == c)
    return b < d ? starts : b == d ? equals : started_by;
  if (b == d)
    return c < a ? finishes : finished_by;
  if (b == c)
    return meets;
  if (d == a)
    return met_by;
  if (a < c)
    return b < d ? overlaps : contains;
  return b < d ? contained_by : overlapped_by;
}
constexpr overlap_state overlap(const decorated_bounds& x, const decorated_bounds& y) {
  return x.is_nai() || y.is_nai() ? overlap_state::undefined : overlap(x.part, y.part);
}
template <Real N, Policies P>
overlap_state overlap(const interval_of<P, N>& x, const interval_of<P, N>& y) {
  return overlap(to_bounds(x), to_bounds(y));
}

} // namespace graze
