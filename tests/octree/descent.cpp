// Descents with every child present, at levels where all octants can be listed and judged exactly.
#include <array>
#include <catch2/catch.hpp>
#include <graze/octree/sound.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <peers/paper2005/gargantini.hpp>
#include <peers/paper2005/plain.hpp>
#include <peers/paper2005/published.hpp>
#include <random>
#include <vector>

using namespace graze;
using namespace graze::octree;
using namespace graze::peers;

namespace {

struct full_tree {
  using node = int;
  [[nodiscard]] node root() const { return 0; }
  [[nodiscard]] std::uint8_t child_mask(node, const cube&, std::uint8_t wanted) const {
    return wanted;
  }
  [[nodiscard]] node child(node, unsigned) const { return 0; }
};

template <class M> std::vector<cube> visited(const ray& r, const cube& root, int level) {
  [[maybe_unused]] const typename M::scope scope;
  const M method(r);
  std::vector<cube> cells;
  descend(method, root, level, full_tree{}, [&](const cube& cell, int, const auto&) {
    cells.push_back(cell);
    return false;
  });
  return cells;
}

constexpr cube unit{{0, 0, 0}, 1};
constexpr int level = 3;

/// Rays through and past lattice points of the level, with every kind of zero and tie.
std::vector<ray> lattice_rays() {
  std::mt19937_64 random(20050101);
  std::vector<ray> rays;
  const auto lattice = [&] { return static_cast<double>(random() % 17) / 8 - 0.5; };
  const auto nudge = [&](double x) {
    const auto k = static_cast<int>(random() % 5) - 2;
    for (int i = 0; i < std::abs(k); ++i)
      x = std::nextafter(x, k < 0 ? -2.0 : 2.0);
    return x;
  };
  while (rays.size() < 3000) {
    vec3 o{lattice(), lattice(), lattice()}, target{lattice(), lattice(), lattice()}, d{};
    for (int a = 0; a < 3; ++a)
      d[a] = target[a] - o[a];
    if (rays.size() % 2 == 0)
      for (int a = 0; a < 3; ++a)
        o[a] = nudge(o[a]), d[a] = d[a] == 0 ? 0 : nudge(d[a]);
    if (const auto r = ray::make(o, d))
      rays.push_back(*r);
  }
  return rays;
}

struct verdicts {
  std::uint64_t touched = 0, touched_missed = 0, owning_missed = 0, crossed_missed = 0,
                spurious = 0;
};

template <class M> verdicts judge_all() {
  const auto root = *root_cube::make(unit, level);
  verdicts sum;
  for (const ray& r : lattice_rays()) {
    const std::vector<cube> cells = visited<M>(r, unit, level);
    for (std::uint64_t z = 0; z < 8; ++z)
      for (std::uint64_t y = 0; y < 8; ++y)
        for (std::uint64_t x = 0; x < 8; ++x) {
          const cube c = root.octant({x, y, z}, level);
          const vec3 hi{c.hi(0), c.hi(1), c.hi(2)};
          const bool seen = std::find(cells.begin(), cells.end(), c) != cells.end();
          const bool touched = oracle::touches(r.origin(), r.direction(), c.lo, hi);
          const unsigned far = (x == 7 ? 1u : 0) | (y == 7 ? 2u : 0) | (z == 7 ? 4u : 0);
          sum.touched += touched;
          sum.spurious += seen && !touched;
          if (seen || !touched)
            continue;
          ++sum.touched_missed;
          sum.crossed_missed += oracle::crosses(r.origin(), r.direction(), c.lo, hi);
          sum.owning_missed += oracle::owns(r.origin(), r.direction(), c.lo, hi, far);
        }
  }
  return sum;
}

} // namespace

TEMPLATE_TEST_CASE("octree.descent: closed reports every touched octant", "[mpfr]",
                   rounding::upward, rounding::nearest, rounding::split, rounding::switching) {
  const verdicts v = judge_all<sound<TestType, convention::closed>>();
  CHECK(v.touched > 10'000);
  CHECK(v.touched_missed == 0);
}

TEMPLATE_TEST_CASE("octree.descent: owned reports every owning octant", "[mpfr]", rounding::upward,
                   rounding::nearest, rounding::split, rounding::switching) {
  const verdicts v = judge_all<sound<TestType, convention::owned>>();
  CHECK(v.touched_missed > 0); // an owned traversal may leave out what is only touched
  CHECK(v.owning_missed == 0);
}

TEMPLATE_TEST_CASE("octree.descent: the baselines miss octants that the ray crosses", "[unit]",
                   published, gargantini) {
  CHECK(judge_all<TestType>().crossed_missed > 0);
}

TEST_CASE("octree.descent: owned is front to back for a ray in a mid-plane", "[regression]") {
  // docs/definitions.md, contract 5: closed octants have no order here; child 2 would come before child 4.
  const auto r = *ray::make({0.25, 0, 0.5}, {0, 1, 0});
  const auto cells = visited<sound<rounding::upward, convention::owned>>(r, unit, 1);
  REQUIRE(cells.size() == 2);
  CHECK(cells[0] == unit.child(4));
  CHECK(cells[1] == unit.child(6));
  CHECK(visited<sound<rounding::upward, convention::closed>>(r, unit, 1).size() == 4);
}

TEST_CASE("octree.descent: a visitor that returns true stops it", "[unit]") {
  const rounding::upward::scope scope;
  const sound<rounding::upward, convention::owned> method(*ray::make({0.1, 0.2, 0.3}, {1, 1, 1}));
  int calls = 0;
  CHECK(descend(method, unit, 5, full_tree{},
                [&](const cube&, int, const auto&) { return ++calls == 2; }));
  CHECK(calls == 2);
}

TEST_CASE("octree.descent: counts the cells that it opens", "[unit]") {
  const rounding::upward::scope scope;
  const sound<rounding::upward, convention::owned> method(*ray::make({0.1, 0.1, 0.1}, {1, 0, 0}));
  std::uint64_t opened = 0;
  descend(
      method, unit, 2, full_tree{}, [](const cube&, int, const auto&) { return false; }, &opened);
  CHECK(opened == 3); // the root and its two children along x
}
