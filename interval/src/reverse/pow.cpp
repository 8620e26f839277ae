/// Reverse power, by its base and by its exponent.
///
/// The power u^t is monotone in u and in t on each side of 1 and of 0, so the solutions on each
/// side form an interval whose ends are powers z^(1/y) or logarithms log_u(z), or are open at 0, 1
/// and infinity. The greatest double <= such an end is found from an estimate, and decided by the
/// correctly rounded power: m <= z^(1/y) iff m^y <= z iff RU(m^y) <= z, for y > 0.
#include "../border.hpp"
#include "solution_set.hpp"
#include <bit>
#include <cstdint>
#include <graze/functions/reverse.hpp>
#include <graze/point.hpp>

namespace graze::functions {

using namespace solutions;

namespace {

/// Doubles >= 0 in their order.
double nonnegative(std::int64_t rank) { return std::bit_cast<double>(rank); }
std::int64_t rank_of(double x) { return std::bit_cast<std::int64_t>(x); }
const std::int64_t last_rank = rank_of(largest);

/// The greatest double m >= 0 for which `at_most(m)` holds, where at_most(0) is true and at_most
/// falls once: by doubling steps from the estimate, then bisection. A good estimate costs two
/// calls.
template <class AtMost> double greatest(double estimate, AtMost at_most) {
  const auto holds = [&](std::int64_t rank) { return rank == 0 || at_most(nonnegative(rank)); };
  std::int64_t below = std::min(estimate > 0 ? rank_of(estimate) : 0, last_rank);
  std::int64_t above = below, step = 1;
  if (holds(below)) {
    do {
      below = above;
      above = std::min(above + step, last_rank + 1);
      step *= 2;
    } while (above <= last_rank && holds(above));
  } else {
    do {
      above = below;
      below = std::max<std::int64_t>(below - step, 0);
      step *= 2;
    } while (!holds(below));
  }
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (holds(middle) ? below : above) = middle;
  }
  return nonnegative(below);
}

/// z^(1/y) for 0 < z < inf, z != 1, and finite y != 0.
end root(double z, double y) {
  // The 64 bits of x87's long double put the estimate within an ulp or so; where long double is
  // double, within a few hundred.
  const auto estimate = static_cast<double>(std::pow(static_cast<long double>(z), 1.0L / y));
  const double m = greatest(estimate, [=](double t) {
    return y > 0 ? point::pow_up(t, y) <= z : point::pow_down(t, y) >= z;
  });
  const bool exact = y > 0 ? point::pow_down(m, y) >= z : point::pow_up(m, y) <= z;
  return m > 0 && exact ? at(m) : just_above(m);
}

/// log_u(z) > 0 for finite u, z > 0, both above 1 or both below.
end positive_logarithm(double u, double z) {
  const auto estimate = static_cast<double>(std::log(static_cast<long double>(z)) /
                                            std::log(static_cast<long double>(u)));
  const double m = greatest(estimate, [=](double t) {
    return u > 1 ? point::pow_up(u, t) <= z : point::pow_down(u, t) >= z;
  });
  const bool exact = u > 1 ? point::pow_down(u, m) >= z : point::pow_up(u, m) <= z;
  return exact ? at(m) : just_above(m);
}

/// log_u(z) < 0, one of u and z above 1 and the other below.
end negative_logarithm(double u, double z) {
  const auto estimate = -static_cast<double>(std::log(static_cast<long double>(z)) /
                                             std::log(static_cast<long double>(u)));
  const double m = greatest(estimate, [=](double t) { // the greatest with u^-t on 1's side of z
    return u > 1 ? point::pow_down(u, -t) >= z : point::pow_up(u, -t) <= z;
  });
  const bool exact = u > 1 ? point::pow_up(u, -m) <= z : point::pow_down(u, -m) >= z;
  return exact ? at(-m) : -just_above(m);
}

} // namespace

namespace inside {
bounds pow_rev1(bounds b, bounds c, bounds x) {
  if (b.is_empty() || c.is_empty())
    return bounds::empty();
  hull_within hull(x);
  const bool reaches_0 = c.lo <= 0; // c, met with the powers below 1, has no least one
  const bool below_1 = c.lo < 1 && c.hi > 0, above_1 = c.hi > 1;
  if (c.contains(0) && b.hi > 0)
    hull.add(at(0), at(0)); // 0^u = 0 for u > 0
  if (c.contains(1))
    b.contains(0) ? hull.add(just_above(0), unbounded_above) // t^0 = 1
                  : hull.add(at(1), at(1));                  // 1^u = 1
  // t > 1 and t < 1, each by u > 0 and u < 0. An end of c within the powers' range gives a root by
  // an end of b that is neither 0 nor infinite. Otherwise the root goes to 1 (the power near 1, or
  // u without bound) or to 0 or infinity (the power near 0 or infinity, or u near 0).
  if (above_1 && b.hi > 0)
    hull.add(c.lo > 1 && b.hi < infinity ? root(c.lo, b.hi) : just_above(1),
             c.hi < infinity && b.lo > 0 ? root(c.hi, b.lo) : unbounded_above);
  if (below_1 && b.lo < 0)
    hull.add(c.hi < 1 && b.lo > -infinity ? root(c.hi, b.lo) : just_above(1),
             !reaches_0 && b.hi < 0 ? root(c.lo, b.hi) : unbounded_above);
  if (below_1 && b.hi > 0)
    hull.add(!reaches_0 && b.lo > 0 ? root(c.lo, b.lo) : just_above(0),
             c.hi < 1 && b.hi < infinity ? root(c.hi, b.hi) : just_below(1));
  if (above_1 && b.lo < 0)
    hull.add(c.hi < infinity && b.hi < 0 ? root(c.hi, b.hi) : just_above(0),
             c.lo > 1 && b.lo > -infinity ? root(c.lo, b.lo) : just_below(1));
  return hull.result();
}
} // namespace inside
bounds pow_rev1::value(bounds b, bounds c, bounds x) {
  return at_border<inside::pow_rev1>(b, c, x);
}

namespace inside {
bounds pow_rev2(bounds a, bounds c, bounds x) {
  if (a.is_empty() || c.is_empty())
    return bounds::empty();
  hull_within hull(x);
  const bool reaches_0 = c.lo <= 0;
  const bool below_1 = c.lo < 1 && c.hi > 0, above_1 = c.hi > 1;
  if (a.contains(0) && c.contains(0))
    hull.add(just_above(0), unbounded_above); // 0^t = 0 for t > 0
  if (c.contains(1) && a.hi > 0)
    a.contains(1) ? hull.add(unbounded_below, unbounded_above) // 1^t = 1
                  : hull.add(at(0), at(0));                    // u^0 = 1
  // u > 1 and 0 < u < 1, each for t > 0 and t < 0. Ends within the ranges give logarithms;
  // otherwise they go to 0 (the power near 1, or u near 0 or infinity) or to infinity (u near 1, or
  // the power near 0 or infinity).
  if (a.hi > 1 && above_1)
    hull.add(c.lo > 1 && a.hi < infinity ? positive_logarithm(a.hi, c.lo) : just_above(0),
             c.hi < infinity && a.lo > 1 ? positive_logarithm(a.lo, c.hi) : unbounded_above);
  if (a.hi > 1 && below_1)
    hull.add(!reaches_0 && a.lo > 1 ? negative_logarithm(a.lo, c.lo) : unbounded_below,
             c.hi < 1 && a.hi < infinity ? negative_logarithm(a.hi, c.hi) : just_below(0));
  if (a.hi > 0 && a.lo < 1 && below_1)
    hull.add(c.hi < 1 && a.lo > 0 ? positive_logarithm(a.lo, c.hi) : just_above(0),
             !reaches_0 && a.hi < 1 ? positive_logarithm(a.hi, c.lo) : unbounded_above);
  if (a.hi > 0 && a.lo < 1 && above_1)
    hull.add(c.hi < infinity && a.hi < 1 ? negative_logarithm(a.hi, c.hi) : unbounded_below,
             c.lo > 1 && a.lo > 0 ? negative_logarithm(a.lo, c.lo) : just_below(0));
  return hull.result();
}
} // namespace inside
bounds pow_rev2::value(bounds a, bounds c, bounds x) {
  return at_border<inside::pow_rev2>(a, c, x);
}

} // namespace graze::functions
