#include "../elementary/angle_pair.hpp"
#include "../elementary/monotone.hpp"
#include "../elementary/sine_pair.hpp"
#include <graze/functions/trigonometric.hpp>

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;

constexpr double pi_down = 0x1.921fb54442d18p+1, pi_up = 0x1.921fb54442d19p+1;

/// In which quarter of the circle is x: floor(2x/pi) mod 4, exactly. Where the whole number is
/// known as well, `turns` is floor(2x/pi), and `whole` says so.
struct quarter {
  std::int64_t turns;
  bool whole;
  [[nodiscard]] int number() const { return static_cast<int>(turns & 3); }
};

/// For huge x, and next to multiples of pi/2, the signs of sin x and cos x tell the quarter: no
/// double but 0 is a multiple of pi/2, so that neither is 0, and a directed rounding keeps the sign
/// (that of a zero too).
template <class Sin, class Cos> __attribute__((noinline)) quarter quarter_by_signs(double x) {
  [[maybe_unused]] const typename Sin::scope scope;
  const bool sin_negative = std::signbit(Sin::up(x)), cos_negative = std::signbit(Cos::up(x));
  return {sin_negative ? (cos_negative ? 2 : 3) : (cos_negative ? 1 : 0), false};
}

/// In any mode. t below has a relative error of at most 2^-51: 2^-53.3 that of 2/pi as a double,
/// 2^-52 that of the product. If its distance to the nearest integers is greater than 2^-50 |t|,
/// the integer below is floor(2x/pi); so it is where |t| is less than 1.
inline quarter quarter_of(double x) {
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  const double t = x * two_over_pi, magnitude = std::fabs(t);
  if (magnitude < 0x1p40) {
    const auto nearer_zero = static_cast<std::int64_t>(t);
    const double fraction = std::fabs(t - static_cast<double>(nearer_zero)); // exact
    const double doubt = magnitude * 0x1p-50;
    if ((fraction < 1 - doubt) & ((fraction > doubt) | (nearer_zero == 0)))
      return {nearer_zero - (x < 0), true};
  }
  return quarter_by_signs<point::sin, point::cos>(x);
}

/// How many multiples of pi/2 are between the quarters of a and b, a <= b: n or n + 4 or more for n
/// = difference mod 4. With n the width b - a is less than (n + 1) pi/2, with n + 4 greater than (n
/// + 3) pi/2; width compared to (n + 2) pi/2 decides, whatever its rounding. 4 stands for more.
int multiples_between(const quarter& a, const quarter& b, double width) {
  const int n = (b.number() - a.number()) & 3;
  return width > (n + 2) * 0x1.921fb54442d18p+0 ? 4 : n;
}

/// sin (Shift = 0) or cos (Shift = 1; cos x = sin(x + pi/2)) over [lo, hi]. Function is that of the
/// two.
template <class Function, int Shift>
__attribute__((noinline)) bounds wave_by_each(double lo, double hi) {
  if (lo != lo)
    return bounds::empty();
  [[maybe_unused]] const typename Function::scope scope;
  hold(lo, hi);
  constexpr bounds all{-1, 1};
  const double width = hi - lo; // infinite if an end is
  if (!(width < 8))             // more than 5/2 pi
    return all;
  const quarter a = quarter_of(lo), b = quarter_of(hi);
  const int crossed = multiples_between(a, b, width);
  // Extremes are where quarter 0 ends (the greatest) and where quarter 2 ends (the least).
  const int first = (a.number() + Shift) & 3;
  const int to_greatest = -first & 3, to_least = (2 - first) & 3;
  const bool greatest = to_greatest < crossed, least = to_least < crossed;
  if (greatest && least)
    return all;
  bounds range = all;
  if (!greatest && !least) {
    Function::both(lo, hi, range.lo, range.hi);
    return range;
  }
  // One extreme: the other bound is at the end that is further from it. Twice its place, with an
  // error below 2^-50 of itself (none at 0), is compared to the sum of the ends.
  bool at_lo = true, at_hi = true;
  if (a.whole && b.whole) {
    const auto place = static_cast<double>(a.turns + 1 + (greatest ? to_greatest : to_least));
    const double twice = place * pi_down, sum = lo + hi;
    const double doubt = (std::fabs(twice) + std::fabs(sum)) * 0x1p-48;
    at_lo = sum - twice <= doubt;
    at_hi = sum - twice >= -doubt;
  }
  const double further = at_lo ? lo : hi;
  if (at_lo && at_hi)
    Function::both(lo, hi, range.lo, range.hi);
  else if (greatest)
    range.lo = Function::down(further);
  else
    range.hi = Function::up(further);
  return greatest ? bounds{range.lo, 1} : bounds{-1, range.hi};
}

template <class Function, int Shift> bounds wave(double lo, double hi) {
#if defined(__x86_64__)
  if (point::core_math::fused) {
    const bounds range = elementary::wave_if_decided(lo, hi, Shift);
    if (__builtin_expect(!range.is_empty(), 1))
      return range;
  }
#endif
  return wave_by_each<Function, Shift>(lo, hi);
}

/// Does [lo, hi], bounded, hold an odd multiple of pi/2?
bool has_pole(double lo, double hi) {
  const double width = hi - lo;
  if (width > 3.25) // more than pi
    return true;
  const quarter a = quarter_of(lo), b = quarter_of(hi);
  const int crossed = multiples_between(a, b, width);
  return crossed >= 2 || (crossed == 1 && a.number() % 2 == 0);
}

__attribute__((noinline)) bounds tangent_by_each(bounds x) {
  if (!x.is_common())
    return x.is_empty() ? bounds::empty() : bounds::entire();
  [[maybe_unused]] const point::tan::scope scope;
  hold(x.lo, x.hi);
  return has_pole(x.lo, x.hi) ? bounds::entire()
                              : elementary::increasing_within_scope<point::tan>(x.lo, x.hi);
}

} // namespace

bounds sin::value(bounds x) { return wave<point::sin, 0>(x.lo, x.hi); }
bounds cos::value(bounds x) { return wave<point::cos, 1>(x.lo, x.hi); }

bounds tan::value(bounds x) {
#if defined(__x86_64__)
  if (point::core_math::fused) {
    const bounds range = elementary::tangent_if_decided(x.lo, x.hi);
    if (__builtin_expect(!range.is_empty(), 1))
      return range;
  }
#endif
  return tangent_by_each(x);
}

bounds asin::value(bounds x) {
  if (!(x.hi >= -1 && x.lo <= 1))
    return bounds::empty();
  return elementary::increasing<point::asin>(x.lo < -1 ? -1 : x.lo, x.hi > 1 ? 1 : x.hi);
}
bounds acos::value(bounds x) {
  if (!(x.hi >= -1 && x.lo <= 1))
    return bounds::empty();
  return elementary::decreasing<point::acos>(x.lo < -1 ? -1 : x.lo, x.hi > 1 ? 1 : x.hi);
}
bounds atan::value(bounds x) { return elementary::increasing_everywhere<point::atan>(x.lo, x.hi); }

decoration sin::local(bounds x) { return everywhere(x); }
decoration cos::local(bounds x) { return everywhere(x); }
decoration tan::local(bounds x) {
  if (!x.is_common())
    return decoration::trv;
  return elementary::continuous(!has_pole(x.lo, x.hi));
}
decoration asin::local(bounds x) { return elementary::continuous(-1 <= x.lo && x.hi <= 1); }
decoration acos::local(bounds x) { return elementary::continuous(-1 <= x.lo && x.hi <= 1); }
decoration atan::local(bounds x) { return everywhere(x); }

namespace {
/// atan2 over a box that holds no points on both sides of the cut; not empty, nor y = [0, 0].
__attribute__((noinline)) bounds angle_by_each(bounds y, bounds x) {
  const point::atan2::scope scope;
  hold(y.lo, y.hi), hold(x.lo, x.hi);
  // + 0.0: a zero of negative sign would be taken for the other side of the cut.
  if (y.lo >= 0)
    return {point::atan2::down((x.hi > 0 ? y.lo : y.hi) + 0.0, x.hi),
            point::atan2::up((x.lo < 0 ? y.lo : y.hi) + 0.0, x.lo)};
  if (y.hi <= 0)
    return {point::atan2::down(x.lo < 0 ? y.hi : y.lo, x.lo),
            point::atan2::up(x.hi > 0 ? y.hi : y.lo, x.hi)};
  return {point::atan2::down(y.lo, x.lo), point::atan2::up(y.hi, x.lo)};
}
} // namespace

/// Above the x axis the angle decreases with x; it decreases with y where x < 0 and increases where
/// x > 0. Below it is the mirror image. So each extreme is at a corner, none of them (0, 0) but
/// where y = [0, 0], nor with two infinite coordinates.
bounds atan2::value(bounds y, bounds x) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  using namespace rounding::exact;                               // comparisons for any environment
  if (below_zero(x.lo) && below_zero(y.lo) && !below_zero(y.hi)) // the cut, from below
    return {-pi_up, pi_up};
  if (is_zero(y.lo) && is_zero(y.hi)) {
    if (is_zero(x.lo) && is_zero(x.hi))
      return bounds::empty();
    return {above_zero(x.hi) ? 0 : pi_down, below_zero(x.lo) ? pi_up : 0};
  }
#if defined(__x86_64__)
  if (point::core_math::fused) {
    const bounds range = elementary::angle_if_decided(y.lo, y.hi, x.lo, x.hi);
    if (__builtin_expect(!range.is_empty(), 1))
      return range;
  }
#endif
  return angle_by_each(y, x);
}

/// Defined but in (0, 0). Restricted to the box it is discontinuous on the negative x axis where
/// there are points below, and continuous where there are points above only.
decoration atan2::local(bounds y, bounds x) {
  if (x.is_empty() || y.is_empty() || (x.contains(0) && y.contains(0)))
    return decoration::trv;
  return x.lo < 0 && y.lo < 0 && y.hi >= 0 ? decoration::def : decoration::dac;
}
bool atan2::continuous_around(bounds y, bounds x) { return !(x.lo < 0 && y.contains(0)); }

} // namespace graze::functions
