#include <catch2/catch.hpp>
#include <graze/oracle/geometry.hpp>
#include <judge.hpp>
#include <rays.hpp>

namespace {
using namespace graze::bench;

std::vector<touched_octant> one_by_one(const occupied_octants& octants,
                                       const graze::octree::ray& r) {
  std::vector<touched_octant> found;
  const auto root = *graze::octree::root_cube::make(octants.root, octants.level);
  for (const octant_index& v : octants.indices) {
    const auto c = root.octant({v[0], v[1], v[2]}, octants.level);
    const graze::octree::vec3 hi{c.hi(0), c.hi(1), c.hi(2)};
    if (graze::oracle::touches(r.origin(), r.direction(), c.lo, hi))
      found.push_back(
          {graze::peers::key_of(v), graze::oracle::crosses(r.origin(), r.direction(), c.lo, hi)});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  return found;
}
} // namespace

TEST_CASE("bench.judge: its octree finds the voxels that a search of all of them finds",
          "[property]") {
  const occupied_octants octants = sphere_shell(4);
  const exact_octants exact(octants);
  std::vector<graze::octree::ray> rays = random_rays(200, 1);
  for (const precision p : {precision::single, precision::twice})
    for (const auto& r : adversarial_rays(octants, p, 300, 2))
      rays.push_back(r);
  std::size_t grazed = 0;
  for (const auto& r : rays) {
    const auto is = exact.touched(r), should = one_by_one(octants, r);
    REQUIRE(is.size() == should.size());
    for (std::size_t i = 0; i < is.size(); ++i) {
      CHECK(is[i].key == should[i].key);
      CHECK(is[i].crossed == should[i].crossed);
      grazed += is[i].crossed ? 0 : 1;
    }
  }
  CHECK(grazed > 1000); // the rays are adversarial: faces, edges and vertices alone
}

TEST_CASE("bench.judge: counts misses, gaps, spurious voxels and doubles", "[unit]") {
  verdict v;
  std::vector<octant_key> found{9, 2, 9, 2, 2};
  v.add({{1, true}, {2, true}, {3, false}}, found);
  CHECK(v.missed == 2);
  CHECK(v.gaps == 1);
  CHECK(v.spurious == 1);
  CHECK(v.doubles == 3);
  CHECK(v.bad_rays == 1);
  CHECK(v.touched == 3);
  CHECK(v.crossed == 2);
}

TEST_CASE("bench.rays: those in single precision are, and the shell has 790,520 voxels at level 9",
          "[unit]") {
  const occupied_octants octants = sphere_shell(6);
  auto rays = random_rays(300, 3);
  for (const auto& r : adversarial_rays(octants, precision::single, 300, 4))
    rays.push_back(r);
  for (const auto& r : rays)
    for (unsigned a = 0; a < 3; ++a) {
      CHECK(static_cast<double>(static_cast<float>(r.origin()[a])) == r.origin()[a]);
      CHECK(static_cast<double>(static_cast<float>(r.direction()[a])) == r.direction()[a]);
    }
  CHECK(sphere_shell(9).indices.size() == 790520);
}
