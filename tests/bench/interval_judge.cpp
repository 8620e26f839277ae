// The judge of interval libraries' answers.
#include <catch2/catch.hpp>
#include <cmath>
#include <judged_intervals.hpp>
#include <limits>

using namespace graze::bench;
using graze::bounds;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double greatest = std::numeric_limits<double>::max();
} // namespace

TEST_CASE("interval_judge: excess is counted in ulps of the tightest bound", "[unit]") {
  CHECK(excess_in_ulps(1, 1, 2) == 0);
  CHECK(excess_in_ulps(1 + 0x1p-52, 1, 1) == 1);
  CHECK(excess_in_ulps(1 - 0x1p-53, 1, 1) == 0.5); // the ulp above a power of two
  CHECK(excess_in_ulps(-3 - 0x1p-50, -3, 5) == 2);
  CHECK(excess_in_ulps(-0x1p-52, 0, 1) == 1); // of the other end
  CHECK(excess_in_ulps(-2 * least, 0, 0) == 2);
  CHECK(excess_in_ulps(greatest, std::nextafter(greatest, 0), 1) == 1);
  CHECK(excess_in_ulps(0, greatest, 1) > 0x1p52);
  CHECK(std::isfinite(excess_in_ulps(-greatest, least, least)));
}

TEST_CASE("interval_judge: what is outside is unsound, what is needlessly infinite counts apart",
          "[unit]") {
  const bounds one{1, 1};
  CHECK(judge({{1, 1}}, {one}).tight == 1);
  CHECK(judge({{1, 1 + 0x1p-52}}, {one}).worst_excess == 1);
  CHECK(judge({{1 + 0x1p-52, 2}}, {one}).unsound == 1);
  CHECK(judge({{0, std::nextafter(1, 0)}}, {one}).unsound == 1);
  CHECK(judge({{-infinity, 1}}, {one}).unbounded == 1);
  CHECK(judge({{-infinity, std::nextafter(1, 0)}}, {one}).unsound == 1);
  CHECK(judge({{none, none}}, {one}).unbounded == 1);
  CHECK(judge({{none, 1}}, {one}).unsound == 0);
  CHECK(judge({{1, infinity}}, {{1, infinity}}).tight == 1);
  CHECK(judge({{1, greatest}}, {{1, infinity}}).unsound == 1);
  CHECK(judge({{5, 6}}, {bounds::empty()}).judged == 0);

  const verdict v = judge({{1, 1}, {1, 1 + 0x3p-52}, {2, 3}, {1, infinity}}, {one, one, one, one});
  CHECK(v.judged == 4);
  CHECK(v.unsound == 1);
  CHECK(v.example == 2);
  CHECK(v.unbounded == 1);
  CHECK(v.tight == 1);
  CHECK(v.mean_excess == 1.5);
  CHECK(v.worst_excess == 3);
}

TEST_CASE("interval_judge: hard operands are bounded, and the same in every run", "[unit]") {
  for (const char* name : {"add", "div", "sqrt", "exp", "tan", "atan2", "pow", "pown(x,4)"}) {
    REQUIRE(has_judge(name));
    const operand_set set = hard_operands_of(name, 300), again = hard_operands_of(name, 300);
    std::size_t points = 0;
    for (std::size_t i = 0; i < set.x.size(); ++i) {
      const ends &x = set.x[i], &y = set.y[i];
      CHECK(-infinity < x.lower);
      CHECK(x.lower <= x.upper);
      CHECK(x.upper < infinity);
      CHECK(-infinity < y.lower);
      CHECK(y.lower <= y.upper);
      CHECK(y.upper < infinity);
      CHECK(x.lower == again.x[i].lower);
      points += x.lower == x.upper;
    }
    CHECK(points > 30);
    CHECK(points < 270);
    CHECK(tightest(name, set, false).size() == 300);
  }
  CHECK(!has_judge("polynomial"));
}
