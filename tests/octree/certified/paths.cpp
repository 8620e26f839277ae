// The lanes of each path give the scalar code's certified hits, bit for bit.
#include "../../support/test_inputs.hpp"
#include "../surface_rays.hpp"
#include "../surface_scenes.hpp"
#include <catch2/catch.hpp>
#include <graze/fuzz/generators.hpp>
#include <graze/octree/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;

TEST_CASE("octree.certified: hits are those of the scalar code on every path", "[property]") {
  scenes::for_each([](const auto& scene) {
    using F = std::remove_cvref_t<decltype(scene.surface)>;
    std::vector<ray> rays;
    for (int j = 1; j < 512; j += 9)
      for (int i = 2; i < 512; i += 9)
        rays.push_back(scene.pixel(i, j));
    for (const bool inside : {false, true})
      for (const ray& r : scenes::awkward(scene, inside))
        rays.push_back(r);
    const auto each = static_cast<std::uint64_t>(test::input_count() / 500);
    for (const fuzz::generator& g : fuzz::generators())
      for (std::uint64_t i = 0; i < each; ++i) {
        const fuzz::trial t =
            fuzz::make_trial(g, 7, i, 1 + static_cast<int>(i % 50), cube{{-4, -4, -4}, 8});
        rays.push_back(*ray::make(t.origin, t.direction));
      }
    const auto scalar = certified_traversal<F>::make(F{}, scene.domain());
    REQUIRE(scalar);
    std::vector<certified_hit> wanted;
    std::uint64_t steps_wanted = 0;
    for (const ray& r : rays)
      wanted.push_back(scalar->first_hit(r, &steps_wanted));
    for (const batch::path p : batch::paths) {
      if (const auto reason = batch::refusal(p)) {
        std::printf("graze: skipped, path %s: %s\n", batch::name(p), reason->c_str());
        continue;
      }
      const auto lanes = lane_certified_traversal<F>::make(F{}, scene.domain(), p);
      REQUIRE(lanes);
      std::vector<certified_hit> hits(rays.size());
      std::uint64_t steps = 0;
      lanes->first_hits(rays, hits, &steps);
      INFO(batch::name(p) << ", reach " << scene.reach);
      CHECK(std::mismatch(hits.begin(), hits.end(), wanted.begin()).first == hits.end());
      CHECK(steps == steps_wanted);
      // whatever rays are beside it, and however many
      for (std::size_t count = 0; count < 40; ++count) {
        const std::size_t from = (count * 577) % (rays.size() - 40);
        std::vector<certified_hit> some(count);
        lanes->first_hits(std::span(rays).subspan(from, count), some);
        CHECK(std::equal(some.begin(), some.end(), wanted.begin() + static_cast<long>(from)));
      }
    }
  });
}
