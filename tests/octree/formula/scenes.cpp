// The scenes' formulas typed as text: the octants of the built-in surfaces, on every path, and the
// same first hits.
#include "../../support/paths.hpp"
#include "../surface_judge.hpp"
#include "../surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <cstring>
#include <graze/octree/lazy_octree.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;
using judge::real;

namespace {

std::string text_of(const spheres&) {
  std::string text;
  for (const auto& s : spheres::parts) {
    char single[200];
    std::snprintf(single, sizeof single, "(x-(%g))^2+(y-(%g))^2+(z-(%g))^2-%g^2", s.centre[0],
                  s.centre[1], s.centre[2], s.radius);
    text += (text.empty() ? "union(" : ",") + std::string(single);
  }
  return text + ")";
}
template <class F> std::string text_of(const F&) { return built_in<F>.formula; }

template <class S> formula formula_of(const S& scene) {
  const auto f = formula::parse(text_of(scene.surface));
  INFO(f.reason());
  REQUIRE(f);
  return *f;
}

/// Octants of the last level that `finer` has and `coarser` lacks.
std::size_t lost(const sparse_octree& finer, sparse_octree::node n, const sparse_octree& coarser,
                 sparse_octree::node m, int level, std::size_t& leaves) {
  if (level == finer.level()) {
    ++leaves;
    return 0;
  }
  std::size_t r = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const auto bit = static_cast<std::uint8_t>(1u << i);
    if (finer.child_mask(n, finer.root_octant(), bit) == 0)
      continue;
    if (coarser.child_mask(m, coarser.root_octant(), bit) == 0)
      ++r;
    else
      r += lost(finer, finer.child(n, i), coarser, coarser.child(m, i), level + 1, leaves);
  }
  return r;
}

} // namespace

TEST_CASE("octree.formula: the scenes as text enclose MPFR's values as the built-in ones do",
          "[property][mpfr]") {
  scenes::for_each([](const auto& scene) {
    const formula text = formula_of(scene);
    const formula_surface f = text.surface();
    CHECK(f.continuous());
    CHECK(f.natural_extension_suffices());
    judge::random_source random(7);
    int wrong = 0, wider = 0;
    for (int i = 0; i < 4000; ++i) {
      box b;
      for (int a = 0; a < 3; ++a) {
        b.lo[a] = random.in(-scene.reach, scene.reach);
        b.hi[a] = b.lo[a] + std::ldexp(random.in(0, 1), -static_cast<int>(random.below(53)));
      }
      const rounding::upward::scope scope;
      const auto x = intervals<rounding::upward>(b);
      const auto v = natural_extension<rounding::upward>(f, x),
                 built_in = natural_extension<rounding::upward>(scene.surface, x);
      vec3 p;
      for (int a = 0; a < 3; ++a)
        p[a] = std::clamp(random.in(b.lo[a], b.hi[a]), b.lo[a], b.hi[a]);
      const real exact = scene.surface(real(p[0]), real(p[1]), real(p[2]));
      wrong += !(real(v.lower()) <= exact && exact <= real(v.upper()));
      // a few roundings of numbers of the size of the domain
      wider += v.lower() < built_in.lower() - 0x1p-44 || v.upper() > built_in.upper() + 0x1p-44;
    }
    CHECK(wrong == 0);
    CHECK(wider == 0);
  });
}

TEST_CASE("octree.formula: the scenes as text keep the built-in octants, and hardly others",
          "[property]") {
  scenes::for_each([](const auto& scene) {
    constexpr int level = 8;
    const formula text = formula_of(scene);
    const auto built_in = voxelize_in_lanes(scene.surface, scene.domain(), level);
    const auto typed = voxelize_in_lanes(text.surface(), scene.domain(), level);
    REQUIRE(built_in);
    REQUIRE(typed);
    std::size_t common = 0;
    CHECK(lost(*built_in, built_in->root(), *typed, typed->root(), 0, common) == 0);
    INFO(text_of(scene.surface).substr(0, 40)
         << ": " << typed->leaf_count() << " octants, built-in " << built_in->leaf_count());
    CHECK(typed->leaf_count() <= built_in->leaf_count() + built_in->leaf_count() / 1000);
  });
}

TEST_CASE("octree.formula: first hits are the built-in ones, on every path and lazily",
          "[property]") {
  scenes::for_each([](const auto& scene) {
    const formula text = formula_of(scene);
    const formula_surface f = text.surface();
    constexpr int level = 30;
    const auto octree = voxelize_in_lanes(scene.surface, scene.domain(), 7);
    const auto typed = voxelize_in_lanes(f, scene.domain(), 7);
    REQUIRE(octree);
    REQUIRE(typed);
    const auto expected_hits = surface_traversal<std::decay_t<decltype(scene.surface)>>::make(
        scene.surface, scene.domain(), *octree, level);
    const auto scalar = surface_traversal<formula_surface>::make(f, scene.domain(), *typed, level);
    REQUIRE(scalar);
    int hits = 0, different = 0, unequal = 0;
    for (int j = 5; j < 512; j += 23)
      for (int i = 3; i < 512; i += 23) {
        const ray r = scene.pixel(i, j);
        const surface_hit a = expected_hits->first_hit(r), b = scalar->first_hit(r);
        hits += b.outcome == verdict::hit;
        different += a.outcome != b.outcome ||
                     (a.outcome == verdict::hit && (a.t_far < b.t_near || b.t_far < a.t_near));
        test::for_each_path([&](batch::path p) {
          const auto by_lanes =
              lane_traversal<formula_surface>::make(f, scene.domain(), *typed, level, p);
          REQUIRE(by_lanes);
          const surface_hit c = by_lanes->first_hit(r);
          unequal += c.outcome != b.outcome || !(c.t_near == b.t_near) || !(c.t_far == b.t_far);
        });
      }
    CHECK(hits > 100);
    CHECK(different == 0);
    CHECK(unequal == 0);
  });
}

TEST_CASE("octree.formula: a ray beside a ruling is given up after as many octants on every path",
          "[unit]") {
  const auto f = formula::parse("x^2+y^2-z^2");
  REQUIRE(f);
  const box domain{{-1, -1, -1}, {1, 1, 1}};
  const auto octree = voxelize(f->surface(), domain, 5);
  REQUIRE(octree);
  const auto scalar =
      surface_traversal<formula_surface>::make(f->surface(), domain, *octree, max_level);
  REQUIRE(scalar);
  // outside of the cone, and so near to it that 2^24 octants and more may hold a zero
  const ray beside = *ray::make({0.125, 0, 0.125 - 0x1p-30}, {1, 0, 1});
  const ray across = *ray::make({0, 0, 2}, {0.25, 0, -1});
  const ray rays[] = {beside, across, beside};
  traversal_counts counts;
  const surface_hit wanted = scalar->first_hit(beside, &counts), other = scalar->first_hit(across);
  CHECK(wanted.outcome == verdict::undecided);
  CHECK(counts.cells_opened == most_cells_opened);
  CHECK(other.outcome == verdict::hit);
  test::for_each_path([&](batch::path p) {
    const auto by_lanes =
        lane_traversal<formula_surface>::make(f->surface(), domain, *octree, max_level, p);
    REQUIRE(by_lanes);
    traversal_counts single, three;
    surface_hit found[3];
    const surface_hit alone = by_lanes->first_hit(beside, &single);
    by_lanes->first_hits(rays, found, &three);
    for (const surface_hit& h : {alone, found[0], found[2]}) {
      CHECK(h.outcome == wanted.outcome);
      CHECK(h.t_near == wanted.t_near);
      CHECK(h.t_far == wanted.t_far);
    }
    CHECK(found[1].outcome == other.outcome);
    CHECK(found[1].t_near == other.t_near);
    CHECK(single.cells_opened == counts.cells_opened);
    CHECK(single.leaves_kept == counts.leaves_kept);
    CHECK(three.cells_opened > 2 * counts.cells_opened);
  });
}
