#pragma once
/// The words of a formula's text: every spelling of a sign is one mark.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace graze::octree::tape {

enum class mark : std::uint8_t {
  end,
  numeral,
  name,
  exponent, ///< superscripts, as in x²
  plus,
  minus,
  times,
  divide,
  modulo,
  power,
  open,
  close,
  comma,
  semicolon,
  equal, ///< = alone
  less,
  less_equal,
  greater,
  greater_equal,
  same, ///< ==
  different,
  bar,
  conjunction, ///< &&
  negation,    ///< !
  unknown
};

/// Bytes [first, last) of the text.
struct word {
  mark what;
  std::size_t first, last;
};

class scanner {
public:
  explicit scanner(std::string_view text) : text_(text) { read(0); }

  [[nodiscard]] const word& here() const { return here_; }
  [[nodiscard]] bool at(mark m) const { return here_.what == m; }
  /// To the next word.
  void step() {
    last_ = here_.last;
    read(here_.last);
  }
  bool accept(mark m) {
    if (!at(m))
      return false;
    step();
    return true;
  }
  /// What stands after this word.
  [[nodiscard]] mark next() const {
    scanner ahead = *this;
    ahead.step();
    return ahead.here_.what;
  }
  /// The end of the word before this one.
  [[nodiscard]] std::size_t last() const { return last_; }
  [[nodiscard]] bool at_two_bars() const {
    return at(mark::bar) && here_.last < text_.size() && text_[here_.last] == '|';
  }
  [[nodiscard]] std::string_view text(std::size_t first, std::size_t last) const {
    return text_.substr(first, last - first);
  }
  [[nodiscard]] std::string_view text() const { return text(here_.first, here_.last); }
  [[nodiscard]] std::string_view rest() const { return text_.substr(here_.first); }

private:
  void read(std::size_t from);

  std::string_view text_;
  word here_{mark::end, 0, 0};
  std::size_t last_ = 0;
};

/// The integer that superscripts write, in ASCII: "-12" of ⁻¹². Nothing where they write none.
std::optional<std::string> exponent_in_ascii(std::string_view superscripts);

} // namespace graze::octree::tape
