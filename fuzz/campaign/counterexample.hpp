#pragma once
/// Of what a campaign has found, the simplest ray.
#include <campaign/campaign.hpp>

namespace graze::fuzz {

/// A ray that shows the most serious finding, before and after shrinking: of the generators' first
/// ones, that which shrinks to the simplest. `shrunk` may be another ray of the same kind of
/// finding (small_witness), where that is simpler.
struct counterexample {
  finding kind;
  std::uint64_t ray; ///< its number in the campaign
  trial found;
  trial shrunk;
};

/// Nothing when the campaign found nothing. With `shrink_it` false `shrunk` is the ray as found; once
/// `stop` is set, what there is then.
std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result,
                                                bool shrink_it = true,
                                                const std::atomic<bool>* stop = nullptr);

} // namespace graze::fuzz
