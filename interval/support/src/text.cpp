#include <algorithm>
#include <graze/support/text.hpp>

namespace graze::support {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

struct character {
  char32_t code;
  std::size_t length; ///< 0: the first byte begins no character
};

/// The first character of a text that is not empty. Unicode 15, table 3-7: no overlong form, no
/// surrogate, nothing beyond U+10FFFF.
character first_character(std::string_view text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80)
    return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length)
    return {0, 0};
  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80)
      return {0, 0};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  if ((length == 3 && code < 0x800) || (length == 4 && code < 0x10000) || code > 0x10FFFF ||
      (0xD800 <= code && code <= 0xDFFF))
    return {0, 0};
  return {code, length};
}

bool ends_line(char32_t c) {
  return (c >= 9 && c <= 13) || c == 0x85 || c == 0x2028 || c == 0x2029;
}
/// Controls (C0, DEL, C1) and marks that turn the direction of what follows.
bool is_hidden(char32_t c) {
  return c < 32 || (c >= 127 && c < 160) || c == 0x200E || c == 0x200F || c == 0x061C ||
         (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

} // namespace

std::string utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const character c = first_character(text);
    const std::size_t length = std::max<std::size_t>(c.length, 1);
    out += c.length != 0 ? text.substr(0, length) : replacement;
    text.remove_prefix(length);
  }
  return out;
}

std::string markup(std::string_view text) {
  std::string out;
  for (const char c : utf8(text))
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\n':
      out += "&#10;";
      break;
    default:
      out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  return out;
}

std::string shown(std::string_view text, std::size_t most) {
  std::string out;
  while (!text.empty()) {
    const character c = first_character(text);
    const std::size_t length = std::max<std::size_t>(c.length, 1);
    if (out.size() + std::max(length, replacement.size()) > most)
      return out + "...";
    if (c.length == 0)
      out += replacement;
    else if (ends_line(c.code))
      out += ' ';
    else if (is_hidden(c.code))
      out += '?';
    else
      out += text.substr(0, length);
    text.remove_prefix(length);
  }
  return out;
}

bool is_content_hash(std::string_view text) {
  return text.size() == 32 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

} // namespace graze::support
