/// Reverse operations of sqr, abs, pown and cosh: the solutions are roots and their mirror images.
#include "../border.hpp"
#include "solution_set.hpp"
#include <graze/functions/reverse.hpp>
#include <graze/point.hpp>
#include <graze/point_rare.hpp>
#include <graze/rounding/nearest.hpp>

namespace graze::functions {

using namespace solutions;

namespace {

/// { t in x : g(abs(t)) in c } for g that grows from g(0) = least, with its inverse.
template <class Inverse>
bounds even(const bounds& c, const bounds& x, double least, Inverse inverse) {
  if (c.is_empty() || c.hi < least)
    return bounds::empty();
  hull_within hull(x);
  hull.add_both_signs(c.lo > least ? inverse(c.lo) : at(0),
                      c.hi < infinity ? inverse(c.hi) : unbounded_above);
  return hull.result();
}

end nth_root(double y, int n) {
  const point::directed root = point::rootn(y, n);
  return {root.down, root.up};
}

/// The positive t with t^n in c, n < 0: from infinity (t^n near 0) down to 0 (t^n without bound).
void add_negative_power(hull_within& hull, const bounds& c, int n, bool mirrored) {
  if (!(c.hi > 0))
    return;
  const auto root = [n](double y) { return nth_root(y, n); };
  const end lo = c.hi < infinity ? root(c.hi) : just_above(0);
  const end hi = c.lo > 0 ? root(c.lo) : unbounded_above;
  mirrored ? hull.add(-hi, -lo) : hull.add(lo, hi);
}

} // namespace

namespace inside {
bounds sqr_rev(bounds c, bounds x) {
  using backend = rounding::nearest;
  return even(c, x, 0, [](double y) { return end{backend::sqrt_down(y), backend::sqrt_up(y)}; });
}
} // namespace inside
bounds sqr_rev::value(bounds c, bounds x) { return at_border<inside::sqr_rev>(c, x); }

namespace inside {
bounds abs_rev(bounds c, bounds x) {
  return even(c, x, 0, [](double y) { return at(y); });
}
} // namespace inside
bounds abs_rev::value(bounds c, bounds x) { return at_border<inside::abs_rev>(c, x); }

namespace inside {
bounds cosh_rev(bounds c, bounds x) {
  return even(c, x, 1, [](double y) { return end{point::acosh_down(y), point::acosh_up(y)}; });
}
} // namespace inside
bounds cosh_rev::value(bounds c, bounds x) { return at_border<inside::cosh_rev>(c, x); }

namespace inside {
bounds pown_rev(bounds c, bounds x, int n) {
  if (c.is_empty())
    return bounds::empty();
  if (n == 0)
    return c.contains(1) ? x : bounds::empty();
  hull_within hull(x);
  if (n < 0) {
    add_negative_power(hull, c, n, false);
    add_negative_power(hull, n % 2 == 0 ? c : bounds{-c.hi, -c.lo}, n, true);
    return hull.result();
  }
  const auto root = [n](double y) { return nth_root(y, n); };
  if (n % 2 == 0)
    return even(c, x, 0, root);
  hull.add(c.lo > -infinity ? root(c.lo) : unbounded_below,
           c.hi < infinity ? root(c.hi) : unbounded_above);
  return hull.result();
}
} // namespace inside
bounds pown_rev::value(bounds c, bounds x, int n) { return at_border<inside::pown_rev>(c, x, n); }

} // namespace graze::functions
