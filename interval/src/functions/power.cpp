#include "../elementary/monotone.hpp"
#include <algorithm>
#include <graze/functions/power.hpp>

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;

} // namespace

bounds cbrt::value(bounds x) { return elementary::increasing_everywhere<point::cbrt>(x.lo, x.hi); }
decoration cbrt::local(bounds x) { return everywhere(x); }

bounds hypot::value(bounds x, bounds y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  const point::hypot::scope scope;
  hold(x.lo, x.hi), hold(y.lo, y.hi);
  return {point::hypot::down(elementary::mignitude(x.lo, x.hi), elementary::mignitude(y.lo, y.hi)),
          point::hypot::up(elementary::magnitude(x.lo, x.hi), elementary::magnitude(y.lo, y.hi))};
}
decoration hypot::local(bounds x, bounds y) {
  return elementary::continuous(!x.is_empty() && !y.is_empty());
}

/// s^t increases with s where t > 0 and decreases where t < 0; it increases with t where s > 1 and
/// decreases where s < 1. Each extreme is thus at a corner of the box, or its limit where the
/// corner is infinite or s = 0, for which C's pow has the right values: 0^t = inf for t < 0,
/// s^-inf, 1^inf = 1, inf^0 = 1.
bounds pow::value(bounds x, bounds y) {
  const point::pow::scope scope;
  hold(x.lo, x.hi), hold(y.lo, y.hi);
  if (!(x.hi >= 0) || y.is_empty())
    return bounds::empty();
  const double a = x.lo > 0 ? x.lo : 0, b = x.hi, c = y.lo, d = y.hi;
  if (b == 0) // 0^t, t > 0
    return d > 0 ? bounds{0, 0} : bounds::empty();
  if (c >= 0)
    return {point::pow::down(a, a < 1 ? d : c), point::pow::up(b, b > 1 ? d : c)};
  if (d <= 0)
    return {point::pow::down(b, b > 1 ? c : d), point::pow::up(a, a < 1 ? c : d)};
  // 1 is in the range; the corners on either side of it are not always both needed.
  bounds r{b <= 1   ? point::pow::down(a, d)
           : a >= 1 ? point::pow::down(b, c)
                    : std::min(point::pow::down(a, d), point::pow::down(b, c)),
           b <= 1   ? point::pow::up(a, c)
           : a >= 1 ? point::pow::up(b, d)
                    : std::max(point::pow::up(a, c), point::pow::up(b, d))};
  hold(r.lo, r.hi);
  return r;
}
decoration pow::local(bounds x, bounds y) {
  return elementary::continuous(!x.is_empty() && !y.is_empty() &&
                                (x.lo > 0 || (x.lo == 0 && y.lo > 0)));
}

} // namespace graze::functions
