#pragma once
/// A campaign's result for people (a table) and for programs (one JSON object).
#include <campaign/campaign.hpp>
#include <string>

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

/// A row a generator and one for all.
std::string table(const campaign_plan& plan, const campaign_result& result);
/// What was found, in hex floats and with its replay line, and the first rays of the other kinds;
/// several lines.
std::string describe(const campaign_plan& plan, const campaign_result& result,
                     const counterexample& c);
/// One object, pretty-printed: traversal, level, seed, rays, touched, misses, gaps, spurious,
/// order_errors, rays_per_second, first_miss_seconds, counterexample, generators and more.
std::string to_json(const campaign_plan& plan, const campaign_result& result,
                    const std::optional<counterexample>& c);

} // namespace graze::fuzz
