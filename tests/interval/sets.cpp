// Set operations and cancellative addition: GMP's rationals compare the widths.
#include "exact_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/boolean.hpp>
#include <graze/functions/arithmetic.hpp>
#include <graze/functions/sets.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/overlap.hpp>

using graze::bounds;
using graze::oracle::hard_boxes;
using graze::test::inputs;
using graze::test::rational;
using graze::test::same;
namespace f = graze::functions;

TEST_CASE("interval.intersection, convex_hull: members decide", "[unit][property]") {
  hard_boxes boxes(4);
  for (int i = 0; i < inputs(); ++i) {
    const bounds x = boxes.next();
    bounds y = boxes.next();
    if (boxes.numbers.coin() && !x.is_empty()) // meets or nearly meets x
      y = {boxes.numbers.nudged(x.hi), std::numeric_limits<double>::infinity()};
    if (y.lo == std::numeric_limits<double>::infinity())
      y = bounds::empty();
    const bounds both = f::intersection::value(x, y), hull = f::convex_hull::value(x, y);
    CAPTURE(x.lo, x.hi, y.lo, y.hi);
    REQUIRE(same(both, f::intersection::value(y, x)));
    REQUIRE(same(hull, f::convex_hull::value(y, x)));
    REQUIRE(both.is_empty() == graze::disjoint(x, y));
    REQUIRE((x.within(hull) && y.within(hull) && both.within(x) && both.within(y)));
    for (const double t : {x.lo, x.hi, y.lo, y.hi})
      if (std::isfinite(t)) {
        REQUIRE(both.contains(t) == (x.contains(t) && y.contains(t)));
        REQUIRE((hull.lo == x.lo || hull.lo == y.lo));
        REQUIRE((hull.hi == x.hi || hull.hi == y.hi));
      }
  }
}

TEST_CASE("interval.cancel_minus, cancel_plus: exact comparison of widths", "[mpfr][hardcase]") {
  hard_boxes boxes(5);
  auto& numbers = boxes.numbers;
  int possible = 0, close = 0;
  for (int i = 0; i < inputs(); ++i) {
    bounds x = boxes.next(), y = boxes.next();
    if (numbers.below(4) != 0 && x.is_common()) { // nearly as wide, and far from or near to x
      const double shift =
          numbers.coin() ? numbers.with_exponent((std::isnormal(x.hi) ? std::ilogb(x.hi) : 0) -
                                                 static_cast<int>(numbers.below(60)))
                         : 0;
      const double a = numbers.nudged(x.lo + shift), b = numbers.nudged(x.hi + shift);
      if (a <= b && std::isfinite(a) && std::isfinite(b)) {
        y = {a, b};
        ++close;
      }
    }
    bounds expected = bounds::entire();
    if (x.is_empty() && (y.is_empty() || y.is_common())) {
      expected = bounds::empty();
    } else if (x.is_common() && y.is_common()) {
      const mpq_class lower = rational(x.lo) - rational(y.lo),
                      upper = rational(x.hi) - rational(y.hi);
      if (lower <= upper) {
        expected = graze::test::enclosure(lower, upper);
        ++possible;
      }
    }
    CAPTURE(x.lo, x.hi, y.lo, y.hi);
    REQUIRE(same(f::cancel_minus::value(x, y), expected));
    REQUIRE(same(f::cancel_plus::value(x, f::neg::value(y)), expected));
  }
  CHECK(possible > inputs() / 10);
  CHECK(close - possible > inputs() / 100);
}

TEST_CASE("interval.comparisons: as their definitions over members say", "[unit]") {
  // Every box with ends among these: the quantifiers run over members that can decide.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double ends[] = {-infinity, -1, -0.0, 1, 2, infinity};
  const double members[] = {-1e300, -3, -2, -1, -0.5, 0, 0.5, 1, 1.5, 2, 3, 4, 1e300};
  std::vector<bounds> boxes{bounds::empty()};
  for (const double a : ends)
    for (const double b : ends)
      if (a <= b && a < infinity && b > -infinity)
        boxes.push_back({a, b});
  const auto for_all = [&](const bounds& x, auto predicate) {
    for (const double t : members)
      if (graze::is_member(t, x) && !predicate(t))
        return false;
    return true;
  };
  const auto exists = [&](const bounds& x, auto predicate) {
    return !for_all(x, [&](double t) { return !predicate(t); });
  };
  for (const bounds& x : boxes)
    for (const bounds& y : boxes) {
      CAPTURE(x.lo, x.hi, y.lo, y.hi);
      CHECK(graze::subset(x, y) == for_all(x, [&](double a) { return y.contains(a); }));
      CHECK(graze::equal(x, y) == (graze::subset(x, y) && graze::subset(y, x)));
      CHECK(graze::disjoint(x, y) == !exists(x, [&](double a) { return y.contains(a); }));
      CHECK(graze::precedes(x, y) ==
            for_all(x, [&](double a) { return for_all(y, [&](double b) { return a <= b; }); }));
      CHECK(graze::strict_precedes(x, y) ==
            for_all(x, [&](double a) { return for_all(y, [&](double b) { return a < b; }); }));
      // the greatest and the least member of an unbounded set do not exist, as 1e300 here does
      const auto unbounded_less = [&](double a, double b, bool strict) {
        return a < b || (a == b && (!strict || std::fabs(a) == 1e300));
      };
      for (const bool strict : {false, true}) {
        const bool less =
            for_all(x,
                    [&](double a) {
                      return exists(y, [&](double b) { return unbounded_less(a, b, strict); });
                    }) &&
            for_all(y, [&](double b) {
              return exists(x, [&](double a) { return unbounded_less(a, b, strict); });
            });
        CHECK((strict ? graze::strict_less(x, y) : graze::less(x, y)) == less);
      }
      const bool interior = for_all(x, [&](double a) {
        return exists(y, [&](double b) { return unbounded_less(b, a, true); }) &&
               exists(y, [&](double b) { return unbounded_less(a, b, true); });
      });
      CHECK(graze::interior(x, y) == interior);
      const auto state = graze::overlap(x, y);
      CHECK((state == graze::overlap_state::equals) == (graze::equal(x, y) && !x.is_empty()));
      CHECK((state == graze::overlap_state::before) ==
            (graze::strict_precedes(x, y) && !x.is_empty() && !y.is_empty()));
    }
}

TEST_CASE("interval.overlap: the converse of each state", "[unit]") {
  using graze::overlap;
  using enum graze::overlap_state;
  const bounds empty = bounds::empty();
  CHECK(overlap(empty, empty) == both_empty);
  CHECK(overlap(empty, {1, 2}) == first_empty);
  CHECK(overlap({1, 2}, empty) == second_empty);
  struct row {
    bounds x, y;
    graze::overlap_state forth, back;
  };
  const row rows[] = {
      {{1, 2}, {3, 4}, before, after},           {{1, 2}, {2, 4}, meets, met_by},
      {{1, 3}, {2, 4}, overlaps, overlapped_by}, {{1, 2}, {1, 4}, starts, started_by},
      {{2, 3}, {1, 4}, contained_by, contains},  {{2, 4}, {1, 4}, finishes, finished_by},
      {{1, 4}, {1, 4}, equals, equals},          {{1, 1}, {1, 1}, equals, equals},
      {{1, 1}, {1, 2}, starts, started_by},      {{2, 2}, {1, 2}, finishes, finished_by},
  };
  for (const row& r : rows) {
    CAPTURE(graze::name_of(r.forth));
    CHECK(overlap(r.x, r.y) == r.forth);
    CHECK(overlap(r.y, r.x) == r.back);
  }
}
