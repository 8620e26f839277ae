// The fast evaluation of exp at both ends: its table, and that it decides nothing wrongly.
#include "../../interval/src/elementary/exponential_pair.hpp"
#include "../../interval/src/elementary/exponential_table.hpp"
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <graze/functions/exponential.hpp>
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

#if defined(__x86_64__)
TEST_CASE("interval.exp: both ends at once are right where decided, and nearly always decided",
          "[property][mpfr][hardcase]") {
  if (!__builtin_cpu_supports("fma") || !__builtin_cpu_supports("avx2")) {
    WARN("this processor has no fused operations: not tested");
    return;
  }
  const test::unary& f = test::unary_functions().front();
  REQUIRE(std::string(f.name) == "exp");
  test::elementary_arguments make(2718);
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

TEST_CASE("interval.exp: the same in any rounding mode, and no flag is cleared or invalid raised",
          "[unit]") {
  namespace hardware = graze::rounding::hardware;
  const unsigned before = hardware::mxcsr();
  for (const bounds& x : {bounds{-1, 2}, bounds{0, 1}, bounds{-700, 700}, bounds::entire(),
                          bounds::empty(), bounds{1e300, 1e308}}) {
    const bounds expected = graze::functions::exp::value(x);
    for (const unsigned mode : {0x1f80u, 0x3f80u, 0x5f80u, 0x7f80u, 0x1f84u}) {
      hardware::set_mxcsr(mode);
      const bounds got = graze::functions::exp::value(x);
      const unsigned after = hardware::mxcsr();
      hardware::set_mxcsr(before);
      CHECK(test::same(got, expected));
      CHECK((after & ~0x20u) == mode); // the flag `inexact` may be raised
    }
  }
}
#endif
