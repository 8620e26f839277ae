#include "../border.hpp"
#include <algorithm>
#include <cmath>
#include <graze/functions/arithmetic.hpp>
#include <graze/rounding/fused.hpp>

namespace graze::functions {

namespace {

using backend = rounding::nearest;
constexpr double infinity = checking::infinity;

interval<> as_interval(const bounds& x) { return to_interval<policies<backend>>(x); }

/// Defined and continuous everywhere.
decoration continuous(bool is_empty) { return is_empty ? decoration::trv : decoration::dac; }
decoration continuous(const bounds& x, const bounds& y) {
  return continuous(x.is_empty() || y.is_empty());
}
decoration off_zero(const bounds& x) {
  return x.is_empty() || x.contains(0) ? decoration::trv : decoration::dac;
}

namespace inside {
bounds add(bounds x, bounds y) { return to_bounds(as_interval(x) + as_interval(y)); }
bounds sub(bounds x, bounds y) { return to_bounds(as_interval(x) - as_interval(y)); }
bounds mul(bounds x, bounds y) { return to_bounds(as_interval(x) * as_interval(y)); }
bounds div(bounds x, bounds y) { return to_bounds(as_interval(x) / as_interval(y)); }
bounds sqr(bounds x) { return to_bounds(square(as_interval(x))); }
bounds sqrt(bounds x) {
  if (x.is_empty() || x.hi < 0)
    return bounds::empty();
  return {x.lo <= 0 ? 0 : backend::sqrt_down(x.lo), backend::sqrt_up(x.hi)};
}
bounds abs(bounds x) {
  if (x.is_empty())
    return x;
  return {std::max({0.0, x.lo, -x.hi}), std::max(-x.lo, x.hi)};
}
bounds min(bounds x, bounds y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  return {std::min(x.lo, y.lo), std::min(x.hi, y.hi)};
}
bounds max(bounds x, bounds y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  return {std::max(x.lo, y.lo), std::max(x.hi, y.hi)};
}
} // namespace inside

} // namespace

bounds pos::value(bounds x) { return x; }
decoration pos::local(bounds x) { return continuous(x.is_empty()); }

bounds neg::value(bounds x) { return {-x.hi, -x.lo}; }
decoration neg::local(bounds x) { return continuous(x.is_empty()); }

bounds add::value(bounds x, bounds y) { return at_border<inside::add>(x, y); }
decoration add::local(bounds x, bounds y) { return continuous(x, y); }

bounds sub::value(bounds x, bounds y) { return at_border<inside::sub>(x, y); }
decoration sub::local(bounds x, bounds y) { return continuous(x, y); }

bounds mul::value(bounds x, bounds y) { return at_border<inside::mul>(x, y); }
decoration mul::local(bounds x, bounds y) { return continuous(x, y); }

bounds div::value(bounds x, bounds y) { return at_border<inside::div>(x, y); }
decoration div::local(bounds x, bounds y) { return x.is_empty() ? decoration::trv : off_zero(y); }

bounds recip::value(bounds x) { return div::value({1, 1}, x); }
decoration recip::local(bounds x) { return off_zero(x); }

bounds sqr::value(bounds x) { return at_border<inside::sqr>(x); }
decoration sqr::local(bounds x) { return continuous(x.is_empty()); }

bounds sqrt::value(bounds x) { return at_border<inside::sqrt>(x); }
decoration sqrt::local(bounds x) { return x.lo >= 0 ? decoration::dac : decoration::trv; }

bounds abs::value(bounds x) { return at_border<inside::abs>(x); }
decoration abs::local(bounds x) { return continuous(x.is_empty()); }

bounds min::value(bounds x, bounds y) { return at_border<inside::min>(x, y); }
decoration min::local(bounds x, bounds y) { return continuous(x, y); }

bounds max::value(bounds x, bounds y) { return at_border<inside::max>(x, y); }
decoration max::local(bounds x, bounds y) { return continuous(x, y); }

namespace {

/// The limit of x y + z at a corner of the box, rounded up, for a finite z: 0 times an infinite
/// bound is 0, since every product near it that counts is 0.
double corner_up(double x, double y, double z) {
  if (x == 0 || y == 0)
    return z;
  if (std::max(std::fabs(x), std::fabs(y)) == infinity) {
    const bool negative = (x < 0) != (y < 0);
    return negative ? -infinity : infinity;
  }
  return rounding::detail::fma_up(x, y, z);
}

/// The least upper bound of x y + z over the boxes x, y and the addend z, rounded up.
double highest(const bounds& x, const bounds& y, double z) {
  if (z == infinity)
    return infinity;
  return std::max({corner_up(x.lo, y.lo, z), corner_up(x.lo, y.hi, z), corner_up(x.hi, y.lo, z),
                   corner_up(x.hi, y.hi, z)});
}

namespace inside {
// Directed rounding is monotone: the greatest of the rounded corners is the greatest one, rounded.
bounds fma(bounds x, bounds y, bounds z) {
  if (x.is_empty() || y.is_empty() || z.is_empty())
    return bounds::empty();
  return {-highest(neg::value(x), y, -z.lo), highest(x, y, z.hi)};
}
} // namespace inside

} // namespace

bounds fma::value(bounds x, bounds y, bounds z) { return at_border<inside::fma>(x, y, z); }
decoration fma::local(bounds x, bounds y, bounds z) {
  return continuous(x.is_empty() || y.is_empty() || z.is_empty());
}

} // namespace graze::functions
