// Surfaces on which the lanes and the scalar code once differed.
#include "../../support/formulas.hpp"
#include "../../support/paths.hpp"
#include <catch2/catch.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;
using support::parsed;

namespace {

void same_leaves(const char* text, const box& domain, std::size_t leaves) {
  const formula f = parsed(text);
  const auto scalar = voxelize(f.surface(), domain, 5);
  REQUIRE(scalar);
  CHECK(scalar->leaf_count() == leaves);
  test::for_each_path([&](batch::path p) {
    const auto by_lanes = voxelize_in_lanes(f.surface(), domain, 5, p);
    REQUIRE(by_lanes);
    CHECK(by_lanes->leaf_count() == leaves);
    CHECK(*by_lanes == *scalar);
  });
}

} // namespace

// Half of 2^-1074, rounded up, is 2^-1074: the centre of a flat box lay outside of it.
TEST_CASE("octree.twins: a box that is flat at 2^-1074 has 48 leaves on every path",
          "[regression]") {
  same_leaves("(x*2^1000-1/2^74)^2*2^148 + y*z + y - z/2 - 1/10",
              {{0x1p-1074, -1, -1}, {0x1p-1074, 1, 1}}, 48);
}

TEST_CASE("octree.twins: a box from 2^-1074 to 2^-1070 has 608 leaves on every path",
          "[regression]") {
  same_leaves("(x*2^1000-1/2^74)^2*2^148 + y*2^1000 - z*2^999 + y*z",
              {{0x1p-1074, -0x1p-1070, -0x1p-1070}, {0x1p-1070, 0x1p-1070, 0x1p-1070}}, 608);
}

// (x - 1/2)^3 + 2^-54: the value at a point was widened by the turns beside it.
TEST_CASE("octree.twins: a point beside a turn of a polynomial is as tight on every path",
          "[regression]") {
  const formula f = parsed("x^3-1.5*x^2+0.75*x-1/8+1/2^54");
  const box domain{{-1, -1, -1}, {2, 1, 1}};
  std::vector<ray> rays;
  for (int i = 0; i < 4000; ++i) {
    const double a = std::ldexp(i - 2000, -12), b = std::ldexp((i * 577) % 4000 - 2000, -12);
    rays.push_back(i % 4 == 0 ? *ray::make({-2, a, b}, {1, 0, 0})
                              : *ray::make({-2, a, b}, {1, b / 8, -a / 8}));
  }
  const auto scalar = certified_traversal<formula_surface>::make(f.surface(), domain);
  REQUIRE(scalar);
  std::vector<certified_hit> wanted;
  long wrong = 0;
  for (const ray& r : rays) {
    wanted.push_back(scalar->first_hit(r));
    const certified_hit& h = wanted.back();
    constexpr double root = 2.5 - 0x1p-18; // in t on every ray
    wrong += h.outcome != verdict::hit || !(h.t_near <= root && root <= h.t_far) ||
             h.t_far - h.t_near > 0x1p-15;
  }
  CHECK(wrong == 0);
  test::for_each_path([&](batch::path p) {
    const auto by_lanes = lane_certified_traversal<formula_surface>::make(f.surface(), domain, p);
    REQUIRE(by_lanes);
    std::vector<certified_hit> hits(rays.size());
    by_lanes->first_hits(rays, hits);
    CHECK(std::equal(hits.begin(), hits.end(), wanted.begin()));
  });
}
