// Words: numbers, names and signs, in ASCII and in the characters that are pasted for them.
#include "scanner.hpp"

#include "characters.hpp"

#include <algorithm>
#include <iterator>

namespace graze::octree::tape {
namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_hexadecimal(char c) {
  return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
}
/// A no-break space too: texts are pasted.
bool is_blank(char32_t c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0xa0; }

struct sign {
  std::string_view text;
  mark what;
};
/// Longer ones before those that they begin with.
constexpr sign signs[] = {
    {"**", mark::power},
    {"<=", mark::less_equal},
    {">=", mark::greater_equal},
    {"==", mark::same},
    {"!=", mark::different},
    {"&&", mark::conjunction},
    {"+", mark::plus},
    {"-", mark::minus},
    {"*", mark::times},
    {"/", mark::divide},
    {"%", mark::modulo},
    {"^", mark::power},
    {"(", mark::open},
    {")", mark::close},
    {",", mark::comma},
    {";", mark::semicolon},
    {"=", mark::equal},
    {"<", mark::less},
    {">", mark::greater},
    {"|", mark::bar},
    {"!", mark::negation},
    {"\u00d7", mark::times},
    {"\u00b7", mark::times},
    {"\u22c5", mark::times},
    {"\u2212", mark::minus},
    {"\u2264", mark::less_equal},
    {"\u2265", mark::greater_equal},
    {"\u2260", mark::different},
};
constexpr std::string_view letters_of_names[] = {"\u03c0", "\u03b8", "\u03c6", "\u03d5", "\u03c1"};

/// '0' to '9', '+', '-', or 0 for what is no superscript.
char plain(const character& of) {
  const char32_t c = of.is_valid ? of.code : 0;
  switch (c) {
  case 0xb9:
    return '1';
  case 0xb2:
    return '2';
  case 0xb3:
    return '3';
  case 0x207a:
    return '+';
  case 0x207b:
    return '-';
  default:
    return c == 0x2070 || (0x2074 <= c && c <= 0x2079) ? static_cast<char>('0' + (c - 0x2070))
                                                       : '\0';
  }
}

/// Bytes of the number at the beginning.
std::size_t length_of_number(std::string_view text) {
  std::size_t at = 0;
  const auto peek = [&](std::size_t ahead = 0) {
    return at + ahead < text.size() ? text[at + ahead] : '\0';
  };
  const bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X') &&
                           (is_hexadecimal(peek(2)) || (peek(2) == '.' && is_hexadecimal(peek(3))));
  at += hexadecimal ? 2 : 0;
  const auto digits = [&] {
    while (hexadecimal ? is_hexadecimal(peek()) : is_digit(peek()))
      ++at;
  };
  digits();
  if (peek() == '.') {
    ++at;
    digits();
  }
  const char letter = hexadecimal ? 'p' : 'e';
  if (peek() == letter || peek() == letter - 'a' + 'A') {
    const std::size_t signs_here = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if (is_digit(peek(1 + signs_here))) {
      at += 1 + signs_here;
      while (is_digit(peek()))
        ++at;
    }
  }
  return at;
}

} // namespace

void scanner::read(std::size_t from) {
  std::string_view rest = text_.substr(from);
  while (!rest.empty() && is_blank(first_character(rest).code))
    rest.remove_prefix(first_character(rest).length);
  const std::size_t first = text_.size() - rest.size();
  const auto found = [&](mark what, std::size_t length) { here_ = {what, first, first + length}; };
  if (rest.empty())
    return found(mark::end, 0);
  if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1])))
    return found(mark::numeral, length_of_number(rest));
  if (is_letter(rest[0])) {
    const auto end = std::find_if_not(rest.begin(), rest.end(),
                                      [](char c) { return is_letter(c) || is_digit(c); });
    return found(mark::name, static_cast<std::size_t>(end - rest.begin()));
  }
  for (const std::string_view letter : letters_of_names)
    if (rest.starts_with(letter))
      return found(mark::name, letter.size());
  std::size_t superscripts = 0;
  while (superscripts < rest.size() && plain(first_character(rest.substr(superscripts))) != 0)
    superscripts += first_character(rest.substr(superscripts)).length;
  if (superscripts != 0)
    return found(mark::exponent, superscripts);
  for (const sign& s : signs)
    if (rest.starts_with(s.text))
      return found(s.what, s.text.size());
  found(mark::unknown, first_character(rest).length);
}

std::optional<std::string> exponent_in_ascii(std::string_view superscripts) {
  std::string r;
  for (; !superscripts.empty(); superscripts.remove_prefix(first_character(superscripts).length))
    r += plain(first_character(superscripts));
  const std::size_t first = r[0] == '-' || r[0] == '+' ? 1 : 0;
  if (first == r.size() ||
      !std::all_of(r.begin() + static_cast<std::ptrdiff_t>(first), r.end(), is_digit))
    return std::nullopt;
  return r;
}

std::string describe_first(std::string_view text) {
  if (text.empty())
    return "the end";
  const character c = first_character(text);
  const auto hexadecimal = [&](std::size_t digits) {
    std::string r;
    for (char32_t code = c.code; code != 0 || r.size() < digits; code /= 16)
      r.insert(r.begin(), "0123456789ABCDEF"[code % 16]);
    return r;
  };
  if (!c.is_valid)
    return "the byte 0x" + hexadecimal(2);
  std::string quoted = "'";
  quoted.append(text.substr(0, c.length)).append("'");
  if (' ' < c.code && c.code < 0x7f)
    return quoted;
  // marks of direction, joiners and the like are not shown
  const bool hidden =
      c.code < 0xa1 || c.code == 0xad || (0x300 <= c.code && c.code < 0x370) ||
      (0x600 <= c.code && c.code < 0x606) || c.code == 0x61c ||
      (0x2000 <= c.code && c.code < 0x2010) || (0x2028 <= c.code && c.code < 0x2030) ||
      (0x205f <= c.code && c.code < 0x2070) || (0xd7ff < c.code && c.code < 0xf900) ||
      (0xfe00 <= c.code && c.code < 0xfe10) || c.code >= 0xfeff;
  return hidden ? "U+" + hexadecimal(4) : quoted + " (U+" + hexadecimal(4) + ")";
}

} // namespace graze::octree::tape
