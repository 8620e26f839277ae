// Polynomials however they are spelt: every ray is decided, as Sturm's sequences decide it.
#include "../../support/formulas.hpp"
#include "../../support/paths.hpp"
#include "../certified/root_judge.hpp"
#include "exact_text.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree_formula.hpp>
#include <graze/octree_formula/lane_kernels.hpp>
#include <graze/oracle/formula_tree.hpp>

#include "../surface_judge.hpp"

using namespace graze;
using namespace graze::octree;
using support::cube_of;
using support::parsed;

namespace {

/// Rays from an eye beside cube_of(reach), `side` by `side` of them.
std::vector<ray> camera(double reach, int side) {
  const vec3 eye{1.9 * reach, 1.3 * reach, 2.3 * reach};
  const double length = std::sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
  const vec3 ahead{-eye[0] / length, -eye[1] / length, -eye[2] / length};
  const double flat = std::hypot(ahead[0], ahead[2]);
  const vec3 right{-ahead[2] / flat, 0, ahead[0] / flat};
  const vec3 up{-ahead[1] * right[2], ahead[0] * right[2] - ahead[2] * right[0],
                ahead[1] * right[0]};
  std::vector<ray> rays;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double u = (2 * i + 1.0) / side - 1, v = 1 - (2 * j + 1.0) / side;
      vec3 d;
      for (int a = 0; a < 3; ++a)
        d[a] = ahead[a] + 0.5 * (u * right[a] + v * up[a]);
      rays.push_back(*ray::make(eye, d));
    }
  return rays;
}

/// By scalar intervals, which those of every path must equal.
std::vector<certified_hit> hits_of(const formula& f, const box& domain,
                                   const std::vector<ray>& rays) {
  const auto scalar = certified_traversal<formula_surface>::make(f.surface(), domain);
  REQUIRE(scalar);
  std::vector<certified_hit> hits;
  for (const ray& r : rays)
    hits.push_back(scalar->first_hit(r));
  test::for_each_path([&](batch::path p) {
    const auto lanes = lane_certified_traversal<formula_surface>::make(f.surface(), domain, p);
    std::vector<certified_hit> other(rays.size());
    lanes->first_hits(rays, other);
    int apart = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
      apart += !(other[i] == hits[i]);
    CHECK(apart == 0);
  });
  return hits;
}

judge::tally judged(const std::string& text, const box& domain, const std::vector<ray>& rays) {
  const std::vector<certified_hit> hits = hits_of(parsed(text), domain, rays);
  const judge::exact_text exact(text);
  judge::tally t;
  for (std::size_t i = 0; i < rays.size(); ++i)
    t.judge(exact, rays[i], domain, hits[i]);
  return t;
}

/// One ray; its hit is a few ulps wide.
certified_hit decided(const std::string& text, const box& domain, const ray& r) {
  const certified_hit h = hits_of(parsed(text), domain, {r})[0];
  INFO(text << ": " << judge::text(r, h));
  CHECK(judge::untruth(judge::exact_text(text), r, domain, h) == "");
  CHECK(h.outcome != verdict::undecided);
  if (h.outcome == verdict::hit)
    CHECK(std::nextafter(std::nextafter(h.t_near, INFINITY), INFINITY) >= h.t_far);
  return h;
}

ray along_x(double x, double y = 0, double z = 0) { return *ray::make({x, y, z}, {1, 0, 0}); }

// By Breske, Labs and van Straten, as collections of surfaces have it; and one of degree 9 in sheared
// coordinates: (T9(x + y) + T9(x - y) + 1) / 2 + z.
const char* const breske =
    "(2*x^7-42*x^5*y^2+70*x^3*y^4-14*x*y^6-14*x^6+70*x^4*y^2+70*x^2*y^4-14*y^6+28*x^5+56*x^3*y^2+"
    "28*x*y^4-84*x^2*y^2+28*y^4-42*x^3-42*x*y^2+14*x^2-14*y^2+14*x)+(1/2)*(64*z^7-112*z^5+56*z^3-7*"
    "z+5)";
const char* const nonic = "256*x^9+9216*x^7*y^2+32256*x^5*y^4+21504*x^3*y^6+2304*x*y^8-576*x^7-"
                          "12096*x^5*y^2-20160*x^3*y^4"
                          "-4032*x*y^6+432*x^5+4320*x^3*y^2+2160*x*y^4-120*x^3-360*x*y^2+9*x+0.5+z";

} // namespace

TEST_CASE("octree.polynomials: every pixel of expanded ones is decided, on every path",
          "[property][exact]") {
  const auto all = [](const std::string& text, double reach, int least_hits, int side = 96) {
    const judge::tally t = judged(text, cube_of(reach), camera(reach, side));
    INFO(text << ": " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.undecided == 0);
    CHECK(t.shared == 0);
    CHECK(t.hits >= least_hits);
  };
  all("x^4-4*x^3+6*x^2-4*x+y", 3, 2000);
  all("x^6-6*x^5+15*x^4-20*x^3+15*x^2-6*x+y", 3, 2000);
  all("x^7-7*x^6+14*x^5-21*x^3+7*x^2+7*x+y", 3, 4000);
  all("x^8-4*x^6+6*x^4-4*x^2+y", 3, 2000);
  all("x^6-3*x^4+3*x^2+y-0.1*z", 3, 1000);
  all(breske, 3, 3000);
  all(nonic, 1, 1000);
}

TEST_CASE("octree.polynomials: multiple roots are hits, and other rays misses",
          "[hardcase][exact]") {
  for (const auto& [text, reach] : std::vector<std::pair<std::string, double>>{
           {"(x^2+y^2+z^2-4)^2", 3},
           {"(x+y+z-0.1)^3", 3},
           {"x^4+2*x^2*y^2+2*x^2*z^2-2*x^2+y^4+2*y^2*z^2-2*y^2+z^4-2*z^2+1", 2}}) {
    const judge::tally t = judged(text, cube_of(reach), camera(reach, 32));
    INFO(text << ": " << t.first_wrong);
    CHECK(t.wrong == 0);
    CHECK(t.undecided == 0);
    CHECK(t.hits >= 80);
    CHECK(t.shared == t.hits);
  }
  // tangent, at a t that is a double, and at one that is not
  for (const char* text : {"x^2+y^2+z^2-1", "x^4-2*x^2+1+y-1", "x^2-0.2*x+0.01+(y-1)",
                           "(x-0.1)^2*(x-0.2)^2+y-1", "(x^2-2)^2*(x^2-0.5)+y-1"})
    for (const double x : {-2.0, -1.75}) {
      const certified_hit h = decided(text, cube_of(4), along_x(x, 1));
      CHECK(h.outcome == verdict::hit);
      CHECK_FALSE(h.unique);
      const certified_hit beside = decided(text, cube_of(4), along_x(x, std::nextafter(1.0, 2)));
      CHECK(beside.outcome ==
            (std::string(text).ends_with("0.5)+y-1") ? verdict::hit : verdict::miss));
    }
  // of odd order
  for (const char* text : {"x^3-0.3*x^2+0.03*x-0.001+y", "x^5+y", "(x-1/3)^3+y", "(x^2-3)^3+y"}) {
    const certified_hit h = decided(text, cube_of(4), along_x(-2));
    CHECK(h.outcome == verdict::hit);
    CHECK_FALSE(h.unique);
  }
}

TEST_CASE("octree.polynomials: roots as near to each other as 2^-60 and 1e-30 are told apart",
          "[hardcase][exact]") {
  for (const char* text :
       {"(x-0.1)*(x-0.1-1/1152921504606846976)*(x+3)*(x-4)", "(x-0.1)^2+1e-40", "(x-0.1)^2-1e-40",
        "(x-0.1)^2*(x-0.3)+1e-60", "x^2-2*x*y+y^2-1e-30", "(x-1/3)*(x-1/3-1e-25)*(x-1/3-1e-26)",
        "x^2-0.2*x+0.01+1e-100", "((x-0.1)^2+1e-50)*(x-0.1-1e-18)"})
    for (const double x : {-2.0, -1.0 / 3, -0x1.8p-40, 0.099}) {
      const certified_hit h = decided(text, cube_of(4), along_x(x, 0.1, 0.2));
      CHECK((h.outcome == verdict::hit || x > 0 || text[std::string(text).size() - 3] == '+' ||
             std::string(text).find("+1e-") != std::string::npos));
    }
}

TEST_CASE("octree.polynomials: roots at the ends of the way through the domain",
          "[hardcase][exact]") {
  // entry and exit are no doubles, nor is what is before and behind
  const box thirds{{-1, -1, -1}, {1, 1, 1}};
  const ray slanted = *ray::make({-3, -0.25, 0.125}, {3, 0.5, 0.25});
  for (const char* text : {"(x-1)^3*(y+z)", "(x+1)^3*(x-1)^2", "(x-1)^2", "(x+1)^2*(y-7)",
                           "(x+1+1e-20)^2", "(x-1-1e-20)^2", "(x+1-1e-20)^2", "(x-1+1e-20)^2",
                           "x^2+2*x+1", "(x+1)*(x-1)^3", "x^3+1e-20*x^2-x-1e-20"})
    decided(text, thirds, slanted);
  CHECK(decided("(x+1)^2", thirds, slanted).outcome == verdict::hit);
  CHECK(decided("(x-1)^2", thirds, slanted).outcome == verdict::hit);
  CHECK(decided("(x+1+1e-20)^2", thirds, slanted).outcome == verdict::miss);
  CHECK(decided("(x-1-1e-20)^2", thirds, slanted).outcome == verdict::miss);
  // t = 0
  for (const char* text : {"x^2-0.5*x+0.0625", "x^3-0.75*x^2+0.1875*x-0.015625",
                           "(x-0.25)^2*(x-0.5)", "(x-0.25)*(x-0.25-1e-30)"}) {
    const certified_hit h = decided(text, thirds, along_x(0.25));
    CHECK(h.outcome == verdict::hit);
    CHECK(h.t_near == 0);
  }
  CHECK(decided("(x-0.25+1e-30)^2", thirds, along_x(0.25)).outcome == verdict::miss);
  // a ray that only touches the domain, in a face, at an edge and in a corner
  decided("(x+y)^2", thirds, *ray::make({-3, 1, 0}, {1, 0, 0}));
  decided("(x-1)^2*(y-1)", thirds, *ray::make({-1, 3, 0}, {1, -1, 0}));
  decided("(x-1)^2+(y-1)^2+(z-1)^2", thirds, *ray::make({0, 2, 1}, {1, -1, 0}));
  const ray touching = *ray::make({0, 2, 1}, {1, -1, 0});
  CHECK(decided("(x-1)^2", thirds, touching).outcome == verdict::hit);
  CHECK(decided("(x-1+1e-300)*(y-5)", thirds, touching).outcome == verdict::miss);
  // within the surface
  const certified_hit within =
      decided("(x+y)^2*(z-3)", thirds, *ray::make({-3, 3, 0.5}, {1, -1, 0}));
  CHECK(within.outcome == verdict::hit);
  CHECK(within.t_near == 2);
}

TEST_CASE("octree.polynomials: small and great scales", "[hardcase][exact]") {
  for (const int e : {-300, -140, -40, 40, 140, 300}) {
    const double scale = std::ldexp(1.0, e);
    char text[200];
    std::snprintf(text, sizeof text, "(x*0x1p%d-0.1)^2*(x*0x1p%d-0.3)+y*0", -e, -e);
    const formula f = parsed(text);
    const box domain{{-scale, -scale, -scale}, {scale, scale, scale}};
    for (const double speed : {scale, 1.0, scale * 0x1p100})
      for (const double from : {-2.0, 0x1.8p-3}) {
        const ray r = *ray::make({scale * from, 0, 0}, {speed, 0, 0});
        const certified_hit h = hits_of(f, domain, {r})[0];
        INFO(text << ": " << judge::text(r, h));
        CHECK(h.outcome == verdict::hit);
        const double t = ((from < 0 ? 0.1 : 0.3) - from) * (scale / speed);
        CHECK(std::fabs(h.t_near - t) < t * 0x1p-48);
      }
  }
}

TEST_CASE("octree.polynomials: random ones with double and near roots are decided",
          "[property][exact]") {
  judge::random_source random(17);
  oracle::random_bits bits(17);
  judge::tally t;
  for (int i = 0; i < 150; ++i) {
    const std::string part = "(" + oracle::some_tree(bits, 4, true)->text + ")";
    for (const std::string& text : {part + "*" + part, part + "*(" + part + "-1e-20)",
                                    part + "*" + part + "+1e-40", part + "*" + part + "*" + part}) {
      const auto f = formula::parse(text);
      REQUIRE(f);
      std::vector<ray> rays;
      for (int k = 0; k < 4; ++k) {
        vec3 o, d;
        for (int a = 0; a < 3; ++a) {
          o[a] = k == 0 ? std::round(random.in(-3, 3)) : random.in(-3, 3);
          d[a] = k == 0 ? std::round(random.in(-2, 2)) / 2 : random.in(-1, 1);
        }
        if (const auto r = ray::make(o, d))
          rays.push_back(*r);
      }
      const std::vector<certified_hit> hits = hits_of(*f, cube_of(2), rays);
      const judge::exact_text exact(text);
      for (std::size_t k = 0; k < rays.size(); ++k)
        t.judge(exact, rays[k], cube_of(2), hits[k]);
    }
  }
  INFO(t.first_wrong);
  CHECK(t.wrong == 0);
  CHECK(t.undecided == 0);
  CHECK(t.hits > 250);
  CHECK(t.shared > 200);
  CHECK(t.misses > 300);
}

TEST_CASE(
    "octree.polynomials: enclosures at points are tight, near multiple turning points as well",
    "[property][exact]") {
  for (const char* text :
       {"x^8-4*x^6+6*x^4-4*x^2", "x^6-3*x^4+3*x^2", "x^4-4*x^3+6*x^2-4*x",
        "x^7-7*x^6+14*x^5-21*x^3+7*x^2+7*x", "x^6-6*x^5+15*x^4-20*x^3+15*x^2-6*x",
        "x^5-0.5*x^4+0.1*x^3-0.01*x^2+0.0005*x", "x^4-2*x^2+1"}) {
    const formula f = parsed(text);
    const judge::exact_text exact(text);
    std::string sizes = text; // the sum of the terms' magnitudes, at |x|
    std::replace(sizes.begin(), sizes.end(), '-', '+');
    const judge::exact_text condition(sizes);
    int wrong = 0, wide = 0;
    const auto value = [](const judge::exact_text& p, const mpq_class& x) -> mpq_class {
      return p(oracle::polynomial(x), oracle::polynomial(0), oracle::polynomial(0)).coefficient(0);
    };
    const rounding::upward::scope scope;
    using interval = bound<rounding::upward>;
    const interval zero(0.0);
    for (int i = 0; i <= 6000; ++i) {
      const double x = i / 1000.0 - 3, beyond = std::nextafter(x, 4);
      const interval at = f.surface()(interval(x), zero, zero),
                     between = f.surface()(interval(x, beyond), zero, zero);
      const mpq_class first = value(exact, x), last = value(exact, beyond);
      const mpq_class size = (value(condition, abs(mpq_class(x))) + 0x1p-1000) * mpq_class(0x1p-52);
      wrong += first < at.lower() || at.upper() < first || first < between.lower() ||
               last < between.lower() || between.upper() < first || between.upper() < last;
      wide += at.upper() - mpq_class(at.lower()) > 24 * size ||
              between.upper() - mpq_class(between.lower()) > 40 * size;
    }
    // ranges, which turn within
    for (int i = 0; i < 200; ++i) {
      const double x = i / 40.0 - 2.5, length = i % 7 * 0.1;
      const interval range = f.surface()(interval(x, x + length), zero, zero);
      for (int k = 0; k <= 64; ++k) {
        const double t = std::min(x + length * k / 64, x + length);
        const mpq_class at = value(exact, t);
        wrong += at < range.lower() || range.upper() < at;
      }
    }
    INFO(text);
    CHECK(wrong == 0);
    CHECK(wide == 0);
  }
}

TEST_CASE(
    "octree.polynomials: what is too large for exact arithmetic is left open, in bounded time",
    "[unit]") {
  const box domain = cube_of(2);
  for (const char* text : {"(x^2+y^2-1)^64+0*z", "(x^40-x^39+y)^2", "((x+y)^8+(y-z)^8-0.001)^8",
                           "(x+1e-300)^2*(y-1e300)^2", "(x*1e-200+1e-300*y)^40"}) {
    const certified_hit h =
        hits_of(parsed(text), domain, {*ray::make({-3, 0.1, 0.2}, {1, 0, 0})})[0];
    CHECK(h.t_near <= h.t_far);
  }
}

TEST_CASE("octree.polynomials: constants are the numbers that are written", "[unit]") {
  // each has a zero only if decimals are taken for their doubles, or the other way round
  for (const char* text : {"(x-0.1)^2+(0.1+0.2-0.3)^2*0+1e-60", "(x*10-1)^2+(y-0.1)^2"})
    CHECK(decided(text, cube_of(4), along_x(-2, 0.1)).outcome == verdict::miss);
  for (const char* text : {"(x-0.1)^2+(0.1+0.2-0.3)^2", "(x-0x1.8p-1)^2+(0.1e1-1)^2",
                           "(x-1/3)^2+(1/3*3-1)^2", "(x-1.5)^2+((0.1)^20*1e20-1)^2"}) {
    const formula f = parsed(text);
    CHECK(hits_of(f, cube_of(4), {along_x(-2)})[0].outcome == verdict::hit);
  }
  // numbers that have the same neighbours are not the same
  for (const char* text :
       {"abs(0.1*x)-abs((0.1+1e-30)*x)", "abs(0.1*x)-abs(0.1000000000000000000001*x)",
        "abs(pi*x)-abs(3.1415926535897932*x)"}) {
    const formula f = parsed(text);
    CHECK(f.surface().program().code.size() > 2);
  }
}
