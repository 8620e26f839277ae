// The monotone step functions. On an interval each is constant or not continuous; and constant, it
// may still jump at a bound.
#include "../border.hpp"
#include <cmath>
#include <graze/functions/arithmetic.hpp>

namespace graze::functions {

namespace {

decoration step(const bounds& x, const bounds& value) {
  if (x.is_empty())
    return decoration::trv;
  return value.lo == value.hi ? decoration::dac : decoration::def;
}

double sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// In any rounding mode: the difference of x and its integral part is exact.
double to_even(double x) {
  const double whole = std::trunc(x), rest = std::fabs(x - whole);
  const bool away = rest > 0.5 || (rest == 0.5 && std::fmod(whole, 2) != 0);
  return away ? whole + std::copysign(1, x) : whole;
}
double to_away(double x) {
  const double whole = std::trunc(x);
  return std::fabs(x - whole) >= 0.5 ? whole + std::copysign(1, x) : whole;
}
bool half_way(double x) { return std::fabs(x - std::trunc(x)) == 0.5; }

namespace inside {
/// A monotone function of both ends.
template <auto Function> bounds step_of(bounds x) { return {Function(x.lo), Function(x.hi)}; }
bounds sign(bounds x) { return x.is_empty() ? x : step_of<sign_of>(x); }
double ceil(double x) { return std::ceil(x); }
double floor(double x) { return std::floor(x); }
double trunc(double x) { return std::trunc(x); }
} // namespace inside

} // namespace

using inside::step_of;

bounds sign::value(bounds x) { return at_border<inside::sign>(x); }
decoration sign::local(bounds x) { return step(x, value(x)); }
bool sign::continuous_around(bounds x) { return !x.contains(0); }

bounds ceil::value(bounds x) { return at_border<step_of<inside::ceil>>(x); }
decoration ceil::local(bounds x) { return step(x, value(x)); }
bool ceil::continuous_around(bounds x) { return std::ceil(x.lo) > x.hi; }

bounds floor::value(bounds x) { return at_border<step_of<inside::floor>>(x); }
decoration floor::local(bounds x) { return step(x, value(x)); }
bool floor::continuous_around(bounds x) { return std::ceil(x.lo) > x.hi; }

// jumps at the integers but 0
bounds trunc::value(bounds x) { return at_border<step_of<inside::trunc>>(x); }
decoration trunc::local(bounds x) { return step(x, value(x)); }
bool trunc::continuous_around(bounds x) {
  return (-1 < x.lo && x.hi < 1) || std::ceil(x.lo) > x.hi;
}

// Both jump half-way between integers; where one is constant, such a point can only be a bound.
bounds round_ties_to_even::value(bounds x) { return at_border<step_of<to_even>>(x); }
decoration round_ties_to_even::local(bounds x) { return step(x, value(x)); }
bool round_ties_to_even::continuous_around(bounds x) { return !half_way(x.lo) && !half_way(x.hi); }

bounds round_ties_to_away::value(bounds x) { return at_border<step_of<to_away>>(x); }
decoration round_ties_to_away::local(bounds x) { return step(x, value(x)); }
bool round_ties_to_away::continuous_around(bounds x) { return !half_way(x.lo) && !half_way(x.hi); }

} // namespace graze::functions
