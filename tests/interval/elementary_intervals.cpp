// The elementary functions of intervals against MPFR: sound, and 0 ulp wide of the range.
#include "verdict.hpp"
#include <algorithm>
#include <graze/functions/exponential.hpp>
#include <graze/functions/hyperbolic.hpp>
#include <graze/functions/power.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/rounding/upward.hpp>

namespace test = graze::test;
namespace oracle = graze::oracle;
namespace ranges = graze::oracle::ranges;
namespace functions = graze::functions;
using graze::bounds;
using graze::decoration;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Sound and tightest on every kind of interval.
template <class Function, class Judge>
void compare(const char* name, oracle::active_range active, Judge judge) {
  oracle::hard_arguments make(1788);
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

template <class Function, class Judge>
void compare_boxes(const char* name, oracle::active_range first, oracle::active_range second,
                   Judge judge) {
  oracle::hard_arguments make(2008);
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
  compare<functions::exp>("exp", {-746, 710}, ranges::exp);
  compare<functions::exp2>("exp2", {-1076, 1025}, ranges::exp2);
  compare<functions::exp10>("exp10", {-324, 309}, ranges::exp10);
  compare<functions::expm1>("expm1", {-40, 710}, ranges::expm1);
  compare<functions::log>("log", {0, 10}, ranges::log);
  compare<functions::log2>("log2", {0, 10}, ranges::log2);
  compare<functions::log10>("log10", {0, 10}, ranges::log10);
  compare<functions::logp1>("logp1", {-1, 10}, ranges::logp1);
}

TEST_CASE("interval.trigonometric: encloses MPFR on hard cases, 0 ulp",
          "[property][mpfr][hardcase]") {
  compare<functions::sin>("sin", {-20, 20}, ranges::sin);
  compare<functions::cos>("cos", {-20, 20}, ranges::cos);
  compare<functions::tan>("tan", {-20, 20}, ranges::tan);
  compare<functions::asin>("asin", {-1, 1}, ranges::asin);
  compare<functions::acos>("acos", {-1, 1}, ranges::acos);
  compare<functions::atan>("atan", {-20, 20}, ranges::atan);
  compare_boxes<functions::atan2>("atan2", {-10, 10}, {-10, 10}, ranges::atan2);
}

TEST_CASE("interval.hyperbolic: encloses MPFR on hard cases, 0 ulp", "[property][mpfr][hardcase]") {
  compare<functions::sinh>("sinh", {-711, 711}, ranges::sinh);
  compare<functions::cosh>("cosh", {-711, 711}, ranges::cosh);
  compare<functions::tanh>("tanh", {-20, 20}, ranges::tanh);
  compare<functions::asinh>("asinh", {-20, 20}, ranges::asinh);
  compare<functions::acosh>("acosh", {1, 20}, ranges::acosh);
  compare<functions::atanh>("atanh", {-1, 1}, ranges::atanh);
}

TEST_CASE("interval.power: encloses MPFR on hard cases, 0 ulp", "[property][mpfr][hardcase]") {
  compare<functions::cbrt>("cbrt", {-20, 20}, ranges::cbrt);
  compare_boxes<functions::hypot>("hypot", {-10, 10}, {-10, 10}, ranges::hypot);
  compare_boxes<functions::pow>("pow", {0, 4}, {-20, 20}, ranges::pow);
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
