// The elementary functions of intervals against MPFR: sound, and 0 ulp wide of the range.
#include "elementary_arguments.hpp"
#include "verdict.hpp"
#include <algorithm>
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/oracle/elementary.hpp>
#include <graze/rounding/upward.hpp>

namespace test = graze::test;
namespace oracle = graze::oracle;
namespace functions = graze::functions;
using graze::bounds;
using graze::decoration;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Sound and tightest on every kind of interval.
template <class Function, class Judge>
void compare(const char* name, test::active_range active, Judge judge) {
  test::elementary_arguments make(1788);
  test::verdict result;
  for (int i = 0, n = test::inputs_per_operation(); i < n; ++i) {
    const bounds x = make.interval(active);
    result.judge(name, judge(x), Function::value(x), x.lo, x.hi);
  }
  for (const bounds& x :
       {bounds::empty(), bounds::entire(), bounds{0, infinity}, bounds{-infinity, 0}, bounds{0, 0},
        bounds{-0.0, 0}, bounds{1, 1}, bounds{-1, 1}, bounds{-infinity, -1}, bounds{1, infinity},
        bounds{-1, -1}})
    result.judge(name, judge(x), Function::value(x), x.lo, x.hi);
  result.check();
}

/// Increasing on the domain [lo, hi]; at its ends the value or the limit.
auto increasing(mpfr_function f, double lo = -infinity, double hi = infinity, bool closed = true) {
  return [=](const bounds& x) {
    const bounds part{std::max(x.lo, lo), std::min(x.hi, hi)};
    const bool none = x.is_empty() || (closed ? part.lo > part.hi : x.hi <= lo || x.lo >= hi);
    return none ? bounds::empty() : oracle::increasing(f, part);
  };
}

/// floor(2x/pi + shift), exactly: 1,300 bits leave 200 for the distance to the nearest multiple.
class quarters {
public:
  quarters(double x, int shift) : count_(1300) {
    mpfr_const_pi(count_, MPFR_RNDN);
    mpfr_d_div(count_, x, count_, MPFR_RNDN);
    mpfr_mul_2ui(count_, count_, 1, MPFR_RNDN);
    mpfr_add_si(count_, count_, shift, MPFR_RNDN);
    mpfr_floor(count_, count_);
  }
  /// Is there an integer k with a < k <= b and k mod 4 = residue?
  static bool between(quarters& a, quarters& b, unsigned long residue) {
    oracle::number k(1300);
    mpfr_sub_ui(k, b.count_, residue, MPFR_RNDN);
    mpfr_div_ui(k, k, 4, MPFR_RNDN);
    mpfr_floor(k, k);
    mpfr_mul_ui(k, k, 4, MPFR_RNDN);
    mpfr_add_ui(k, k, residue, MPFR_RNDN); // the greatest such k <= b
    return mpfr_greater_p(k, a.count_) != 0;
  }

private:
  oracle::number count_;
};

auto wave(mpfr_function f, int shift) {
  return [=](const bounds& x) {
    if (x.is_empty())
      return x;
    if (!x.is_common())
      return bounds{-1, 1};
    const bounds a = oracle::enclosed(f, x.lo), b = oracle::enclosed(f, x.hi);
    quarters from(x.lo, shift), to(x.hi, shift);
    return bounds{quarters::between(from, to, 3) ? -1 : std::min(a.lo, b.lo),
                  quarters::between(from, to, 1) ? 1 : std::max(a.hi, b.hi)};
  };
}

bounds tangent(const bounds& x) {
  if (x.is_empty())
    return x;
  if (!x.is_common())
    return bounds::entire();
  quarters from(x.lo, 0), to(x.hi, 0);
  if (quarters::between(from, to, 1) || quarters::between(from, to, 3))
    return bounds::entire();
  return oracle::increasing(mpfr_tan, x);
}

bounds cosine_hyperbolic(const bounds& x) {
  if (x.is_empty())
    return x;
  const bounds a = oracle::enclosed(mpfr_cosh, x.lo), b = oracle::enclosed(mpfr_cosh, x.hi);
  return {x.contains(0) ? 1 : std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

bounds hull(const bounds& a, const bounds& b) {
  if (a.is_empty() || b.is_empty())
    return a.is_empty() ? b : a;
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// The angle takes its extremes at the corners of the parts above and below the x axis. A corner
/// (0, 0) is no point, one at (inf, inf) no limit: the corners beside them have the extremes.
bounds angle(const bounds& y, const bounds& x) {
  bounds range = bounds::empty();
  if (x.is_empty() || y.is_empty())
    return range;
  const auto corner = [&](double s, double t) {
    if ((s == 0 && t == 0) || (std::fabs(s) == infinity && std::fabs(t) == infinity))
      return;
    range = hull(range, oracle::enclosed(mpfr_atan2, s, t));
  };
  for (const double t : {x.lo, x.hi}) {
    if (y.hi >= 0) {
      corner(y.hi == 0 ? 0.0 : y.hi, t);
      corner(y.lo > 0 ? y.lo : 0.0, t);
    }
    if (y.lo < 0) {
      corner(y.lo, t);
      corner(y.hi < 0 ? y.hi : -0.0, t);
    }
  }
  return range;
}

/// y log x takes its extremes at corners. 0^0 and inf^0 stand for the 1 = s^0 beside them, 1^inf
/// for 1^t.
bounds power(const bounds& x, const bounds& y) {
  bounds range = bounds::empty();
  if (x.is_empty() || y.is_empty() || x.hi < 0)
    return range;
  if (x.hi == 0)
    return y.hi > 0 ? bounds{0, 0} : range;
  for (const double s : {std::max(x.lo, 0.0), x.hi})
    for (const double t : {y.lo, y.hi})
      range = hull(range, oracle::enclosed(mpfr_pow, s == 0 ? 0.0 : s, t));
  return range;
}

bounds magnitudes(const bounds& x) {
  const double a = std::fabs(x.lo), b = std::fabs(x.hi);
  return {x.contains(0) ? 0 : std::min(a, b), std::max(a, b)};
}
bounds length(const bounds& x, const bounds& y) {
  if (x.is_empty() || y.is_empty())
    return bounds::empty();
  const bounds a = magnitudes(x), b = magnitudes(y);
  return {oracle::rounded_down(mpfr_hypot, a.lo, b.lo), oracle::rounded_up(mpfr_hypot, a.hi, b.hi)};
}

template <class Function, class Judge>
void compare_boxes(const char* name, test::active_range first, test::active_range second,
                   Judge judge) {
  test::elementary_arguments make(2008);
  test::verdict result;
  const auto compare_one = [&](const bounds& x, const bounds& y) {
    result.judge(name, judge(x, y), Function::value(x, y), x.lo, x.hi, y.lo, y.hi);
  };
  for (int i = 0, n = test::inputs_per_operation(); i < n; ++i)
    compare_one(make.interval(first), make.interval(second));
  const double ends[] = {-infinity, -2, -1, -0.5, -0.0, 0, 0.5, 1, 2, infinity};
  for (const double a : ends)
    for (const double b : ends)
      for (const double c : ends)
        for (const double d : ends)
          if (a <= b && c <= d && a < infinity && b > -infinity && c < infinity && d > -infinity)
            compare_one({a, b}, {c, d});
  compare_one(bounds::empty(), {1, 2});
  compare_one({1, 2}, bounds::empty());
  result.check();
}

} // namespace

TEST_CASE("interval.exponential: encloses MPFR on hard cases, 0 ulp",
          "[property][mpfr][hardcase]") {
  compare<functions::exp>("exp", {-746, 710}, increasing(mpfr_exp));
  compare<functions::exp2>("exp2", {-1076, 1025}, increasing(mpfr_exp2));
  compare<functions::exp10>("exp10", {-324, 309}, increasing(mpfr_exp10));
  compare<functions::expm1>("expm1", {-40, 710}, increasing(mpfr_expm1));
  compare<functions::log>("log", {0, 10}, increasing(mpfr_log, 0, infinity, false));
  compare<functions::log2>("log2", {0, 10}, increasing(mpfr_log2, 0, infinity, false));
  compare<functions::log10>("log10", {0, 10}, increasing(mpfr_log10, 0, infinity, false));
  compare<functions::logp1>("logp1", {-1, 10}, increasing(mpfr_log1p, -1, infinity, false));
}

TEST_CASE("interval.trigonometric: encloses MPFR on hard cases, 0 ulp",
          "[property][mpfr][hardcase]") {
  compare<functions::sin>("sin", {-20, 20}, wave(mpfr_sin, 0));
  compare<functions::cos>("cos", {-20, 20}, wave(mpfr_cos, 1));
  compare<functions::tan>("tan", {-20, 20}, tangent);
  compare<functions::asin>("asin", {-1, 1}, increasing(mpfr_asin, -1, 1));
  compare<functions::acos>("acos", {-1, 1}, [](const bounds& x) {
    const bounds part{std::max(x.lo, -1.0), std::min(x.hi, 1.0)};
    return part.lo <= part.hi ? oracle::decreasing(mpfr_acos, part) : bounds::empty();
  });
  compare<functions::atan>("atan", {-20, 20}, increasing(mpfr_atan));
  compare_boxes<functions::atan2>("atan2", {-10, 10}, {-10, 10}, angle);
}

TEST_CASE("interval.hyperbolic: encloses MPFR on hard cases, 0 ulp", "[property][mpfr][hardcase]") {
  compare<functions::sinh>("sinh", {-711, 711}, increasing(mpfr_sinh));
  compare<functions::cosh>("cosh", {-711, 711}, cosine_hyperbolic);
  compare<functions::tanh>("tanh", {-20, 20}, increasing(mpfr_tanh));
  compare<functions::asinh>("asinh", {-20, 20}, increasing(mpfr_asinh));
  compare<functions::acosh>("acosh", {1, 20}, increasing(mpfr_acosh, 1));
  compare<functions::atanh>("atanh", {-1, 1}, increasing(mpfr_atanh, -1, 1, false));
}

TEST_CASE("interval.power: encloses MPFR on hard cases, 0 ulp", "[property][mpfr][hardcase]") {
  compare<functions::cbrt>("cbrt", {-20, 20}, increasing(mpfr_cbrt));
  compare_boxes<functions::hypot>("hypot", {-10, 10}, {-10, 10}, length);
  compare_boxes<functions::pow>("pow", {0, 4}, {-20, 20}, power);
}

TEST_CASE("interval.elementary: decorations say where a function is defined and continuous",
          "[unit]") {
  const auto everywhere = decoration::dac, defined = decoration::def, nothing = decoration::trv;
  CHECK(functions::exp::local({-infinity, 1}) == everywhere);
  CHECK(functions::exp::local(bounds::empty()) == nothing);
  CHECK(functions::log::local({0, 1}) == nothing);
  CHECK(functions::log::local({0x1p-1074, infinity}) == everywhere);
  CHECK(functions::log2::local({-1, 1}) == nothing);
  CHECK(functions::log10::local({1, 2}) == everywhere);
  CHECK(functions::logp1::local({-1, 1}) == nothing);
  CHECK(functions::logp1::local({-0x1.fffffffffffffp-1, 1}) == everywhere);
  CHECK(functions::sin::local(bounds::entire()) == everywhere);
  CHECK(functions::tan::local({1, 2}) == nothing);
  CHECK(functions::tan::local({-1.5, 1.5}) == everywhere);
  CHECK(functions::tan::local({-1.5, 1.6}) == nothing);
  CHECK(functions::tan::local({0, infinity}) == nothing);
  CHECK(functions::tan::local(bounds::empty()) == nothing);
  CHECK(functions::asin::local({-1, 1}) == everywhere);
  CHECK(functions::acos::local({-1, 0x1.0000000000001p+0}) == nothing);
  CHECK(functions::acosh::local({1, infinity}) == everywhere);
  CHECK(functions::acosh::local({0.5, 2}) == nothing);
  CHECK(functions::atanh::local({-1, 0}) == nothing);
  CHECK(functions::atanh::local({-0.5, 0}) == everywhere);
  CHECK(functions::atan2::local({0, 1}, {0, 1}) == nothing);
  CHECK(functions::atan2::local({0, 1}, {-2, -1}) == everywhere); // the cut from above
  CHECK(functions::atan2::local({-1, 0}, {-2, -1}) == defined);
  CHECK(functions::atan2::local({-1, 1}, {-2, -1}) == defined);
  CHECK(functions::atan2::local({-1, -0x1p-1074}, {-2, 2}) == everywhere);
  CHECK(functions::atan2::local({-1, 1}, {0x1p-1074, 2}) == everywhere);
  CHECK(functions::atan2::local(bounds::empty(), {1, 2}) == nothing);
  CHECK(functions::pow::local({0, 1}, {0, 1}) == nothing);
  CHECK(functions::pow::local({0, 1}, {0x1p-1074, 1}) == everywhere);
  CHECK(functions::pow::local({0.5, 1}, {-1, 1}) == everywhere);
  CHECK(functions::pow::local({-1, 1}, {1, 2}) == nothing);
  CHECK(functions::hypot::local({-1, 1}, bounds::entire()) == everywhere);
  CHECK(functions::cbrt::local(bounds::entire()) == everywhere);
}

TEST_CASE("interval.elementary: functions of every interval type", "[unit]") {
  using I = graze::interval<graze::rounding::upward>;
  const I x(0.5, 0.75), y(-1.0, 2.0);
  CHECK(exp(I(0.0)) == I(1.0));
  CHECK(log(I(1.0)) == I(0.0));
  CHECK(empty(log(I(-2.0, -1.0))));
  CHECK(sin(I(1.0, 2.0)).upper() == 1);
  CHECK(tan(I(1.0, 2.0)) == I::whole());
  CHECK(atan2(I(0.0), I(-1.0)) == I(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1));
  CHECK(pow(I(4.0), I(0.5)) == I(2.0));
  CHECK(cbrt(I(-27.0, 8.0)) == I(-3.0, 2.0));
  CHECK(hypot(I(3.0), I(4.0)) == I(5.0));
  CHECK(exp2(I(-1.0, 3.0)) == I(0.5, 8.0));
  CHECK(exp10(I(0.0, 2.0)) == I(1.0, 100.0));
  CHECK(log2(I(0.25, 8.0)) == I(-2.0, 3.0));
  CHECK(log10(I(1.0, 1000.0)) == I(0.0, 3.0));
  CHECK(cosh(I(-1.0, 1.0)).lower() == 1);
  for (const I& each : {expm1(x), logp1(x), cos(x), asin(x), acos(x), atan(x), sinh(x), tanh(x),
                        asinh(x), acosh(I(1.5)), atanh(x), expm1(y)})
    CHECK(!empty(each));
}
