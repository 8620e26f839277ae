// Where shadow rays and reflected rays begin, against exact geometry.
#include "../support/exact_roots.hpp"
#include <catch2/catch.hpp>
#include <graze/octree/lane_kernels.hpp>
#include <graze/render/render.hpp>

using namespace graze;
using namespace graze::render;

namespace {

template <class F> int exact_sign(const F& f, const std::array<mpq_class, 3>& p) {
  const oracle::polynomial v =
      f(oracle::polynomial(p[0]), oracle::polynomial(p[1]), oracle::polynomial(p[2]));
  return v.degree() < 0 ? 0 : sgn(v.coefficient(0));
}

std::array<mpq_class, 3> exact_point(const octree::ray& r, const mpq_class& t) {
  std::array<mpq_class, 3> p;
  for (std::size_t a = 0; a < 3; ++a)
    p[a] = mpq_class(r.origin()[a]) + t * mpq_class(r.direction()[a]);
  return p;
}

/// Every 8th hit of the scene, its departure, and the rays from there.
template <class F> void check(const char* name, int levels, method search) {
  const scene& s = *find_scene(name);
  const auto surface = prepare(s, 7, levels, search);
  REQUIRE(surface);
  int departures = 0, secondary = 0, undecided = 0;
  for (int row = 1; row < 512; row += 12)
    for (int column = 5; column < 512; column += 12) {
      const octree::ray r = s.view.ray_through(column, row, 512);
      octree::surface_hit h{};
      (*surface)->first_hits({&r, 1}, {&h, 1}, nullptr);
      if (h.outcome != octree::verdict::hit)
        continue;
      departure from{};
      (*surface)->depart({&r, 1}, {&h, 1}, {&from, 1});
      INFO(name << " column " << column << " row " << row);
      REQUIRE(from.proven);
      ++departures;
      // on the side from which the ray came, as near as told
      const std::array<mpq_class, 3> p = {from.point[0], from.point[1], from.point[2]};
      const int before = exact_sign(F{}, exact_point(r, h.t_near));
      if (before != 0)
        REQUIRE(exact_sign(F{}, p) == before);
      const auto root = ::support::first_root(F{}, r, s.domain);
      REQUIRE(root);
      const auto q = exact_point(r, root->lo);
      mpq_class square = 0;
      for (std::size_t a = 0; a < 3; ++a)
        square += (p[a] - q[a]) * (p[a] - q[a]);
      REQUIRE(square <= mpq_class(from.shift) * from.shift * (1 + mpq_class(0x1p-60)));

      const vec3 point = {from.point};
      const vec3 normal = facing_normal((*surface)->gradient(point), r.direction());
      const vec3& lamp = s.lights[0].position;
      std::vector<vec3> directions = {reflected(r.direction(), normal)};
      const vec3 to_light = {lamp[0] - point[0], lamp[1] - point[1], lamp[2] - point[2]};
      if (normal[0] * to_light[0] + normal[1] * to_light[1] + normal[2] * to_light[2] > 0)
        directions.push_back(to_light);
      for (const vec3& d : directions) {
        const octree::ray next = *octree::ray::make(from.point, d);
        octree::surface_hit found{};
        (*surface)->first_hits({&next, 1}, {&found, 1}, nullptr);
        ++secondary;
        undecided += found.outcome == octree::verdict::undecided;
        if (found.outcome == octree::verdict::undecided)
          continue;
        // not the hit that it left, unless the exact ray meets the surface there again
        const auto exact = ::support::first_root(F{}, next, s.domain);
        REQUIRE(found.outcome == (exact ? octree::verdict::hit : octree::verdict::miss));
        if (!exact)
          continue;
        REQUIRE(exact->lo > 0);
        REQUIRE(mpq_class(found.t_near) <= exact->hi);
        REQUIRE(exact->lo <= mpq_class(found.t_far));
      }
    }
  INFO(name << " " << departures << " departures, " << secondary << " secondary rays, " << undecided
            << " undecided");
  CHECK(departures > 400);
  CHECK(secondary > 800);
  CHECK(undecided * 200 < secondary);
}

struct unit_ball {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return octree::sqr(x) + octree::sqr(y) + octree::sqr(z) - octree::constants<N>::exact(1);
  }
};

struct nothing {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return (x + y + z) * octree::constants<N>::exact(0);
  }
};

} // namespace

TEST_CASE("render.secondary: rays begin on the seen side, as near as told, and are judged exactly",
          "[mpfr]") {
  const auto search = GENERATE(method::descent, method::certified);
  for (const int levels : {30, 50}) {
    check<octree::tanglecube>("tanglecube", levels, search);
    check<octree::quartdef>("quartdef", levels, search);
    if (search == method::certified)
      break; // it has no levels
  }
}

TEST_CASE("render.secondary: no ray that leaves a ball outwards meets it, at any angle", "[unit]") {
  const octree::box domain = {{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}};
  const auto tree = octree::voxelize(unit_ball{}, domain, 6);
  REQUIRE(tree);
  const int levels = GENERATE(20, 30, 50);
  const auto surface =
      octree::surface_traversal<unit_ball>::make(unit_ball{}, domain, *tree, levels);
  REQUIRE(surface);
  int left = 0;
  for (int i = 0; i < 400; ++i) {
    // ever nearer to grazing: 1 - x falls to 1e-9
    const double x = 1 - std::pow(0.95, i);
    const octree::ray r = *octree::ray::make({x, 0.01, 4}, {0, 0, -1});
    const octree::surface_hit h = surface->first_hit(r);
    if (h.outcome != octree::verdict::hit)
      continue;
    departure from{};
    {
      [[maybe_unused]] const rounding::upward::scope scope;
      from = depart<unit_ball, rounding::upward>(unit_ball{}, domain, r, h, 0.01);
    }
    if (!from.proven)
      continue;
    ++left;
    for (const double steepness : {1.0, 1e-3, 1e-6}) {
      const vec3 n = {from.point[0], from.point[1], from.point[2]};
      const vec3 along = {-n[2], 0, n[0]}; // at a right angle to n
      vec3 d;
      for (std::size_t a = 0; a < 3; ++a)
        d[a] = steepness * n[a] + along[a];
      INFO("x " << x << " steepness " << steepness << " shift " << from.shift);
      const octree::surface_hit again = surface->first_hit(*octree::ray::make(from.point, d));
      CHECK(again.outcome != octree::verdict::hit);
      if (steepness == 1.0)
        CHECK(again.outcome == octree::verdict::miss);
    }
  }
  CHECK(left > 100);
}

TEST_CASE("render.secondary: no departure is proven where f has no proven sign", "[unit]") {
  const octree::box domain = {{-2, -2, -2}, {2, 2, 2}};
  const octree::ray r = *octree::ray::make({0, 0, 1.5}, {0, 0, -1});
  [[maybe_unused]] const rounding::upward::scope scope;
  const octree::surface_hit h{octree::verdict::hit, 0.5, 0.5, {{}, 0}, false};
  CHECK_FALSE(depart<nothing, rounding::upward>(nothing{}, domain, r, h, 0.1).proven);
}

TEST_CASE("render.trace: the same picture for one thread and for three; shadows are darker",
          "[unit]") {
  const scene& s = *find_scene("spheres");
  const auto surface = prepare(s, 6, 30);
  REQUIRE(surface);
  settings chosen = {70, 1, mode::trace};
  const rendering single = render_picture(s, **surface, chosen);
  chosen.threads = 3;
  const rendering three = render_picture(s, **surface, chosen);
  CHECK(*encode(to_picture(single), file_format::exr) ==
        *encode(to_picture(three), file_format::exr));
  CHECK(single.counts.shadow_rays > 1000);
  CHECK(single.counts.reflected_rays > 1000);
  CHECK(single.counts.shadow_rays == three.counts.shadow_rays);
  CHECK(single.counts.longest_shift > 0);
  CHECK(single.counts.longest_shift == three.counts.longest_shift);

  // without reflection, tracing can only take light away
  scene matt = s;
  matt.objects[0].look.reflection = 0;
  const rendering traced = render_picture(matt, **surface, {70, 2, mode::trace});
  const rendering cast = render_picture(matt, **surface, {70, 2});
  int darker = 0;
  for (std::size_t i = 0; i < cast.pixels.size(); ++i) {
    CHECK(traced.pixels[i].colour[0] <= cast.pixels[i].colour[0]);
    darker += traced.pixels[i].colour[0] < cast.pixels[i].colour[0];
  }
  CHECK(darker > 50);
  CHECK(traced.counts.reflected_rays == 0);
}

TEST_CASE("render.sampling: crops and samples are those of the whole and of the larger picture",
          "[unit]") {
  const scene& s = *find_scene("tanglecube");
  const auto surface = prepare(s, 6, 30);
  REQUIRE(surface);
  settings chosen = {{48, 40}, 2, mode::trace};
  const rendering whole = render_picture(s, **surface, chosen);
  chosen.crop = window{7, 5, {33, 21}};
  const rendering part = render_picture(s, **surface, chosen);
  REQUIRE(part.pixels.size() == 33 * 21);
  for (std::size_t row = 0; row < 21; ++row)
    for (std::size_t column = 0; column < 33; ++column)
      REQUIRE(part.pixels[row * 33 + column].colour ==
              whole.pixels[(row + 5) * 48 + column + 7].colour);

  const rendering large = render_picture(s, **surface, {64, 2});
  const rendering sampled = render_picture(s, **surface, {32, 2, mode::cast, 2});
  CHECK(sampled.counts.pixels == 1024);
  CHECK(sampled.counts.camera_rays == 5 * 1024);
  for (std::size_t row = 0; row < 32; ++row)
    for (std::size_t column = 0; column < 32; ++column) {
      const auto at = [&](std::size_t j, std::size_t i) {
        return large.pixels[(2 * row + j) * 64 + 2 * column + i].colour[0];
      };
      CHECK(sampled.pixels[row * 32 + column].colour[0] ==
            Approx((at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1)) / 4).margin(1e-6));
    }
}
