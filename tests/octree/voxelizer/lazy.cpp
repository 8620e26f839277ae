// The lazy octree: the leaves of the eager one, evaluated only where rays look.
#include "../surface_judge.hpp"
#include "../surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <graze/octree/descent.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/lazy_octree.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <thread>
#include <xmmintrin.h>

using namespace graze;
using namespace graze::octree;

namespace {

using method = sound<rounding::upward, convention::owned>;

struct seen_leaf {
  cube cell;
  content kind;
  friend bool operator==(const seen_leaf&, const seen_leaf&) = default;
};

/// All leaves on each of the rays, in order.
template <class T> std::vector<seen_leaf> leaves_on(const T& tree, const std::vector<ray>& rays) {
  std::vector<seen_leaf> seen;
  const method::scope scope;
  for (const ray& r : rays)
    descend(method(r), tree.root_octant(), tree.level(), tree,
            [&](const cube& cell, const auto& n, const auto&) {
              seen.push_back({cell, tree.leaf(n)});
              return false;
            });
  return seen;
}

/// Keeps everything, if it is asked within its scope.
struct judge_of_modes {
  using scope = rounding::upward::scope;
  using octant = cube;
  static bool rounds_up() { return (_mm_getcsr() & 0x6000) == 0x4000; }
  std::uint8_t open(const cube&) const { return rounds_up() ? 0xff : 0; }
  leaf_children leaves(const cube&) const {
    return rounds_up() ? leaf_children{0xff, 0x0f} : leaf_children{};
  }
};

std::vector<ray> random_rays(double reach, int count) {
  judge::random_source random(17);
  std::vector<ray> rays;
  while (static_cast<int>(rays.size()) < count) {
    vec3 o, d;
    for (int a = 0; a < 3; ++a) {
      o[a] = random.in(-2 * reach, 2 * reach);
      d[a] = random.below(9) == 0 ? 0 : random.in(-1, 1);
    }
    if (const auto r = ray::make(o, d))
      rays.push_back(*r);
  }
  return rays;
}

} // namespace

TEST_CASE("octree.lazy: rays meet the eager octree's leaves, in order", "[property]") {
  scenes::for_each([](const auto& scene) {
    using surface = std::decay_t<decltype(scene.surface)>;
    for (const int level : {1, 2, 8}) {
      const auto root = enclosing_root(scene.domain(), level);
      const lane_judge<surface> judge(scene.surface, scene.domain());
      const auto eager = voxelize_by(judge, *root);
      REQUIRE(eager);
      const lazy_octree<lane_judge<surface>> lazy(judge, *root);
      const auto rays = random_rays(scene.reach, 300);
      const auto expected_leaves = leaves_on(*eager, rays);
      CHECK(expected_leaves.size() > 100);
      CHECK(leaves_on(lazy, rays) == expected_leaves);
      const std::size_t decided = lazy.decided_count();
      CHECK(leaves_on(lazy, rays) == expected_leaves); // from what is remembered
      CHECK(lazy.decided_count() == decided);
      if (level == 8)
        CHECK(decided < eager->node_count() / 2);
    }
  });
}

TEST_CASE("octree.lazy: the judge is asked in its own scope, the caller's mode stays", "[unit]") {
  const lazy_octree<judge_of_modes> lazy(judge_of_modes{}, *root_cube::make({{0, 0, 0}, 1}, 2));
  const unsigned before = _mm_getcsr();
  CHECK(lazy.child_mask(lazy.root(), lazy.root_octant(), 0x7f) == 0x7f);
  const auto child = lazy.child(lazy.root(), 5);
  CHECK(lazy.child_mask(child, lazy.root_octant().child(5), 0xff) == 0xff);
  CHECK(lazy.leaf(lazy.child(child, 3)) == content::certified);
  CHECK(lazy.leaf(lazy.child(child, 4)) == content::possible);
  CHECK(_mm_getcsr() == before);
}

TEST_CASE("octree.lazy: threads share one", "[property]") {
  const tanglecube f;
  const box domain{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}};
  const auto root = enclosing_root(domain, 9);
  const lane_judge<tanglecube> judge(f, domain);
  const auto eager = voxelize_by(judge, *root);
  const auto rays = random_rays(2.5, 2000);
  const auto expected_leaves = leaves_on(*eager, rays);
  const lazy_octree<lane_judge<tanglecube>> lazy(judge, *root);
  std::vector<std::vector<seen_leaf>> seen(4);
  std::vector<std::thread> threads;
  for (auto& s : seen)
    threads.emplace_back([&] { s = leaves_on(lazy, rays); });
  for (std::thread& t : threads)
    t.join();
  for (const auto& s : seen)
    CHECK(s == expected_leaves);
}

TEST_CASE("octree.lazy: first hits are those of the eager octree", "[property]") {
  scenes::for_each([](const auto& scene) {
    using surface = std::decay_t<decltype(scene.surface)>;
    using judge_type = lane_judge<surface>;
    const auto root = enclosing_root(scene.domain(), 7);
    const judge_type judge(scene.surface, scene.domain());
    const auto eager = voxelize_by(judge, *root);
    REQUIRE(eager);
    for (const int level : {7, 12, 30}) {
      const lazy_octree<judge_type> lazy(judge, *root);
      const auto known =
          surface_traversal<surface>::make(scene.surface, scene.domain(), *eager, level);
      const auto found =
          surface_traversal<surface, method, rounding::upward, lazy_octree<judge_type>>::make(
              scene.surface, scene.domain(), lazy, level);
      REQUIRE(known);
      REQUIRE(found);
      long wrong = 0, hits = 0;
      for (int j = 3; j < 512; j += 23)
        for (int i = 5; i < 512; i += 23) {
          const ray r = scene.pixel(i, j);
          const surface_hit a = known->first_hit(r), b = found->first_hit(r);
          wrong += a.outcome != b.outcome || a.t_near != b.t_near || a.t_far != b.t_far ||
                   !(a.leaf == b.leaf) || a.certified_leaf != b.certified_leaf;
          hits += a.outcome == verdict::hit;
        }
      CHECK(wrong == 0);
      CHECK(hits > 20);
      CHECK(lazy.decided_count() < eager->node_count());
    }
  });
}
