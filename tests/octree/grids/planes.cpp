// The planes of grids by their rules, judged by rationals that MPFR rounds; and what is refused.
#include "hard_grids.hpp"
#include <catch2/catch.hpp>
#include <set>

using namespace graze;
using namespace graze::grid_tests;

TEST_CASE("octree.grid: planes are those of their rules, exactly", "[mpfr][property]") {
  std::uint64_t planes = 0, apart = 0;
  std::set<plane_rule> rules;
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    random_stream r(1610, i);
    const hard_grid g = make_grid(r, 300);
    rules.insert(g.planes.rule());
    for (unsigned a = 0; a < 3; ++a) {
      const int axis = static_cast<int>(a);
      if (g.planes.rule() == plane_rule::given)
        continue;
      for (int k = 0; k < 12; ++k) {
        const std::uint32_t at = r.below(g.planes.count(axis) + 1);
        const mpq_class exact =
            plane_by_rule(g.planes.rule(), g.plan[a], g.planes.flat(axis) ? 0 : at);
        const double lower = g.planes.lower(axis, at), upper = g.planes.upper(axis, at);
        INFO("grid " << i << " (" << name_of(g.planes.rule()) << "), axis " << a << ", plane "
                     << at);
        REQUIRE(mpq_class(lower) <= exact);
        REQUIRE(exact <= mpq_class(upper));
        REQUIRE(upper <= steps_away(lower, 1));
        REQUIRE((exact == lower) == (lower == upper));
        if (g.planes.rule() != plane_rule::exact)
          REQUIRE(lower == upper);
        const plane_value p = g.planes.plane(axis, at);
        REQUIRE(mpq_class(p.origin) + p.multiple * mpq_class(p.spacing) == exact);
        REQUIRE(mpq_class(upper) - mpq_class(lower) <= mpq_class(g.planes.plane_width(axis)));
        ++planes;
        apart += lower != upper;
      }
    }
  }
  CHECK(rules.size() == 6);
  CHECK(planes > 40'000);
  CHECK(apart > 1'000);
}

TEST_CASE("octree.grid: the rules differ where they should", "[unit]") {
  const auto plane = [](plane_rule rule, std::uint32_t k) {
    return grid::make({0.3, 0, 0}, {0.1, 1, 1}, {100, 1, 1}, rule)->upper(0, k);
  };
  int multiplied = 0, added = 0;
  for (std::uint32_t k = 0; k <= 100; ++k) {
    multiplied += plane(plane_rule::multiplied, k) != plane(plane_rule::rounded, k);
    added += plane(plane_rule::added, k) != plane(plane_rule::rounded, k);
  }
  CHECK(multiplied > 0);
  CHECK(added > 0);
  CHECK(plane(plane_rule::binary32, 10) == static_cast<double>(0.3f + 10.0f * 0.1f));
}

TEST_CASE("octree.grid: what is refused, with the axis, the plane and the way out", "[unit]") {
  const auto reason = [](const expected<grid>& g) {
    REQUIRE_FALSE(g);
    return g.reason();
  };
  using Catch::Contains;
  const std::array<std::uint32_t, 3> n{4, 4, 4};
  CHECK_THAT(reason(grid::make({0, 0x1p53, 0}, {1, 1, 1}, n, plane_rule::rounded)),
             Contains("axis 1: plane 1") && Contains("0x1p+53") && Contains("plane_rule::exact"));
  CHECK(grid::make({0, 0x1p53, 0}, {1, 1, 1}, n, plane_rule::exact));
  CHECK_THAT(reason(grid::make({0, 0, 0x1p1023}, {1, 1, 0x1p1022}, n, plane_rule::exact)),
             Contains("axis 2: plane 2") && Contains("smaller spacing"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 1, 1}, {4, 0, 4}, plane_rule::exact)),
             Contains("axis 1: a count of 0") && Contains("flat"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 1, 1}, {4, (1u << 20) + 1, 4}, plane_rule::exact)),
             Contains("axis 1") && Contains("split"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 0, 1}, n, plane_rule::exact)),
             Contains("axis 1") && Contains("flat"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, -1, 1}, n, plane_rule::added)),
             Contains("axis 1") && Contains("lower corner"));
  CHECK_THAT(reason(grid::make({0, 0, NAN}, {1, 1, 1}, n, plane_rule::exact)), Contains("axis 2"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 1, INFINITY}, n, plane_rule::exact)),
             Contains("axis 2"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 1, 1}, n, plane_rule::given)), Contains("arrays"));
  CHECK_THAT(reason(grid::make({0, 0, 0}, {1, 1e300, 1}, n, plane_rule::binary32)),
             Contains("axis 1: plane 0"));

  const std::vector<double> good{0, 1}, twice{0, 1, 1, 2}, bad{0, NAN}, none;
  const auto given = [&](const std::vector<double>& y) { return grid::make({good, y, good}); };
  CHECK_THAT(reason(given(twice)), Contains("axis 1: plane 2") && Contains("increasing order"));
  CHECK_THAT(reason(given(bad)), Contains("axis 1: plane 1"));
  CHECK_THAT(reason(given(none)), Contains("axis 1") && Contains("flat"));
  CHECK(given({5})->flat(1));

  CHECK_THAT(root_cube::make({{0.1, 0.1, 0.1}, 0.1}, 20).reason(),
             Contains("use graze::octree::grid"));
}
