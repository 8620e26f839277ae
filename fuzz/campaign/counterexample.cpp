#include <campaign/counterexample.hpp>
#include <chrono>
#include <generate/tame.hpp>
#include <judge/answer_text.hpp>
#include <shrink/small_witness.hpp>

namespace graze::fuzz {

std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result, finding kind,
                                                bool shrink_it, const std::atomic<bool>* stop) {
  const auto under_test = plan.under_test.guarded();
  std::optional<counterexample> simplest;
  const shrink_deadline end = usual_deadline(); // of all together
  for (const auto& ray : result.first_rays(kind)) {
    if (!ray || (simplest && std::chrono::steady_clock::now() >= end))
      continue;
    const trial found = trial_of(plan, *ray);
    const trial shrunk =
        shrink_it ? shrink(found, *under_test, kind, 30'000, end, stop, plan.scene.grid != nullptr)
                  : found;
    if (!simplest || complexity_of(shrunk) < complexity_of(simplest->shrunk))
      simplest = counterexample{kind, *ray, found, shrunk};
  }
  // each hang costs its whole time; a grid or map is not made anew
  if (simplest && shrink_it && kind != finding::hang && !plan.scene.grid)
    if (const auto small = small_witness(*under_test, kind, 10'000, end, stop, plan.scene);
        small && complexity_of(*small) < complexity_of(simplest->shrunk) &&
        (is_tame(*small) || !is_tame(simplest->found)))
      simplest->shrunk = *small;
  if (simplest && kind > finding::not_a_number) {
    visited answer;
    ask(*under_test, simplest->shrunk, answer);
    if (const auto at = trial_answered(simplest->shrunk, answer))
      simplest->answer = answer_text(*at, truth_of(*at), answer, under_test->promises(),
                                     allowance_of(*under_test));
  }
  return simplest;
}

std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result, bool shrink_it,
                                                const std::atomic<bool>* stop) {
  const auto kind = result.foremost();
  return kind ? counterexample_of(plan, result, *kind, shrink_it, stop) : std::nullopt;
}

std::vector<counterexample> counterexamples_of(const campaign_plan& plan,
                                               const campaign_result& result, bool shrink_them,
                                               const std::atomic<bool>* stop) {
  std::vector<counterexample> all;
  for (const finding kind : result.kinds_found())
    if (auto one = counterexample_of(plan, result, kind, shrink_them, stop))
      all.push_back(*std::move(one));
  return all;
}

} // namespace graze::fuzz
