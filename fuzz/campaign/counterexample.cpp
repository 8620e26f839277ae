#include <campaign/counterexample.hpp>
#include <chrono>
#include <shrink/small_witness.hpp>

namespace graze::fuzz {

std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result, bool shrink_it,
                                                const std::atomic<bool>* stop) {
  const auto kind = result.worst_finding();
  if (!kind)
    return std::nullopt;
  const auto under_test = plan.under_test.guarded();
  std::optional<counterexample> simplest;
  const shrink_deadline end = usual_deadline(); // of all together
  for (const auto& of_generator : result.first) {
    const auto& ray = of_generator[static_cast<unsigned>(*kind)];
    if (!ray || (simplest && std::chrono::steady_clock::now() >= end))
      continue;
    const trial found = trial_of(plan, *ray);
    if (!shrink_it)
      return counterexample{*kind, *ray, found, found};
    const trial shrunk = shrink(found, *under_test, *kind, 30'000, end, stop);
    if (!simplest || complexity_of(shrunk) < complexity_of(simplest->shrunk))
      simplest = counterexample{*kind, *ray, found, shrunk};
  }
  if (simplest && *kind != finding::hang && plan.scene.cells == cell_kind::cube) // each hang costs its whole time
    if (const auto small = small_witness(*under_test, *kind, 10'000, end, stop);
        small && complexity_of(*small) < complexity_of(simplest->shrunk))
      simplest->shrunk = *small;
  return simplest;
}

} // namespace graze::fuzz
