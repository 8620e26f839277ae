// Roots within ulps of the domain's faces: a hit that is said to be unique is in the domain, and
// none there is lost. Judged by exact roots.
#include "../surface_scenes.hpp"
#include "root_judge.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/batch.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <vector>

#include "../surface_judge.hpp"

using namespace graze;
using namespace graze::octree;

namespace {

/// A plane across an axis.
struct plane {
  int axis;
  double at;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return (axis == 0 ? x : axis == 1 ? y : z) - constants<N>::exact(at);
  }
};
/// A saddle that is the plane but for a little.
struct saddle {
  int axis;
  double at;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    const N &along = axis == 0 ? x : axis == 1 ? y : z, &beside = axis == 0 ? y : x;
    return along - constants<N>::exact(at) + sqr(beside) * constants<N>::exact(0x1p-55);
  }
};

double step(double x, int ulps) {
  for (; ulps != 0; ulps += ulps < 0 ? 1 : -1)
    x = std::nextafter(x, ulps < 0 ? -INFINITY : INFINITY);
  return x;
}

template <class F> void beside_each_face(judge::tally& t) {
  judge::random_source random(41);
  // faces of 53 bits, so that distances from afar are rounded
  const box domain{{-0x1.f8a3b1c9d2e47p-1, -0x1.8c4f2a9b3d1e5p-1, 0x1.83a1c5e7f9b2dp-2},
                   {0x1.07b3d5f1a2c4fp+0, 0x1.4196fb2d3c5a7p+1, 0x1.1e4a6c8b0d2f3p+0}};
  for (int i = 0; i < 3000; ++i)
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const double face = upper ? domain.hi[axis] : domain.lo[axis];
        const F f{axis, step(face, static_cast<int>(random.below(5)) - 2)};
        vec3 o, d;
        const bool through = random.below(2) == 0; // the domain first, or the face first
        const double way = through == upper ? 1 : -1;
        if (i % 2 == 0) {
          for (int a = 0; a < 3; ++a) {
            o[a] = random.in(domain.lo[a], domain.hi[a]);
            d[a] = (random.in(domain.lo[a], domain.hi[a]) - o[a]) / 64;
          }
          o[axis] = way > 0 ? domain.lo[axis] - random.in(0, 1) : domain.hi[axis] + random.in(0, 1);
          d[axis] = way * random.in(0.1, 4);
        } else {
          // t d without an error, and a distance that is no double: a t that is off by half a unit
          // in its last place is beyond the face, and known to be
          const double far = random.in(8, 64);
          o[axis] = face - way * far;
          d[axis] = way;
          for (int a = 0; a < 3; ++a)
            if (a != axis) {
              d[a] = random.in(-1, 1) / 64;
              o[a] = random.in(domain.lo[a], domain.hi[a]) - far * d[a];
            }
        }
        if (const auto a = static_cast<unsigned>((axis + 1) % 3); random.below(4) == 0) {
          d[a] = 0; // in a face, or beside it
          const int on = static_cast<int>(random.below(5)) - 2;
          o[a] = step(random.below(2) == 0 ? domain.lo[a] : domain.hi[a], on);
        }
        const ray r = *ray::make(o, d);
        t.judge(f, r, domain, certified_traversal<F>::make(f, domain)->first_hit(r));
      }
}

} // namespace

TEST_CASE("octree.certified: surfaces within ulps of each face of the domain",
          "[regression][exact][hardcase]") {
  for (const bool curved : {false, true}) {
    judge::tally t;
    curved ? beside_each_face<saddle>(t) : beside_each_face<plane>(t);
    INFO((curved ? "saddle" : "plane") << ": " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.hits > 1000);
    CHECK(t.misses > 1000);
    CHECK(t.undecided > 100);
  }
}

TEST_CASE("octree.certified: a face of the domain within ulps of a scene's surface, on every path",
          "[regression][exact][hardcase]") {
  scenes::for_each([](const auto& scene) {
    using F = std::remove_cvref_t<decltype(scene.surface)>;
    judge::random_source random(43);
    const auto whole = certified_traversal<F>::make(F{}, scene.domain());
    REQUIRE(whole);
    std::vector<judge::tally> tallies(1 + std::size(batch::paths));
    int cut = 0;
    for (int k = 0; k < 20'000 && cut < 400; ++k) {
      const ray r =
          scene.pixel(static_cast<int>(random.below(512)), static_cast<int>(random.below(512)));
      const certified_hit h = whole->first_hit(r);
      if (h.outcome != verdict::hit)
        continue;
      ++cut;
      // the first root's coordinate on some axis becomes a face of the domain, to some ulps
      const int axis = static_cast<int>(random.below(3));
      const double at = r.origin()[axis] + h.t_near * r.direction()[axis];
      const double face = step(at, static_cast<int>(random.below(7)) - 3);
      box domain = scene.domain();
      (random.below(2) == 0 ? domain.lo : domain.hi)[axis] = face;
      const auto scalar = certified_traversal<F>::make(F{}, domain);
      if (!scalar)
        continue;
      const certified_hit wanted = scalar->first_hit(r);
      tallies[0].judge(F{}, r, domain, wanted);
      for (std::size_t p = 0; p < std::size(batch::paths); ++p) {
        const auto by_lanes = lane_certified_traversal<F>::make(F{}, domain, batch::paths[p]);
        if (!by_lanes)
          continue;
        certified_hit hit;
        by_lanes->first_hits(std::span(&r, 1), std::span(&hit, 1));
        tallies[p + 1].judge(F{}, r, domain, hit);
        CHECK(hit == wanted);
      }
    }
    CHECK(cut == 400);
    INFO("reach " << scene.reach << ", " << tallies[0].hits << " hits");
    for (const judge::tally& t : tallies) {
      INFO(t.first_wrong);
      CHECK(t.wrong == 0);
    }
    CHECK(tallies[0].hits > 20);
  });
}

TEST_CASE("octree.certified: a ray that passes beside the domain is a miss, in no step", "[unit]") {
  judge::random_source random(47);
  const box domain{{-1, -0.75, 0.375}, {1, 2.5, 1.125}};
  const plane f{0, 0.5};
  const auto traversal = certified_traversal<plane>::make(f, domain);
  REQUIRE(traversal);
  int beside = 0;
  for (int i = 0; i < 20'000; ++i) {
    vec3 o, d;
    for (int a = 0; a < 3; ++a) {
      o[a] = random.in(-4, 4);
      d[a] = random.below(6) == 0 ? 0 : random.in(-1, 1);
    }
    const auto r = ray::make(o, d);
    if (!r || oracle::rational::range_in(o, d, {-1.001, -0.751, 0.374}, {1.001, 2.501, 1.126}))
      continue;
    ++beside;
    std::uint64_t steps = 0;
    const certified_hit h = traversal->first_hit(*r, &steps);
    REQUIRE(h.outcome == verdict::miss);
    REQUIRE(steps == 0);
  }
  CHECK(beside > 10'000);
}
