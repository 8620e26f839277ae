#pragma once
/// The lines that the extracted model and the code answer, and how answers are folded: the C++ side
/// of graze_model.ml. README.md describes the lines. Plain C++ without floating-point arithmetic,
/// so that no flag and no mode matters here.
#include "tree.hpp"
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::tie {

using point = std::array<double, 3>;

/// b: a ray and a box with planes between. c: a ray and a cell. t: a cell, and the tree below it.
struct line {
  char kind = 'b';
  point o{}, d{}, lo{}, hi{}, mid{}; ///< hi and mid: of b alone
  double size = 0;                   ///< of c and t
  std::string_view answers;          ///< what stands after the colon
  std::string_view answers_down;     ///< and after a semicolon: where planes round down
};

inline bool is_nan(std::uint64_t bits) {
  return (bits & ~(std::uint64_t{1} << 63)) > 0x7ff0000000000000;
}

/// The pattern of x; that of the quiet NaN without payload for any.
inline std::uint64_t pattern(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return is_nan(bits) ? 0x7ff8000000000000 : bits;
}

/// 16 digits, those at the end that are 0 left out, or not.
inline std::string digits(std::uint64_t bits, bool short_form = false) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
  std::string s(text);
  while (short_form && s.size() > 1 && s.back() == '0')
    s.pop_back();
  return s;
}

inline std::optional<line> parse(std::string_view text) {
  line l;
  std::vector<double> numbers;
  if (const auto colon = text.find(" : "); colon != text.npos) {
    l.answers = l.answers_down = text.substr(colon + 3);
    if (const auto other = l.answers.find(" ; "); other != text.npos) {
      l.answers_down = l.answers.substr(other + 3);
      l.answers = l.answers.substr(0, other);
    }
    text = text.substr(0, colon);
  }
  if (text.size() < 2 || text[1] != ' ')
    return {};
  l.kind = text[0];
  for (std::size_t i = 2; i < text.size();) {
    std::uint64_t bits = 0;
    int n = 0;
    for (; i < text.size() && text[i] != ' '; ++i, ++n) {
      const char c = text[i];
      const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
      if (digit < 0 || n == 16)
        return {};
      bits = bits << 4 | static_cast<unsigned>(digit);
    }
    if (n == 0)
      return {};
    numbers.push_back(std::bit_cast<double>(bits << (64 - 4 * n)));
    ++i;
  }
  const auto three = [&](std::size_t i) {
    return point{numbers[i], numbers[i + 1], numbers[i + 2]};
  };
  if (numbers.size() != (l.kind == 'b' ? 15u : l.kind == 'c' || l.kind == 't' ? 10u : 0u))
    return {};
  l.o = three(0), l.d = three(3), l.lo = three(6);
  if (l.kind == 'b')
    l.hi = three(9), l.mid = three(12);
  else
    l.size = numbers[9];
  return l;
}

/// The answers to one line: numbers folded to 64 bits in their order, verdicts as they stand.
class answers {
public:
  explicit answers(bool show = false) : show_(show) {}

  void number(const char* axis, const char* name, double x) {
    if (show_)
      std::printf("  %s%s %s\n", axis, name, digits(pattern(x)).c_str());
    fold_ = fold(fold_, pattern(x));
  }
  void verdict(const char* name, const std::string& text) {
    if (show_)
      std::printf("  %s %s\n", name, text.c_str());
    verdicts_ += text + ' ';
  }
  [[nodiscard]] const std::string& verdicts() const { return verdicts_; }
  [[nodiscard]] std::string text() const { return verdicts_ + digits(fold_); }

private:
  bool show_;
  std::uint64_t fold_ = fold_start;
  std::string verdicts_;
};

inline std::string mask_text(unsigned mask) {
  char text[3];
  std::snprintf(text, sizeof text, "%02x", mask & 0xffu);
  return text;
}

inline std::string visits_text(unsigned count, std::uint64_t fold) {
  return std::to_string(count) + '/' + digits(fold);
}

} // namespace graze::tie
