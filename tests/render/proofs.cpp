// What is told as proven, against exact roots and normals there in rationals.
#include "../support/exact_roots.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/render/arrays.hpp>
#include <graze/render/scene_text.hpp>

using namespace graze;
using namespace graze::render;

namespace {

using exact3 = std::array<mpq_class, 3>;

/// Half the gradient of the tanglecube, or of the sphere that the point is nearest to.
exact3 gradient_of(const octree::tanglecube&, const exact3& p) {
  exact3 g;
  for (std::size_t a = 0; a < 3; ++a)
    g[a] = 2 * p[a] * p[a] * p[a] - 5 * p[a];
  return g;
}
exact3 gradient_of(const octree::spheres&, const exact3& p) {
  exact3 g;
  mpq_class least = 1000;
  for (const auto& s : octree::spheres::parts) {
    const exact3 away = {p[0] - mpq_class(s.centre[0]), p[1] - mpq_class(s.centre[1]),
                         p[2] - mpq_class(s.centre[2])};
    const mpq_class value = away[0] * away[0] + away[1] * away[1] + away[2] * away[2] -
                            mpq_class(s.radius) * mpq_class(s.radius);
    if (value < least) {
      least = value;
      g = away;
    }
  }
  return g;
}

/// Roots are known to 2^-100 of t; what follows from them to a little less.
const mpq_class slack(0x1p-90);

template <class F> void judge(const char* name, method search, double widest) {
  const scene& s = *find_scene(name);
  const auto surface = prepare(s, 6, 30, search);
  REQUIRE(surface);
  const int size = 96;
  const rendering r = render_picture(s, **surface, {size, 2, mode::cast, 1, {}, true});
  const picture image = to_picture(r);
  int hits = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const auto i = static_cast<std::size_t>(row * size + column);
      const proof& p = r.facts[i].proven;
      const octree::ray ray = s.view.ray_through(column, row, size);
      const auto root = ::support::first_root(F{}, ray, s.domain);
      INFO(name << " column " << column << " row " << row);
      REQUIRE(r.facts[i].verdict == (root ? 0 : 1));
      if (!root) {
        CHECK(std::isinf(p.depth_lower));
        CHECK(std::isinf(p.depth_upper));
        CHECK(std::isnan(p.point.lo[0]));
        CHECK(std::isnan(p.normal.hi[2]));
        continue;
      }
      ++hits;
      mpq_class square = 0, gradient_square = 0;
      exact3 at;
      for (std::size_t a = 0; a < 3; ++a) {
        const mpq_class d(ray.direction()[a]);
        square += d * d;
        at[a] = mpq_class(ray.origin()[a]) + root->lo * d;
        REQUIRE(mpq_class(p.point.lo[a]) <= at[a] + slack);
        REQUIRE(at[a] - slack <= mpq_class(p.point.hi[a]));
      }
      const mpq_class lower(p.depth_lower), upper(p.depth_upper);
      REQUIRE(lower >= 0);
      REQUIRE(lower * lower <= root->hi * root->hi * square);
      REQUIRE(root->lo * root->lo * square <= upper * upper);
      REQUIRE(p.depth_upper - p.depth_lower < widest);
      const exact3 g = gradient_of(F{}, at);
      for (const mpq_class& part : g)
        gradient_square += part * part;
      for (std::size_t a = 0; a < 3; ++a) { // n |n| rises with n
        const mpq_class n = sgn(g[a]) * g[a] * g[a] / gradient_square, lo(p.normal.lo[a]),
                        hi(p.normal.hi[a]);
        REQUIRE(sgn(lo) * lo * lo <= n + slack);
        REQUIRE(n - slack <= sgn(hi) * hi * hi);
        REQUIRE(p.normal.hi[a] - p.normal.lo[a] < 100 * widest);
        const std::string axis(1, "XYZ"[a]);
        REQUIRE(static_cast<double>(image.find("normal.lower." + axis)->values[i]) <=
                p.normal.lo[a]);
        REQUIRE(static_cast<double>(image.find("normal.upper." + axis)->values[i]) >=
                p.normal.hi[a]);
      }
      for (const auto& [layer, value] :
           {std::pair{"depth.lower.", p.depth_lower}, {"depth.upper.", p.depth_upper}}) {
        double sum = 0;
        for (const char* part : {"1", "2", "3"})
          sum += static_cast<double>(image.find(layer + std::string(part))->values[i]);
        REQUIRE(sum == value);
      }
    }
  CHECK(hits > 1500);
}

} // namespace

TEST_CASE("render.proof: depth, point and normal hold the exact first root's", "[mpfr]") {
  judge<octree::tanglecube>("tanglecube", method::certified, 1e-11);
  judge<octree::spheres>("spheres", method::certified, 1e-11);
  judge<octree::tanglecube>("tanglecube", method::descent, 1e-6);
  judge<octree::spheres>("spheres", method::descent, 1e-6);
}

TEST_CASE("render.proof: no normal is told where there may be none", "[unit]") {
  const auto middle_of = [](const char* text) {
    const auto s = scene_from(text);
    REQUIRE(s);
    const auto surface = prepare(*s, 6, 30, method::certified);
    REQUIRE(surface);
    const rendering r = render_picture(*s, **surface, {1, 1, mode::cast, 1, {}, true});
    return r.facts.front();
  };
  const auto cone = middle_of(
      R"({"formula": "z^3 + (x^2+y^2)*z", "domain": [-1, 1], "camera":
          {"eye": [0, 0, 4], "look_at": [0, 0, 0]}})"); // the gradient is 0 at the only root
  if (cone.verdict == 0) {
    CHECK(std::isnan(cone.proven.normal.lo[2]));
    CHECK(cone.proven.depth_lower <= 4);
    CHECK(cone.proven.depth_upper >= 4);
  }
  const auto plane = middle_of(
      R"({"formula": "z/2", "domain": [-1, 1], "camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0]}})");
  CHECK(plane.verdict == 0);
  CHECK(plane.proven.normal.lo[2] <= 1);
  CHECK(plane.proven.normal.lo[2] > 1 - 1e-15);
  CHECK(plane.proven.normal.hi[2] == 1);
  CHECK(plane.proven.normal.lo[0] <= 0);
  CHECK(plane.proven.normal.hi[0] >= 0);
}

TEST_CASE("render.proof: parts of a double as floats are its sum, or beyond it", "[unit]") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 1.0, 1 + 0x1p-52, 0.1, 1e-30, 0x1.fffffffffffffp+100, 3e38, 1e39,
                         1e300, 1e-44, 5e-324, 0x1.8000000000001p-140, inf}) {
    rendering r;
    r.pixels.resize(1);
    r.facts.resize(1);
    r.facts[0].proven.depth_lower = r.facts[0].proven.depth_upper = x;
    const picture image = to_picture(r);
    const auto sum = [&](const std::string& layer) {
      double all = 0;
      for (const char* part : {"1", "2", "3"})
        all += static_cast<double>(image.find(layer + part)->values[0]);
      return all;
    };
    INFO(x);
    CHECK(sum("depth.lower.") <= x);
    CHECK(sum("depth.upper.") >= x);
    if (x == 0 || x == inf || (x > 0x1p-90 && x < 0x1p127)) {
      CHECK(sum("depth.lower.") == x);
      CHECK(sum("depth.upper.") == x);
    }
  }
}
