/// Every case on record stays a test: the oracle says touched, sound visits, the baseline misses.
#include <catch2/catch.hpp>
#include <judge/replay.hpp>
#include <traversal/list.hpp>
#include <xmmintrin.h>

using namespace graze::fuzz;

namespace {

trial recorded(std::size_t line) {
  const auto cases = read_replay_file(GRAZE_CORPUS "/numerics.jsonl");
  INFO(cases.reason());
  REQUIRE(cases);
  for (const replay_case& c : *cases)
    if (c.line == line)
      return c.at;
  FAIL("no such line");
  return {};
}

void missed_by(const char* baseline, std::size_t line) {
  const trial t = recorded(line);
  for (const traversal_entry& e : traversals()) {
    if (!e.name.starts_with("sound"))
      continue;
    const auto sound = e.make();
    const replay_result right = replay(t, *sound);
    INFO(e.name);
    CHECK(right.touches == 1);
    CHECK(right.crosses == 1);
    CHECK(right.visited == 1);
    CHECK(right.findings == 0);
  }
  const auto wrong = find_traversal(baseline)->make();
  CHECK(replay(t, *wrong).visited == 0);
}

} // namespace

TEST_CASE("regression: c rounded once misses an octant of level 50", "[regression]") {
  missed_by("published", 1);
}
TEST_CASE("regression: one rounding of x - x0 misses an octant from a far origin", "[regression]") {
  missed_by("published", 2);
}
TEST_CASE("regression: no rule for a zero component misses the root", "[regression]") {
  missed_by("published", 3);
}
TEST_CASE("regression: underflowing products miss the root", "[regression]") {
  missed_by("published", 4);
}
TEST_CASE("regression: overflowing products give NaN and miss the root", "[regression]") {
  missed_by("published", 5);
}

TEST_CASE("regression: flushed subnormals miss the unit cube", "[regression]") {
  missed_by("plain", 6);
  const trial t = recorded(6);
  const unsigned found = _mm_getcsr();
  _mm_setcsr(found | 0x8040); // FTZ and DAZ, as a caller's -ffast-math would leave them
  const auto sound = find_traversal("sound")->make();
  visited answer;
  sound->visit(t, answer); // its scope does not flush
  const unsigned left = _mm_getcsr();
  _mm_setcsr(found);
  CHECK(left == (found | 0x8040));
  CHECK(answer.set() == 1);
}

TEST_CASE("regression: in a mid-plane owned is front to back, closed is not", "[regression]") {
  const trial t = recorded(7);
  const truth exact = truth_of(t);
  REQUIRE(exact.owners == 2);
  CHECK(exact.owner_order[0] == octant_at(0, 0, 1)); // child 4
  CHECK(exact.owner_order[1] == octant_at(0, 1, 1)); // child 6
  visited owned, closed;
  find_traversal("sound")->make()->visit(t, owned);
  find_traversal("sound-closed")->make()->visit(t, closed);
  CHECK_FALSE(out_of_order(exact, owned));
  CHECK(misses(exact, owned, promise::owned) == 0);
  CHECK(misses(exact, closed, promise::touched) == 0);
  // closed also reports the children below the plane, and child 2 (of them) before child 4
  CHECK(closed.size() == 4);
  CHECK(owned.size() == 2);
}
