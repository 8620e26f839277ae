/// The exact predicate and the exact descent on each adversarial generator's rays at level 50:
/// decisions and rays per second. The predicate is asked as it is within a descent, with the mode
/// set upwards.
#include <benchmark/benchmark.h>
#include <generate/generators.hpp>
#include <graze/octree/exact.hpp>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/upward.hpp>
#include <string>
#include <traversal/method_traversal.hpp>
#include <vector>

namespace {

using namespace graze;
using octree::convention;

constexpr unsigned rays = 1500; // with their octants they fit in the second-level cache
constexpr int level = 50;

struct question {
  octree::ray ray;
  std::vector<octree::cube> octants;
};

std::vector<question> questions_of(const fuzz::generator& g) {
  std::vector<question> all;
  for (unsigned k = 0; k < rays; ++k) {
    const fuzz::trial t = fuzz::make_trial(g, 3, k, level);
    all.push_back({*octree::ray::make(t.origin, t.direction), {}});
    for (fuzz::octant_set left = t.all(); left != 0; left &= left - 1)
      all.back().octants.push_back(
          t.octant(static_cast<fuzz::octant_number>(std::countr_zero(left))));
  }
  return all;
}

template <convention C> void decide(benchmark::State& state, const fuzz::generator& g) {
  const std::vector<question> all = questions_of(g);
  const rounding::upward::scope scope;
  std::int64_t decisions = 0;
  for ([[maybe_unused]] auto pass : state)
    for (const question& q : all) {
      const octree::exact_touch touch(q.ray);
      for (const octree::cube& c : q.octants)
        benchmark::DoNotOptimize(touch.meets<C>(c));
      decisions += static_cast<std::int64_t>(q.octants.size());
    }
  state.SetItemsProcessed(decisions);
}

template <octree::Method M> void traverse(benchmark::State& state, const fuzz::generator& g) {
  std::vector<fuzz::trial> trials;
  for (unsigned k = 0; k < rays; ++k)
    trials.push_back(fuzz::make_trial(g, 3, k, level));
  fuzz::method_traversal<M> traversal("", fuzz::promise::owned);
  fuzz::visited found;
  for ([[maybe_unused]] auto pass : state)
    for (const fuzz::trial& t : trials) {
      found.clear();
      traversal.visit(t, found);
      benchmark::DoNotOptimize(found.set());
    }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * rays));
}

} // namespace

int main(int argc, char** argv) {
  if (!graze::rounding::program_may_start("graze-exact-bench"))
    return 2;
  using rounding::upward;
  for (const fuzz::generator& g : fuzz::generators()) {
    const std::string name(g.name);
    const auto add = [&](const std::string& title,
                         void (*run)(benchmark::State&, const fuzz::generator&)) {
      benchmark::RegisterBenchmark((title + "/" + name).c_str(),
                                   [run, &g](benchmark::State& state) { run(state, g); });
    };
    add("touches", decide<convention::closed>);
    add("owns", decide<convention::owned>);
    add("descend/sound", traverse<octree::sound<upward, convention::owned>>);
    add("descend/exact", traverse<octree::exact<upward, convention::owned>>);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
