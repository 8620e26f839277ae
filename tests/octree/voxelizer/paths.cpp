// The voxelizer on several threads: the bytes of one.
#include "../surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/parallel_voxelizer.hpp>

using namespace graze;
using namespace graze::octree;

namespace {

/// Domains with octants that they cut, and with far and small surfaces.
template <class Scene> std::vector<box> domains(const Scene& scene) {
  const double r = scene.reach;
  return {scene.domain(),
          {{-r / 3, -r, 0.1}, {r, r / 7, r}},
          {{-1024, -1024, -1024}, {1024, 1024, 1024}},
          {{0.5, 0.25, -0.125}, {0.75, 0.5, 2}},
          {{4 * r, 4 * r, 4 * r}, {5 * r, 5 * r, 5 * r}}};
}

struct plane { // x = 0, a face of octants at every level
  template <class N> N operator()(const N& x, const N&, const N&) const { return x; }
};

} // namespace

TEST_CASE("octree.voxelizer: any number of threads gives the same bytes", "[property]") {
  scenes::for_each([](const auto& scene) {
    using surface = std::decay_t<decltype(scene.surface)>;
    for (const box& domain : domains(scene))
      for (const int level : {1, 2, 5, 6, 8}) {
        const auto root = enclosing_root(domain, level);
        REQUIRE(root);
        const lane_judge<surface> judge(scene.surface, domain);
        const auto alone = voxelize_by(judge, *root);
        REQUIRE(alone);
        for (const int threads : {0, 1, 2, 7}) {
          const auto together = voxelize_parallel(judge, *root, {threads, nullptr, {}});
          REQUIRE(together);
          INFO("reach " << scene.reach << ", level " << level << ", threads " << threads);
          CHECK(*together == *alone);
        }
      }
  });
}

TEST_CASE("octree.voxelizer: threads serve any surface, tell progress and can be stopped",
          "[unit]") {
  const plane f;
  const box domain{{-1, -1, -1}, {1, 1, 1}};
  const auto root = enclosing_root(domain, 8);
  const scalar_judge<plane> judge(f, domain);
  std::size_t last = 0, parts = 0, wrong = 0;
  const auto tree = voxelize_parallel(judge, *root, {2, nullptr, [&](std::size_t d, std::size_t n) {
                                                       wrong += d <= last || d > n;
                                                       last = d;
                                                       parts = n;
                                                     }});
  REQUIRE(tree);
  CHECK(*tree == *voxelize(f, domain, 8));
  CHECK(wrong == 0);
  CHECK(parts > 1);
  std::atomic<bool> stop{true};
  const auto none = voxelize_parallel(judge, *root, {2, &stop, {}});
  CHECK_FALSE(none);
  CHECK(none.reason() == "interrupted");
  CHECK_FALSE(voxelize_parallel(judge, *root, {-1, nullptr, {}}));
}

TEST_CASE("octree.voxelizer: refuses an empty domain and a level too deep", "[unit]") {
  CHECK_FALSE(voxelize_in_lanes(quartdef{}, box{{1, -1, -1}, {-1, 1, 1}}, 3));
  CHECK_FALSE(voxelize_in_lanes(quartdef{}, box{{-1, -1, -1}, {1, 1, 1}}, 54));
}
