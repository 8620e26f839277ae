#include "campaign_of.hpp"
#include <generate/tame.hpp>
#include <shrink/shrink.hpp>
#include <traversal/list.hpp>
#include <trial/replay_line.hpp>

using namespace graze::fuzz;

TEST_CASE("fuzz.shrink: every candidate is legal and simpler", "[property]") {
  for (const generator& g : generators())
    for (const int level : {3, 50})
      for (unsigned k = 0; k < 10; ++k) {
        const trial t = make_trial(g, 21, k, level);
        for (const trial& s : simpler(t)) {
          REQUIRE(judgeable(s));
          REQUIRE(complexity_of(s) < complexity_of(t));
        }
      }
}

TEST_CASE("fuzz.shrink: what always fails becomes the simplest trial of all", "[unit]") {
  for (const generator& g : generators()) {
    const trial t = shrink(make_trial(g, 22, 0, 50), [](const trial&) { return true; });
    INFO(g.name);
    CHECK(t.level == 0);
    CHECK(t.extent == std::array<std::uint8_t, 3>{1, 1, 1});
    CHECK(complexity_of(t).bits <= 3); // a direction of one bit, and nothing else
  }
}

TEST_CASE("fuzz.shrink: what never fails stays, and the budget is kept", "[unit]") {
  const trial t = make_trial(*find_generator("vertex"), 23, 0, 30);
  CHECK(shrink(t, [](const trial&) { return false; }) == t);
  unsigned asked = 0;
  (void)shrink(t, [&](const trial&) { return ++asked, true; }, 3);
  CHECK(asked == 3); // the simplest of all is reached in a few steps
}

TEST_CASE("fuzz.shrink: keeps the kind of finding for every mutant", "[property]") {
  for (const traversal_entry& e : mutants()) {
    const auto under_test = e.guarded();
    if (under_test->takes(cell_kind::grid, false)) // below, and in its own scenes
      continue;
    const campaign_plan plan = plan_of(e.name, 30, 2000);
    const campaign_result result = run(plan);
    const auto kind = result.foremost();
    REQUIRE(kind);
    for (const auto& first : result.first)
      if (const auto& ray = first[static_cast<unsigned>(*kind)]) {
        const trial found = trial_of(plan, *ray);
        const trial small = shrink(found, *under_test, *kind);
        INFO(e.name << " ray " << *ray);
        CHECK((judge(small, *under_test).findings & bit(*kind)) != 0);
        CHECK(small.level < found.level);
        CHECK(std::popcount(small.all()) <= (*kind == finding::order ? 2 : 1));
      }
  }
}

TEST_CASE("fuzz.shrink: grids, boxes and segments become small, and keep their finding",
          "[property]") {
  for (const traversal_entry& e : wrong_references())
    for (const cell_kind cells : {cell_kind::grid, cell_kind::boxes, cell_kind::cube})
      for (const bool segments : {false, true}) {
        if (e.name == "mutant-open-end" && !segments)
          continue;
        campaign_plan plan = plan_of(e.name, 20, 800);
        plan.scene = {cells, segments, nullptr};
        const campaign_result result = run(plan);
        const auto kind = result.foremost();
        INFO(e.name << " " << static_cast<unsigned>(cells) << " " << segments);
        REQUIRE(kind);
        const auto under_test = e.guarded();
        for (const auto& ray : result.first_rays(*kind)) {
          if (!ray)
            continue;
          const trial found = trial_of(plan, *ray);
          const trial small = shrink(found, *under_test, *kind, 1500);
          INFO(to_json_line(found));
          INFO(to_json_line(small));
          CHECK((judge(small, *under_test).findings & bit(*kind)) != 0);
          CHECK(complexity_of(small) <= complexity_of(found));
          CHECK(std::popcount(small.all()) <= 4);
          // a tame ray stays tame, which its grid's size decides
          if (small.grid && small.grid->rule != plane_rule::given && !is_tame(found)) {
            CHECK(small.grid->rule == found.grid->rule);
            CHECK(small.grid->count[0] + small.grid->count[1] + small.grid->count[2] <= 20);
          }
          break;
        }
      }
}
