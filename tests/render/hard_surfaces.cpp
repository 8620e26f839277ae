// The gallery of hard surfaces: each with the verdicts that are expected.
#include <catch2/catch.hpp>
#include <fstream>
#include <graze/oracle/polynomial.hpp>
#include <graze/oracle/roots.hpp>
#include <graze/render/render.hpp>
#include <graze/render/scene_text.hpp>
#include <sstream>

using namespace graze;
using namespace graze::render;

namespace {

scene hard(const std::string& name) {
  std::ifstream file(std::string(GRAZE_SCENES) + "/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  const auto s = scene_from(text.str());
  INFO(name << ": " << s.reason());
  REQUIRE(s);
  return *s;
}

/// 65x65: the ray of the middle pixel goes through the camera's aim exactly.
tally counts(const scene& s, int levels, method search = method::descent) {
  const auto surface = prepare(s, 5, levels, search);
  INFO(s.name << ": " << surface.reason());
  REQUIRE(surface);
  return render_picture(s, **surface, {65, 2}).counts;
}

tally certified_counts(const scene& s) { return counts(s, 30, method::certified); }

/// Rays of the 65x65 pixels that meet the sphere, exactly.
std::uint64_t rays_that_meet(const scene& s, const vec3& centre,
                             const mpq_class& square_of_radius) {
  std::uint64_t meet = 0;
  for (int row = 0; row < 65; ++row)
    for (int column = 0; column < 65; ++column) {
      const octree::ray r = s.view.ray_through(column, row, 65);
      mpq_class dd = 0, od = 0, oo = -square_of_radius;
      for (std::size_t a = 0; a < 3; ++a) {
        const mpq_class d = r.direction()[a], o = mpq_class(r.origin()[a]) - centre[a];
        dd += d * d;
        od += o * d;
        oo += o * o;
      }
      meet += od * od >= dd * oo;
    }
  return meet;
}

} // namespace

TEST_CASE("render.hard: algebraic surfaces with many nodes, no pixel undecided", "[unit]") {
  struct row {
    const char* name;
    std::uint64_t hits;
  };
  for (const row& r :
       {row{"barth_sextic", 753}, row{"barth_decic", 1085}, row{"kummer_quartic", 1308},
        row{"steiner_roman", 1120}, row{"chmutov_sextic", 1306}}) {
    const scene s = hard(r.name);
    for (const tally& c : {counts(s, 30), certified_counts(s)}) {
      INFO(r.name);
      CHECK(c.hits == r.hits);
      CHECK(c.misses == 4225 - r.hits);
      CHECK(c.undecided == 0);
    }
  }
}

TEST_CASE("render.hard: a double root is left open by the descent, and decided along the ray",
          "[mpfr]") {
  const scene s = hard("double_root");
  const std::uint64_t meet = rays_that_meet(s, {0, 0, 0}, 1);
  CHECK(meet == 1533);
  const tally descent = counts(s, 30), along = certified_counts(s);
  CHECK(descent.hits == 0);
  CHECK(descent.undecided == meet);
  CHECK(descent.misses == 4225 - meet);
  CHECK(along.hits == meet);
  CHECK(along.undecided == 0);
  CHECK(along.misses == 4225 - meet);
}

TEST_CASE("render.hard: the ray through a cone's tip is left open by the descent, and is a hit",
          "[unit]") {
  const scene s = hard("cone_tip");
  for (const tally& c : {counts(s, 30), counts(s, 50)}) {
    CHECK(c.hits == 2313);
    CHECK(c.misses == 1911);
    CHECK(c.undecided == 1);
  }
  const tally along = certified_counts(s);
  CHECK(along.hits == 2314);
  CHECK(along.misses == 1911);
  CHECK(along.undecided == 0);
}

TEST_CASE("render.hard: a shell of 5e-13 is undecided where octants are thicker, else hit",
          "[mpfr]") {
  const scene s = hard("thin_shell");
  const std::uint64_t meet = rays_that_meet(s, {0, 0, 0}, 1);
  const tally coarse = counts(s, 30);
  CHECK(coarse.misses == 4225 - meet);
  CHECK(coarse.undecided >= meet - 5);
  for (const tally& fine : {counts(s, 50), certified_counts(s)}) {
    CHECK(fine.hits == meet);
    CHECK(fine.misses == 4225 - meet);
  }
}

TEST_CASE("render.hard: a sphere of radius 1 at a distance of 7,000,000", "[mpfr]") {
  const scene s = hard("far_tiny_sphere");
  const std::uint64_t meet = rays_that_meet(s, {3e6, 2e6, 6e6}, 1);
  CHECK(meet == 1151);
  const tally coarse = counts(s, 30);
  CHECK(coarse.hits == meet);
  CHECK(coarse.undecided <= 10); // octants of 1/64 beside the sphere
  for (const tally& fine : {counts(s, 50), certified_counts(s)}) {
    CHECK(fine.hits == meet);
    CHECK(fine.misses == 4225 - meet);
  }
}

TEST_CASE("render.hard: shadow rays along a cone's rulings come to an end", "[unit]") {
  const scene s = hard("cone_tip");
  const auto search = GENERATE(method::descent, method::certified);
  const auto surface = prepare(s, 5, 50, search);
  REQUIRE(surface);
  settings chosen = {40, 2, mode::trace};
  const tally c = render_picture(s, **surface, chosen).counts;
  CHECK(c.pixels == 1600);
  CHECK(c.shadow_rays > 500);
}

TEST_CASE("render.hard: a descent that goes deeper decides no less, and its octree is bounded",
          "[unit]") {
  // a septic of Breske, Labs and van Straten, expanded: its surface fills the domain
  const auto s = scene_from(
      R"({"formula": "(2*x^7-42*x^5*y^2+70*x^3*y^4-14*x*y^6-14*x^6+70*x^4*y^2+70*x^2*y^4-14*y^6+28*x^5+56*x^3*y^2+28*x*y^4-84*x^2*y^2+28*y^4-42*x^3-42*x*y^2+14*x^2-14*y^2+14*x)+(64*z^7-112*z^5+56*z^3-7*z+5)/2", "domain": [-3, 3]})");
  REQUIRE(s);
  const auto along = prepare(*s, 9, 30, method::certified);
  REQUIRE(along);
  settings chosen = {40, 2, mode::cast};
  const tally exact = render_picture(*s, **along, chosen).counts;
  CHECK(exact.undecided == 0);
  for (const int levels : {12, 30}) {
    const auto surface = prepare(*s, 9, levels, method::descent);
    REQUIRE(surface);
    CHECK((*surface)->octree_leaves() < 100'000); // 1.6 million at level 9
    const tally c = render_picture(*s, **surface, chosen).counts;
    INFO("NL " << levels);
    CHECK(c.undecided <= (levels == 12 ? 1 : 0));
    CHECK(c.hits + c.undecided >= exact.hits);
    CHECK(c.misses <= exact.misses);
  }
}
