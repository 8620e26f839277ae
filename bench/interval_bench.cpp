// interval_bench: ns an operation of graze::interval and of its peers, and as a multiple of plain
// double or of the C library's function. Options are Google Benchmark's, and --operands=N (4096: so
// few that branch predictors learn them); the table at the end holds medians where
// --benchmark_repetitions is given.
#include "measure.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <graze/rounding/environment.hpp>
#include <map>
#include <string>
#include <vector>

namespace {

class table : public benchmark::ConsoleReporter {
public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration)
        continue;
      const std::string name = run.run_name.function_name; // e.g. exp/mixed/MPFI
      const std::size_t slash = name.rfind('/');
      const std::string operation = name.substr(0, slash), library = name.substr(slash + 1);
      times_[{operation, library}].push_back(run.GetAdjustedCPUTime() / graze::bench::size);
    }
  }
  void Finalize() override {
    std::vector<std::string> operations, libraries; // in order of registration
    for (const graze::bench::contender& c : graze::bench::contenders())
      if (times_.contains({c.operation + "/" + c.set, c.library}))
        remember(operations, c.operation + "/" + c.set), remember(libraries, c.library);
    std::printf("\nns an operation (multiple of double's), median\n%-15s", "");
    for (const std::string& l : libraries)
      std::printf(" %19s", l.c_str());
    std::printf("\n");
    for (const std::string& o : operations) {
      std::printf("%-15s", o.c_str());
      const double base = median(o, "double");
      for (const std::string& l : libraries)
        if (const double t = median(o, l); t > 0)
          std::printf("   %8.2f (%6.1f)", t, base > 0 ? t / base : 0);
        else
          std::printf(" %19s", "-");
      std::printf("\n");
    }
  }

private:
  static void remember(std::vector<std::string>& all, const std::string& name) {
    if (std::find(all.begin(), all.end(), name) == all.end())
      all.push_back(name);
  }
  double median(const std::string& operation, const std::string& library) {
    std::vector<double>& t = times_[{operation, library}];
    if (t.empty())
      return 0;
    std::sort(t.begin(), t.end());
    return t[t.size() / 2];
  }
  std::map<std::pair<std::string, std::string>, std::vector<double>> times_;
};

/// Takes --operands=N, 1 to 2^22, out of the arguments; returns false where N is none.
bool take_operands(int& argc, char** argv) {
  const std::string option = "--operands=";
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]).starts_with(option)) {
      char* end = nullptr;
      const char* const digits = argv[i] + option.size();
      const unsigned long n = std::strtoul(digits, &end, 10);
      if (end == digits || *end != 0 || n < 1 || n > (1u << 22))
        return false;
      graze::bench::size = n;
      std::copy(argv + i + 1, argv + argc, argv + i);
      --argc, --i;
    }
  return true;
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("interval_bench"))
    return 2;
  if (!take_operands(argc, argv)) {
    std::fprintf(stderr, "interval_bench: --operands takes a number from 1 to 4194304\n");
    return 2;
  }
  benchmark::AddCustomContext("operands", std::to_string(graze::bench::size));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  using namespace graze::bench;
  const std::string missing = measure_all();
  std::printf("peers left out: %s\n", missing.empty() ? "none" : missing.c_str());
  for (const contender& c : contenders())
    benchmark::RegisterBenchmark((c.operation + "/" + c.set + "/" + c.library).c_str(), c.time);
  table reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
