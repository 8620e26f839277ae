#include "request.hpp"

#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <graze/octree/cube.hpp>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>

namespace graze::render {
namespace {

/// All of `text` as integers with `separator` between.
std::optional<std::vector<int>> integers(std::string_view text, char separator) {
  std::vector<int> all;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    int x = 0;
    const auto [rest, error] = std::from_chars(at, end, x);
    if (error != std::errc{} || (rest != end && *rest != separator))
      return std::nullopt;
    all.push_back(x);
    if (rest == end)
      return all;
    at = rest + 1;
  }
}

unexpected outside(const char* name, int value, int least, int most) {
  return unexpected{fmt::format("{} must be {} to {}, not {}", name, least, most, value)};
}

} // namespace

int side_of(int spp) {
  for (int side = 1; side <= 16; ++side)
    if (side * side == spp)
      return side;
  return 0;
}

expected<std::string> frame_file(const std::string& output, int i) {
  const auto at = output.find('%');
  if (at == std::string::npos) {
    const std::filesystem::path whole(output);
    return (whole.parent_path() / whole.stem()).string() + fmt::format("_{:04}", i) +
           whole.extension().string();
  }
  std::size_t end = at + 1;
  const bool zeros = output[end] == '0';
  std::size_t width = 0;
  for (; output[end] >= '0' && output[end] <= '9' && width < 10; ++end)
    width = 10 * width + static_cast<std::size_t>(output[end] - '0');
  if (output[end] != 'd' || width >= 10 || output.find('%', end) != std::string::npos)
    return unexpected{fmt::format("the pattern '{}' needs one %d, such as %04d", output)};
  std::string number = std::to_string(i);
  if (number.size() < width)
    number.insert(0, width - number.size(), zeros ? '0' : ' ');
  return output.substr(0, at) + number + output.substr(end + 1);
}

expected<extent> extent_from(std::string_view text) {
  const auto numbers = integers(text, 'x');
  if (!numbers || numbers->size() > 2)
    return unexpected{
        fmt::format("--size must be a number of pixels, or WIDTHxHEIGHT, not '{}'", text)};
  return extent(numbers->front(), numbers->back());
}

expected<window> window_from(std::string_view text) {
  const auto numbers = integers(text, ',');
  if (!numbers || numbers->size() != 4)
    return unexpected{fmt::format("--crop must be x,y,width,height, not '{}'", text)};
  return window{(*numbers)[0], (*numbers)[1], {(*numbers)[2], (*numbers)[3]}};
}

support::status picture_settings::check() const {
  constexpr int deepest = octree::max_level;
  if (levels < 1 || levels > deepest)
    return outside("--levels", levels, 1, deepest);
  if (octree_level < 1 || octree_level > 12)
    return outside("--octree-level", octree_level, 1, 12);
  for (const int side : {size.width, size.height})
    if (side < 1 || side > largest_size)
      return outside("--size", side, 1, largest_size);
  if (side_of(spp) == 0)
    return unexpected{fmt::format("--spp must be a square number, 1, 4, 9 ... 256, not {}", spp)};
  if (crop &&
      (crop->column < 0 || crop->row < 0 || crop->size.width < 1 || crop->size.height < 1 ||
       crop->size.width > size.width - crop->column || crop->size.height > size.height - crop->row))
    return unexpected{fmt::format("--crop must be at least one pixel, and within {}x{}", size.width,
                                  size.height)};
  return {};
}

std::string picture_settings::text() const {
  nlohmann::ordered_json j = {
      {"mode", mode == render::mode::trace ? "trace" : "cast"},
      {"method", method == render::method::certified ? "certified" : "descent"},
      {"levels", levels},
      {"octree_level", octree_level},
      {"size", {size.width, size.height}},
      {"spp", spp}};
  if (crop)
    j["crop"] = {crop->column, crop->row, crop->size.width, crop->size.height};
  if (show_gaps)
    j["show_gaps"] = true;
  return j.dump();
}

expected<picture_settings> picture_settings::parse(std::string_view text) {
  try {
    const auto j = nlohmann::json::parse(text);
    picture_settings s;
    const auto mode_name = j.at("mode").get<std::string>();
    if (mode_name != "cast" && mode_name != "trace")
      return unexpected{"its mode is unknown"};
    s.mode = mode_name == "trace" ? render::mode::trace : render::mode::cast;
    const auto method_name = j.value("method", "descent"); // pictures of before there was another
    if (method_name != "descent" && method_name != "certified")
      return unexpected{"its method is unknown"};
    s.method = method_name == "certified" ? render::method::certified : render::method::descent;
    bool whole = true;
    const auto number = [&whole](const nlohmann::json& value) {
      const auto x = support::whole_number<int>(value);
      whole = whole && x.has_value();
      return x.value_or(0);
    };
    s.levels = number(j.at("levels"));
    s.octree_level = number(j.at("octree_level"));
    s.size = {number(j.at("size").at(0)), number(j.at("size").at(1))};
    s.spp = number(j.at("spp"));
    if (j.contains("crop")) {
      const nlohmann::json& c = j.at("crop");
      s.crop = window{number(c.at(0)), number(c.at(1)), {number(c.at(2)), number(c.at(3))}};
    }
    s.show_gaps = j.value("show_gaps", false);
    if (!whole)
      return unexpected{"its settings hold a number that is not whole, or too large"};
    if (const support::status may = s.check(); !may)
      return unexpected{may.reason()};
    return s;
  } catch (const nlohmann::json::exception&) {
    return unexpected{"its settings cannot be read"};
  }
}

} // namespace graze::render
