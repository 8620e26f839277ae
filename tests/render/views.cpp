// Cameras as people ask for them, what they show, colours, light and background.
#include <catch2/catch.hpp>
#include <cmath>
#include <fmt/format.h>
#include <graze/render/render.hpp>
#include <graze/render/scene_text.hpp>

using namespace graze::render;

namespace {

scene parsed(const std::string& text) {
  const auto s = scene_from(text);
  INFO(text << "\n" << s.reason());
  REQUIRE(s);
  return *s;
}
scene of_formula(const std::string& formula, const std::string& domain,
                 const std::string& more = "") {
  return parsed(R"({"formula": ")" + formula + R"(", "domain": )" + domain + more + "}");
}
scene seen(scene s, const framing& asked) {
  const auto made = settle_view(s, asked);
  INFO(made.reason());
  REQUIRE(made);
  return s;
}
rendering render(const scene& s, int size, int sampling = 1) {
  const auto surface = prepare(s, 6, 30, method::certified);
  INFO(s.name << " " << surface.reason());
  REQUIRE(surface);
  return render_picture(s, **surface, {size, 2, mode::cast, sampling, {}, true});
}

framing by_angles(double azimuth, double elevation, const vec3& up) {
  framing f;
  f.azimuth = azimuth;
  f.elevation = elevation;
  f.up = up;
  return f;
}
camera framed(const framing& asked, const ball& shown = {{0, 0, 0}, 1}) {
  const auto made = frame(asked, shown);
  INFO(made.reason());
  REQUIRE(made);
  return made->view;
}
double length(const vec3& v) { return std::sqrt(detail::dot(v, v)); }
bool near(const vec3& a, const vec3& b, double most = 1e-12) {
  return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}) <= most * (1 + length(b));
}
constexpr vec3 x_up = {1, 0, 0}, y_up = {0, 1, 0}, z_up = {0, 0, 1};

} // namespace

TEST_CASE("render.view: azimuth turns by the right hand from the axis after up, elevation rises",
          "[unit]") {
  const auto direction = [](const framing& asked) {
    const vec3 eye = framed(asked).eye; // looks at 0
    return vec3{eye[0] / length(eye), eye[1] / length(eye), eye[2] / length(eye)};
  };
  CHECK(near(direction(by_angles(0, 0, z_up)), {1, 0, 0}));
  CHECK(near(direction(by_angles(90, 0, z_up)), {0, 1, 0}));
  CHECK(near(direction(by_angles(-90, 0, z_up)), {0, -1, 0}));
  CHECK(near(direction(by_angles(7, 90, z_up)), {0, 0, 1}));
  CHECK(near(direction(by_angles(7, -90, z_up)), {0, 0, -1}));
  CHECK(near(direction(by_angles(0, 0, y_up)), {0, 0, 1}));
  CHECK(near(direction(by_angles(90, 0, y_up)), {1, 0, 0}));
  CHECK(near(direction(by_angles(90, 0, x_up)), {0, 0, 1}));
  CHECK(near(direction(by_angles(30, 40, {0, 0, 5})), direction(by_angles(390, 40, z_up))));
  CHECK(near(direction({}), {3 / 7., 2 / 7., 6 / 7.}));
}

TEST_CASE(
    "render.view: right, up and the view are at right angles, the point is in the middle, and "
    "the angle is what was asked",
    "[unit]") {
  framing by_eye, around = by_angles(123, -35, {1, 2, 3});
  by_eye.eye = vec3{3, -1, 2};
  by_eye.look_at = around.look_at = vec3{0.5, 0.25, -1};
  for (framing asked : {by_eye, around}) {
    asked.fov = 50;
    const camera c = framed(asked);
    const double scale = length(c.centre) * length(c.up);
    CHECK(std::fabs(detail::dot(c.centre, c.right)) < 1e-13 * scale);
    CHECK(std::fabs(detail::dot(c.centre, c.up)) < 1e-13 * scale);
    CHECK(std::fabs(detail::dot(c.right, c.up)) < 1e-13 * scale);
    CHECK(std::fabs(detail::dot(c.right, asked.up.value_or(y_up))) < 1e-13 * scale); // the horizon
    CHECK(detail::dot(c.up, asked.up.value_or(y_up)) > 0);
    CHECK(near({c.eye[0] + c.centre[0], c.eye[1] + c.centre[1], c.eye[2] + c.centre[2]},
               *asked.look_at));
    CHECK(length(c.up) == Approx(length(c.right)).epsilon(1e-13));
    CHECK(std::atan(length(c.up) / 2 / length(c.centre)) * 360 / M_PI == Approx(50).epsilon(1e-12));
    framing closer = asked;
    closer.zoom = 4;
    const camera z = framed(closer);
    CHECK(z.eye == c.eye);
    CHECK(length(z.up) == Approx(length(c.up) / 4).epsilon(1e-13));
  }
}

TEST_CASE("render.view: a quarter turn about an axis permutes the camera's coordinates, exactly",
          "[unit]") {
  for (const vec3& up : {x_up, y_up, z_up})
    for (const double azimuth : {0.0, 20.0, 123.456}) {
      const camera c = framed(by_angles(azimuth, 33, up)),
                   d = framed(by_angles(azimuth + 90, 33, up)),
                   e = turned(*frame(by_angles(azimuth, 33, up), ball{{0, 0, 0}, 1}), 90);
      const std::size_t a = up == x_up ? 0 : up == y_up ? 1 : 2, b = (a + 1) % 3, k = (a + 2) % 3;
      for (const auto part : {&camera::eye, &camera::centre, &camera::right, &camera::up}) {
        const vec3& from = c.*part;
        vec3 to;
        to[a] = from[a];
        to[b] = -from[k];
        to[k] = from[b];
        CHECK((e.*part) == to);
        CHECK(near(d.*part, to)); // azimuth + 90 may be rounded
        if (azimuth == 0 || azimuth == 20)
          CHECK((d.*part) == to);
      }
    }
}

TEST_CASE(
    "render.view: a surface that a quarter turn about z maps to itself looks alike from four sides",
    "[unit]") {
  const scene s =
      of_formula("x^4 + y^4 - 5*x^2 - 5*y^2 + z^4/2 - 2*z^2*(x^2+y^2)/9 + 10", "[-3, 3]");
  const rendering first = render(seen(s, by_angles(20, 25, z_up)), 64);
  CHECK(first.counts.hits > 1000);
  for (const double azimuth : {110, 200, 290}) {
    const rendering r = render(seen(s, by_angles(azimuth, 25, z_up)), 64);
    for (std::size_t i = 0; i < r.pixels.size(); ++i) {
      REQUIRE(r.facts[i].verdict == first.facts[i].verdict);
      REQUIRE((r.pixels[i].depth == first.pixels[i].depth ||
               std::fabs(r.pixels[i].depth - first.pixels[i].depth) < 1e-5f));
    }
  }
}

TEST_CASE("render.view: turning the eye by 90 degrees is turning the surface by -90", "[unit]") {
  const rendering eye_turned =
      render(seen(of_formula("(x-0.25)^2 + 2*y^2 + 3*(z+0.125)^2 + x*y/2 + x^3/4 - 0.5", "[-1, 1]"),
                  by_angles(90, 10, z_up)),
             64);
  const rendering surface_turned = render(
      seen(of_formula("(-y-0.25)^2 + 2*x^2 + 3*(z+0.125)^2 - x*y/2 - y^3/4 - 0.5", "[-1, 1]"),
           by_angles(0, 10, z_up)),
      64);
  const rendering other_turned = render(
      seen(of_formula("(-y-0.25)^2 + 2*x^2 + 3*(z+0.125)^2 - x*y/2 - y^3/4 - 0.5", "[-1, 1]"),
           by_angles(180, 10, z_up)),
      64);
  int differs = 0;
  for (std::size_t i = 0; i < eye_turned.facts.size(); ++i) {
    CHECK(eye_turned.facts[i].verdict == surface_turned.facts[i].verdict);
    differs += eye_turned.facts[i].verdict != other_turned.facts[i].verdict ||
                       std::fabs(eye_turned.pixels[i].depth - other_turned.pixels[i].depth) > 0.01f
                   ? 1
                   : 0;
  }
  CHECK(differs > 100);
}

TEST_CASE("render.view: the surface fills the picture and is within it, however large the domain",
          "[unit]") {
  struct place {
    const char *formula, *domain;
    framing asked;
  };
  framing by_eye;
  by_eye.eye = vec3{50, 20, 30};
  framing wide;
  wide.fov = 100;
  const char* const here = "x^2 + y^2 + z^2 - 1";
  const char* const there = "(x - 40)^2 + (y + 30)^2 + (z - 7)^2 - 1";
  for (const place& p : {place{here, "[-1.5, 1.5]", {}}, place{here, "[-200, 300]", {}},
                         place{there, "[-90, 100]", {}}, place{there, "[-90, 100]", by_eye},
                         place{here, "[-200, 300]", by_angles(200, 70, z_up)},
                         place{here, "[-2, 2]", wide}, place{here, "[-2, 2]", by_eye}}) {
    const rendering r = render(seen(of_formula(p.formula, p.domain), p.asked), 100);
    int first = 100, last = 0, top = 100, bottom = 0;
    for (int row = 0; row < 100; ++row)
      for (int column = 0; column < 100; ++column)
        if (r.facts[static_cast<std::size_t>(row * 100 + column)].verdict == 0) {
          first = std::min(first, column);
          last = std::max(last, column);
          top = std::min(top, row);
          bottom = std::max(bottom, row);
        }
    INFO(p.formula << " in " << p.domain << ": columns " << first << " to " << last << ", rows "
                   << top << " to " << bottom);
    CHECK(first >= 1);
    CHECK(top >= 1);
    CHECK(last <= 98);
    CHECK(bottom <= 98);
    CHECK(last - first >= 85);
    CHECK(bottom - top >= 85);
  }
}

TEST_CASE("render.view: the surface's extent holds it, and is the domain's where nothing is known",
          "[unit]") {
  const auto holds = [](const ball& b, const vec3& p) {
    return length({p[0] - b.middle[0], p[1] - b.middle[1], p[2] - b.middle[2]}) <= b.radius;
  };
  const ball two = surface_extent(
      of_formula("((x-3)^2 + y^2 + z^2 - 1/100)*((x+3)^2 + (y-1)^2 + z^2 - 1/100)", "[-50, 50]"));
  CHECK(holds(two, {3.1, 0, 0}));
  CHECK(holds(two, {-3.1, 1, 0}));
  CHECK(two.radius < 4);
  const ball all = ball_about({{-1, -1, -1}, {1, 1, 1}});
  for (const char* formula : {"z - x", "1/(x-x)", "sqrt(-1-x^2)", "x^2 + 1"}) {
    const auto s =
        scene_from(std::string(R"({"formula": ")") + formula + R"(", "domain": [-1, 1]})");
    if (!s)
      continue; // refused when it is read
    const ball b = surface_extent(*s);
    INFO(formula);
    CHECK(b.middle == all.middle);
    CHECK(b.radius == Approx(all.radius).epsilon(1e-14));
  }
}

TEST_CASE("render.view: a scene that has a camera keeps it, and zoom, angle and orbit begin there",
          "[unit]") {
  for (const scene& built_in : scenes()) {
    CHECK(seen(built_in, {}).view == built_in.view);
    CHECK(seen(built_in, {}).lights.size() == 2);
    framing zoomed;
    zoomed.zoom = 2;
    const camera half = seen(built_in, zoomed).view;
    CHECK(half.eye == built_in.view.eye);
    CHECK(half.up[1] == built_in.view.up[1] / 2);
    framing wide;
    wide.fov = 90; // the eye comes nearer, and sees as much of the plane through the middle
    const camera near_by = seen(built_in, wide).view;
    CHECK(length(near_by.eye) == Approx(length(built_in.view.eye) * 2 / 7).epsilon(1e-3));
    scene s = built_in;
    const auto from = settle_view(s, {});
    REQUIRE(from);
    CHECK(from->look_at == vec3{0, 0, 0});
    CHECK(turned(*from, 0) == built_in.view);
    CHECK(turned(*from, 360) == built_in.view);
    const camera opposite = turned(*from, 180);
    CHECK(opposite.eye == vec3{-built_in.view.eye[0], built_in.view.eye[1], -built_in.view.eye[2]});
  }
}

TEST_CASE("render.view: what is no view is refused, with the way out", "[unit]") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const auto refused = [](const framing& asked, const std::string& reason) {
    const auto a = frame(asked, ball{{0, 0, 0}, 1}), b = frame(asked, camera::standard(1), vec3{});
    INFO(reason << "\n" << a.reason() << "\n" << b.reason());
    REQUIRE_FALSE(a);
    REQUIRE_FALSE(b);
    CHECK(a.reason().find(reason) != std::string::npos);
    CHECK(b.reason().find(reason) != std::string::npos);
  };
  for (const double wrong : {nan, inf, -inf, 1e300}) {
    framing f;
    f.azimuth = wrong;
    refused(f, "azimuth must be");
    f = {};
    f.elevation = wrong;
    refused(f, "elevation must be -90 to 90");
    f = {};
    f.fov = wrong;
    refused(f, "fov must be");
    f = {};
    f.zoom = wrong;
    refused(f, "zoom must be");
    f = {};
    f.eye = vec3{0, wrong, 1};
    refused(f, "eye must be finite");
    f = {};
    f.look_at = vec3{wrong, 0, 1};
    refused(f, "look-at must be finite");
    f = {};
    f.up = vec3{wrong, 0, 1};
    refused(f, "up must be finite");
  }
  framing f;
  f.up = vec3{0, 0, 0};
  refused(f, "up must not be 0: it is a direction, such as");
  for (const double wrong : {0.0, -1.0, 180.0}) {
    f = {};
    f.fov = wrong;
    refused(f, "fov must be");
  }
  f = {};
  f.zoom = 0;
  refused(f, "zoom must be");
  f = {};
  f.elevation = 90.5;
  refused(f, "elevation must be");
  f = {};
  f.eye = f.look_at = vec3{1, 2, 3};
  refused(f, "the eye is at the point at which it looks: move one of them");
  f.look_at = vec3{1, 2, 4};
  f.up = vec3{0, 0, -7};
  refused(f, "up is along the view: give another axis, such as x");
  f.up.reset();
  f.azimuth = 3;
  refused(f, "leave out one of them");
  f = {};
  f.eye = vec3{0, 5, 0}; // along the usual up, which nobody has asked for
  f.look_at = vec3{0, 0, 0};
  CHECK(frame(f, ball{{0, 0, 0}, 1}));
  for (const double close : {1e-200, 5e-324, 1e-95}) {
    f.eye = vec3{close, 0, 0};
    CHECK_FALSE(frame(f, ball{{0, 0, 0}, 1}));
  }
}

TEST_CASE("render.view: scene files ask for cameras as options do, and options go before",
          "[unit]") {
  const char* const sphere = "x^2 + y^2 + z^2 - 1";
  const scene s = of_formula(sphere, "[-2, 2]",
                             R"(, "camera": {"azimuth": 30, "elevation": 5, "up": "z", "fov": 40,
                                 "zoom": 2, "look_at": [0.1, 0, 0]})");
  framing same = by_angles(30, 5, z_up);
  same.fov = 40;
  same.zoom = 2;
  same.look_at = vec3{0.1, 0, 0};
  CHECK(seen(s, {}).view == seen(of_formula(sphere, "[-2, 2]"), same).view);
  CHECK(seen(s, {}).lit == scene::lamps::headlight);
  framing by_eye;
  by_eye.eye = vec3{1, 2, 3};
  same.azimuth.reset();
  same.elevation.reset();
  same.eye = by_eye.eye;
  CHECK(seen(s, by_eye).view == seen(of_formula(sphere, "[-2, 2]"), same).view);
  // what a picture tells is the camera itself
  const scene settled = seen(s, {});
  const scene again = parsed(text_of(settled));
  CHECK(seen(again, {}).view == settled.view);
  CHECK(seen(again, {}).lights.front().position == settled.lights.front().position);
  const auto refused = [&](const std::string& more, const std::string& reason) {
    const auto found = scene_from(R"({"formula": "x", "domain": [-1, 1], )" + more + "}");
    INFO(more << "\n" << found.reason());
    REQUIRE_FALSE(found);
    CHECK(found.reason().find(reason) != std::string::npos);
  };
  refused(R"("camera": {"eye": [1, 0, 0], "azimuth": 3})", "key camera: eye and azimuth");
  refused(R"("camera": {"eye": [1, 0, 0], "look_at": [1, 0, 0]})", "key camera: the eye is at");
  refused(R"("camera": {"eye": [1, 0, 0], "centre": [1, 0, 0], "azimuth": 1})", "no key 'azimuth'");
  refused(R"("camera": {"azimut": 1})", "no key 'azimut'");
  refused(R"("camera": {"up": "w"})", "key camera.up");
  refused(R"("camera": {"fov": 0})", "key camera: fov must be");
  refused(R"("lights": "torch")", "key lights: must be a list, [ ... ], or \"headlight\"");
  refused(R"("background": "clear")", "key background: 'clear' is no colour");
  refused(R"("colour": "mauve")", "key colour: 'mauve' is no colour: #rrggbb");
  refused(R"("colour": "red", "material": {"body": [1, 0, 0]})", "key colour: ");
}

TEST_CASE("render.colours: names, sRGB in hex digits, linear numbers", "[unit]") {
  CHECK(*colour_from("white") == colour{1, 1, 1});
  CHECK(*colour_from("#000000") == colour{0, 0, 0});
  CHECK(*colour_from("#f80") == *colour_from("#ff8800"));
  CHECK(*colour_from("0.25,0.5,2") == colour{0.25, 0.5, 2});
  for (int i = 0; i < 256; ++i) { // as a picture writes them
    const colour c = *colour_from(fmt::format("#{:02x}00{:02x}", i, 255 - i));
    CHECK(srgb_byte(static_cast<float>(c[0])) == i);
    CHECK(srgb_byte(static_cast<float>(c[2])) == 255 - i);
  }
  for (const char* wrong : {"", "#", "#12345", "#1234567", "#-12345", "#gg0000", "1,2", "1,2,3,4",
                            "-1,0,0", "nan,0,0", "0,0,inf", "Red", "101,0,0"})
    CHECK_FALSE(colour_from(wrong));
}

TEST_CASE("render.colours: the inside colour is what is seen from f < 0", "[unit]") {
  const auto of = [](double elevation) {
    scene s = of_formula("x^2 + y^2 + z^2 - 1", "[-1.5, 1.5, -1.5, 1.5, -1.5, 0]",
                         R"(, "material": {"body": [1, 0, 0], "inside": [0, 0, 1], "ambient": 1,
                             "diffuse": 0, "specular": 0}, "background": [0, 1, 0])");
    const rendering r = render(seen(s, by_angles(0, elevation, z_up)), 48);
    std::array<int, 3> counts{};
    for (const pixel& p : r.pixels)
      for (std::size_t c = 0; c < 3; ++c)
        counts[c] += p.colour[c] == 1 ? 1 : 0;
    CHECK(counts[0] + counts[1] + counts[2] == 48 * 48);
    return counts;
  };
  const auto above = of(90), below = of(-90), beside = of(30);
  CHECK(above[0] == 0); // a bowl, seen from above
  CHECK(above[2] > 500);
  CHECK(below[2] == 0);
  CHECK(below[0] > 500);
  CHECK(beside[0] > 100);
  CHECK(beside[2] > 100);
}

TEST_CASE("render.background: a transparent picture over a background is the opaque one",
          "[unit]") {
  const scene opaque = seen(of_formula("x^2 + 2*y^2 + z^2 - 1", "[-1.5, 1.5]"), {});
  scene clear = opaque;
  clear.transparent = true;
  const rendering a = render(opaque, 40, 4), b = render(clear, 40, 4);
  int edges = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const pixel& p = b.pixels[i];
    CHECK(a.pixels[i].alpha == 1);
    CHECK(p.alpha * 16 == std::floor(p.alpha * 16));
    edges += p.alpha > 0 && p.alpha < 1 ? 1 : 0;
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(static_cast<double>(p.colour[c]) + (1 - p.alpha) * opaque.background[c] ==
            Approx(a.pixels[i].colour[c]).margin(1e-6));
  }
  CHECK(edges > 60);
  CHECK(to_picture(b, true).find("A") != nullptr);
  CHECK(to_picture(a).find("A") == nullptr);
}

TEST_CASE("render.light: a camera that turns brings its light, unless the scene has chosen",
          "[unit]") {
  const auto brightness = [](const scene& s) {
    const rendering r = render(s, 64);
    double sum = 0;
    for (std::size_t i = 0; i < r.pixels.size(); ++i)
      if (r.facts[i].verdict == 0)
        sum += r.pixels[i].colour[0];
    return sum / static_cast<double>(r.counts.hits);
  };
  const scene& built_in = *find_scene("tanglecube");
  const double front = brightness(built_in);
  for (const double azimuth : {0.0, 120.0, 206.0, 300.0}) {
    framing asked;
    asked.azimuth = azimuth;
    CHECK(brightness(seen(built_in, asked)) > 0.8 * front);
  }
  scene given = of_formula("x^2 + y^2 + z^2 - 1", "[-1.5, 1.5]",
                           R"(, "lights": [{"position": [0, 0, 9], "intensity": 1}])");
  CHECK(brightness(seen(given, by_angles(0, -90, z_up))) <
        0.2 * brightness(seen(given, by_angles(0, 90, z_up))));
}
