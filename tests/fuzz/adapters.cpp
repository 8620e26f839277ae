/// The traversals of others, from their papers: what each is caught at, and that the reference and
/// our exact mode are not accused.
#include "campaign_of.hpp"

using namespace graze::fuzz;

namespace {

/// Misses a crossed octant of a campaign at level 10 among its first rays, which take some 10 ms.
void caught_early(std::string_view name) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    campaign_plan plan = plan_of(name, 10, 20'000);
    plan.seed = seed;
    const campaign_result result = run(plan);
    INFO(name << ", seed " << seed);
    CHECK(result.total.rays_with_miss > 0);
    CHECK(result.total.misses == result.total.crossed_missed);
  }
}

} // namespace

TEST_CASE("fuzz.adapters: Amanatides-Woo is caught early", "[property]") {
  caught_early("amanatides-woo");
}
TEST_CASE("fuzz.adapters: Revelles is caught early", "[property]") { caught_early("revelles"); }
TEST_CASE("fuzz.adapters: Williams is caught early", "[property]") { caught_early("williams"); }
TEST_CASE("fuzz.adapters: Tavian Barnes' branchless test is caught early", "[property]") {
  caught_early("tavian");
}
TEST_CASE("fuzz.adapters: Ize's padded test is caught early", "[property]") { caught_early("ize"); }
TEST_CASE("fuzz.adapters: pbrt's padded test is caught early", "[property]") {
  caught_early("pbrt");
}

// An adapter that is wrong by itself would be caught as well: on rays with nothing special each
// reports all that is crossed and nothing that is far.
TEST_CASE("fuzz.adapters: none misses an octant on rays with nothing special", "[property]") {
  for (const traversal_entry& e : adapters()) {
    if (!e.make()->takes(cell_kind::cube, false))
      continue;
    for (const int level : {1, 4, 10}) {
      const counts c =
          run(plan_of(e.name, level, e.name.starts_with("rational") ? 1000 : 20'000, "random"))
              .total;
      INFO(e.name << " at level " << level);
      CHECK(c.rays_with_miss == 0);
      CHECK(c.gaps == 0);
      CHECK(c.far_spurious == 0);
      CHECK(c.revisits == 0);
      if (const promise p = e.make()->promises(); p != promise::any && p != promise::count)
        CHECK(c.visited > 0);
    }
  }
}

TEST_CASE("fuzz.adapters: the rational reference is not accused", "[property]") {
  for (const int level : {1, 10, 30, 50, 53}) {
    const campaign_result result = run(plan_of("rational", level, 2000));
    CHECK(result.total.findings == 0);
    CHECK(result.total.touched > 2000);
  }
}

TEST_CASE("fuzz.adapters: a program's own traversal is found by its name", "[unit]") {
  CHECK(find_traversal("somebody's") == nullptr);
  add_traversals({{"somebody's", "linked to this program", find_traversal("sound")->make}});
  REQUIRE(find_traversal("somebody's") != nullptr);
  CHECK(run(plan_of("somebody's", 10, 2000)).total.findings == 0);
}
