#pragma once
/// What is measured, the same for every library: operations on arrays, one after the other.
/// A contender is timed by interval_bench and judged by graze-interval-report.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace graze::bench {

/// Operands of an array: what a core's fastest cache holds, and few enough for a branch predictor
/// to learn (--operands).
inline std::size_t size = 4096;

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
  unit,               ///< two ends in [-1, 1]
  unit_narrow,        ///< of width up to 2^-6, in [-1, 1]
};

/// What a library answers: two ends, equal for plain double; NaN where it has no answer.
struct enclosure {
  double lower, upper;
};

/// A library's way to do one operation on one kind of operands.
struct contender {
  std::string operation; ///< "exp", "pown(x,4)"
  std::string set;       ///< "narrow", "mixed", ...
  std::string library;
  operands kind;
  bool of_points; ///< takes ends::point, not an interval
  std::function<void(benchmark::State&)> time;
  /// The answers to x[i], y[i], z[i]; arrays of any, equal length.
  std::function<std::vector<enclosure>(const std::vector<ends>&, const std::vector<ends>&,
                                       const std::vector<ends>&)>
      answers;
};

/// All that have been registered, in order.
inline std::vector<contender>& contenders() {
  static std::vector<contender> all;
  return all;
}

inline std::vector<ends> make(operands kind, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const bool positive = kind == operands::positive || kind == operands::positive_narrow;
  const bool unit = kind == operands::unit || kind == operands::unit_narrow;
  const bool narrow = kind == operands::narrow || kind == operands::positive_narrow ||
                      kind == operands::unit_narrow;
  const double greatest = unit ? 1 : 10;
  std::uniform_real_distribution<double> any(positive ? 0x1p-10 : -greatest, greatest),
      width(0, 0x1p-6);
  std::vector<ends> r(size);
  for (ends& e : r) {
    const double a = any(random), b = narrow ? std::min(a + width(random), greatest) : any(random);
    e = {std::min(a, b), std::max(a, b), kind == operands::mixed_of_logarithm ? std::fabs(a) : a};
  }
  return r;
}

/// Registers a contender; `name` is "exp/narrow": the operation, and what its set is called.
inline void enlist(const std::string& name, operands kind, const std::string& library,
                   bool of_points, decltype(contender::time) time,
                   decltype(contender::answers) answers) {
  const std::size_t slash = name.find('/');
  contenders().push_back({name.substr(0, slash), name.substr(slash + 1), library, kind, of_points,
                          std::move(time), std::move(answers)});
}

/// r[i] = operation(x[i], y[i], z[i]). A function of its own, so that what is judged is what is
/// timed: here the compiler knows neither operands nor rounding mode.
template <class N, class Operation>
[[gnu::noinline]] void run(const Operation& operation, std::size_t n, const N* x, const N* y,
                           const N* z, N* r) {
  for (std::size_t i = 0; i < n; ++i)
    operation(r[i], x[i], y[i], z[i]);
}

/// Registers `operation`(r, x, y, z) of the library L: L::number, L::scope, L::assign(number,
/// ends), L::enclosed(number).
template <class L, class Operation>
void measure(const std::string& name, operands kind, Operation operation) {
  using N = typename L::number;
  const auto assign = [](std::vector<N>& to, const std::vector<ends>& from) {
    for (std::size_t i = 0; i < from.size(); ++i)
      L::assign(to[i], from[i]);
  };
  const auto time = [=](benchmark::State& state) {
    std::vector<N> x(size), y(size), z(size), r(size);
    assign(x, make(kind, 1)), assign(y, make(kind, 2)), assign(z, make(kind, 3));
    [[maybe_unused]] const typename L::scope scope;
    for ([[maybe_unused]] auto pass : state) {
      run(operation, size, x.data(), y.data(), z.data(), r.data());
      benchmark::ClobberMemory();
    }
  };
  const auto answers = [=](const std::vector<ends>& a, const std::vector<ends>& b,
                           const std::vector<ends>& c) {
    std::vector<N> x(a.size()), y(a.size()), z(a.size()), r(a.size());
    assign(x, a), assign(y, b), assign(z, c);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<enclosure> all(a.size(), {nan, nan});
    for (std::size_t i = 0; i < a.size(); ++i)
      try {
        [[maybe_unused]] const typename L::scope scope;
        run(operation, 1, &x[i], &y[i], &z[i], &r[i]);
        all[i] = L::enclosed(r[i]);
      } catch (const std::exception&) { // how a library may say that it has no answer
      }
    return all;
  };
  enlist(name, kind, L::name, std::is_same_v<N, double>, time, answers);
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
template <class L> void measure_operators() {
  GRAZE_MEASURE("add/mixed", operands::mixed, x + y);
  GRAZE_MEASURE("sub/mixed", operands::mixed, x - y);
  GRAZE_MEASURE("mul/mixed", operands::mixed, x * y);
  GRAZE_MEASURE("div/mixed", operands::mixed, x / y);
  GRAZE_MEASURE("sqrt/positive", operands::positive, sqrt(x));
  GRAZE_MEASURE("sqr/mixed", operands::mixed, square(x));
}
template <class L> void measure_arithmetic() {
  measure_operators<L>();
  // x^4-5x^2+...+11.8 in a form in which no variable occurs twice
  const auto polynomial = [k = L::constant(2.5, 2.5),
                           c = L::constant(0x1.bcccccccccccdp+2, 0x1.bccccccccccccp+2)](
                              auto& r, const auto& x, const auto& y, const auto& z) {
    r = square(square(x) - k) + square(square(y) - k) + square(square(z) - k) - c;
  };
  measure<L>("polynomial/mixed", operands::mixed, polynomial);
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
  GRAZE_MEASURE("asin/narrow", operands::unit_narrow, asin(x));
  GRAZE_MEASURE("asin/mixed", operands::unit, asin(x));
  GRAZE_MEASURE("acos/narrow", operands::unit_narrow, acos(x));
  GRAZE_MEASURE("acos/mixed", operands::unit, acos(x));
  GRAZE_MEASURE_BOTH("sinh", sinh(x));
  GRAZE_MEASURE_BOTH("cosh", cosh(x));
  GRAZE_MEASURE_BOTH("tanh", tanh(x));
  GRAZE_MEASURE("pow/narrow", operands::positive_narrow, pow(x, y));
  GRAZE_MEASURE("pow/mixed", operands::positive, pow(x, y));
}

// Each in a file of its own.
void measure_double();
void measure_graze();
void measure_boost();
void measure_cgal();
void measure_mpfi();
void measure_arb();
/// Both return "; NAME (WHY)" for each that is left out.
std::string measure_batches();
std::string measure_inari();
/// All of them; returns "NAME (WHY); ..." for those that are left out.
std::string measure_all();

} // namespace graze::bench
