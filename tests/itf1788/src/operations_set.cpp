#include "operation.hpp"
#include <graze/overlap.hpp>

namespace graze::itf1788 {

namespace {

/// A comparison or a number of N intervals.
template <std::size_t N, auto f, auto c>
std::vector<result> query(std::span<const value> operands) {
  std::vector<result> all;
  if (const auto bare = operands_of<bounds, N>(operands)) {
    all = single_result(std::apply(f, *bare));
    add_bare_forms<f, c>(all, *bare);
  } else if (const auto marked = operands_of<decorated_bounds, N>(operands)) {
    all = single_result(std::apply(f, *marked));
    add_decorated_forms<f>(all, *marked);
  }
  return all;
}

#define GRAZE_QUERY(itl, name, N)                                                                  \
  operation { itl, query<N, GRAZE_OVERLOADS(name), graze_##name> }

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
  if (const auto* bare = std::get_if<bounds>(&operands[1])) {
    std::vector<result> all = single_result(graze::is_member(m, *bare));
    add_form(all, graze_is_member(m, to_c(*bare)), "graze.h");
    return all;
  }
  if (const auto* decorated = std::get_if<decorated_bounds>(&operands[1]))
    return single_result(graze::is_member(m, *decorated));
  return {};
}

/// A bare interval is never NaI.
std::vector<result> is_nai(std::span<const value> operands) {
  if (operands_of<bounds, 1>(operands))
    return single_result(false);
  if (const auto decorated = operands_of<decorated_bounds, 1>(operands))
    return single_result((*decorated)[0].is_nai());
  return {};
}

std::vector<result> overlap(std::span<const value> operands) {
  if (const auto bare = operands_of<bounds, 2>(operands)) {
    const auto& [x, y] = *bare;
    std::vector<result> all = single_result(overlap_name{name_of(graze::overlap(x, y))});
    add_form(all, overlap_name{graze_overlap(to_c(x), to_c(y))}, "graze.h");
    return all;
  }
  if (const auto marked = operands_of<decorated_bounds, 2>(operands))
    return single_result(overlap_name{name_of(graze::overlap((*marked)[0], (*marked)[1]))});
  return {};
}

} // namespace

std::span<const operation> set_operations() {
  static constexpr std::array table{
      GRAZE_OPERATION("intersection", intersection, 2),
      GRAZE_OPERATION("convexHull", convex_hull, 2),
      GRAZE_OPERATION("cancelPlus", cancel_plus, 2),
      GRAZE_OPERATION("cancelMinus", cancel_minus, 2),
      GRAZE_QUERY("inf", inf, 1),
      GRAZE_QUERY("sup", sup, 1),
      GRAZE_QUERY("mid", mid, 1),
      GRAZE_QUERY("rad", rad, 1),
      operation{"midRad", mid_rad},
      GRAZE_QUERY("wid", wid, 1),
      GRAZE_QUERY("mag", mag, 1),
      GRAZE_QUERY("mig", mig, 1),
      GRAZE_QUERY("isEmpty", is_empty, 1),
      GRAZE_QUERY("isEntire", is_entire, 1),
      GRAZE_QUERY("isSingleton", is_singleton, 1),
      GRAZE_QUERY("isCommonInterval", is_common_interval, 1),
      operation{"isMember", is_member},
      operation{"isNaI", is_nai},
      GRAZE_QUERY("equal", equal, 2),
      GRAZE_QUERY("subset", subset, 2),
      GRAZE_QUERY("interior", interior, 2),
      GRAZE_QUERY("disjoint", disjoint, 2),
      GRAZE_QUERY("less", less, 2),
      GRAZE_QUERY("strictLess", strict_less, 2),
      GRAZE_QUERY("precedes", precedes, 2),
      GRAZE_QUERY("strictPrecedes", strict_precedes, 2),
      operation{"overlap", overlap},
  };
  return table;
}

} // namespace graze::itf1788
