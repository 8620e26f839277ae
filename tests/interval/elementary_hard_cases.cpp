// The directed point functions where correct rounding is hardest: arguments that CORE-MATH's
// sources name (their tables of exceptional cases and their authors' special tests), and arguments
// made here whose values are nearly doubles. And CORE-MATH compiled in two ways.
#include "../../interval/src/elementary/core_math.hpp"
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <graze/oracle/elementary.hpp>
#include <graze/rounding/hardware.hpp>
#include <vector>

namespace test = graze::test;
namespace oracle = graze::oracle;
using graze::bounds;

TEST_CASE("interval.points: hard cases that CORE-MATH's sources name", "[mpfr][hardcase]") {
  for (const test::unary& f : test::unary_functions()) {
    const std::vector<double> arguments = test::literals_of(f.core_math);
    INFO(f.name);
    CHECK(arguments.size() > 10);
    test::verdict result;
    for (const double literal : arguments)
      for (const int beside : {-1, 0, 1})
        for (const double sign : {1.0, -1.0}) {
          const double x = sign * oracle::hard_operands::step(literal, beside);
          result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
        }
    result.check();
  }
  for (const test::binary& f : test::binary_functions()) {
    const std::vector<double> arguments = test::literals_of(f.name);
    INFO(f.name);
    CHECK(arguments.size() > 10);
    test::verdict result;
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i) // pairs stand side by side
      for (const bool exchanged : {false, true})
        for (const int signs : {0, 1, 2, 3}) {
          const double x = (signs & 1 ? -1 : 1) * arguments[i + exchanged],
                       y = (signs & 2 ? -1 : 1) * arguments[i + !exchanged];
          result.judge(f.name, oracle::enclosed(f.exact, x, y), {f.down(x, y), f.up(x, y)}, x, y);
        }
    result.check();
  }
}

// CRlibm's own tests, 53,613 hard cases, are in its source distribution (tests/*.testdata; not in
// the crate that the build fetches). GRAZE_CRLIBM_TESTS names that folder. Their arguments are
// used; MPFR says what is right.
TEST_CASE("interval.points: CRlibm's own hard cases, where GRAZE_CRLIBM_TESTS has them",
          "[mpfr][hardcase]") {
  const char* folder = std::getenv("GRAZE_CRLIBM_TESTS");
  if (!folder) {
    test::skipped("GRAZE_CRLIBM_TESTS is not set");
    return;
  }
  std::size_t total = 0;
  for (const test::unary& f : test::unary_functions()) {
    std::ifstream file(std::filesystem::path(folder) / (std::string(f.core_math) + ".testdata"));
    test::verdict result;
    std::size_t count = 0;
    for (std::string line; std::getline(file, line);) {
      char mode[8];
      unsigned high, low;
      if (std::sscanf(line.c_str(), "%7s %x %x", mode, &high, &low) != 3 || mode[0] == '#')
        continue;
      const double x = std::bit_cast<double>(std::uint64_t{high} << 32 | low);
      result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
      ++count;
    }
    total += count;
    if (count > 0)
      result.check();
  }
  CHECK(total > 50000);
}

TEST_CASE("interval.points: values that are nearly doubles", "[property][mpfr][hardcase]") {
  const int inputs = test::inputs_per_operation() / 50;
  for (const test::unary& f : test::unary_functions()) {
    oracle::hard_arguments make(1993);
    test::verdict result;
    for (int i = 0; i < inputs; ++i) {
      double x = make.uniform(f.active.lo, f.active.hi);
      if (make.coin())
        x = std::ldexp(x, -static_cast<int>(make.below(30)));
      x = test::nearly_a_double(f, x);
      result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
    }
    result.check();
  }
}

#if defined(__x86_64__)

TEST_CASE("interval.core_math: with and without fused operations, the same bits in each mode",
          "[property]") {
  if (!__builtin_cpu_supports("fma") || !__builtin_cpu_supports("avx2")) {
    test::skipped("this processor has no fused operations: only one of the two ways was tested");
    return;
  }
  struct unary {
    const char* name;
    double (*plain)(double);
    double (*fused)(double);
  };
  struct binary {
    const char* name;
    double (*plain)(double, double);
    double (*fused)(double, double);
  };
#define GRAZE_ROW(name) {#name, graze_cr_##name, graze_cr_##name##_fma},
  const unary functions[] = {GRAZE_FOR_EACH_POINT(GRAZE_ROW)};
  const binary binaries[] = {GRAZE_BINARY_FUNCTIONS(GRAZE_ROW)};
#undef GRAZE_ROW
  namespace hardware = graze::rounding::hardware;
  const int inputs = test::inputs_per_operation() / 5;
  for (const hardware::mode mode : {hardware::mode::up, hardware::mode::down}) {
    for (const unary& f : functions) {
      oracle::hard_arguments make(1997);
      test::verdict result;
      for (int i = 0; i < inputs; ++i) {
        const double x = make.point({-4, 4});
        double a, b;
        {
          const hardware::mode_scope scope(mode);
          a = f.plain(x), b = f.fused(x);
        }
        result.judge(f.name, {a, a}, {b, b}, x);
      }
      result.check();
    }
    for (const binary& f : binaries) {
      oracle::hard_arguments make(1999);
      test::verdict result;
      for (int i = 0; i < inputs; ++i) {
        const double x = make.point({-4, 4}), y = make.point({-30, 30});
        double a, b;
        {
          const hardware::mode_scope scope(mode);
          a = f.plain(x, y), b = f.fused(x, y);
        }
        result.judge(f.name, {a, a}, {b, b}, x, y);
      }
      result.check();
    }
  }
}
#endif
