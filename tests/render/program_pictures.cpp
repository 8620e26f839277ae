// Pictures that graze-render has written, read by another library.
#include "../support/program.hpp"
#include "read_picture.hpp"
#include <cmath>
#include <graze/render/shading.hpp>
#include <nlohmann/json.hpp>

using support::call, support::scratch;

TEST_CASE("graze-render: a picture and a line with rays/s, hits and octants a ray", "[unit]") {
  const scratch dir;
  const std::string file = dir / "a.png";
  const auto o =
      call(GRAZE_RENDER, "--scene tanglecube --levels 30 --size 64 --octree-level 6 -o " + file);
  CHECK(o.code == 0);
  for (const char* word : {"rays/s", "hits", "octants a ray"})
    CHECK(o.out.find(word) != std::string::npos);
  const auto back = read_picture(file);
  REQUIRE(back);
  CHECK(back->width == 64);
  CHECK(back->height == 64);
}

TEST_CASE("graze-render: an interrupt leaves a valid picture or none, and says so", "[unit]") {
  const scratch dir, pictures;
  // The signal comes with the first report of progress, long before the end.
  const std::string log = dir / "log", file = pictures / "a.png";
  const auto o = call(
      "sh", "-c '" + std::string(GRAZE_RENDER) +
                " --scene spheres --levels 50 --size 2048 --spp 256 --progress -o " + file + " 2>" +
                log + " & while ! [ -s " + log + " ]; do sleep 0.02; done; kill -INT $!; wait $!'");
  const std::string err = support::content(log);
  INFO(err);
  CHECK(err.find("interrupted") != std::string::npos);
  CHECK(o.code == 130);
  if (!pictures.empty()) {
    const auto part = read_picture(file);
    REQUIRE(part.has_value());
    const std::pair<std::string, std::string> entry = {"graze:complete", "no"};
    CHECK(std::count(part->metadata.begin(), part->metadata.end(), entry) == 1);
  }
}

TEST_CASE("graze-render: poles and jumps are decided, counted, and background unless asked for",
          "[regression]") {
  const scratch dir;
  struct row {
    const char *formula, *domain, *count;
  };
  for (const row& w :
       {row{"1/x+y+z", "-2,2", "poles"},
        {"sec(x)+y", "-2,2", "poles"},
        {"x*tan(z/0.5)-y", "-2,2", "poles"},
        {"x/abs(x)+y", "-2,2", "jumps"},
        {"z-floor(x)", "-3,3", "jumps"},
        {"(x-2*floor(x/2)-1)^2+(y-2*floor(y/2)-1)^2+(z-2*floor(z/2)-1)^2-0.3", "-4,4", "jumps"},
        {"atan2(y,x)-z", "-2,2", "jumps"},
        {"sin(x)/x+y", "-2,2", "gaps"}}) {
    const std::string common = std::string("--formula \"") + w.formula + "\" --domain=" + w.domain +
                               " --size 128 -o " + (dir / "a.exr");
    const auto o = call(GRAZE_RENDER, common + " --json");
    INFO(w.formula << ": " << o.err);
    REQUIRE(o.code == 0);
    const auto line = nlohmann::json::parse(o.out);
    CHECK(line["undecided"] == 0);
    CHECK(line[w.count] > 0);
    CHECK(line["hits"].get<int>() + line["misses"].get<int>() + line[w.count].get<int>() == 16384);
    const auto plain = read_picture(dir / "a.exr");
    const auto said = call(GRAZE_RENDER, common + " --show-gaps").out;
    CHECK(said.find(std::to_string(line[w.count].get<int>()) + " " + w.count) != std::string::npos);
    const auto shown = read_picture(dir / "a.exr");
    REQUIRE(plain);
    REQUIRE(shown);
    const auto channel = [](const graze::render::picture& p, const char* name) {
      for (const auto& c : p.channels)
        if (c.name == name)
          return c.values;
      return std::vector<float>();
    };
    const auto code = channel(*plain, "verdict.code"), depth = channel(*plain, "Z");
    const auto blue = channel(*plain, "B"), blue_shown = channel(*shown, "B");
    REQUIRE(code.size() == 16384);
    REQUIRE(channel(*shown, "verdict.code") == code);
    int orange = 0, wrong = 0;
    const float background = static_cast<float>(graze::render::default_background[2]);
    for (std::size_t i = 0; i < code.size(); ++i) {
      const bool named = code[i] > 2;
      orange += named;
      wrong += named && (blue[i] != background || blue_shown[i] != 0 || !std::isinf(depth[i]));
      wrong += !named && blue[i] != blue_shown[i];
    }
    CHECK(orange == line[w.count]);
    CHECK(wrong == 0);
  }
}
