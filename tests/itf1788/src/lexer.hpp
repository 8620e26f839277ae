#pragma once
/// The tokens of .itl files.
#include <string>
#include <string_view>

namespace graze::itf1788 {

enum class token_kind { word, number, text, symbol, end, error };

struct token {
  token_kind kind = token_kind::end;
  std::string_view written; ///< as in the file; for `text` with its quotes; for `symbol` one of
                            ///< { } ; = <= _ [ ] . ,
  int line = 1;
  const char* why = nullptr; ///< of an error
};

/// Hands out one token after the other; `end` for ever after the last.
class lexer {
public:
  explicit lexer(std::string_view text) : text_(text) {}
  token next();

private:
  [[nodiscard]] char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
  [[nodiscard]] bool begins(std::string_view with) const {
    return text_.substr(position_).starts_with(with);
  }
  bool skip_blank();
  token take(token_kind kind, std::size_t length);
  token take_error(const char* why, std::size_t length);
  [[nodiscard]] std::size_t number_length() const;

  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 1;
};

} // namespace graze::itf1788
