/// Each mutant is told apart from the sound traversal and from the others by what is found.
#include "campaign_of.hpp"

using namespace graze::fuzz;

namespace {
counts total_of(std::string_view name, int level) {
  return run(plan_of(name, level, 40'000)).total;
}
const std::array<int, 4> levels{1, 10, 30, 50};
} // namespace

TEST_CASE("fuzz.mutants: dropping one child is seen as misses of crossed octants and gaps",
          "[property]") {
  for (const int level : levels) {
    const counts c = total_of("mutant-drops", level);
    CHECK(c.crossed_missed > 1000);
    CHECK(c.gaps > 1000);
    CHECK(c.order_errors == 0);
    CHECK(c.revisits == 0);
    CHECK(c.far_spurious == 0);
  }
}

TEST_CASE("fuzz.mutants: reversing the order is seen as order errors and nothing else",
          "[property]") {
  for (const int level : levels) {
    const counts c = total_of("mutant-reversed", level);
    CHECK(c.order_errors > 1000);
    CHECK(c.findings == c.order_errors);
    CHECK(c.misses == 0);
    CHECK(c.gaps == 0);
  }
}

TEST_CASE("fuzz.mutants: reporting everything is seen as spurious octants far from the ray and "
          "nothing else",
          "[property]") {
  for (const int level : levels) {
    const counts c = total_of("mutant-everything", level);
    CHECK(c.far_spurious > 500);
    CHECK(c.findings == c.far_spurious);
    CHECK(c.misses == 0);
    CHECK(c.gaps == 0);
  }
}

TEST_CASE("fuzz.mutants: skipping exact hits is seen as misses of owners that are not crossed",
          "[property]") {
  for (const int level : levels) {
    const counts c = total_of("mutant-exact", level);
    CHECK(c.misses > 100);
    CHECK(c.order_errors == 0);
    CHECK(c.far_spurious == 0);
    CHECK(run(plan_of("mutant-exact", level, 3000, "vertex")).total.misses > 0);
    if (level <= 30) // random rays do not hit planes exactly
      CHECK(run(plan_of("mutant-exact", level, 3000, "random")).total.misses == 0);
  }
}

TEST_CASE("fuzz.mutants: a repeated octant is seen as a revisit and nothing else", "[property]") {
  const counts c = total_of("mutant-twice", 10);
  CHECK(c.revisits > 1000);
  CHECK(c.findings == c.revisits);
}

TEST_CASE("fuzz.mutants: bounds that pass for exact are seen as spurious octants and nothing else",
          "[property]") {
  for (const int level : levels) {
    const campaign_result result = run(plan_of("mutant-inexact", level, 40'000));
    CHECK(result.total.spurious > 1000);
    CHECK(result.total.misses == 0);
    CHECK(result.total.order_errors == 0);
    CHECK(result.foremost() == finding::spurious);
  }
}
