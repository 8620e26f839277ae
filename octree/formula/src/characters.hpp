#pragma once
/// The characters of a text as UTF-8.
#include <cstddef>
#include <string>
#include <string_view>

namespace graze::octree::tape {

struct character {
  char32_t code;
  std::size_t length; ///< bytes
  bool is_valid;      ///< else one byte that is no part of UTF-8, its code that byte
};

/// The first one of a text that is not empty.
constexpr character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80)
    return {first, 1, true};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  const character none{first, 1, false};
  if (first < 0xc2 || first > 0xf4 || text.size() < length)
    return none;
  char32_t code = first & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0u) != 0x80)
      return none;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool is_short = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  if (is_short || code > 0x10ffff || (0xd800 <= code && code < 0xe000))
    return none;
  return {code, length, true};
}

constexpr std::size_t count_characters(std::string_view text) {
  std::size_t n = 0;
  for (; !text.empty(); text.remove_prefix(first_character(text).length))
    ++n;
  return n;
}

/// For a message: '*', 'é' (U+00E9), U+0001, "the byte 0xFF"; "the end" of an empty text.
std::string describe_first(std::string_view text);

} // namespace graze::octree::tape
