#include "operation.hpp"
#include <graze/boolean.hpp>
#include <graze/functions/sets.hpp>
#include <graze/numeric.hpp>
#include <graze/overlap.hpp>

namespace graze::itf1788 {

namespace {

// The library's functions are overloaded: a table needs one object for all overloads.
#define GRAZE_OVERLOADS(name) [](const auto&... x) { return graze::name(x...); }

std::vector<result> mid_rad(std::span<const value> operands) {
  const auto both = [](const centre& c) -> std::vector<result> { return {result{{c.mid, c.rad}}}; };
  if (const auto bare = operands_of<bounds, 1>(operands))
    return both(graze::mid_rad((*bare)[0]));
  if (const auto decorated = operands_of<decorated_bounds, 1>(operands))
    return both(graze::mid_rad((*decorated)[0]));
  return {};
}

std::vector<result> is_member(std::span<const value> operands) {
  if (operands.size() < 2)
    return {};
  const auto* n = std::get_if<std::int64_t>(&operands[0]);
  const auto* number = std::get_if<double>(&operands[0]);
  if (n == nullptr && number == nullptr)
    return {};
  const double m = n != nullptr ? static_cast<double>(*n) : *number;
  if (const auto* bare = std::get_if<bounds>(&operands[1]))
    return one(graze::is_member(m, *bare));
  if (const auto* decorated = std::get_if<decorated_bounds>(&operands[1]))
    return one(graze::is_member(m, *decorated));
  return {};
}

/// A bare interval is never NaI.
std::vector<result> is_nai(std::span<const value> operands) {
  if (operands_of<bounds, 1>(operands))
    return one(false);
  if (const auto decorated = operands_of<decorated_bounds, 1>(operands))
    return one((*decorated)[0].is_nai());
  return {};
}

constexpr auto overlap_of = [](const auto& x, const auto& y) {
  return overlap_name{name_of(overlap(x, y))};
};

} // namespace

std::span<const operation> set_operations() {
  static constexpr std::array table{
      operation{"intersection", function<functions::intersection, 2>},
      operation{"convexHull", function<functions::convex_hull, 2>},
      operation{"cancelPlus", function<functions::cancel_plus, 2>},
      operation{"cancelMinus", function<functions::cancel_minus, 2>},
      operation{"inf", query<1, GRAZE_OVERLOADS(inf)>},
      operation{"sup", query<1, GRAZE_OVERLOADS(sup)>},
      operation{"mid", query<1, GRAZE_OVERLOADS(mid)>},
      operation{"rad", query<1, GRAZE_OVERLOADS(rad)>},
      operation{"midRad", mid_rad},
      operation{"wid", query<1, GRAZE_OVERLOADS(wid)>},
      operation{"mag", query<1, GRAZE_OVERLOADS(mag)>},
      operation{"mig", query<1, GRAZE_OVERLOADS(mig)>},
      operation{"isEmpty", query<1, GRAZE_OVERLOADS(is_empty)>},
      operation{"isEntire", query<1, GRAZE_OVERLOADS(is_entire)>},
      operation{"isSingleton", query<1, GRAZE_OVERLOADS(is_singleton)>},
      operation{"isCommonInterval", query<1, GRAZE_OVERLOADS(is_common_interval)>},
      operation{"isMember", is_member},
      operation{"isNaI", is_nai},
      operation{"equal", query<2, GRAZE_OVERLOADS(equal)>},
      operation{"subset", query<2, GRAZE_OVERLOADS(subset)>},
      operation{"interior", query<2, GRAZE_OVERLOADS(interior)>},
      operation{"disjoint", query<2, GRAZE_OVERLOADS(disjoint)>},
      operation{"less", query<2, GRAZE_OVERLOADS(less)>},
      operation{"strictLess", query<2, GRAZE_OVERLOADS(strict_less)>},
      operation{"precedes", query<2, GRAZE_OVERLOADS(precedes)>},
      operation{"strictPrecedes", query<2, GRAZE_OVERLOADS(strict_precedes)>},
      operation{"overlap", query<2, overlap_of>},
  };
  return table;
}

} // namespace graze::itf1788
