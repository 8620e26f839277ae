#pragma once
#include <cmath>
#include <peers/papers/slabs.hpp>

namespace graze::peers {

/// Tavian Barnes 2022, "Fast, branchless ray/bounding box intersections, part 3: boundaries": no
/// sign is looked at; minima and maxima, in an order in which NaN counts as inside.
class tavian : slabs {
public:
  static constexpr char name[] = "tavian", title[] = "Tavian";
  static constexpr char summary[] =
      "branchless ray/box test, boundaries included (Tavian Barnes 2022)";
  using slabs::slabs;

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = INFINITY;
    for (unsigned a = 0; a < 3; ++a) {
      const double first = (lo[a] - origin_[a]) * inverse_[a];
      const double second = (hi[a] - origin_[a]) * inverse_[a];
      enter = min(max(first, enter), max(second, enter));
      leave = max(min(first, leave), min(second, leave));
    }
    return enter <= leave;
  }

private:
  // as minsd and maxsd: the second operand where one is NaN
  static double min(double x, double y) { return x < y ? x : y; }
  static double max(double x, double y) { return x > y ? x : y; }
};

} // namespace graze::peers
