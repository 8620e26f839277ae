// The directed point functions against MPFR.
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <catch2/catch.hpp>
#include <graze/oracle/elementary.hpp>
#include <graze/point.hpp>
#include <graze/rounding/hardware.hpp>

namespace test = graze::test;
namespace oracle = graze::oracle;
namespace point = graze::point;
using graze::bounds;

namespace {

/// Cubes and their roots, sums of two squares, powers: where a value is a double.
double exact_argument(oracle::hard_arguments& make) {
  const auto n = static_cast<double>(make.below(1 << 18));
  const double cube = n * n * n; // below 2^54: exact where 53 bits are enough, else next to exact
  return make.nudged(
      std::ldexp(make.coin() ? cube : -cube, 3 * (static_cast<int>(make.below(600)) - 340)));
}

} // namespace

TEST_CASE("interval.points: functions of one argument equal MPFR in both directions",
          "[property][mpfr][hardcase]") {
  const int inputs = test::inputs_per_operation();
  for (const test::unary& f : test::unary_functions()) {
    oracle::hard_arguments make(1788);
    test::verdict result;
    for (int i = 0; i < inputs; ++i) {
      const double x =
          f.down == point::cbrt_down && i % 4 == 0 ? exact_argument(make) : make.point(f.active);
      result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
    }
    result.check();
  }
}

TEST_CASE("interval.points: functions of two arguments equal MPFR in both directions",
          "[property][mpfr][hardcase]") {
  const int inputs = test::inputs_per_operation();
  for (const test::binary& f : test::binary_functions()) {
    oracle::hard_arguments make(2008);
    oracle::hard_operands pairs(1985);
    test::verdict result;
    for (int i = 0; i < inputs; ++i) {
      double x, y;
      switch (i % 6) {
      case 0:
        x = make.uniform(-10, 10), y = make.uniform(-10, 10);
        break;
      case 1:
        x = make.point({-10, 10}), y = make.point({-10, 10});
        break;
      case 2: { // right triangles with integer sides, scaled
        // One side may be 2^-25 of the other.
        const auto m = static_cast<double>(make.below(1 << 26)),
                   n = static_cast<double>(make.below(1 << 26) >> make.below(26));
        const int scale = static_cast<int>(make.below(2040)) - 1060;
        x = make.nudged(std::ldexp(m * m - n * n, scale));
        y = make.coin() ? std::ldexp(2 * m * n, scale) : make.nudged(std::ldexp(2 * m * n, scale));
        break;
      }
      case 3: { // powers that are doubles, or close to 2^-1074, to the largest double, to 1
        x = make.coin() ? static_cast<double>(make.below(100))
                        : std::ldexp(static_cast<double>(1 + make.below(1000)),
                                     -static_cast<int>(make.below(20)));
        y = std::ldexp(static_cast<double>(make.below(256)), -static_cast<int>(make.below(6)));
        if (make.coin())
          y = -y;
        if (make.below(4) == 0)
          x = make.nudged(x * x), x *= x;
        break;
      }
      case 4: { // results at the ends of the exponents' range
        x = make.coin() ? make.uniform(0, 4)
                        : make.nudged(1 + std::ldexp(1, -static_cast<int>(make.below(53))));
        const double logarithm = std::log2(x);
        y = make.nudged((make.coin() ? 1024 : -1022 - make.uniform(0, 54)) / logarithm);
        break;
      }
      default: {
        const auto pair = pairs.next(static_cast<oracle::hardness>(
            make.below(static_cast<std::uint64_t>(oracle::hardness::count))));
        x = pair.x, y = pair.y;
      }
      }
      if (x != x || y != y)
        continue;
      result.judge(f.name, oracle::enclosed(f.exact, x, y), {f.down(x, y), f.up(x, y)}, x, y);
    }
    result.check();
  }
}

TEST_CASE("interval.points: limits, poles, and outside of the domain", "[unit]") {
  const double infinity = std::numeric_limits<double>::infinity(),
               none = std::numeric_limits<double>::quiet_NaN();
  for (const test::unary& f : test::unary_functions())
    for (const double x : {0.0, -0.0, 1.0, -1.0, 2.0, -2.0, infinity, -infinity, none}) {
      INFO(test::call(f.name, x));
      const bounds expected = oracle::enclosed(f.exact, x);
      CHECK(test::same(f.down(x), expected.lo));
      CHECK(test::same(f.up(x), expected.hi));
    }
  const double values[] = {0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -3.0, infinity, -infinity};
  for (const test::binary& f : test::binary_functions())
    for (const double x : values)
      for (const double y : values) {
        INFO(test::call(f.name, x, y));
        const bounds expected = oracle::enclosed(f.exact, x, y);
        CHECK(test::same(f.down(x, y), expected.lo));
        CHECK(test::same(f.up(x, y), expected.hi));
      }
}

#if defined(__x86_64__)
TEST_CASE("interval.points: any mode will do, and it is left as found, flags included", "[unit]") {
  namespace hardware = graze::rounding::hardware;
  const double down = point::exp_down(1), up = point::pow_up(0.7, 9.1);
  const unsigned before = hardware::mxcsr();
  for (const unsigned mode : {0x1f80u, 0x3f80u, 0x5f80u, 0x7f80u, 0x1fa0u}) {
    hardware::set_mxcsr(mode);
    const double other_down = point::exp_down(1), other_up = point::pow_up(0.7, 9.1);
    const unsigned after = hardware::mxcsr();
    hardware::set_mxcsr(before);
    CHECK(after == mode);
    CHECK(other_down == down);
    CHECK(other_up == up);
  }
}
#endif
