#pragma once
/// What is measured, the same for every library: 4,096 operations on arrays, one after the other.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace graze::bench {

inline constexpr std::size_t size = 4096;

/// An interval, and a number for plain double: a random point of the function's domain.
struct ends {
  double lower, upper, point;
};

/// The operands of a kind of operation; fixed seeds.
enum class operands {
  mixed,    ///< two ends in [-10, 10]: half of them hold 0
  positive, ///< two ends in [2^-10, 10]
  narrow,   ///< of width up to 2^-6, in [-10, 10]
  positive_narrow,
  mixed_of_logarithm, ///< as mixed: half of them hold 0, a quarter lie below it; points above 0
};

inline std::vector<ends> make(operands kind, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const bool positive = kind == operands::positive || kind == operands::positive_narrow;
  const bool narrow = kind == operands::narrow || kind == operands::positive_narrow;
  std::uniform_real_distribution<double> any(positive ? 0x1p-10 : -10, 10), width(0, 0x1p-6);
  std::vector<ends> r(size);
  for (ends& e : r) {
    const double a = any(random), b = narrow ? a + width(random) : any(random);
    e = {std::min(a, b), std::max(a, b), kind == operands::mixed_of_logarithm ? std::fabs(a) : a};
  }
  return r;
}

/// Registers `operation`(r, x, y, z) of the library L: L::number, L::scope, L::make(lower, upper).
template <class L, class Operation>
void measure(const char* name, operands kind, Operation operation) {
  using N = typename L::number;
  benchmark::RegisterBenchmark((std::string(name) + "/" + L::name).c_str(),
                               [kind, operation](benchmark::State& state) {
                                 std::vector<N> x(size), y(size), z(size), r(size);
                                 const auto fill = [&](std::vector<N>& to, std::uint64_t seed) {
                                   const std::vector<ends> from = make(kind, seed);
                                   for (std::size_t i = 0; i < size; ++i)
                                     L::assign(to[i], from[i]);
                                 };
                                 fill(x, 1), fill(y, 2), fill(z, 3);
                                 [[maybe_unused]] const typename L::scope scope;
                                 for ([[maybe_unused]] auto pass : state) {
                                   const N *a = x.data(), *b = y.data(), *c = z.data();
                                   N* to = r.data();
                                   for (std::size_t i = 0; i < size; ++i)
                                     operation(to[i], a[i], b[i], c[i]);
                                   benchmark::ClobberMemory();
                                 }
                               });
}

/// All operations of a library whose numbers are values with operators; functions that it does not
/// have are left out.
#define GRAZE_MEASURE(name, kind, expression)                                                      \
  do {                                                                                             \
    const auto operation = [](auto& r, const auto& x, const auto& y, const auto& z) {              \
      (void)y, (void)z, r = (expression);                                                          \
    };                                                                                             \
    using N = typename L::number;                                                                  \
    if constexpr (requires(const N& x, const N& y, const N& z) { expression; })                    \
      measure<L>(name, kind, operation);                                                           \
  } while (false)

/// Every name that a library has is declared by the including file before this is instantiated.
template <class L> void measure_arithmetic() {
  GRAZE_MEASURE("add", operands::mixed, x + y);
  GRAZE_MEASURE("sub", operands::mixed, x - y);
  GRAZE_MEASURE("mul", operands::mixed, x * y);
  GRAZE_MEASURE("div", operands::mixed, x / y);
  GRAZE_MEASURE("sqrt", operands::positive, sqrt(x));
  GRAZE_MEASURE("sqr", operands::mixed, square(x));
  // x^4-5x^2+...+11.8 in a form in which no variable occurs twice
  const auto polynomial = [k = L::constant(2.5, 2.5),
                           c = L::constant(0x1.bcccccccccccdp+2, 0x1.bccccccccccccp+2)](
                              auto& r, const auto& x, const auto& y, const auto& z) {
    r = square(square(x) - k) + square(square(y) - k) + square(square(z) - k) - c;
  };
  measure<L>("polynomial", operands::mixed, polynomial);
}
/// Functions take narrow intervals, the two ends of which are near each other, and mixed ones.
#define GRAZE_MEASURE_BOTH(name, expression)                                                       \
  GRAZE_MEASURE(name "/narrow", operands::narrow, expression);                                     \
  GRAZE_MEASURE(name "/mixed", operands::mixed, expression)
template <class L> void measure_functions() {
  GRAZE_MEASURE_BOTH("exp", exp(x));
  GRAZE_MEASURE("log/narrow", operands::positive_narrow, log(x));
  GRAZE_MEASURE("log/mixed", operands::mixed_of_logarithm, log(x));
  GRAZE_MEASURE("log/positive", operands::positive, log(x));
  GRAZE_MEASURE_BOTH("sin", sin(x));
  GRAZE_MEASURE_BOTH("cos", cos(x));
  GRAZE_MEASURE_BOTH("tan", tan(x));
  GRAZE_MEASURE_BOTH("atan", atan(x));
  GRAZE_MEASURE_BOTH("atan2", atan2(x, y));
  GRAZE_MEASURE_BOTH("pown(x,4)", pown(x, 4));
}

// Each in a file of its own.
void measure_double();
void measure_graze();
void measure_boost();
void measure_cgal();
void measure_mpfi();
void measure_arb();

} // namespace graze::bench
