// The surfaces' own formulas, over eight boxes at once, give the scalar type's bounds on every
// path.
#include "../surface_judge.hpp"
#include "evaluate.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <graze/batch.hpp>
#include <graze/octree/surfaces.hpp>
#include <limits>

using namespace graze;
using namespace graze::test;

namespace {

using scalar = graze::interval<>;

void same_as_scalar(batch::path p, void (*evaluate)(const eight_boxes&, eight_values&)) {
  if (const auto reason = batch::refusal(p)) {
    std::printf("graze: skipped, path %s: %s\n", batch::name(p), reason->c_str());
    return;
  }
  judge::random_source random(8);
  constexpr double turns[] = {
      0, 1, -1, 0x1.279a74590331cp-1, -0x1.279a74590331cp-1, 1.75, -2.5, 0x1.94c583ada5b53p+0};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  long wrong = 0;
  for (int round = 0; round < 20'000; ++round) {
    double lo[3][8], hi[3][8];
    for (auto& axis : lo)
      for (double& t : axis) {
        const std::size_t lane = &t - axis;
        double& end = hi[&axis - lo][lane];
        t = random.below(3) == 0 ? turns[random.below(8)] : random.in(-3, 3);
        end = t;
        if (random.below(5) != 0) {
          const double size = std::ldexp(random.in(0, 2), -static_cast<int>(random.below(56)));
          (random.below(2) == 0 ? t : end) += random.below(2) == 0 ? size : 0;
          if (end < t)
            std::swap(t, end);
        }
        if (random.below(100) == 0)
          t = -infinity;
        if (random.below(100) == 0)
          end = infinity;
      }
    eight_values values;
    evaluate({{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}, values);
    for (int lane = 0; lane < 8; ++lane) {
      const auto axis = [&](int a) { return scalar(lo[a][lane], hi[a][lane]); };
      const scalar x = axis(0), y = axis(1), z = axis(2);
      const auto check = [&](int scene, const scalar& expected) {
        wrong += !(values.lo[scene][lane] == expected.lower()) ||
                 !(values.hi[scene][lane] == expected.upper());
        wrong += ((values.holds_zero[scene] >> lane & 1) != 0) !=
                 (expected.lower() <= 0 && 0 <= expected.upper());
      };
      check(spheres_scene, octree::spheres{}(x, y, z));
      check(quartdef_scene, octree::quartdef{}(x, y, z));
      check(tanglecube_scene, octree::tanglecube{}(x, y, z));
      check(holesrot_scene, octree::holesrot{}(x, y, z));
    }
  }
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("octree.eight: baseline, surfaces over interval8 have the scalar bounds", "[property]") {
  same_as_scalar(batch::path::baseline, evaluate_baseline);
}
#if defined(__x86_64__)
TEST_CASE("octree.eight: avx2, surfaces over interval8 have the scalar bounds", "[property]") {
  same_as_scalar(batch::path::avx2, evaluate_avx2);
}
TEST_CASE("octree.eight: avx512, surfaces over interval8 have the scalar bounds", "[property]") {
  same_as_scalar(batch::path::avx512, evaluate_avx512);
}
#endif
