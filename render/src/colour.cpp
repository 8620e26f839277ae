// Colours as people write them.
#include <charconv>
#include <fmt/format.h>
#include <graze/render/scene_text.hpp>
#include <graze/render/shading.hpp>
#include <graze/support/text.hpp>

namespace graze::render {
namespace {

/// CSS Color Module Level 4, 6.1.
struct named {
  std::string_view name;
  unsigned srgb;
};
constexpr named names[] = {
    {"black", 0x000000},   {"white", 0xffffff},  {"grey", 0x808080},      {"gray", 0x808080},
    {"silver", 0xc0c0c0},  {"red", 0xff0000},    {"green", 0x008000},     {"blue", 0x0000ff},
    {"yellow", 0xffff00},  {"orange", 0xffa500}, {"gold", 0xffd700},      {"brown", 0xa52a2a},
    {"purple", 0x800080},  {"pink", 0xffc0cb},   {"teal", 0x008080},      {"navy", 0x000080},
    {"olive", 0x808000},   {"maroon", 0x800000}, {"lime", 0x00ff00},      {"cyan", 0x00ffff},
    {"crimson", 0xdc143c}, {"tomato", 0xff6347}, {"steelblue", 0x4682b4}, {"ivory", 0xfffff0},
};

/// IEC 61966-2-1.
double linear_of(unsigned byte) {
  const double x = byte / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
colour of_srgb(unsigned rgb) {
  return {linear_of(rgb >> 16 & 255), linear_of(rgb >> 8 & 255), linear_of(rgb & 255)};
}

std::optional<unsigned> hex_from(std::string_view digits) {
  unsigned value = 0;
  const auto [rest, error] = std::from_chars(digits.begin(), digits.end(), value, 16);
  if (error != std::errc{} || rest != digits.end())
    return std::nullopt;
  if (digits.size() == 6)
    return value;
  if (digits.size() == 3) // each digit twice
    return (value >> 8 & 15) * 0x110000 + (value >> 4 & 15) * 0x1100 + (value & 15) * 0x11;
  return std::nullopt;
}

} // namespace

expected<colour> colour_from(std::string_view text) {
  for (const named& n : names)
    if (n.name == text)
      return of_srgb(n.srgb);
  if (text.starts_with('#'))
    if (const auto rgb = hex_from(text.substr(1)))
      return of_srgb(*rgb);
  if (const auto parts = numbers_from(text); parts && parts->size() == 3) {
    const colour c = {(*parts)[0], (*parts)[1], (*parts)[2]};
    bool within = true;
    for (const double part : c)
      within = within && part >= 0 && part <= 100;
    if (within)
      return c;
  }
  std::string all;
  for (const named& n : names)
    all += (all.empty() ? "" : ", ") + std::string(n.name);
  return unexpected{
      fmt::format("'{}' is no colour: #rrggbb, r,g,b (linear, from 0 on), or one of {}",
                  support::shown(text, 40), all)};
}

} // namespace graze::render
