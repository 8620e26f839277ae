// Certified first hits judged exactly: the polynomial along each ray over rationals, its distinct
// roots counted by Sturm.
#include "../surface_rays.hpp"
#include "../surface_scenes.hpp"
#include "root_judge.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <graze/octree/certified_hit.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/rounding/nearest.hpp>
#include <peers/paper2005/plain.hpp>

using namespace graze;
using namespace graze::octree;
using namespace graze::peers;
using judge::tally;

namespace {

template <class S> std::vector<ray> pixels(const S& scene, int stride) {
  std::vector<ray> rays;
  for (int j = stride / 2; j < 512; j += stride)
    for (int i = stride / 2; i < 512; i += stride)
      rays.push_back(scene.pixel(i, j));
  return rays;
}

template <rounding::Backend B = rounding::upward, class F>
tally examine(const F& f, const box& domain, const std::vector<ray>& rays) {
  const auto traversal = certified_traversal<F, B>::make(f, domain);
  REQUIRE(traversal);
  tally t;
  for (const ray& r : rays) {
    std::uint64_t steps = 0;
    t.judge(f, r, domain, traversal->first_hit(r, &steps));
    t.most_steps = std::max(t.most_steps, steps);
  }
  return t;
}

template <class F> certified_hit hit_of(const F& f, const box& domain, const ray& r) {
  return certified_traversal<F>::make(f, domain)->first_hit(r);
}

/// All 262,144 pixels, by the lanes (which have the scalar code's bits: paths.cpp).
template <class S> void examine_all_pixels(const S& scene, int hits_in_all) {
  const auto traversal =
      lane_certified_traversal<decltype(scene.surface)>::make(scene.surface, scene.domain());
  REQUIRE(traversal);
  const std::vector<ray> rays = pixels(scene, 1);
  std::vector<certified_hit> hits(rays.size());
  traversal->first_hits(rays, hits);
  tally t;
  std::vector<double> widths;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    t.judge(scene.surface, rays[i], scene.domain(), hits[i]);
    if (hits[i].outcome == verdict::hit)
      widths.push_back((hits[i].t_far - hits[i].t_near) /
                       (std::nextafter(hits[i].t_near, 1e300) - hits[i].t_near));
  }
  INFO(t.first_wrong);
  CHECK(t.wrong == 0);
  CHECK(t.undecided == 0);
  CHECK(t.shared == 0);
  CHECK(t.hits == hits_in_all);
  std::nth_element(widths.begin(), widths.begin() + t.hits / 2, widths.end());
  CHECK(widths[static_cast<std::size_t>(t.hits / 2)] <= 4);
}

/// Where an error of rounding or a forgotten case would show: rays through points on the surface
/// and tangent to it, along axes and faces of the domain, from far away, and with the least and the
/// greatest directions.
std::vector<ray> adversarial(double reach, const std::vector<vec3>& points, bool from_inside) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<ray> rays;
  const auto add = [&](const vec3& o, const vec3& d) {
    const auto r = ray::make(o, d);
    const bool inside = std::max({std::fabs(o[0]), std::fabs(o[1]), std::fabs(o[2])}) < reach;
    if (r && (from_inside || !inside))
      rays.push_back(*r);
  };
  std::vector<vec3> ways;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        ways.push_back({double(x), double(y), double(z)});
  for (const vec3& p : points)
    for (const vec3& d : ways) {
      vec3 before, scaled = d;
      for (const double back : {0.0, 0.25, 4.0, 0x1p30, 0x1p45}) {
        for (unsigned a = 0; a < 3; ++a)
          before[a] = p[a] - back * d[a];
        add(before, d);
        vec3 beside = before; // one ulp off
        beside[rays.size() % 3] = std::nextafter(before[rays.size() % 3], 10);
        add(beside, d);
      }
      for (unsigned a = 0; a < 3; ++a)
        before[a] = p[a] - 4 * d[a];
      for (const double scale : {tiny, 5 * tiny, 0x1p-1040, 0x1p-600, 0x1p900, 0x1p1022}) {
        for (unsigned a = 0; a < 3; ++a)
          scaled[a] = d[a] * scale;
        add(before, scaled);
        add(p, scaled);
      }
      for (const double back : {1e16, 1e100, 1e300}) {
        for (unsigned a = 0; a < 3; ++a)
          before[a] = p[a] - back * d[a];
        add(before, d);
        for (unsigned a = 0; a < 3; ++a)
          scaled[a] = d[a] * back;
        add(before, scaled);
      }
    }
  // along axes: in the domain's faces, one ulp beside them, on its edges and through its corners
  for (const double u : {-reach, std::nextafter(-reach, -10), std::nextafter(-reach, 0), 0.0, 0.5,
                         reach, std::nextafter(reach, 10)})
    for (const double v : {-reach, 0.0, 1.0, reach})
      for (unsigned a = 0; a < 3; ++a)
        for (const double along : {1.0, -1.0, 0x1p-1070, -0x1p1000}) {
          vec3 o{}, d{};
          o[a] = along > 0 ? -2 * reach : 2 * reach;
          o[(a + 1) % 3] = u;
          o[(a + 2) % 3] = v;
          d[a] = along;
          add(o, d);
        }
  return rays;
}

} // namespace

TEST_CASE("octree.certified: all 262,144 pixels of tanglecube are those of the exact roots",
          "[property][exact]") {
  examine_all_pixels(scenes::scene_of<tanglecube>, 97549);
}
TEST_CASE("octree.certified: all 262,144 pixels of quartdef are those of the exact roots",
          "[property][exact]") {
  examine_all_pixels(scenes::scene_of<quartdef>, 109209);
}
TEST_CASE("octree.certified: all 262,144 pixels of holesrot are those of the exact roots",
          "[property][exact]") {
  examine_all_pixels(scenes::scene_of<holesrot>, 100452);
}
TEST_CASE("octree.certified: all 262,144 pixels of spheres are those of the exact roots",
          "[property][exact]") {
  examine_all_pixels(scenes::scene_of<spheres>, 73660);
}

TEST_CASE("octree.certified: verdicts and enclosures hold the exact roots, awkward rays",
          "[property][exact]") {
  const auto check = [](const auto& scene, bool from_inside) {
    const tally t = examine(scene.surface, scene.domain(), scenes::awkward(scene, from_inside));
    INFO("reach " << scene.reach << " inside " << from_inside << ": " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.hits > 100);
    CHECK(t.undecided < t.rays / 50);
  };
  scenes::for_each([&](const auto& scene) { check(scene, false); });
  scenes::for_each_from_inside([&](const auto& scene) { check(scene, true); });
}

TEST_CASE("octree.certified: verdicts and enclosures hold the exact roots, adversarial rays",
          "[hardcase][exact]") {
  const auto check = [](const auto& scene, const std::vector<vec3>& points, bool from_inside) {
    const tally t =
        examine(scene.surface, scene.domain(), adversarial(scene.reach, points, from_inside));
    INFO("reach " << scene.reach << ", " << t.undecided << " of " << t.rays
                  << " undecided: " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.hits > 100);
    CHECK(t.misses > 100);
    CHECK(t.most_steps < 1000); // no ray is given up for its length
  };
  // points of the surface, the first two of quartdef its singular ones; holesrot holds whole lines
  check(scenes::scene_of<spheres>, {{0, 1, 0}, {1.75, 0.625, 0}, {0, 0, -2.375}, {2.375, 0, 0}},
        false);
  check(scenes::scene_of<quartdef>, {{0, 1, 1}, {1, -1, 0}, {1, 1, 1.4142135623730951}}, true);
  check(scenes::scene_of<tanglecube>, {{1.5, 1.5, 0.5}, {0, 0, 2.0}, {1.5811388300841898, 1.25, 0}},
        true);
  check(scenes::scene_of<holesrot>, {{0, 0, 0}, {1, -1, 0}, {0.5, -0.5, 1}, {1, 1, 1}}, true);
}

TEST_CASE("octree.certified: a tangent ray is undecided or beside, never a miss",
          "[hardcase][exact]") {
  const auto& scene = scenes::scene_of<spheres>;
  for (const double direction : {1.0, -1.0, 0x1p-300, 3.0}) {
    const ray r = *ray::make({direction > 0 ? -3.0 : 3.0, 1, 0}, {direction, 0, 0}); // at (0,1,0)
    const certified_hit h = hit_of(scene.surface, scene.domain(), r);
    INFO(judge::text(r, h));
    CHECK(h.outcome == verdict::undecided); // a double root changes no sign
    CHECK(judge::untruth(scene.surface, r, scene.domain(), h) == "");
    // the error of g, some ulps, is as wide as its root in t
    CHECK((h.t_far - h.t_near) * std::fabs(direction) < 0x1p-20);
  }
  for (int k = 8; k <= 52; ++k) // grazing from inside and from outside
    for (const double side : {1.0, -1.0}) {
      const ray r = *ray::make({-3, 1 + side * std::ldexp(1.0, -k), 0}, {1, 0, 0});
      const certified_hit h = hit_of(scene.surface, scene.domain(), r);
      INFO(judge::text(r, h) << " k " << k);
      CHECK(judge::untruth(scene.surface, r, scene.domain(), h) == "");
      if (k < 46) // known apart from a tangent
        CHECK(h.outcome == (side < 0 ? verdict::hit : verdict::miss));
    }
}

namespace {
/// The unit sphere, alone.
struct squared_distance {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return sqr(x) + sqr(y) + sqr(z) - constants<N>::exact(1);
  }
};
/// Everywhere a double root.
struct squared_sphere {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return sqr(sqr(x) + sqr(y) + sqr(z) - constants<N>::exact(1));
  }
};
/// A root of order three on the plane x = 1.
struct cubed_plane {
  template <class N> N operator()(const N& x, const N& y, const N&) const {
    const N p = x - constants<N>::exact(1);
    return p * p * p + y * constants<N>::exact(0);
  }
};
/// Two surfaces 2^-40 apart.
struct thin_shell {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    const N outer = sqr(x) + sqr(y) + sqr(z) - constants<N>::exact(1);
    return outer * (outer + constants<N>::exact(0x1p-40));
  }
};
/// Seen along z a cone's tip, at the origin.
struct cone {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return sqr(x) + sqr(y) - sqr(z);
  }
};
} // namespace

TEST_CASE("octree.certified: roots that are not simple", "[hardcase][exact]") {
  const box domain{{-2, -2, -2}, {2, 2, 2}};
  std::vector<ray> rays;
  judge::random_source random(7);
  for (int k = 0; k < 500; ++k) {
    vec3 o{-3, random.in(-1, 1), random.in(-1, 1)}, d{1, random.in(-0.1, 0.1), 0};
    if (k % 5 == 0)
      o = {-3, 0, 0};
    rays.push_back(*ray::make(o, d));
  }
  const tally squared = examine(squared_sphere{}, domain, rays);
  INFO(squared.first_wrong);
  CHECK(squared.wrong == 0);
  CHECK(squared.hits == 0);
  CHECK(squared.misses > 50);
  CHECK(squared.undecided > 200);
  const tally cubed = examine(cubed_plane{}, domain, rays);
  INFO(cubed.first_wrong);
  CHECK(cubed.wrong == 0);
  CHECK(cubed.hits == cubed.rays); // g changes its sign: the root is proven
  CHECK(cubed.shared == cubed.rays);
  const tally thin = examine(thin_shell{}, domain, rays);
  INFO(thin.first_wrong);
  CHECK(thin.wrong == 0);
  CHECK(thin.hits > 200);
  const tally tip = examine(cone{}, domain, rays);
  INFO(tip.first_wrong);
  CHECK(tip.wrong == 0);
  for (const tally& t : {squared, cubed, thin, tip})
    CHECK(t.most_steps < 1000);
  CHECK(tip.hits > 150);

  for (const ray& r : rays) { // the blur is as wide as rounding makes it, not wider
    const certified_hit h = hit_of(squared_sphere{}, domain, r);
    if (h.outcome == verdict::undecided)
      CHECK(h.t_far - h.t_near < 4);
  }
}

TEST_CASE("octree.certified: an origin on the surface", "[hardcase][exact]") {
  const auto& scene = scenes::scene_of<spheres>;
  const box domain = scene.domain();
  // g(0) is exactly 0, and g is monotone there
  const certified_hit in = hit_of(scene.surface, domain, *ray::make({0, 0, -2.375}, {0, 0, 1}));
  CHECK(in.outcome == verdict::hit);
  CHECK(in.unique);
  CHECK(in.t_near == 0);
  CHECK(in.t_far == 0);
  // here it is not: whether the root is before the origin, at it or after it is below rounding
  int undecided = 0;
  for (int k = 0; k < 50; ++k) {
    const double angle = 0.1 + 0.01 * k;
    const ray r = *ray::make({std::cos(angle), 0, -std::sin(angle)}, {1, 0, -1});
    const certified_hit h = hit_of(squared_distance{}, domain, r);
    INFO(judge::text(r, h));
    CHECK(judge::untruth(squared_distance{}, r, domain, h) == "");
    CHECK(h.outcome != verdict::miss);
    undecided += h.outcome == verdict::undecided;
    CHECK(h.t_near < 0x1p-50);
    CHECK(h.t_far < 0x1p-45);
  }
  CHECK(undecided > 20);
}

TEST_CASE("octree.certified: agrees with the descent to level 30", "[property]") {
  scenes::for_each([](const auto& scene) {
    using F = std::remove_cvref_t<decltype(scene.surface)>;
    const auto octree = voxelize_in_lanes(F{}, scene.domain(), 7);
    REQUIRE(octree);
    const auto descent = lane_traversal<F>::make(F{}, scene.domain(), *octree, 30);
    const auto along = lane_certified_traversal<F>::make(F{}, scene.domain());
    REQUIRE(descent);
    REQUIRE(along);
    std::vector<ray> rays = pixels(scene, 4);
    for (const bool inside : {false, true})
      for (const ray& r : scenes::awkward(scene, inside))
        rays.push_back(r);
    std::vector<surface_hit> slow(rays.size());
    std::vector<certified_hit> fast(rays.size());
    descent->first_hits(rays, slow);
    along->first_hits(rays, fast);
    int apart = 0, less_decided = 0, wider = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const surface_hit& s = slow[i];
      const certified_hit& c = fast[i];
      const bool both = s.outcome != verdict::miss && c.outcome != verdict::miss;
      apart += s.outcome != c.outcome && s.outcome != verdict::undecided &&
               c.outcome != verdict::undecided;
      apart += both && (s.t_far < c.t_near || c.t_far < s.t_near) &&
               (s.outcome == verdict::hit || c.outcome == verdict::hit);
      less_decided += c.outcome == verdict::undecided && s.outcome != verdict::undecided;
      hits += both;
      wider += both && c.t_far - c.t_near > s.t_far - s.t_near;
    }
    INFO("reach " << scene.reach);
    CHECK(apart == 0);
    CHECK(hits > 4000);
    CHECK(less_decided <= 5);
    CHECK(wider <= hits / 1000);
  });
}

TEST_CASE("octree.certified: without outward rounding the judge finds wrong enclosures",
          "[property][exact]") {
  scenes::for_each([](const auto& scene) {
    const tally t = examine<undirected>(scene.surface, scene.domain(), pixels(scene, 8));
    INFO("reach " << scene.reach);
    CHECK(t.wrong > t.hits / 10);
  });
}

TEST_CASE("octree.certified: the caller's control words are restored, flushing is not used",
          "[unit]") {
  const auto& scene = scenes::scene_of<tanglecube>;
  const auto traversal = certified_traversal<tanglecube>::make(scene.surface, scene.domain());
  const ray r = scene.pixel(256, 256);
  const certified_hit plain = traversal->first_hit(r);
  const unsigned before = _mm_getcsr();
  for (const unsigned mode : {0x8040u, 0x2000u, 0x4000u, 0x6000u}) {
    _mm_setcsr(before | mode);
    const certified_hit changed = traversal->first_hit(r);
    const unsigned after = _mm_getcsr();
    _mm_setcsr(before);
    CHECK((after & ~0x3fu) == ((before | mode) & ~0x3fu));
    CHECK(changed == plain);
  }
  // `nearest` has no scope of its own
  const auto other =
      certified_traversal<tanglecube, rounding::nearest>::make(scene.surface, scene.domain());
  CHECK(other->first_hit(r) == plain);
  _mm_setcsr(before | 0x8040);
  const certified_hit flushed = other->first_hit(r);
  _mm_setcsr(before);
  CHECK(flushed.outcome == verdict::undecided);
}

TEST_CASE("octree.certified: refuses what it cannot do", "[unit]") {
  using traversal = certified_traversal<holesrot>;
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_FALSE(traversal::make({}, box{{1, 0, 0}, {0, 1, 1}}));
  CHECK_FALSE(traversal::make({}, box{{0, 0, 0}, {1, infinite, 1}}));
  CHECK_FALSE(lane_certified_traversal<holesrot>::make({}, box{{1, 0, 0}, {0, 1, 1}}));
  CHECK(traversal::make({}, box{{0, 0, 0}, {1, 1, 1}}));
}
