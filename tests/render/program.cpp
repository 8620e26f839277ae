// graze-render as its users meet it: output, exit codes, bad input.
#include "../support/program.hpp"
#include <graze/render/image.hpp>
#include <nlohmann/json.hpp>

using support::call, support::scratch;

namespace {
void refused(const scratch& dir, const std::string& arguments, const std::string& reason) {
  support::refused(GRAZE_RENDER, arguments, reason);
  CHECK(dir.empty());
}
} // namespace

TEST_CASE("graze-render: a picture and a line with rays/s, hits and octants a ray", "[unit]") {
  const scratch dir;
  const std::string file = dir / "a.png";
  const auto o =
      call(GRAZE_RENDER, "--scene tanglecube --levels 30 --size 64 --octree-level 6 -o " + file);
  CHECK(o.code == 0);
  for (const char* word : {"rays/s", "hits", "octants a ray"})
    CHECK(o.out.find(word) != std::string::npos);
  const auto back = graze::render::read_picture(file);
  REQUIRE(back);
  CHECK(back->width == 64);
  CHECK(back->height == 64);
}

TEST_CASE("graze-render: --json prints one object, whose counts add up", "[unit]") {
  const scratch dir;
  const auto o =
      call(GRAZE_RENDER,
           "--scene spheres --levels 50 --size 64 --octree-level 6 --json -o " + (dir / "a.exr"));
  REQUIRE(o.code == 0);
  const auto line = nlohmann::json::parse(o.out);
  CHECK(line["rays"] == 4096);
  CHECK(line["hits"].get<int>() + line["misses"].get<int>() + line["undecided"].get<int>() == 4096);
  CHECK(line["complete"] == true);
}

TEST_CASE("graze-render: bad input is one line, exit code 2, and no file", "[unit]") {
  const scratch dir;
  const std::string to = " -o " + (dir / "a.png");
  refused(dir, "--scene teapot --levels 30" + to, "tanglecube");
  refused(dir, "--scene tanglecube --levels 0" + to, "--levels must be 1 to 53, not 0");
  refused(dir, "--scene tanglecube --levels 54" + to, "--levels must be 1 to 53, not 54");
  refused(dir, "--scene tanglecube --levels x" + to, "--levels");
  refused(dir, "--scene tanglecube --levels 30 --size 0" + to, "--size");
  refused(dir, "--scene tanglecube --levels 30 --size -5" + to, "--size");
  refused(dir, "--scene tanglecube --levels 30 --threads -1" + to, "--threads");
  refused(dir, "--scene tanglecube --levels 30 -o " + (dir / "none/a.png"), "none");
  refused(dir, "--scene tanglecube --levels 30 -o " + (dir / "a.jpg"), "png");
  refused(dir, "--levels 30" + to, "--scene");
  refused(dir, "--scene tanglecube", "--output");
}

TEST_CASE("graze-render: an interrupt leaves a valid picture or none, and says so", "[unit]") {
  const scratch dir;
  // One signal only: timeout would send a second to the group, which ends the program at once.
  const auto o = call(GRAZE_RENDER, "--scene spheres --levels 50 --size 4096 -o " + (dir / "a.png"),
                      "timeout --foreground -s INT 2 ");
  CHECK(o.err.find("interrupted") != std::string::npos);
  if (!dir.empty())
    CHECK(graze::render::read_picture(dir / "a.png").has_value());
}

TEST_CASE("graze-render: help has examples", "[unit]") {
  const auto o = call(GRAZE_RENDER, "--help");
  CHECK(o.code == 0);
  CHECK(o.out.find("Examples") != std::string::npos);
}
