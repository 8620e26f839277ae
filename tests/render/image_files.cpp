// Pictures written and read back, and what they tell of themselves.
#include "../support/program.hpp"
#include <cmath>
#include <graze/render/image.hpp>
#include <graze/render/picture_texts.hpp>
#include <graze/support/files.hpp>
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
  REQUIRE(graze::support::write_atomically(file, *bytes));
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

TEST_CASE("render.texts: of both formats, without a look at a pixel", "[unit]") {
  for (const file_format format : {file_format::png, file_format::exr}) {
    const auto bytes = encode(small(), format);
    REQUIRE(bytes.has_value());
    const std::string whole(bytes->begin(), bytes->end());
    const auto texts = texts_in(whole);
    REQUIRE(texts.has_value());
    CHECK(texts->at("graze:scene") == "none");
    // what is cut off is refused or says the same, wherever that is
    for (std::size_t length = 0; length < whole.size(); ++length)
      if (const auto part = texts_in(whole.substr(0, length)); part)
        CHECK(*part == *texts);
  }
  CHECK_FALSE(texts_in("").has_value());
  CHECK_FALSE(texts_in("GIF89a").has_value());
  // a length of 4 GB takes no memory
  CHECK_FALSE(texts_in(std::string("\x76\x2f\x31\x01\x02\0\0\0a\0string\0\xff\xff\xff\xff", 21)));
}
