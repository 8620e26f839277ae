// Pictures written and read back, and what they tell of themselves.
#include "../support/program.hpp"
#include "read_picture.hpp"
#include <bit>
#include <cmath>
#include <graze/render/picture_texts.hpp>
#include <graze/support/files.hpp>
#include <limits>
#include <random>

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

TEST_CASE("render.image: png holds colours divided by alpha, exr multiplied by it", "[unit]") {
  const picture image = {3,
                         1,
                         {{"R", {0.125f, 0.0f, 0.5f}},
                          {"G", {0.25f, 0.0f, 1.0f}},
                          {"B", {0.0f, 0.0f, 2.0f}},
                          {"A", {0.25f, 0.0f, 1.0f}}}};
  const scratch dir;
  write(image, dir / "a.png");
  write(image, dir / "a.exr");
  const auto png = read_picture(dir / "a.png"), exr = read_picture(dir / "a.exr");
  REQUIRE(png);
  REQUIRE(exr);
  const auto bytes = [&](const char* name) {
    std::vector<long> all;
    for (const float x : png->find(name)->values)
      all.push_back(std::lround(x * 255));
    return all;
  };
  CHECK(bytes("R") == std::vector<long>{188, 0, 188});
  CHECK(bytes("G") == std::vector<long>{255, 0, 255});
  CHECK(bytes("B") == std::vector<long>{0, 0, 255});
  CHECK(bytes("A") == std::vector<long>{64, 0, 255});
  for (const channel& c : image.channels)
    CHECK(exr->find(c.name)->values == c.values);
}

TEST_CASE("render.image: png has the byte of every float", "[unit]") {
  // at both sides of each place where the byte changes, what is no number between 0 and 1, others
  constexpr float inf = std::numeric_limits<float>::infinity();
  std::vector<float> values = {0.0f, -0.0f, 1e-45f, -1e-45f, 1e-38f,
                               -1,   2,     inf,    -inf,    std::nanf("")};
  for (float x = 0; x < 1;) {
    float below = x, from = 1; // from has another byte, or is the last
    while (std::bit_cast<std::uint32_t>(from) - std::bit_cast<std::uint32_t>(below) > 1) {
      const float middle = std::bit_cast<float>(
          std::midpoint(std::bit_cast<std::uint32_t>(below), std::bit_cast<std::uint32_t>(from)));
      (srgb_byte(middle) == srgb_byte(x) ? below : from) = middle;
    }
    for (const float near : {below, from, std::nextafter(from, 2.0f)})
      values.push_back(near);
    x = from;
  }
  std::mt19937 random(1);
  while (values.size() < 30000)
    values.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random() % 0x3f800001)));
  for (int i = 0; i < 30000; ++i)
    values.push_back(static_cast<float>(random()) * 0x1p-32f);
  const int width = 250, height = static_cast<int>(values.size()) / width;
  REQUIRE(values.size() == static_cast<std::size_t>(width * height));
  std::vector<float> backwards(values.rbegin(), values.rend());
  const scratch dir;
  write({width, height, {{"R", values}, {"G", backwards}, {"B", values}}}, dir / "a.png");
  const auto back = read_picture(dir / "a.png");
  REQUIRE(back);
  REQUIRE(back->width == width);
  const auto check = [&](const char* name, const std::vector<float>& wanted) {
    const auto& found = back->find(name)->values;
    REQUIRE(found.size() == wanted.size());
    int wrong = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      wrong += std::lround(found[i] * 255) != srgb_byte(wanted[i]) ? 1 : 0;
    CHECK(wrong == 0);
  };
  check("R", values);
  check("G", backwards);
  check("B", values);
}

TEST_CASE("render.image: texts of any length and in UTF-8 come back from both formats", "[unit]") {
  picture image = small();
  image.metadata = {{"graze:scene", "\xce\xb1 " + std::string(200000, 'x')}, {"empty", ""}};
  const scratch dir;
  for (const char* name : {"a.png", "a.exr"}) {
    write(image, dir / name);
    const auto texts = texts_of_picture(dir / name);
    REQUIRE(texts);
    for (const auto& [key, value] : image.metadata)
      CHECK(texts->at(key) == value);
  }
}

TEST_CASE("render.image: a picture that lacks something is refused", "[unit]") {
  for (const file_format format : {file_format::png, file_format::exr}) {
    CHECK_FALSE(encode({}, format));
    CHECK_FALSE(encode({1, 1, {}}, format));
    CHECK_FALSE(encode({2, 1, {{"R", {0}}, {"G", {0}}, {"B", {0}}}}, format));
  }
  CHECK_FALSE(encode({1, 1, {{"R", {0}}, {"Z", {0}}}}, file_format::png));
  CHECK(encode({1, 1, {{"R", {0}}, {"Z", {0}}}}, file_format::exr));
  // a name that PNG cannot hold
  CHECK_FALSE(encode({1, 1, {{"R", {0}}, {"G", {0}}, {"B", {0}}}, {{"", "x"}}}, file_format::png));
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
