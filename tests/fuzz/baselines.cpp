/// The baselines' misses are found at once, shrunk, and told again by rationals.
#include "campaign_of.hpp"
#include <judge/replay.hpp>
#include <report/report.hpp>
#include <shrink/shrink.hpp>

using namespace graze::fuzz;

namespace {

void found_at_once(std::string_view name) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    campaign_plan plan = plan_of(name, 50, 20'000);
    plan.seed = seed;
    const campaign_result result = run(plan);
    CHECK(result.first_miss_seconds);
    campaign_plan soonest = plan;
    soonest.until_finding = true;
    soonest.workers = 1;
    CHECK(run(soonest).total.rays < 2000);
    CHECK(result.total.crossed_missed > 0);
    CHECK(result.total.misses == result.total.crossed_missed); // only a crossed octant counts here
    if (seed != 1)
      continue;
    const auto c = counterexample_of(plan, result);
    REQUIRE(c);
    CHECK((c->kind == finding::crossed_miss || c->kind == finding::gross_miss));
    CHECK(complexity_of(c->shrunk) < complexity_of(c->found));
    // through the codec, as a user would
    const auto again = from_json_line(to_json_line(c->shrunk));
    REQUIRE(again);
    const auto baseline = plan.under_test.make();
    const replay_result wrong = replay(*again, *baseline);
    CHECK(wrong.oracles_agree);
    CHECK(wrong.crosses == 1);
    CHECK(wrong.visited == 0);
    const auto sound = find_traversal("sound")->make();
    CHECK(replay(*again, *sound).visited == 1);
    CHECK(replay(*again, *sound).findings == 0);
  }
}

} // namespace

TEST_CASE("fuzz.baselines: published misses a crossed octant in 2,000 rays at level 50",
          "[property]") {
  found_at_once("published");
}
TEST_CASE("fuzz.baselines: plain misses a crossed octant in 2,000 rays at level 50", "[property]") {
  found_at_once("plain");
}
TEST_CASE("fuzz.baselines: gargantini misses a crossed octant in 2,000 rays at level 50",
          "[property]") {
  found_at_once("gargantini");
}
TEST_CASE("fuzz.baselines: published's counterexample needs a few bits only", "[property]") {
  const campaign_plan plan = plan_of("published", 50, 20'000);
  const auto c = counterexample_of(plan, run(plan));
  REQUIRE(c);
  CHECK(c->shrunk.level <= 1);
  CHECK(complexity_of(c->shrunk).bits < 40);
}
