#include "hard_rays.hpp"
#include <catch2/catch.hpp>
#include <graze/oracle/arrival.hpp>
#include <graze/oracle/rational.hpp>
#include <xmmintrin.h>

using namespace graze::oracle;
using graze::oracle::test::hard_scenes;
using graze::oracle::test::scene;

namespace {

struct box {
  point lo, hi;
};

/// A box between two planes an axis of the scene; flat (lo = hi) now and then.
box some_box(const scene& s, hard_scenes& random) {
  box b;
  for (unsigned a = 0; a < 3; ++a) {
    const auto n = s.planes[a].size();
    const auto i = random.below(n), j = random.below(n);
    const bool flat = random.below(20) == 0;
    b.lo[a] = s.planes[a][flat ? i : std::min(i, std::min(n - 2, j))];
    b.hi[a] = flat ? b.lo[a] : s.planes[a][std::max({i, j, std::min(i, std::min(n - 2, j)) + 1})];
  }
  return b;
}

unsigned verdicts(const scene& s, const box& b, unsigned far) {
  return (touches(s.origin, s.direction, b.lo, b.hi) ? 1u : 0u) |
         (crosses(s.origin, s.direction, b.lo, b.hi) ? 2u : 0u) |
         (owns(s.origin, s.direction, b.lo, b.hi, far) ? 4u : 0u);
}

} // namespace

TEST_CASE("oracle.geometry: touches, crosses and owns equal the rational ones on hard rays",
          "[property][hardcase]") {
  hard_scenes random(1);
  std::array<int, 8> seen{};
  for (int i = 0; i < 100'000; ++i) {
    const scene s = random.next();
    const box b = some_box(s, random);
    const auto far = static_cast<unsigned>(random.below(8));
    const unsigned fast = verdicts(s, b, far);
    const unsigned slow = (rational::touches(s.origin, s.direction, b.lo, b.hi) ? 1u : 0u) |
                          (rational::crosses(s.origin, s.direction, b.lo, b.hi) ? 2u : 0u) |
                          (rational::owns(s.origin, s.direction, b.lo, b.hi, far) ? 4u : 0u);
    ++seen[slow];
    if (fast != slow) {
      CAPTURE(i, s.origin, s.direction, b.lo, b.hi, far);
      REQUIRE(fast == slow);
    }
  }
  // The rays are hard: all combinations that can be (crossed or owned implies touched; a crossed
  // box has an interior point, which it owns) occur often.
  for (const unsigned possible : {0u, 1u, 5u, 7u})
    CHECK(seen[possible] > 2'000);
  for (const unsigned impossible : {2u, 3u, 4u, 6u})
    CHECK(seen[impossible] == 0);
}

TEST_CASE(
    "oracle.geometry: the answers do not depend on rounding mode or flushing, which are restored",
    "[property][hardcase]") {
  hard_scenes random(2);
  const unsigned found = _mm_getcsr();
  std::vector<step> steps;
  int judged = 0;
  for (int i = 0; i < 20'000; ++i) {
    const scene s = random.next();
    const box b = some_box(s, random);
    const unsigned expected = verdicts(s, b, 0);
    const std::vector<step> expected_steps = steps_in_grid(s.origin, s.direction, s.grid());
    // up, down, to zero, flushing of results and of operands
    for (const unsigned mode : {0x5f80u, 0x3f80u, 0x7f80u, 0x9f80u, 0x1fc0u, 0xdfc0u}) {
      _mm_setcsr(mode);
      const unsigned verdict = verdicts(s, b, 0);
      steps_in_grid(s.origin, s.direction, s.grid(), steps);
      const unsigned after = _mm_getcsr() & ~0x3fu;
      _mm_setcsr(found);
      if (verdict != expected || steps != expected_steps || after != mode) {
        CAPTURE(i, mode, after);
        REQUIRE(verdict == expected);
        REQUIRE(steps == expected_steps);
        REQUIRE(after == mode);
      }
      ++judged;
    }
  }
  CHECK(judged == 6 * 20'000);
}

TEST_CASE("oracle.geometry: unit cube, known answers", "[unit]") {
  const point lo{0, 0, 0}, hi{1, 1, 1};
  struct example {
    point origin, direction;
    bool touched, crossed, owned, owned_as_root;
  };
  const double tiny = 0x1p-1074, ulp = 0x1p-53;
  const std::array examples{
      example{{-1, .5, .5}, {1, 0, 0}, true, true, true, true},      // straight through
      example{{-1, .5, .5}, {-1, 0, 0}, false, false, false, false}, // behind
      example{{-1, 0, .5}, {1, 0, 0}, true, false, true, true},      // in the near face
      example{{-1, 1, .5}, {1, 0, 0}, true, false, false, true},     // in the far face
      example{{-1, 1, 1}, {1, 0, 0}, true, false, false, true},      // along the far edge
      example{{-1, 0, 0}, {1, 0, 0}, true, false, true, true},       // along the near edge
      example{{0, 0, 0}, {-1, -1, -1}, true, false, true, true},     // leaves from the near vertex
      example{{1, 1, 1}, {1, 1, 1}, true, false, false, true},       // leaves from the far vertex
      example{{1, 1, 1}, {-1, -1, -1}, true, true, true, true},      // in from the far vertex
      example{{1, .5, .5}, {1, 0, 0}, true, false, false, true},     // leaves from the far face
      example{{1, .5, .5}, {0, 1, 0}, true, false, false, true},     // moves in the far face
      example{{0, .5, .5}, {-1, 0, 0}, true, false, true, true},     // leaves from the near face
      example{{-1, 1, .5}, {1, 1, 0}, false, false, false, false},   // passes beside
      example{{-1, 0, .5}, {1, 1, 0}, true, false, false, true},     // the edge x = 0, y = 1
      example{{-1, -1, .5}, {1, 1, 0}, true, true, true, true},      // the diagonal
      example{{-1, 2, .5}, {1, -1, 0}, true, true, true, true},      // the other one, by an edge
      example{{1, -1, .5}, {-1, 1, 0}, true, false, true, true},     // the edge x = 0, y = 0
      example{{2, 0, .5}, {-1, 1, 0}, true, false, false, true},     // the edge x = 1, y = 1
      example{{.5, .5, .5}, {tiny, 0, 0}, true, true, true, true},   // starts inside
      example{{-1, .5, -tiny}, {1, 0, 0}, false, false, false, false}, // below by the least double
      example{{-1, .5, -tiny}, {1, 0, tiny}, true, true, true, true},  // and rises to the face
      example{{-1, .5, 1 - ulp}, {1, 0, 0}, true, true, true, true},   // within by an ulp
      example{{-1, .5, 1 + 2 * ulp}, {1, 0, 0}, false, false, false, false}, // without by an ulp
      example{{-0x1p1000, .5, .5}, {0x1p1000, -tiny, tiny}, true, true, true, true},
      example{{-1.7e308, .5, .5}, {1.7e308, 1.7e308, 0}, false, false, false, false},
      example{{-1.7e308, -1.7e308, -1.7e308}, {tiny, tiny, tiny}, true, true, true, true}};
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const example& e = examples[i];
    CAPTURE(i, e.origin, e.direction);
    CHECK(touches(e.origin, e.direction, lo, hi) == e.touched);
    CHECK(crosses(e.origin, e.direction, lo, hi) == e.crossed);
    CHECK(owns(e.origin, e.direction, lo, hi) == e.owned);
    CHECK(owns(e.origin, e.direction, lo, hi, 7) == e.owned_as_root);
    CHECK(rational::touches(e.origin, e.direction, lo, hi) == e.touched);
    CHECK(rational::crosses(e.origin, e.direction, lo, hi) == e.crossed);
    CHECK(rational::owns(e.origin, e.direction, lo, hi) == e.owned);
    CHECK(rational::owns(e.origin, e.direction, lo, hi, 7) == e.owned_as_root);
  }
}

TEST_CASE("oracle.geometry: one axis closed at its far face owns there and nowhere else",
          "[unit]") {
  const point lo{0, 0, 0}, hi{1, 1, 1};
  const point origin{-1, 1, .5}, direction{1, 0, 0}; // in the far face of y
  CHECK(owns(origin, direction, lo, hi, 2));
  CHECK_FALSE(owns(origin, direction, lo, hi, 1 | 4));
  const point edge_origin{-1, 1, 1}; // along the far edge of y and z
  CHECK(owns(edge_origin, direction, lo, hi, 2 | 4));
  CHECK_FALSE(owns(edge_origin, direction, lo, hi, 2));
  CHECK_FALSE(owns(edge_origin, direction, lo, hi, 4));
}

TEST_CASE("oracle.geometry: every point of a ray in the root is owned by one octant at a time",
          "[property]") {
  // A diagonal through the centre of [0,1]^3 has two owners; its mirror in x four closed neighbours
  // but, by half-openness, owners 1, then (at the centre) 7, then 6.
  const auto owners = [](const point& o, const point& d) {
    unsigned mask = 0;
    for (unsigned child = 0; child < 8; ++child) {
      point lo, hi;
      for (unsigned a = 0; a < 3; ++a) {
        lo[a] = (child >> a & 1) != 0 ? .5 : 0;
        hi[a] = lo[a] + .5;
      }
      if (owns(o, d, lo, hi, child))
        mask |= 1u << child; // upper children end at the root's far faces
    }
    return mask;
  };
  CHECK(owners({0, 0, 0}, {1, 1, 1}) == (1u << 0 | 1u << 7));
  CHECK(owners({1, 1, 1}, {-1, -1, -1}) == (1u << 0 | 1u << 7));
  CHECK(owners({1, 0, 0}, {-1, 1, 1}) == (1u << 1 | 1u << 7 | 1u << 6));
  CHECK(owners({0, 1, .25}, {1, -1, 0}) == (1u << 2 | 1u << 3 | 1u << 1));
}
