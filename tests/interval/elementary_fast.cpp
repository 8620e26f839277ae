// The fast evaluations at both ends: their tables, and that they decide nothing wrongly.
#include "../../interval/src/elementary/angle_pair.hpp"
#include "../../interval/src/elementary/angle_table.hpp"
#include "../../interval/src/elementary/exponential_pair.hpp"
#include "../../interval/src/elementary/exponential_table.hpp"
#include "../../interval/src/elementary/logarithm_pair.hpp"
#include "../../interval/src/elementary/logarithm_table.hpp"
#include "../../interval/src/elementary/sine_pair.hpp"
#include "../../interval/src/elementary/sine_table.hpp"
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <algorithm>
#include <graze/functions/exponential.hpp>
#include <graze/functions/trigonometric.hpp>
#include <graze/oracle/elementary.hpp>
#include <graze/rounding/hardware.hpp>

namespace test = graze::test;
namespace oracle = graze::oracle;
using graze::bounds;

TEST_CASE("interval.exp: the table of powers of two is MPFR's", "[unit][mpfr]") {
  for (int i = 0; i < 128; ++i) {
    oracle::number power(300);
    mpfr_set_d(power, i / 128.0, MPFR_RNDN);
    mpfr_exp2(power, power, MPFR_RNDN);
    const double high = mpfr_get_d(power, MPFR_RNDN);
    mpfr_sub_d(power, power, high, MPFR_RNDN);
    CHECK(graze::elementary::powers_of_two[i].high == high);
    CHECK(graze::elementary::powers_of_two[i].low == mpfr_get_d(power, MPFR_RNDN));
  }
}

TEST_CASE("interval.log: the table of logarithms is MPFR's, and as the error bound needs it",
          "[unit][mpfr]") {
  double at = 0.6875;
  for (const auto& [r, high, low, unused] : graze::elementary::logarithms) {
    const double next = at + (at < 1 ? 0x1p-8 : 0x1p-7), unit = at < 1 ? 0x1p-53 : 0x1p-52;
    oracle::number log(300), first(300), last(300);
    mpfr_set_d(log, r, MPFR_RNDN);
    mpfr_log(log, log, MPFR_RNDN);
    mpfr_neg(log, log, MPFR_RNDN);
    const double steps = std::nearbyint(mpfr_get_d(log, MPFR_RNDN) * 0x1p42);
    CHECK(high == steps * 0x1p-42);
    mpfr_sub_d(log, log, high, MPFR_RNDN);
    CHECK(low == mpfr_get_d(log, MPFR_RNDN));
    // r x - 1 at the ends, exactly: |z| <= 2^-7, 53 bits of r's unit times x's, and no more than
    // high.
    const auto z = [r = r](mpfr_ptr into, double x) {
      mpfr_set_d(into, r, MPFR_RNDN);
      mpfr_mul_d(into, into, x, MPFR_RNDN);
      mpfr_sub_ui(into, into, 1, MPFR_RNDN);
    };
    z(first, at), z(last, next);
    int bits = 0;
    while (std::ldexp(r, bits) != std::floor(std::ldexp(r, bits)))
      ++bits;
    for (mpfr_ptr end : {mpfr_ptr(first), mpfr_ptr(last)}) {
      CHECK(mpfr_cmpabs_ui(end, 0) >= 0);
      const double size = std::fabs(mpfr_get_d(end, MPFR_RNDA));
      CHECK(size <= 0x1p-7);
      CHECK(size <= std::ldexp(unit, 53 - bits));
      CHECK((high == 0 || size <= std::fabs(high)));
    }
    at = next;
  }
  CHECK(at == 1.375);
}

TEST_CASE("interval.atan2: the table of angles is MPFR's", "[unit][mpfr]") {
  for (int j = 0; j <= 128; ++j) {
    oracle::number angle(300);
    mpfr_set_d(angle, j / 128.0, MPFR_RNDN);
    mpfr_atan(angle, angle, MPFR_RNDN);
    const double high = std::nearbyint(mpfr_get_d(angle, MPFR_RNDN) * 0x1p48) * 0x1p-48;
    mpfr_sub_d(angle, angle, high, MPFR_RNDN);
    CHECK(graze::elementary::angles[j].high == high);
    CHECK(graze::elementary::angles[j].low == mpfr_get_d(angle, MPFR_RNDN));
  }
}

TEST_CASE("interval.sin: the table of sines is MPFR's", "[unit][mpfr]") {
  for (int j = 0; j < 512; ++j) {
    oracle::number angle(400);
    mpfr_const_pi(angle, MPFR_RNDN);
    mpfr_mul_ui(angle, angle, static_cast<unsigned>(j), MPFR_RNDN);
    mpfr_div_2ui(angle, angle, 8, MPFR_RNDN);
    mpfr_sin(angle, angle, MPFR_RNDN);
    if (j % 128 == 0) // 0 or +-1
      mpfr_rint(angle, angle, MPFR_RNDN);
    const double high = mpfr_get_d(angle, MPFR_RNDN);
    mpfr_sub_d(angle, angle, high, MPFR_RNDN);
    CHECK(graze::elementary::sines[j].high == high);
    CHECK(graze::elementary::sines[j].low == mpfr_get_d(angle, MPFR_RNDN));
  }
}

#if defined(__x86_64__)
TEST_CASE("interval.exp: both ends at once are right where decided, and nearly always decided",
          "[property][mpfr][hardcase]") {
  if (!__builtin_cpu_supports("fma") || !__builtin_cpu_supports("avx2")) {
    test::skipped("this processor has no fused operations");
    return;
  }
  const test::unary& f = test::unary_functions().front();
  REQUIRE(std::string(f.name) == "exp");
  oracle::hard_arguments make(2718);
  test::verdict result;
  const int inputs = test::inputs_per_operation();
  int decided = 0, usual = 0;
  for (int i = 0; i < inputs; ++i) {
    bounds x;
    switch (i % 4) {
    case 0: // of any size
      x = {make.uniform(-708, 708), make.uniform(-708, 708)};
      break;
    case 1: // near multiples of ln2/256, where k changes, and of ln2, where the result nears 2^m
      x.lo = make.nudged(static_cast<double>(make.below(1 << 18)) * 0x1.62e42fefa39efp-9);
      x.hi = -make.nudged(static_cast<double>(make.below(1000)) * 0x1.62e42fefa39efp-1);
      break;
    case 2:
      x = {make.point(f.active), make.point({-1, 1})};
      break;
    default: // the hardest
      x = {test::nearly_a_double(f, make.uniform(-700, 700)), make.uniform(-1e-3, 1e-3)};
      if (i % 40 != 3)
        x.lo = make.uniform(-1, 1);
    }
    const bounds both = graze::elementary::exponential_if_decided(x.lo, x.hi);
    const bool done = !both.is_empty();
    if (i % 4 == 0)
      ++usual, decided += done;
    if (done)
      result.judge("exp",
                   {oracle::rounded_down(mpfr_exp, x.lo), oracle::rounded_up(mpfr_exp, x.hi)}, both,
                   x.lo, x.hi);
  }
  result.check();
  CHECK(decided > 0.97 * usual);
}

namespace {
bool fused() { return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2"); }

const test::unary& function(const std::string& name) {
  for (const test::unary& f : test::unary_functions())
    if (f.name == name)
      return f;
  throw std::runtime_error(name);
}

/// A point for the fast evaluations: of the range, of any size, near the points where the
/// argument's reduction changes (multiples of `step`), short fractions, and nearly a double.
double fast_argument(oracle::hard_arguments& make, const test::unary& f, int i, double lo,
                     double hi, double step) {
  switch (i % 5) {
  case 0:
    return make.uniform(lo, hi);
  case 1:
    return make.nudged(std::floor(make.uniform(lo, hi) / step) * step);
  case 2:
    return i % 50 == 2 ? test::nearly_a_double(f, make.uniform(lo, hi)) : make.uniform(lo, hi);
  case 3:
    return make.near_multiple_of_half_pi();
  default:
    return make.point(f.active);
  }
}
} // namespace

TEST_CASE("interval.log: both ends at once are right where decided, and nearly always decided",
          "[property][mpfr][hardcase]") {
  if (!fused()) {
    test::skipped("this processor has no fused operations");
    return;
  }
  const test::unary& f = function("log");
  oracle::hard_arguments make(3141);
  test::verdict result;
  const int inputs = test::inputs_per_operation();
  int decided = 0, usual = 0;
  for (int i = 0; i < inputs; ++i) {
    const double size = i % 2 ? 2 : 100;
    const double a = fast_argument(make, f, i, 0x1p-10, size, 0x1p-8);
    const double b = fast_argument(make, f, i, 0x1p-10, size, 0x1p-7);
    const bounds both = graze::elementary::logarithm_if_decided(a, b);
    if (i % 5 == 0)
      ++usual, decided += !both.is_empty();
    if (!both.is_empty())
      result.judge("log", {oracle::rounded_down(mpfr_log, a), oracle::rounded_up(mpfr_log, b)},
                   both, a, b);
  }
  result.check();
  CHECK(decided > 0.97 * usual);
}

TEST_CASE("interval.sin: both ends at once are right where decided, and nearly always decided",
          "[property][mpfr][hardcase]") {
  if (!fused()) {
    test::skipped("this processor has no fused operations");
    return;
  }
  oracle::hard_arguments make(1618);
  for (const char* name : {"sin", "cos", "tan"}) {
    const test::unary& f = function(name);
    test::verdict result;
    const int inputs = test::inputs_per_operation();
    int decided = 0, usual = 0;
    for (int i = 0; i < inputs; ++i) {
      const double size = i % 2 ? 10 : 1024;
      const double a = fast_argument(make, f, i, -size, size, 0x1.921fb54442d18p-8);
      // Ends beside each other, so that no extreme and no pole is between them.
      const double b =
          i % 3 ? a : oracle::hard_operands::step(a, static_cast<int>(make.below(100)));
      const double least = std::fabs(std::remainder(a, 0x1.921fb54442d18p+0)); // of pi/2
      const double lo = std::min(a, b), hi = std::max(a, b);
      const bounds both = name[0] == 't'
                              ? graze::elementary::tangent_if_decided(lo, hi)
                              : graze::elementary::wave_if_decided(lo, hi, name[0] == 'c');
      if (i % 5 == 0)
        ++usual, decided += !both.is_empty();
      if (both.is_empty() || (lo != hi && !(least > 0x1p-12)))
        continue;
      const auto down = [&](double x) { return oracle::rounded_down(f.exact, x); };
      const auto up = [&](double x) { return oracle::rounded_up(f.exact, x); };
      result.judge(name, {std::min(down(lo), down(hi)), std::max(up(lo), up(hi))}, both, lo, hi);
    }
    result.check();
    INFO(name);
    CHECK(decided > 0.95 * usual);
  }
}

TEST_CASE("interval.atan2: both corners at once are right where decided, and nearly always decided",
          "[property][mpfr][hardcase]") {
  if (!fused()) {
    test::skipped("this processor has no fused operations");
    return;
  }
  oracle::hard_arguments make(5772);
  test::verdict result;
  const int inputs = test::inputs_per_operation();
  int decided = 0, usual = 0;
  const auto down = [](double y, double x) { return oracle::rounded_down(mpfr_atan2, y, x); };
  const auto up = [](double y, double x) { return oracle::rounded_up(mpfr_atan2, y, x); };
  for (int i = 0; i < inputs; ++i) {
    double x = make.uniform(-10, 10), y = make.uniform(-10, 10);
    switch (i % 8) {
    case 0: // beside the middle between two steps of the table, and beside a step
      y = make.nudged(x * static_cast<double>(make.below(257)) * 0x1p-8);
      break;
    case 1: // the same from the y axis
      x = make.nudged(y * static_cast<double>(make.below(257)) * 0x1p-8);
      break;
    case 2: // small and huge quotients
      y = std::ldexp(y, static_cast<int>(make.below(200)) - 100);
      break;
    case 3:
      x = make.point({-10, 10}), y = make.point({-10, 10});
      break;
    case 4: // integers: many of one quotient
      x = std::floor(x), y = std::floor(y);
      break;
    case 5: // denominators of all bits set
      x = oracle::hard_operands::step(std::ldexp(1, static_cast<int>(make.below(8))), -1);
      y = make.nudged(x * static_cast<double>(make.below(257)) * 0x1p-8);
      break;
    default:
      break;
    }
    const double to_x = i % 3 ? make.nudged(x) : x + make.uniform(0, 4);
    const double to_y = i % 3 ? make.nudged(y) : y + make.uniform(0, 4);
    const auto [x_lo, x_hi] = std::minmax(x, to_x);
    const auto [y_lo, y_hi] = std::minmax(y, to_y);
    if ((x_lo < 0 && y_lo < 0 && y_hi >= 0) || (y_lo == 0 && y_hi == 0))
      continue;
    const bounds both = graze::elementary::angle_if_decided(y_lo, y_hi, x_lo, x_hi);
    if (i % 8 > 5)
      ++usual, decided += !both.is_empty();
    if (both.is_empty())
      continue;
    // Extremes are at corners, none of which is (0, 0) where this is decided.
    bounds exact{4, -4};
    for (const double at_y : {y_lo, y_hi})
      for (const double at_x : {x_lo, x_hi}) {
        exact.lo = std::min(exact.lo, down(at_y + 0.0, at_x));
        exact.hi = std::max(exact.hi, up(at_y + 0.0, at_x));
      }
    result.judge("atan2", exact, both, y_lo, x_lo);
  }
  result.check();
  CHECK(decided > 0.99 * usual);
}

TEST_CASE(
    "interval.elementary: the fast evaluations give the same in any rounding mode, and no flag "
    "is cleared or invalid raised",
    "[unit]") {
  namespace hardware = graze::rounding::hardware;
  const unsigned before = hardware::mxcsr();
  bounds (*const functions[])(bounds) = {graze::functions::exp::value, graze::functions::log::value,
                                         graze::functions::sin::value, graze::functions::cos::value,
                                         graze::functions::tan::value};
  const double tiny = 0x1p-1074;
  for (const auto function : functions)
    for (const bounds& x :
         {bounds{-1, 2}, bounds{0, 1}, bounds{-700, 700}, bounds::entire(), bounds::empty(),
          bounds{1e300, 1e308}, bounds{0.3, 0.7}, bounds{2, 3}, bounds{1, 1}, bounds{-tiny, tiny},
          bounds{tiny, tiny}, bounds{1e-300, 1e-200}, bounds{-2, -1.75}, bounds{5, 6}}) {
      const bounds expected = function(x);
      for (const unsigned mode : {0x1f80u, 0x3f80u, 0x5f80u, 0x7f80u, 0x1f84u}) {
        hardware::set_mxcsr(mode);
        const bounds got = function(x);
        const unsigned after = hardware::mxcsr();
        hardware::set_mxcsr(before);
        CHECK(test::same(got, expected));
        // Inexact, underflow, denormal operand may be raised; invalid where NaN is compared.
        CHECK((after & ~0x32u & ~(x.is_empty() ? 1u : 0u)) == mode);
      }
    }
}

TEST_CASE("interval.atan2: the same in any rounding mode", "[unit]") {
  namespace hardware = graze::rounding::hardware;
  const unsigned before = hardware::mxcsr();
  const bounds sets[] = {{-3, -2}, {-1, 0}, {-0.0, 1}, {-1, 2}, {0.3, 0.4}, {1, 1e300}, {2, 5}};
  for (const bounds& y : sets)
    for (const bounds& x : sets) {
      const bounds expected = graze::functions::atan2::value(y, x);
      for (const unsigned mode : {0x1f80u, 0x3f80u, 0x5f80u, 0x7f80u}) {
        hardware::set_mxcsr(mode);
        const bounds got = graze::functions::atan2::value(y, x);
        const unsigned after = hardware::mxcsr();
        hardware::set_mxcsr(before);
        CHECK(test::same(got, expected));
        CHECK((after & ~0x32u) == mode);
      }
    }
}
#endif
