// The paths and the scalar code agree on every verdict: which children a ray passes and in which
// order, which of them a surface is proven not to meet, first hits, and whole octrees.
#include "../../support/test_inputs.hpp"
#include "../surface_judge.hpp"
#include "../surface_scenes.hpp"
#include "walk_by.hpp"
#include <catch2/catch.hpp>
#include <cstdio>
#include <graze/fuzz/generators.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/voxelizer.hpp>

using namespace graze;
using namespace graze::test;
using namespace graze::octree;

namespace {

const path_under_test& walks_of(batch::path p) {
#if defined(__x86_64__)
  if (p == batch::path::avx2)
    return avx2_walks;
  if (p == batch::path::avx512)
    return avx512_walks;
#endif
  return baseline_walks;
}

/// Calls check(path) for each path that runs here, and names the others.
template <class Check> void for_each_path(Check check) {
  for (const batch::path p : batch::paths)
    if (const auto reason = batch::refusal(p))
      std::printf("graze: skipped, path %s: %s\n", batch::name(p), reason->c_str());
    else
      check(p);
}

template <convention C> trail scalar_walk(const ray& r, const way& w) {
  return walk<sound<rounding::upward, C>>(r, w);
}

bool same(const surface_hit& a, const surface_hit& b) {
  return a.outcome == b.outcome && a.t_near == b.t_near && a.t_far == b.t_far && a.leaf == b.leaf &&
         a.certified_leaf == b.certified_leaf;
}

bool same(const sparse_octree& a, const sparse_octree& b) {
  if (a.node_count() != b.node_count() || a.leaf_count() != b.leaf_count() || !(a.box() == b.box()))
    return false;
  for (sparse_octree::node n = 0; n < a.node_count(); ++n)
    if (a.child_mask(n, a.box(), 0xff) != b.child_mask(n, a.box(), 0xff) ||
        a.child(n, 0) != b.child(n, 0))
      return false;
  for (sparse_octree::node n = 0; n < a.leaf_count(); ++n)
    if (a.leaf(n) != b.leaf(n))
      return false;
  return true;
}

} // namespace

TEST_CASE("octree.lanes: children passed and their order are the scalar method's on every path",
          "[property]") {
  const auto rays_a_level = static_cast<std::uint64_t>(std::max(1l, test::input_count() / 800));
  const cube roots[] = {{{0, 0, 0}, 1}, {{-4, -4, -4}, 8}, {{0x1p900, 0, -0x1p900}, 0x1p900}};
  for_each_path([&](batch::path p) {
    const path_under_test& lanes = walks_of(p);
    for (const fuzz::generator& g : fuzz::generators()) {
      long wrong = 0, steps = 0;
      for (int level = 1; level <= 50; ++level)
        for (std::uint64_t i = 0; i < rays_a_level; ++i) {
          const fuzz::trial t = fuzz::make_trial(g, 4, i, level, roots[i % 3]);
          const way w{t.root, level, t.base, 0x9e3779b97f4a7c15u * (i + 1)};
          const ray r = *ray::make(t.origin, t.direction);
          const trail closed = scalar_walk<convention::closed>(r, w);
          wrong += !(lanes.closed(r, w) == closed);
          wrong += !(lanes.owned(r, w) == scalar_walk<convention::owned>(r, w));
          steps += closed.steps;
        }
      INFO(batch::name(p) << ", rays of " << g.name << ", " << steps << " octants");
      CHECK(steps > 0);
      CHECK(wrong == 0);
    }
  });
}

TEST_CASE("octree.lanes: children without a zero, and corners' signs, are the scalar code's on "
          "every path",
          "[property]") {
  using B = rounding::upward;
  for_each_path([&](batch::path p) {
    judge::random_source random(26);
    long wrong = 0, none = 0;
    for (int round = 0; round < 30'000; ++round) {
      const int level = static_cast<int>(random.below(49));
      const root_cube root = *root_cube::make({{-4, -4, -4}, 8}, level + 2);
      // at a surface, where the verdicts are close: on the axis of the diagonal, by bisection
      cube cell = root.box();
      const auto surface = random.below(surface_count);
      for (int k = 0; k < level; ++k) {
        cell = cell.child(static_cast<unsigned>(random.below(8)));
        if (k >= 2 && surface != 0) { // towards a child that may have a zero
          const inclusions at = baseline_walks.inclusion(cell);
          const unsigned left = ~at.none[surface - 1] & 0xffu;
          if (left != 0 && ++k < level)
            cell = cell.child(static_cast<unsigned>(std::countr_zero(left)));
        }
      }
      const inclusions found = walks_of(p).inclusion(cell);
      const B::scope scope;
      std::size_t s = 0;
      const auto check = [&](const auto& f) {
        for (unsigned i = 0; i < 8; ++i) {
          const bool free = has_no_zero<B>(f, closed_box(cell.child(i)));
          const int sign = certified_sign_at<B>(f, closed_box(cell).corner(i));
          wrong += ((found.none[s] >> i & 1) != 0) != free;
          wrong += ((found.positive[s] >> i & 1) != 0) != (sign > 0);
          wrong += ((found.negative[s] >> i & 1) != 0) != (sign < 0);
          none += free;
        }
        ++s;
      };
      check(spheres{});
      check(quartdef{});
      check(tanglecube{});
      check(holesrot{});
      check(loose_surface{});
    }
    INFO(batch::name(p));
    CHECK(none > 1000);
    CHECK(wrong == 0);
  });
}

TEST_CASE("octree.lanes: octrees are those of voxelize on every path, cut domains too",
          "[property]") {
  for_each_path([&](batch::path p) {
    scenes::for_each([&](const auto& scene) {
      using F = std::remove_cvref_t<decltype(scene.surface)>;
      const box domains[] = {scene.domain(),
                             {{-1.3, -0.7, -2}, {1.1, 1.9, 0.3}},
                             {{0.1, 0.1, 0.1}, {0.1, 1.5, 1.5}},
                             {{0, 0, 0}, {1, 1, 1}}};
      for (const box& domain : domains)
        for (int level = 1; level <= 7; ++level) {
          const auto wanted = voxelize(F{}, domain, level);
          const auto found = voxelize_in_lanes(F{}, domain, level, p);
          REQUIRE(wanted);
          REQUIRE(found);
          INFO(batch::name(p) << " level " << level);
          CHECK(same(*wanted, *found));
        }
      CHECK_FALSE(voxelize_in_lanes(F{}, box{{1, 0, 0}, {0, 1, 1}}, 4, p));
    });
  });
}

TEST_CASE("octree.lanes: first hits are those of surface_traversal on every path", "[property]") {
  scenes::for_each([&](const auto& scene) {
    using F = std::remove_cvref_t<decltype(scene.surface)>;
    const auto octree = voxelize(F{}, scene.domain(), 6);
    REQUIRE(octree);
    std::vector<ray> rays;
    for (int j = 1; j < 512; j += 17)
      for (int i = 2; i < 512; i += 17)
        rays.push_back(scene.pixel(i, j));
    for (const fuzz::generator& g : fuzz::generators())
      for (std::uint64_t i = 0; i < 40; ++i) {
        const fuzz::trial t = fuzz::make_trial(g, 7, i, 1 + static_cast<int>(i), octree->box());
        rays.push_back(*ray::make(t.origin, t.direction));
      }
    for (const int level : {5, 6, 7, 20, 30, 50}) {
      const auto stored = level < 6 ? voxelize(F{}, scene.domain(), level) : octree;
      const auto scalar = surface_traversal<F>::make(F{}, scene.domain(), *stored, level);
      REQUIRE(scalar);
      for_each_path([&](batch::path p) {
        const auto lanes = lane_traversal<F>::make(F{}, scene.domain(), *stored, level, p);
        REQUIRE(lanes);
        long wrong = 0;
        traversal_counts expected_counts, counts;
        for (const ray& r : rays)
          wrong += !same(lanes->first_hit(r, &counts), scalar->first_hit(r, &expected_counts));
        traversal_counts batch_counts;
        std::vector<surface_hit> hits(rays.size());
        lanes->first_hits(rays, hits, &batch_counts);
        for (std::size_t i = 0; i < rays.size(); ++i)
          wrong += !same(hits[i], scalar->first_hit(rays[i]));
        CHECK(batch_counts.cells_opened == expected_counts.cells_opened);
        CHECK(batch_counts.leaves_kept == expected_counts.leaves_kept);
        INFO(batch::name(p) << " level " << level);
        CHECK(wrong == 0);
        CHECK(counts.cells_opened == expected_counts.cells_opened);
        CHECK(counts.leaves_kept == expected_counts.leaves_kept);
      });
    }
    CHECK_FALSE(lane_traversal<F>::make(F{}, scene.domain(), *octree, 60));
  });
}
