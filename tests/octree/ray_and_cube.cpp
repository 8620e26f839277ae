#include <catch2/catch.hpp>
#include <graze/octree/cube.hpp>
#include <graze/octree/exact_touch.hpp>
#include <graze/octree/ray.hpp>
#include <limits>

using namespace graze::octree;

namespace {
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST_CASE("octree.ray: refuses what is not a ray, with the reason", "[unit]") {
  CHECK(ray::make({not_a_number, 0, 0}, {1, 0, 0}).reason() == "ray origin is not finite");
  CHECK(ray::make({0, inf, 0}, {1, 0, 0}).reason() == "ray origin is not finite");
  CHECK(ray::make({0, 0, 0}, {1, 0, not_a_number}).reason() == "ray direction is not finite");
  CHECK(ray::make({0, 0, 0}, {1, -inf, 0}).reason() == "ray direction is not finite");
  CHECK(ray::make({0, 0, 0}, {0, -0.0, 0}).reason() == "ray direction is zero");
  CHECK(ray::make({1e308, -5e-324, 0}, {5e-324, 0, 0}).has_value());
}

#if defined(__x86_64__)
TEST_CASE("octree.ray: a subnormal direction is none but zero where numbers are flushed",
          "[regression]") {
  namespace hardware = graze::rounding::hardware;
  const unsigned found = hardware::mxcsr();
  hardware::set_mxcsr(0x9fc0); // FTZ and DAZ
  const auto r = ray::make({.25, .25, 0}, {0x1p-1074, 0x1p-1074, 0x1p-1074});
  const bool met = r && touches(*r, {{0, 0, 0}, 1}), owned = r && owns(*r, {{.25, .25, 0}, .25});
  hardware::set_mxcsr(found);
  CHECK(r);
  CHECK(met);
  CHECK(owned);
}
#endif

TEST_CASE("octree.root_cube: exact to level 53 on powers of two, refused at 54", "[unit]") {
  for (const cube& box : {cube{{0, 0, 0}, 1}, cube{{0, 0, 0}, 0x1p60}, cube{{-4, -4, -4}, 8},
                          cube{{0, 0, 0}, 0x1p-1021}, cube{{-0x1p1022, 0, 0}, 0x1p1023}}) {
    CHECK(root_cube::make(box, 53).has_value());
    CHECK_FALSE(root_cube::make(box, 54).has_value());
    CHECK_FALSE(root_cube::make(box, 0).has_value());
  }
}

TEST_CASE("octree.root_cube: refuses a root whose octants would have rounded corners", "[unit]") {
  CHECK(root_cube::make({{-2.5, -2.5, -2.5}, 5}, 51).has_value());
  CHECK_FALSE(root_cube::make({{-2.5, -2.5, -2.5}, 5}, 52).has_value());
  CHECK_FALSE(root_cube::make({{0.1, 0.1, 0.1}, 1}, 1).has_value());
  CHECK_FALSE(root_cube::make({{1, 1, 1}, 0x1p-53}, 1).has_value()); // the far corner is rounded
  CHECK_FALSE(root_cube::make({{0, 0, 0}, 0x1p-1023}, 53).has_value());
  CHECK_FALSE(root_cube::make({{0, 0, 0}, 0}, 9).has_value());
  CHECK_FALSE(root_cube::make({{0, 0, 0}, -1}, 9).has_value());
  CHECK_FALSE(root_cube::make({{0, 0, not_a_number}, 1}, 9).has_value());
  CHECK_FALSE(root_cube::make({{0x1p1023, 0, 0}, 0x1p1023}, 9).has_value());
}

TEST_CASE("octree.cube: a path of children gives the octant of the index, exactly", "[unit]") {
  // on [-3,3]^3 at level 52 lo + index * size is not the corner for half of the far indices
  const auto [box, deepest] =
      GENERATE(std::pair{cube{{-2, -2, -2}, 4}, 53}, std::pair{cube{{-3, -3, -3}, 6}, 52});
  const auto root = root_cube::make(box, deepest);
  REQUIRE(root);
  std::uint64_t bits = 0x9e3779b97f4a7c15u;
  for (int path = 0; path < 100; ++path) {
    std::array<std::uint64_t, 3> index{};
    cube cell = root->root_octant();
    REQUIRE(cell == root->octant(index, 0));
    for (int level = 1; level <= deepest; ++level) {
      bits ^= bits << 13, bits ^= bits >> 7, bits ^= bits << 17;
      const unsigned child = bits & 7;
      cell = cell.child(child);
      for (unsigned a = 0; a < 3; ++a)
        index[a] = 2 * index[a] + (child >> a & 1);
      REQUIRE(cell == root->octant(index, level));
      for (int a = 0; a < 3; ++a)
        REQUIRE(cell.hi(a) - cell.lo[a] == cell.size);
    }
  }
}
