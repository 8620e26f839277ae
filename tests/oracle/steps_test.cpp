#include "hard_rays.hpp"
#include <catch2/catch.hpp>
#include <graze/oracle/rational.hpp>

using namespace graze::oracle;
using graze::oracle::test::hard_scenes;
using graze::oracle::test::scene;

namespace {

place place_of(const mpq_class& x, std::span<const double> planes) {
  int at = -1;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (x == planes[k])
      return static_cast<place>(2 * k);
    if (x > planes[k])
      at = static_cast<int>(2 * k + 1);
  }
  return static_cast<place>(at);
}

/// By definition: all t >= 0 at which some plane is reached, sorted; the places at these, and at
/// one t within each open segment between and after them.
std::vector<step> steps_by_definition(const scene& s) {
  std::vector<mpq_class> times{0};
  for (unsigned a = 0; a < 3; ++a) {
    if (s.direction[a] == 0)
      continue;
    for (const double p : s.planes[a]) {
      mpq_class t = (mpq_class(p) - s.origin[a]) / mpq_class(s.direction[a]);
      if (t > 0)
        times.push_back(std::move(t));
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<step> steps;
  const auto report = [&](const mpq_class& t, bool segment) {
    step found{{}, segment};
    for (unsigned a = 0; a < 3; ++a) {
      found.at[a] = place_of(s.origin[a] + t * s.direction[a], s.planes[a]);
      if (found.at[a] < 0 || found.at[a] > static_cast<int>(2 * s.planes[a].size() - 2))
        return;
    }
    steps.push_back(found);
  };
  for (std::size_t i = 0; i < times.size(); ++i) {
    report(times[i], false);
    report(i + 1 < times.size() ? mpq_class((times[i] + times[i + 1]) / 2)
                                : mpq_class(times[i] + 1),
           true);
  }
  return steps;
}

std::array<std::vector<double>, 3> same_planes(const std::vector<double>& p) { return {p, p, p}; }

} // namespace

TEST_CASE("oracle.steps: equal to the definition in rationals on hard rays",
          "[property][hardcase]") {
  hard_scenes random(3);
  std::vector<step> fast;
  std::size_t rays_in = 0, ties = 0;
  for (int i = 0; i < 40'000; ++i) {
    const scene s = random.next();
    steps_in_grid(s.origin, s.direction, s.grid(), fast);
    const std::vector<step> slow = steps_by_definition(s);
    if (fast != slow) {
      CAPTURE(i, s.origin, s.direction, s.planes[0], s.planes[1], s.planes[2]);
      REQUIRE(fast.size() == slow.size());
      REQUIRE(fast == slow);
    }
    rays_in += slow.empty() ? 0 : 1;
    for (const step& x : slow) {
      int moving_on_planes = 0;
      for (unsigned a = 0; a < 3; ++a)
        if (s.direction[a] != 0 && x.at[a] % 2 == 0)
          ++moving_on_planes;
      ties += moving_on_planes >= 2 ? 1 : 0;
    }
  }
  CHECK(rays_in > 12'000);
  CHECK(ties > 6'000);
}

TEST_CASE("oracle.steps: points and segments alternate, are maximal, and move monotonically",
          "[property][hardcase]") {
  hard_scenes random(4);
  int walks = 0;
  for (int i = 0; i < 200'000; ++i) {
    const scene s = random.next();
    const std::vector<step> steps = steps_in_grid(s.origin, s.direction, s.grid());
    bool sane = true;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      bool point_has_plane = false;
      for (unsigned a = 0; a < 3; ++a) {
        const int at = steps[k].at[a];
        const double d = s.direction[a];
        sane &= at >= 0 && at <= static_cast<int>(2 * s.planes[a].size() - 2);
        point_has_plane |= d != 0 && at % 2 == 0;
        if (steps[k].segment && d != 0)
          sane &= at % 2 != 0; // in an open segment nothing is on a plane
        if (k == 0)
          continue;
        const int moved = at - steps[k - 1].at[a];
        sane &= moved == 0 || (moved == 1 && d > 0) || (moved == -1 && d < 0);
      }
      if (k > 0) {
        sane &= steps[k].segment != steps[k - 1].segment;
        sane &= steps[k].at != steps[k - 1].at || k == 1; // only t = 0 may be like what follows
        if (!steps[k].segment)
          sane &= point_has_plane;
      }
    }
    // The hull is closed: a ray comes into it and leaves it in a point.
    if (!steps.empty())
      sane &= !steps.front().segment && !steps.back().segment;
    if (!sane) {
      CAPTURE(i, s.origin, s.direction, s.planes[0], s.planes[1], s.planes[2]);
      REQUIRE(sane);
    }
    walks += steps.empty() ? 0 : 1;
  }
  CHECK(walks > 50'000);
}

TEST_CASE("oracle.steps: a box is touched, crossed, owned as the steps within it say",
          "[property][hardcase]") {
  hard_scenes random(5);
  int boxes_owned = 0;
  for (int i = 0; i < 100'000; ++i) {
    const scene s = random.next();
    const std::vector<step> steps = steps_in_grid(s.origin, s.direction, s.grid());
    std::array<int, 3> cell;
    point lo, hi;
    for (unsigned a = 0; a < 3; ++a) {
      cell[a] = static_cast<int>(random.below(s.planes[a].size() - 1));
      lo[a] = s.planes[a][static_cast<unsigned>(cell[a])];
      hi[a] = s.planes[a][static_cast<unsigned>(cell[a]) + 1];
    }
    bool touched = false, crossed = false, owned = false;
    for (const step& x : steps) {
      bool closed = true, open = true, half_open = true;
      for (unsigned a = 0; a < 3; ++a) {
        const int within = x.at[a] - 2 * cell[a]; // 0: on lo, 1: between, 2: on hi
        closed &= within >= 0 && within <= 2;
        open &= within == 1;
        half_open &= within == 0 || within == 1;
      }
      touched |= closed;
      crossed |= open;
      owned |= half_open;
    }
    if (touched != touches(s.origin, s.direction, lo, hi) ||
        crossed != crosses(s.origin, s.direction, lo, hi) ||
        owned != owns(s.origin, s.direction, lo, hi)) {
      CAPTURE(i, s.origin, s.direction, lo, hi, touched, crossed, owned);
      REQUIRE(touched == touches(s.origin, s.direction, lo, hi));
      REQUIRE(crossed == crosses(s.origin, s.direction, lo, hi));
      REQUIRE(owned == owns(s.origin, s.direction, lo, hi));
    }
    boxes_owned += owned ? 1 : 0;
  }
  CHECK(boxes_owned > 5'000);
}

TEST_CASE("oracle.steps: known walks", "[unit]") {
  const auto planes = same_planes({0, .5, 1});
  const std::array<std::span<const double>, 3> grid{planes[0], planes[1], planes[2]};
  using steps = std::vector<step>;
  const auto on = [](int x, int y, int z) {
    return step{{static_cast<place>(x), static_cast<place>(y), static_cast<place>(z)}, false};
  };
  const auto along = [](int x, int y, int z) {
    return step{{static_cast<place>(x), static_cast<place>(y), static_cast<place>(z)}, true};
  };
  SECTION("the diagonal through three vertices") {
    CHECK(steps_in_grid({-1, -1, -1}, {1, 1, 1}, grid) ==
          steps{on(0, 0, 0), along(1, 1, 1), on(2, 2, 2), along(3, 3, 3), on(4, 4, 4)});
  }
  SECTION("from the centre outward") {
    CHECK(steps_in_grid({.5, .5, .5}, {-1, 1, 0}, grid) ==
          steps{on(2, 2, 2), along(1, 3, 2), on(0, 4, 2)});
  }
  SECTION("from inside of a cell") {
    CHECK(steps_in_grid({.25, .25, .25}, {0, 0, -2}, grid) ==
          steps{on(1, 1, 1), along(1, 1, 1), on(1, 1, 0)});
  }
  SECTION("along an edge, and a vertex alone") {
    CHECK(steps_in_grid({-1, 1, 1}, {.5, 0, 0}, grid) ==
          steps{on(0, 4, 4), along(1, 4, 4), on(2, 4, 4), along(3, 4, 4), on(4, 4, 4)});
    CHECK(steps_in_grid({1, 1, 1}, {1, 1, 1}, grid) == steps{on(4, 4, 4)});
    CHECK(steps_in_grid({-1, 1, .5}, {1, 1, 0}, grid).empty());
    CHECK(steps_in_grid({-1, 0, .5}, {1, 1, 0}, grid) == steps{on(0, 4, 2)});
  }
  SECTION("misses, from before, beside and behind") {
    CHECK(steps_in_grid({-1, .5, .5}, {-1, 0, 0}, grid).empty());
    CHECK(steps_in_grid({2, .5, .5}, {1, 0, 0}, grid).empty());
    CHECK(steps_in_grid({-1, 1.5, .5}, {1, 0, 0}, grid).empty());
    CHECK(steps_in_grid({-1, -3, .5}, {1, 1, 0}, grid).empty());
  }
  SECTION("two planes that are one ulp apart in t are told apart") {
    const double above = std::nextafter(1.0, 2.0);
    CHECK(steps_in_grid({-.5, -.5, .25}, {1, above, 0}, grid) ==
          steps{on(0, 1, 1), along(1, 1, 1), on(1, 2, 1), along(1, 3, 1), on(2, 3, 1),
                along(3, 3, 1), on(3, 4, 1)});
  }
}

TEST_CASE("oracle.steps: sixty planes an axis", "[unit]") {
  std::vector<double> p;
  for (int i = 0; i < 60; ++i)
    p.push_back(i);
  const auto planes = same_planes(p);
  const std::array<std::span<const double>, 3> grid{planes[0], planes[1], planes[2]};
  const std::vector<step> diagonal = steps_in_grid({-1, -1, -1}, {3, 3, 3}, grid);
  REQUIRE(diagonal.size() == 119);
  CHECK(diagonal.back() == step{{118, 118, 118}, false});
  const std::vector<step> skew = steps_in_grid({0, .25, .5}, {1, 1, 1}, grid);
  // Until z leaves at t = 58.5: t = 0, 58 planes of x, 58 of y, 59 of z, and the segments between
  // them.
  CHECK(skew.size() == 2 * (1 + 58 + 58 + 59) - 1);
  CHECK(skew == steps_by_definition({{0, .25, .5}, {1, 1, 1}, planes}));
}
