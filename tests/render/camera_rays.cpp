// The camera's rays against the design's formula in rationals.
#include <catch2/catch.hpp>
#include <gmpxx.h>
#include <graze/render/camera.hpp>
#include <graze/render/scene.hpp>

using namespace graze::render;

namespace {

/// CD + ((i + 1/2)/n - 1/2) CR + (1/2 - (j + 1/2)/n) CU with the design's decimals.
mpq_class ideal(int axis, int i, int j, int n) {
  static const mpq_class centre[] = {-3, -2, -6};
  static const mpq_class right[] = {mpq_class("3578125/1000000"), 0,
                                    mpq_class("-17890625/10000000")};
  static const mpq_class up[] = {mpq_class("-51171875/100000000"),
                                 mpq_class("38330078125/10000000000"),
                                 mpq_class("-10224609375/10000000000")};
  mpq_class u(2 * i + 1, 2 * n), v(2 * j + 1, 2 * n);
  u.canonicalize();
  v.canonicalize();
  mpq_class r = right[axis], c = up[axis];
  r.canonicalize();
  c.canonicalize();
  return centre[axis] + (u - mpq_class(1, 2)) * r + (mpq_class(1, 2) - v) * c;
}

} // namespace

TEST_CASE("render.camera: at 512x512 every ray is the design's, exactly", "[unit]") {
  const camera view = camera::standard(2);
  for (const int i : {0, 1, 255, 256, 300, 511})
    for (int j = 0; j < 512; ++j) {
      const auto r = view.ray_through(i, j, 512);
      REQUIRE(r.origin() == vec3{6, 4, 12});
      for (int a = 0; a < 3; ++a)
        REQUIRE(mpq_class(r.direction()[a]) == ideal(a, i, j, 512));
    }
}

TEST_CASE("render.camera: at other sizes a ray is within 2^-49 of the design's", "[unit]") {
  const camera view = camera::standard(1.125);
  for (const int n : {1, 3, 100, 501, 1000})
    for (int i = 0; i < n; i += 7)
      for (int j = 0; j < n; j += 5) {
        const auto r = view.ray_through(i, j, n);
        for (int a = 0; a < 3; ++a)
          REQUIRE(abs(mpq_class(r.direction()[a]) - ideal(a, i, j, n)) < mpq_class(0x1p-49));
      }
}

TEST_CASE("render.scene: the table is the design's", "[unit]") {
  REQUIRE(scenes().size() == 6);
  const auto is = [](const char* name, double scale, double half) {
    const scene* s = find_scene(name);
    REQUIRE(s != nullptr);
    CHECK(s->view == camera::standard(scale));
    CHECK(s->domain == graze::octree::box{{-half, -half, -half}, {half, half, half}});
  };
  is("spheres", 1.5, 2.5);
  is("quartdef", 1.125, 1.5);
  is("tanglecube", 2, 2.5);
  is("holesrot", 2, 2);
  is("asterisk(3,4)", 0.5, 1);
  is("asterisk(9,18)", 0.5, 1);
  CHECK(find_scene("teapot") == nullptr);
}
