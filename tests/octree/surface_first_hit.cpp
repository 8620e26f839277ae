// First hits judged exactly: the polynomial along each ray over rationals, its roots by Sturm.
#include "../support/exact_roots.hpp"
#include "surface_judge.hpp"
#include "surface_rays.hpp"
#include "surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/rounding/nearest.hpp>
#include <peers/paper2005/gargantini.hpp>
#include <peers/paper2005/plain.hpp>
#include <peers/paper2005/published.hpp>
#include <string>

using namespace graze;
using namespace graze::octree;
using namespace graze::peers;

namespace {

struct tally {
  int rays = 0, hits = 0, undecided = 0, wrong = 0;
  std::string first_wrong;
};

/// Whether `h` says the truth about the ray; "" or what is wrong.
template <class F>
std::string untruth(const F& f, const box& domain, const ray& r, const surface_hit& h) {
  const auto root = support::first_root(f, r, domain);
  if (h.outcome == verdict::miss)
    return root ? "a root, reported as a miss" : "";
  if (h.outcome == verdict::hit && !root)
    return "no root, reported as a hit";
  if (root && root->hi < mpq_class(h.t_near))
    return "a root before the enclosure";
  if (root && mpq_class(h.t_far) < root->lo)
    return "the first root is after the enclosure";
  return "";
}

template <class S>
tally examine(const S& scene, int level, const std::vector<ray>& rays, double widest) {
  const auto octree = voxelize(scene.surface, scene.domain(), 7);
  REQUIRE(octree);
  const auto traversal = surface_traversal<decltype(scene.surface)>::make(
      scene.surface, scene.domain(), *octree, level);
  REQUIRE(traversal);
  tally t;
  for (const ray& r : rays) {
    const surface_hit h = traversal->first_hit(r);
    ++t.rays;
    t.hits += h.outcome == verdict::hit;
    t.undecided += h.outcome == verdict::undecided;
    std::string why = untruth(scene.surface, scene.domain(), r, h);
    if (why.empty() && h.outcome == verdict::hit && !(h.t_far - h.t_near <= widest))
      why = "enclosure is wide";
    if (why.empty())
      continue;
    if (t.wrong++ == 0) {
      char text[400];
      std::snprintf(text, sizeof text, "%s: o=(%a,%a,%a) d=(%a,%a,%a) outcome %d t=[%a,%a]",
                    why.c_str(), r.origin()[0], r.origin()[1], r.origin()[2], r.direction()[0],
                    r.direction()[1], r.direction()[2], static_cast<int>(h.outcome), h.t_near,
                    h.t_far);
      t.first_wrong = text;
    }
  }
  return t;
}

template <class S> std::vector<ray> pixels(const S& scene) {
  std::vector<ray> rays;
  for (int j = 3; j < 512; j += 11)
    for (int i = 5; i < 512; i += 11)
      rays.push_back(scene.pixel(i, j));
  return rays;
}

} // namespace

TEST_CASE("octree.surface_traversal: the depth encloses the exact first root, camera rays",
          "[property][exact]") {
  scenes::for_each([](const auto& scene) {
    for (const int level : {30, 50, 53}) {
      // the longest part of a ray within an octant is a few octants of the level, or the rounding
      const tally t = examine(scene, level, pixels(scene), level == 30 ? 0x1p-24 : 0x1p-38);
      INFO("level " << level << ", reach " << scene.reach << ": " << t.first_wrong);
      CHECK(t.rays >= 1000);
      CHECK(t.wrong == 0);
      CHECK(t.hits > 300);
      CHECK(t.undecided == 0);
    }
  });
}

TEST_CASE("octree.surface_traversal: the depth encloses the exact first root, awkward rays",
          "[property][exact]") {
  scenes::for_each([](const auto& scene) {
    for (const int level : {12, 30, 50}) {
      const tally t = examine(scene, level, scenes::awkward(scene, false), 1e300);
      INFO("level " << level << ", reach " << scene.reach << ": " << t.first_wrong);
      CHECK(t.wrong == 0);
      CHECK(t.hits > 100);
      CHECK(t.undecided < t.rays / 20);
    }
  });
}

TEST_CASE("octree.surface_traversal: rays from inside the domain", "[property][exact]") {
  scenes::for_each_from_inside([](const auto& scene) {
    const tally t = examine(scene, 30, scenes::awkward(scene, true), 1e300);
    INFO("reach " << scene.reach << ": " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.hits > 100);
    CHECK(t.undecided < t.rays / 20);
  });
}

TEST_CASE("octree.surface_traversal: a tangent ray is never a miss", "[hardcase][exact]") {
  const auto& scene = scenes::scene_of<spheres>;
  for (const int level : {9, 30, 50}) {
    const auto octree = voxelize(scene.surface, scene.domain(), 7);
    const auto traversal =
        surface_traversal<spheres>::make(scene.surface, scene.domain(), *octree, level);
    for (const double direction : {1.0, -1.0, 0x1p-300, 3.0}) {
      const ray r =
          *ray::make({direction > 0 ? -3.0 : 3.0, 1, 0}, {direction, 0, 0}); // touches at (0,1,0)
      const surface_hit h = traversal->first_hit(r);
      INFO("level " << level << " direction " << direction);
      CHECK(h.outcome == verdict::undecided); // a double root changes no sign
      CHECK(untruth(scene.surface, scene.domain(), r, h) == "");
    }
  }
}

TEST_CASE("octree.surface_traversal: the caller's control words are restored, flushing is not used",
          "[unit]") {
  const auto& scene = scenes::scene_of<tanglecube>;
  const auto octree = voxelize(scene.surface, scene.domain(), 5);
  const auto traversal =
      surface_traversal<tanglecube>::make(scene.surface, scene.domain(), *octree, 30);
  const surface_hit plain = traversal->first_hit(scene.pixel(256, 256));
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  const surface_hit flushed = traversal->first_hit(scene.pixel(256, 256));
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  CHECK((after & ~0x3fu) == ((before | 0x8040) & ~0x3fu));
  CHECK(flushed.t_near == plain.t_near);
  CHECK(flushed.t_far == plain.t_far);
}

TEMPLATE_TEST_CASE("octree.surface_traversal: runs with the baselines too", "[unit]", published,
                   plain, gargantini) {
  const auto& scene = scenes::scene_of<tanglecube>;
  const auto octree = voxelize(scene.surface, scene.domain(), 7);
  const auto ours = surface_traversal<tanglecube>::make(scene.surface, scene.domain(), *octree, 20);
  const auto theirs = surface_traversal<tanglecube, TestType, rounding::nearest>::make(
      scene.surface, scene.domain(), *octree, 20);
  int different = 0, rays = 0;
  for (const ray& r : pixels(scene)) {
    ++rays;
    different += ours->first_hit(r).outcome != theirs->first_hit(r).outcome;
  }
  CHECK(different < rays / 50); // at level 20 they rarely differ
}

TEST_CASE("octree.surface_traversal: refuses what it cannot do", "[unit]") {
  const auto& scene = scenes::scene_of<holesrot>;
  const auto octree = voxelize(scene.surface, scene.domain(), 4);
  REQUIRE(octree);
  using traversal = surface_traversal<holesrot>;
  CHECK_FALSE(traversal::make(scene.surface, scene.domain(), *octree, 0));
  CHECK_FALSE(traversal::make(scene.surface, scene.domain(), *octree, 54));
  CHECK(traversal::make(scene.surface, scene.domain(), *octree, 53));
}
