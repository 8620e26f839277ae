#include "campaign_of.hpp"
#include <report/report.hpp>

using namespace graze::fuzz;

namespace {

void nothing_found(std::string_view name, int level, std::uint64_t rays) {
  const campaign_plan plan = plan_of(name, level, rays);
  const campaign_result result = run(plan);
  const auto c = counterexample_of(plan, result);
  INFO(table(plan, result) << (c ? describe(plan, result, *c) : ""));
  CHECK(result.total.rays == rays);
  CHECK(result.total.touched > rays);
  CHECK(result.total.misses == 0);
  CHECK(result.total.gaps == 0);
  CHECK(result.total.order_errors == 0);
  CHECK(result.total.findings == 0);
}

} // namespace

TEST_CASE("fuzz.campaign: sound misses nothing at level 10", "[property]") {
  nothing_found("sound", 10, 300'000);
}
TEST_CASE("fuzz.campaign: sound misses nothing at level 30", "[property]") {
  nothing_found("sound", 30, 300'000);
}
TEST_CASE("fuzz.campaign: sound misses nothing at level 50", "[property]") {
  nothing_found("sound", 50, 300'000);
}
TEST_CASE("fuzz.campaign: sound misses nothing at the first and the last level", "[property]") {
  nothing_found("sound", 1, 50'000);
  nothing_found("sound", 53, 50'000);
}
TEST_CASE("fuzz.campaign: sound-closed misses no touched octant", "[property]") {
  for (const int level : {10, 30, 50})
    nothing_found("sound-closed", level, 50'000);
}
TEST_CASE("fuzz.campaign: sound on every backend misses nothing", "[property]") {
  for (const traversal_entry& e : traversals())
    if (e.name.starts_with("sound-"))
      nothing_found(e.name, 50, 30'000);
}

TEST_CASE("fuzz.campaign: exact reports no octant too few and none too many", "[property]") {
  for (const traversal_entry& e : traversals())
    if (e.name.starts_with("exact"))
      for (const int level : {1, 10, 30, 50, 53})
        nothing_found(e.name, level, 50'000);
}

TEST_CASE("fuzz.campaign: the lanes keep their promises to level 20 and decline what is below",
          "[property]") {
  for (const traversal_entry& e : lane_traversals()) {
    for (const int level : {1, 2, 10, 20})
      nothing_found(e.name, level, 20'000);
    const counts deep = run(plan_of(e.name, 21, 1'000)).total;
    CHECK(deep.declined == deep.rays);
  }
}

TEST_CASE("fuzz.campaign: counts and first findings do not depend on the number of threads",
          "[property]") {
  campaign_plan plan = plan_of("published", 40, 20'001);
  plan.workers = 1;
  const campaign_result single = run(plan);
  for (const unsigned threads : {2u, 3u, 7u}) {
    plan.workers = threads;
    const campaign_result several = run(plan);
    CHECK(several.first == single.first);
    REQUIRE(several.by_generator.size() == single.by_generator.size());
    for (std::size_t g = 0; g < single.by_generator.size(); ++g)
      CHECK(several.by_generator[g] == single.by_generator[g]);
    const auto a = counterexample_of(plan, single), b = counterexample_of(plan, several);
    REQUIRE((a && b));
    CHECK(a->shrunk == b->shrunk);
  }
}

TEST_CASE("fuzz.campaign: a piece of a campaign counts the same rays", "[property]") {
  campaign_plan plan = plan_of("gargantini", 20, 6000);
  const counts whole = run(plan).total;
  counts pieces;
  for (const std::uint64_t from : {0, 2000, 4000}) {
    plan.first = from;
    plan.trials = 2000;
    pieces += run(plan).total;
  }
  CHECK(pieces == whole);
}

TEST_CASE("fuzz.campaign: stops when told and keeps what it has", "[unit]") {
  campaign_plan plan = plan_of("sound", 10, 0);
  std::atomic<bool> stop{false};
  const campaign_result result =
      run_campaign(plan, stop, [&](std::uint64_t, double) { stop = true; });
  CHECK(result.interrupted);
  CHECK(result.total.rays > 0);
}

TEST_CASE("fuzz.campaign: a budget of time is kept", "[unit]") {
  campaign_plan plan = plan_of("sound", 10, 0);
  plan.seconds = 0.2;
  const campaign_result result = run(plan);
  CHECK(result.seconds >= 0.2); // and it has ended, though there is no budget of rays
  CHECK_FALSE(result.interrupted);
}
