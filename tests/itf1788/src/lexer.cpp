#include "lexer.hpp"
#include <algorithm>

namespace graze::itf1788 {

namespace {

// <cctype> depends on the locale.
bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_hex_digit(char c) {
  return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
}
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

} // namespace

/// False at a comment that does not end.
bool lexer::skip_blank() {
  while (position_ < text_.size()) {
    const char c = at(position_);
    if (c == '\n')
      ++line_;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      ++position_;
    } else if (begins("/*") || begins("#*")) {
      const std::size_t end = text_.find(c == '/' ? "*/" : "*#", position_ + 2);
      if (end == std::string_view::npos)
        return false;
      line_ += static_cast<int>(std::count(text_.begin() + position_, text_.begin() + end, '\n'));
      position_ = end + 2;
    } else if (begins("//") || c == '#') {
      position_ = std::min(text_.find('\n', position_), text_.size());
    } else {
      break;
    }
  }
  return true;
}

token lexer::take(token_kind kind, std::size_t length) {
  const token t{kind, text_.substr(position_, length), line_, nullptr};
  position_ += length;
  line_ += static_cast<int>(std::count(t.written.begin(), t.written.end(), '\n'));
  return t;
}

token lexer::take_error(const char* why, std::size_t length) {
  token t = take(token_kind::error, length);
  t.why = why;
  return t;
}

/// The length of the number that begins here, with its sign and its suffix; 0 if none does.
std::size_t lexer::number_length() const {
  std::size_t i = position_ + (is_sign(at(position_)) ? 1 : 0);
  const bool hexadecimal = at(i) == '0' && (at(i + 1) == 'x' || at(i + 1) == 'X');
  if (hexadecimal)
    i += 2;
  std::size_t digits = 0;
  const auto skip_digits = [&] {
    for (; hexadecimal ? is_hex_digit(at(i)) : is_digit(at(i)); ++i)
      ++digits;
  };
  skip_digits();
  if (at(i) == '.') {
    ++i;
    skip_digits();
  }
  if (digits == 0)
    return 0;
  const char mark = at(i);
  if (hexadecimal ? mark == 'p' || mark == 'P' : mark == 'e' || mark == 'E') {
    std::size_t j = i + (is_sign(at(i + 1)) ? 2 : 1);
    if (is_digit(at(j))) {
      while (is_digit(at(j)))
        ++j;
      i = j;
    }
  }
  while (is_letter(at(i))) // f, l, u, ul, ...: the parser looks at them
    ++i;
  return i - position_;
}

token lexer::next() {
  if (!skip_blank())
    return take_error("a comment without end", 0);
  if (position_ == text_.size())
    return take(token_kind::end, 0);
  const char c = at(position_);
  if (c == '"') {
    std::size_t i = position_ + 1;
    while (i < text_.size() && at(i) != '"' && at(i) != '\n')
      i += at(i) == '\\' ? 2 : 1;
    if (at(i) != '"')
      return take_error("a string without end", 0);
    return take(token_kind::text, i + 1 - position_);
  }
  if (const std::size_t length = number_length(); length != 0)
    return take(token_kind::number, length);
  if (const std::size_t sign = is_sign(c) ? 1 : 0; is_letter(at(position_ + sign))) {
    std::size_t i = position_ + sign;
    while (is_word(at(i)))
      ++i;
    return take(token_kind::word, i - position_);
  }
  if (begins("<="))
    return take(token_kind::symbol, 2);
  if (std::string_view("{};=_[].,").find(c) != std::string_view::npos)
    return take(token_kind::symbol, 1);
  return take_error("a character that has no meaning here", 1);
}

} // namespace graze::itf1788
