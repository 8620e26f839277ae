#pragma once
#include <campaign/campaign.hpp>
#include <catch2/catch.hpp>

namespace graze::fuzz {

/// A plan with all generators (or one) and a budget of rays.
inline campaign_plan plan_of(std::string_view traversal, int level, std::uint64_t rays,
                             std::string_view only = {}) {
  campaign_plan plan;
  const traversal_entry* const named = find_traversal(traversal);
  REQUIRE(named != nullptr);
  plan.under_test = *named;
  for (const generator& g : generators())
    if (only.empty() || g.name == only)
      plan.generators.push_back(&g);
  REQUIRE_FALSE(plan.generators.empty());
  plan.level = plan.last_level = level;
  plan.trials = rays;
  plan.workers = 2;
  return plan;
}

inline campaign_result run(const campaign_plan& plan) {
  const std::atomic<bool> stop{false};
  return run_campaign(plan, stop);
}

} // namespace graze::fuzz
