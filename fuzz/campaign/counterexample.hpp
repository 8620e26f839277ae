#pragma once
/// Of what a campaign has found, the most ordinary ray: a tame one (generate/tame.hpp) before others, the
/// simplest of them (shrink/shrink.hpp).
#include <campaign/campaign.hpp>

namespace graze::fuzz {

/// A ray that shows a kind of finding, before and after shrinking: of the generators' first ones, that which
/// shrinks to the simplest. `shrunk` may be another ray of the same kind of finding (small_witness), where
/// that is simpler; it is tame where `found` is.
struct counterexample {
  finding kind;
  std::uint64_t ray; ///< its number in the campaign
  trial found;
  trial shrunk;
  std::string
      answer{}; ///< to `shrunk`, and what is right (judge/answer_text.hpp); empty of a fault
};

/// Of this kind; nothing when the campaign has not found it. With `shrink_it` false `shrunk` is the ray as
/// found; once `stop` is set, what there is then.
std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result, finding kind,
                                                bool shrink_it = true,
                                                const std::atomic<bool>* stop = nullptr);

/// Of the foremost kind.
std::optional<counterexample> counterexample_of(const campaign_plan& plan,
                                                const campaign_result& result,
                                                bool shrink_it = true,
                                                const std::atomic<bool>* stop = nullptr);

/// One of each kind, in the order of campaign_result::kinds_found().
std::vector<counterexample> counterexamples_of(const campaign_plan& plan,
                                               const campaign_result& result,
                                               bool shrink_them = true,
                                               const std::atomic<bool>* stop = nullptr);

} // namespace graze::fuzz
