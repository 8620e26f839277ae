// Pictures that graze-render has written, read by another library.
#include "../support/program.hpp"
#include "read_picture.hpp"

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
