// The directed point functions where correct rounding is hardest: arguments that CORE-MATH's
// sources name (their tables of exceptional cases and their authors' special tests), and arguments
// made here whose values are nearly doubles. And CORE-MATH compiled in two ways.
#include "elementary_functions.hpp"
#include "verdict.hpp"
#include <filesystem>
#include <fstream>
#include <graze/oracle/elementary.hpp>
#include <graze/rounding/hardware.hpp>
#include <iterator>
#include <regex>
#include <vector>

namespace test = graze::test;
namespace oracle = graze::oracle;
using graze::bounds;

namespace {

/// Every hexadecimal floating-point literal of a function's source files that is a double.
std::vector<double> literals_of(const std::string& function) {
  std::vector<double> found;
  const std::filesystem::path folder =
      std::filesystem::path(GRAZE_CORE_MATH_DIR) / "src" / "binary64" / function;
  for (const std::string& name : {function + ".c", std::string("check_special.c")}) {
    std::ifstream file(folder / name);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    static const std::regex literal("0x[0-9a-fA-F]*\\.?[0-9a-fA-F]*p[-+]?[0-9]+");
    for (std::sregex_iterator each(text.begin(), text.end(), literal), end; each != end; ++each) {
      const double x = std::strtod(each->str().c_str(), nullptr);
      if (std::isfinite(x))
        found.push_back(x);
    }
  }
  return found;
}

/// Beside x, on a step of doubles where f is nearly linear, the argument whose value is nearest to
/// a double but not equal: 2^-15 of an ulp off, or less. There the first, fast evaluation of a
/// correctly rounded function cannot decide.
double nearly_a_double(const test::unary& f, double x) {
  constexpr int steps = 1 << 14;
  const double last = test::hard_operands::step(x, steps);
  oracle::number value(160), other(160), argument;
  const auto evaluate = [&](double at, mpfr_ptr into) {
    mpfr_set_d(argument, at, MPFR_RNDN);
    f.exact(into, argument, MPFR_RNDN);
  };
  evaluate(x, value);
  evaluate(last, other);
  if (!mpfr_regular_p(value) || !mpfr_regular_p(other) || std::signbit(x) != std::signbit(last))
    return x;
  // In units of 2^-64 ulp, modulo the ulp.
  const auto exponent = mpfr_get_exp(value);
  if (exponent < -1000)
    return x;
  const auto fraction = [&](mpfr_ptr t) {
    oracle::number scaled(160), whole(160);
    mpfr_mul_2si(scaled, t, 53 - exponent, MPFR_RNDN);
    mpfr_floor(whole, scaled);
    mpfr_sub(scaled, scaled, whole, MPFR_RNDN);
    mpfr_mul_2ui(scaled, scaled, 64, MPFR_RNDN);
    return mpfr_get_uj(scaled, MPFR_RNDZ);
  };
  const std::uint64_t start = fraction(value);
  mpfr_sub(other, other, value, MPFR_RNDN);
  mpfr_div_ui(other, other, steps, MPFR_RNDN);
  const std::uint64_t slope = fraction(other);
  std::uint64_t here = start, least = ~std::uint64_t{0};
  int best = 0;
  for (int k = 0; k < steps; ++k, here += slope) {
    const std::uint64_t distance = here >> 63 ? ~here + 1 : here;
    if (distance < least && distance != 0) {
      least = distance;
      best = k;
    }
  }
  return test::hard_operands::step(x, best);
}

} // namespace

TEST_CASE("interval.points: hard cases that CORE-MATH's sources name", "[mpfr][hardcase]") {
  for (const test::unary& f : test::unary_functions()) {
    const std::vector<double> arguments = literals_of(f.core_math);
    INFO(f.name);
    CHECK(arguments.size() > 10);
    test::verdict result;
    for (const double literal : arguments)
      for (const int beside : {-1, 0, 1})
        for (const double sign : {1.0, -1.0}) {
          const double x = sign * test::hard_operands::step(literal, beside);
          result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
        }
    result.check();
  }
  for (const test::binary& f : test::binary_functions()) {
    const std::vector<double> arguments = literals_of(f.name);
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

TEST_CASE("interval.points: values that are nearly doubles", "[property][mpfr][hardcase]") {
  const int inputs = test::inputs_per_operation() / 50;
  for (const test::unary& f : test::unary_functions()) {
    test::elementary_arguments make(1993);
    test::verdict result;
    for (int i = 0; i < inputs; ++i) {
      double x = make.uniform(f.active.lo, f.active.hi);
      if (make.coin())
        x = std::ldexp(x, -static_cast<int>(make.below(30)));
      x = nearly_a_double(f, x);
      result.judge(f.name, oracle::enclosed(f.exact, x), {f.down(x), f.up(x)}, x);
    }
    result.check();
  }
}

#if defined(__x86_64__)
#define GRAZE_UNARY_FUNCTIONS(X)                                                                   \
  X(exp)                                                                                           \
  X(exp2) X(exp10) X(expm1) X(log) X(log2) X(log10) X(log1p) X(sin) X(cos) X(tan) X(asin) X(acos)  \
      X(atan) X(sinh) X(cosh) X(tanh) X(asinh) X(acosh) X(atanh) X(cbrt)
#define GRAZE_BINARY_FUNCTIONS(X) X(atan2) X(hypot) X(pow)
extern "C" {
#define GRAZE_DECLARE(name) double graze_cr_##name(double), graze_cr_##name##_fma(double);
GRAZE_UNARY_FUNCTIONS(GRAZE_DECLARE)
#undef GRAZE_DECLARE
#define GRAZE_DECLARE(name)                                                                        \
  double graze_cr_##name(double, double), graze_cr_##name##_fma(double, double);
GRAZE_BINARY_FUNCTIONS(GRAZE_DECLARE)
#undef GRAZE_DECLARE
}

TEST_CASE("interval.core_math: with and without fused operations, the same bits in each mode",
          "[property]") {
  if (!__builtin_cpu_supports("fma") || !__builtin_cpu_supports("avx2")) {
    WARN("this processor has no fused operations; only one of the two ways was tested");
    return;
  }
  struct one {
    const char* name;
    double (*plain)(double);
    double (*fused)(double);
  };
  struct two {
    const char* name;
    double (*plain)(double, double);
    double (*fused)(double, double);
  };
#define GRAZE_ROW(name) {#name, graze_cr_##name, graze_cr_##name##_fma},
  const one functions[] = {GRAZE_UNARY_FUNCTIONS(GRAZE_ROW)};
  const two binaries[] = {GRAZE_BINARY_FUNCTIONS(GRAZE_ROW)};
#undef GRAZE_ROW
  namespace hardware = graze::rounding::hardware;
  const int inputs = test::inputs_per_operation() / 5;
  for (const hardware::mode mode : {hardware::mode::up, hardware::mode::down}) {
    for (const one& f : functions) {
      test::elementary_arguments make(1997);
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
    for (const two& f : binaries) {
      test::elementary_arguments make(1999);
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
