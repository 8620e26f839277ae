// Pictures written and read back; files that appear whole or not at all.
#include "../support/program.hpp"
#include <cmath>
#include <graze/render/atomic_file.hpp>
#include <graze/render/image.hpp>
#include <limits>

using namespace graze::render;
using support::scratch;

namespace {

picture small() {
  const float inf = std::numeric_limits<float>::infinity();
  return {2,
          1,
          {{"R", {0.0f, 1.0f}}, {"G", {0.25f, 0.5f}}, {"B", {0.125f, 2.0f}}, {"Z", {3.5f, inf}}},
          {{"graze:scene", "none"}}};
}

void write(const picture& image, const std::string& file) {
  const auto bytes = encode(image, *format_of(file));
  REQUIRE(bytes);
  REQUIRE(write_atomically(file, *bytes));
}

} // namespace

TEST_CASE("render.image: exr comes back as it was written", "[unit]") {
  const scratch dir;
  write(small(), dir / "a.exr");
  const auto back = read_picture(dir / "a.exr");
  REQUIRE(back);
  for (const channel& c : small().channels) {
    const channel* found = back->find(c.name);
    REQUIRE(found != nullptr);
    CHECK(found->values == c.values);
  }
}

TEST_CASE("render.image: png holds sRGB bytes", "[unit]") {
  CHECK(srgb_byte(0) == 0);
  CHECK(srgb_byte(1) == 255);
  CHECK(srgb_byte(0.5f) == 188);
  CHECK(srgb_byte(-1) == 0);
  CHECK(srgb_byte(7) == 255);
  CHECK(srgb_byte(std::nanf("")) == 0);
  const scratch dir;
  write(small(), dir / "a.PNG");
  const auto back = read_picture(dir / "a.PNG");
  REQUIRE(back);
  CHECK(std::lround(back->find("G")->values[1] * 255) == 188);
}

TEST_CASE("render.image: other extensions are refused with those that there are", "[unit]") {
  CHECK(format_of("a.exr").has_value());
  CHECK_FALSE(format_of("a.jpg").has_value());
  CHECK_FALSE(format_of("a").has_value());
  CHECK(format_of("a.jpg").reason().find("png") != std::string::npos);
}

TEST_CASE("render.file: a failed write leaves nothing", "[unit]") {
  const scratch dir;
  const unsigned char bytes[] = {1, 2, 3};
  CHECK_FALSE(write_atomically(dir / "none/a.png", bytes));
  CHECK(dir.empty());
  CHECK_FALSE(why_not_writable(dir / "none/a.png").empty());
  CHECK(why_not_writable(dir / "a.png").empty());
  REQUIRE(write_atomically(dir / "a.png", bytes));
  CHECK(support::content(dir / "a.png") == "\x01\x02\x03");
}

TEST_CASE("render.file: a full disk is said, and an older file is untouched", "[unit]") {
  const unsigned char bytes[] = {1, 2, 3};
  CHECK_FALSE(write_atomically("/dev/full/a.png", bytes));
  const scratch dir;
  std::filesystem::create_directory(dir / "a.png"); // in the way of the rename
  CHECK_FALSE(write_atomically(dir / "a.png", bytes));
  CHECK(std::filesystem::is_directory(dir / "a.png"));
}
