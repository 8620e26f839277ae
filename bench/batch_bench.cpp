// graze-batch-bench: intervals in batches against plain vectorised double, in one run: 4,096 random
// intervals of mixed sign, each path that the processor has. Repetitions are interleaved; the table
// at the end holds the ratios of the medians.
#include "aligned.hpp"
#include "plain_vectorised.hpp"
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <graze/batch.hpp>
#include <graze/rounding/environment.hpp>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

namespace batch = graze::batch;
namespace plain = graze::bench::plain;

constexpr std::size_t n = 4096;

using graze::bench::aligned_vector;

struct arrays {
  aligned_vector<double> lo = aligned_vector<double>(n), hi = aligned_vector<double>(n);
  operator batch::const_intervals() const { return {lo, hi}; }
  operator batch::intervals() { return {lo, hi}; }
};

/// Ends uniform in [-1, 1], sorted: a quarter each of negative and positive, half of mixed
/// intervals.
arrays random_arrays(unsigned seed, double least) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> end(least, 1);
  arrays a;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = end(random), q = end(random);
    a.lo[i] = std::min(p, q), a.hi[i] = std::max(p, q);
  }
  return a;
}

const arrays x = random_arrays(1, -1), y = random_arrays(2, -1), z = random_arrays(3, -1),
             positive = random_arrays(4, 0);
arrays result;

aligned_vector<graze::bounds> pairs_of(const arrays& a) {
  aligned_vector<graze::bounds> p(n);
  for (std::size_t i = 0; i < n; ++i)
    p[i] = {a.lo[i], a.hi[i]};
  return p;
}
const aligned_vector<graze::bounds> x_pairs = pairs_of(x), y_pairs = pairs_of(y);
aligned_vector<graze::bounds> result_pairs(n);

template <class Operation> void run(benchmark::State& state, Operation operation) {
  for (auto _ : state) {
    operation();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * n);
}

constexpr graze::bounds shift{2.5, 2.5};
constexpr graze::bounds constant{0x1.bccccccccccccp+2, 0x1.bcccccccccccdp+2}; // 139/20

template <class Plain, class Batch> void add(const char* name, Plain plainly, Batch batched) {
  benchmark::RegisterBenchmark((std::string(name) + "/plain").c_str(),
                               [=](benchmark::State& s) { run(s, plainly); });
  for (const batch::path p : batch::paths)
    if (!batch::refusal(p))
      benchmark::RegisterBenchmark((std::string(name) + "/" + batch::name(p)).c_str(),
                                   [=](benchmark::State& s) {
                                     batch::force_path(p);
                                     run(s, batched);
                                   });
}

/// Remembers the medians, in ns an element.
class medians : public benchmark::ConsoleReporter {
public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& r : runs)
      if (r.aggregate_name == "median")
        nanoseconds[r.run_name.function_name] = r.GetAdjustedCPUTime() / n;
  }
  std::map<std::string, double> nanoseconds;
};

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-batch-bench"))
    return 2;
  if (const auto reason = batch::refusal(batch::path::avx512)) {
    std::fprintf(stderr, "plain double is compiled for AVX-512 here: %s\n", reason->c_str());
    return 1;
  }
  std::vector<char*> arguments{argv[0]};
  std::string defaults[] = {"--benchmark_repetitions=15", "--benchmark_min_time=0.02",
                            "--benchmark_enable_random_interleaving=true"};
  for (std::string& d : defaults)
    arguments.push_back(d.data());
  for (int i = 1; i < argc; ++i)
    arguments.push_back(argv[i]);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
    return 2;

  double* r = result.lo.data();
  const double *a = x.lo.data(), *b = y.lo.data(), *c = z.lo.data(), *p = positive.lo.data();
  add("add", [=] { plain::add(n, a, b, r); }, [] { batch::add(x, y, result); });
  add("mul", [=] { plain::mul(n, a, b, r); }, [] { batch::mul(x, y, result); });
  add("div", [=] { plain::div(n, a, b, r); }, [] { batch::div(x, y, result); });
  add("sqr", [=] { plain::sqr(n, a, r); }, [] { batch::sqr(x, result); });
  add("sqrt", [=] { plain::sqrt(n, p, r); }, [] { batch::sqrt(positive, result); });
  add("fma", [=] { plain::fma(n, a, b, c, r); }, [] { batch::fma(x, y, z, result); });
  add(
      "polynomial", [=] { plain::tanglecube(n, a, b, c, r); },
      [] { batch::biquadratic(x, y, z, shift, constant, result); });
  add(
      "mul_of_pairs", [=] { plain::mul(n, a, b, r); },
      [] { batch::mul(x_pairs, y_pairs, result_pairs); });

  medians reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("%-14s %10s", "ns an element", "plain");
  for (const batch::path q : batch::paths)
    std::printf("  %20s", batch::name(q));
  std::printf("\n");
  for (const char* name :
       {"add", "mul", "div", "sqr", "sqrt", "fma", "polynomial", "mul_of_pairs"}) {
    const auto base = reporter.nanoseconds.find(std::string(name) + "/plain");
    if (base == reporter.nanoseconds.end())
      continue;
    std::printf("%-14s %10.4f", name, base->second);
    for (const batch::path q : batch::paths) {
      const auto m = reporter.nanoseconds.find(std::string(name) + "/" + batch::name(q));
      if (m == reporter.nanoseconds.end())
        std::printf("  %20s", "not on this machine");
      else
        std::printf("  %10.4f (%6.2fx)", m->second, m->second / base->second);
    }
    std::printf("\n");
  }
}
