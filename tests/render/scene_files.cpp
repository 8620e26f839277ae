// Scenes as text, and what is made of their objects.
#include <catch2/catch.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/render/render.hpp>
#include <graze/render/scene_text.hpp>

namespace octree = graze::octree;
using namespace graze::render;

namespace {

rendering render(const scene& s, int size) {
  const auto surface = prepare(s, 6, 30);
  INFO(s.name << " " << surface.reason());
  REQUIRE(surface);
  settings chosen = {size, 2};
  chosen.facts = true;
  return render_picture(s, **surface, chosen);
}

scene parsed(const std::string& text) {
  const auto s = scene_from(text);
  INFO(text << "\n" << s.reason());
  REQUIRE(s);
  return *s;
}

const char* const parts = R"({
  "objects": [
    {"name": "ball", "formula": "x^2 + y^2 + z^2 - 1", "body": [1, 0, 0]},
    {"name": "rod", "formula": "x^2 + y^2 - 0.1", "body": [0, 1, 0], "reflection": 0},
    {"name": "half", "formula": "z", "body": [0, 0, 1]}
  ],
  "domain": [-1.5, 1.5],)";

} // namespace

TEST_CASE("render.scene_text: a scene's text gives the same scene", "[unit]") {
  for (const scene& s : scenes()) {
    const scene again = parsed(text_of(s));
    CHECK(text_of(again) == text_of(s));
    CHECK(again.view == s.view);
    CHECK(again.domain == s.domain);
    CHECK(again.built_in == s.built_in);
  }
  const scene s = parsed(std::string(parts) + R"("solid": {"difference": ["ball",
      {"union": ["rod", "half"]}]}, "camera": {"scale": 0.1, "at": [0.1, 0.2, 0.3]},
      "lights": [{"position": [1, 2, 3e10], "intensity": 0.1}], "background": [0, 0, 0.1]})");
  CHECK(text_of(parsed(text_of(s))) == text_of(s));
  CHECK(s.objects[1].look.reflection == 0);
  CHECK(s.lights.size() == 1);
  const scene with_names = parsed(R"({"objects": [
      {"name": "a", "formula": "w=t; x=w;"}, {"name": "b", "formula": "w=2t;|y|<w"}],
      "domain": [-2, 2], "set": {"t": 0.1}})");
  CHECK(text_of(parsed(text_of(with_names))) == text_of(with_names));
  CHECK(text_of(with_names).find(R"("set":{"t":"0.1"})") != std::string::npos);
  CHECK(formula_text(with_names) == "union((w=t; x=w;),(w=2t;|y|<w))");
  CHECK(prepare(with_names, 4, 10));
  CHECK(formula_text(s) == "difference((x^2 + y^2 + z^2 - 1),union((x^2 + y^2 - 0.1),(z)))");
}

TEST_CASE("render.scene_text: a built-in scene's formula is the built-in surface", "[unit]") {
  int texts = 0;
  octree::for_each_built_in([&texts]<class F>(const octree::built_in_surface<F>& row) {
    const auto parsed = octree::formula::parse(row.formula);
    if (!parsed || !octree::is_algebraic<F>())
      return;
    ++texts;
    const scene& compiled = *find_scene(row.name);
    scene text = compiled;
    text.built_in.clear();
    text.objects[0].formula = *parsed;
    const rendering a = render(compiled, 40), b = render(text, 40);
    CHECK(a.counts.hits == b.counts.hits);
    for (std::size_t i = 0; i < a.facts.size(); ++i)
      REQUIRE(a.facts[i].verdict == b.facts[i].verdict);
  });
  CHECK(texts >= 3);
}

TEST_CASE("render.scene_text: the object is the one whose surface was hit", "[unit]") {
  const auto seen = [](const char* solid) {
    const rendering r = render(parsed(std::string(parts) + solid), 60);
    std::array<int, 3> count{};
    for (const pixel_facts& f : r.facts)
      if (f.object >= 0)
        ++count[static_cast<std::size_t>(f.object)];
    CHECK(r.counts.undecided == 0);
    return count;
  };
  // the ball alone; with a rod through it; with a hole in it, whose wall is the rod's; a half of it
  const auto ball = seen(R"("solid": "ball"})");
  CHECK(ball[0] > 300);
  CHECK(ball[1] + ball[2] == 0);
  const auto together = seen(R"("solid": {"union": ["ball", "rod"]}})");
  CHECK(together[0] < ball[0]);
  CHECK(together[1] > 20);
  const auto hole = seen(R"("solid": {"difference": ["ball", "rod"]}})");
  CHECK(hole[0] < ball[0]);
  CHECK(hole[1] > 20);
  CHECK(hole[2] == 0);
  const auto half = seen(R"("solid": {"intersection": ["ball", "half"]}})");
  CHECK(half[2] > 50);
  CHECK(half[1] == 0);
  CHECK(half[0] + half[2] <= ball[0]);
}

TEST_CASE("render.scene_text: what is no scene is refused, with the key", "[unit]") {
  const auto refused = [](const std::string& text, const char* reason) {
    const auto s = scene_from(text);
    INFO(text << "\n" << s.reason());
    REQUIRE_FALSE(s);
    CHECK(s.reason().find(reason) != std::string::npos);
    CHECK(s.reason().find('\n') == std::string::npos);
  };
  refused("", "parse error at line 1, column 1");
  refused("[]", "must be an object");
  refused(R"({"formula": "x", "domain": [0, 1e999]})", "number overflow");
  refused(R"({"formula": "x"})", "'domain' is missing");
  refused(R"({"formula": "x", "domain": [0, 1], "camra": 1})", "there is no key 'camra'");
  refused(R"({"formula": "x", "surface": "spheres", "domain": [0, 1]})", "exclude each other");
  refused(R"({"surface": "teapot"})", "key surface: there is no 'teapot'");
  refused(R"({"surface": "spheres", "material": {"body": [1, 2]}})", "key material.body");
  refused(R"({"surface": "spheres", "material": {"reflection": 2}})", "must be 0 to 1, not 2");
  refused(R"({"surface": "spheres", "camera": {"eye": [0, 0, 0], "centre": [1, 0, 0],
              "right": [0, 1, 0], "up": [1, 1, 0]}})",
          "key camera: centre, right and up must not lie in one plane");
  refused(std::string(parts) + R"("solid": {"union": ["ball"]}})", "key solid.union: needs two");
  refused(std::string(parts) + R"("solid": {"union": ["ball", "cube"]}})",
          "key solid.union[1]: there is no object 'cube'");
  refused(std::string(parts) + R"("solid": {"sum": ["ball", "rod"]}})", "'sum' is none of");
  refused(std::string(parts) + R"("material": {}})", "objects have their own");
  std::string deep = "\"ball\"";
  for (int i = 0; i < 100; ++i)
    deep = "{\"union\": [\"ball\", " + deep + "]}";
  refused(std::string(parts) + "\"solid\": " + deep + "}", "is nested more than");
}

TEST_CASE("render.domain_from: two numbers or six", "[unit]") {
  CHECK(*domain_from("-1,2") == graze::octree::box{{-1, -1, -1}, {2, 2, 2}});
  CHECK(*domain_from("0,1,2,3,4,5") == graze::octree::box{{0, 2, 4}, {1, 3, 5}});
  for (const char* wrong : {"", "1", "1,", "1,2,3", "2,1", "0,nan", "a,b", "1,2,"})
    CHECK_FALSE(domain_from(wrong));
}
