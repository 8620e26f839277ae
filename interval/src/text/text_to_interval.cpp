// The grammar of interval literals: IEEE 1788-2015, 12.11.3 (table 12.1 and the text below it).
#include "../border.hpp"
#include "../exact/exact_number.hpp"
#include <algorithm>
#include <graze/text.hpp>
#include <optional>

namespace graze {

namespace {

using detail::exact_number;
using detail::natural;
using rounding::exact::direction;
constexpr double infinity = checking::infinity;

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_hexadecimal_digit(char c) {
  const char lower = static_cast<char>(c | 0x20);
  return is_digit(c) || ('a' <= lower && lower <= 'f');
}
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Takes what it recognizes from the front of a text; letters in any case.
class reader {
public:
  explicit reader(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] char peek() const { return rest_.empty() ? '\0' : rest_.front(); }

  /// The word, in lower case, or nothing.
  bool take(std::string_view word) {
    if (rest_.size() < word.size())
      return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
      const char c = rest_[i];
      if (('A' <= c && c <= 'Z' ? static_cast<char>(c | 0x20) : c) != word[i])
        return false;
    }
    rest_.remove_prefix(word.size());
    return true;
  }
  std::string_view take_while(bool (*belongs)(char)) {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), belongs);
    const auto found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(found.size());
    return found;
  }
  void skip_blanks() { take_while(is_blank); }
  /// A sign if there is one; true for a minus.
  bool take_sign() { return take("-") || (take("+"), false); }

  /// Digits with an optional point, at least one digit. Leading zeros are dropped.
  struct significand {
    std::string digits;
    std::int64_t places; ///< digits after the point
    bool is_integer;     ///< there is no point
  };
  std::optional<significand> take_significand(bool (*belongs)(char)) {
    const std::string_view whole = take_while(belongs);
    const bool is_integer = !take(".");
    const std::string_view fraction = is_integer ? std::string_view() : take_while(belongs);
    if (whole.empty() && fraction.empty())
      return std::nullopt;
    std::string digits(whole);
    digits += fraction;
    digits.erase(0, digits.find_first_not_of('0'));
    return significand{digits, static_cast<std::int64_t>(fraction.size()), is_integer};
  }

  /// A signed integer; one beyond +-10^17, which no text is long enough to make up for, counts as
  /// that.
  std::optional<std::int64_t> take_exponent() {
    const bool negative = take_sign();
    const std::string_view digits = take_while(is_digit);
    if (digits.empty())
      return std::nullopt;
    std::int64_t n = 0;
    for (const char c : digits)
      n = std::min<std::int64_t>(n * 10 + (c - '0'), 100000000000000000);
    return negative ? -n : n;
  }

private:
  std::string_view rest_;
};

/// One end of an interval: a number, or an infinity.
struct end_point {
  exact_number number;
  double infinite = 0; ///< +-inf, else 0
};

struct rounded_end {
  double down, up;
  explicit rounded_end(const end_point& e)
      : down(e.infinite != 0 ? e.infinite : e.number.rounded(direction::down)),
        up(e.infinite != 0 ? e.infinite : e.number.rounded(direction::up)) {}
};

/// number | infinity
std::optional<end_point> take_end(reader& text) {
  end_point e;
  const bool negative = text.take_sign();
  if (text.take("infinity") || text.take("inf")) {
    e.infinite = negative ? -infinity : infinity;
    return e;
  }
  e.number.negative = negative;
  if (text.take("0x")) {
    const auto s = text.take_significand(is_hexadecimal_digit);
    if (!s || !text.take("p"))
      return std::nullopt;
    const auto exponent = text.take_exponent();
    if (!exponent)
      return std::nullopt;
    e.number.numerator = natural::of_hexadecimal(s->digits);
    e.number.twos = *exponent - 4 * s->places;
    return e;
  }
  const auto s = text.take_significand(is_digit);
  if (!s)
    return std::nullopt;
  e.number.numerator = natural::of_decimal(s->digits);
  if (s->is_integer && text.take("/")) {
    e.number.denominator = natural::of_decimal(text.take_while(is_digit));
    if (e.number.denominator.is_zero())
      return std::nullopt;
    return e;
  }
  std::int64_t exponent = -s->places;
  if (text.take("e")) {
    const auto written = text.take_exponent();
    if (!written)
      return std::nullopt;
    exponent += *written;
  }
  e.number.scale_by_ten_to(exponent);
  return e;
}

/// What a bare literal means.
struct meaning {
  bounds enclosure = bounds::empty();
  bool bounded = false; ///< not empty, and the exact set is bounded
  exception signal = exception::none;
};

meaning interval_between(const end_point& lower, const end_point& upper) {
  const rounded_end l(lower), u(upper);
  if (l.down == infinity || u.up == -infinity || l.down > u.down || l.up > u.up)
    return {.signal = exception::undefined_operation};
  meaning m{{l.down, u.up}, lower.infinite == 0 && upper.infinite == 0};
  // Within one gap between doubles the standard's own examples leave the order undecided.
  if (l.down != l.up && l.down == u.down && !(lower.number == upper.number))
    m.signal = exception::possibly_undefined_operation;
  return m;
}

/// What follows "[", up to and with "]".
std::optional<meaning> take_bracketed(reader& text) {
  text.skip_blanks();
  if (text.take("]"))
    return meaning{};
  std::optional<end_point> lower, upper;
  if (text.peek() != ',') {
    lower = take_end(text);
    if (!lower)
      return std::nullopt;
    text.skip_blanks();
    if (text.take("]")) {
      if (lower->infinite != 0)
        return std::nullopt;
      const rounded_end r(*lower);
      return meaning{{r.down, r.up}, true};
    }
  }
  if (!text.take(","))
    return std::nullopt;
  text.skip_blanks();
  if (text.peek() != ']') {
    upper = take_end(text);
    if (!upper)
      return std::nullopt;
    text.skip_blanks();
  }
  if (!text.take("]"))
    return std::nullopt;
  return interval_between(lower.value_or(end_point{{}, -infinity}),
                          upper.value_or(end_point{{}, infinity}));
}

/// "[empty]" or "[entire]", or nothing taken.
std::optional<meaning> take_word(reader& text) {
  reader ahead = text;
  if (!ahead.take("["))
    return std::nullopt;
  ahead.skip_blanks();
  std::optional<meaning> found;
  if (ahead.take("empty"))
    found = meaning{};
  else if (ahead.take("entire"))
    found = meaning{bounds::entire()};
  ahead.skip_blanks();
  if (!found || !ahead.take("]"))
    return std::nullopt;
  text = ahead;
  return found;
}

/// m +- r for integers m of either sign and r, times 2^-1 10^exponent.
exact_number sum_of(const natural& m, bool negative, const natural& r, bool minus,
                    std::int64_t exponent) {
  exact_number n;
  n.negative = negative;
  n.numerator = m;
  if (negative == minus) {
    n.numerator += r;
  } else if (r <= m) {
    n.numerator -= r;
  } else {
    n.numerator = r;
    n.numerator -= m;
    n.negative = minus;
  }
  n.scale_by_ten_to(exponent);
  n.twos -= 1;
  return n;
}

/// 3.56?1ue2: see text_to_interval.
std::optional<meaning> take_uncertain(reader& text) {
  const bool negative = text.take_sign();
  const auto s = text.take_significand(is_digit);
  if (!s || !text.take("?"))
    return std::nullopt;
  const bool unlimited = text.take("?");
  const std::string_view written = unlimited ? std::string_view() : text.take_while(is_digit);
  const bool up = text.take("u"), down = !up && text.take("d");
  std::int64_t exponent = -s->places;
  if (text.take("e")) {
    const auto e = text.take_exponent();
    if (!e)
      return std::nullopt;
    exponent += *e;
  }
  // in half units of the last place
  natural middle = natural::of_decimal(s->digits), radius = 1;
  middle <<= 1;
  if (!written.empty()) {
    radius = natural::of_decimal(written);
    radius <<= 1;
  }
  const natural none;
  meaning m{bounds::entire(), !unlimited};
  if (!unlimited || up)
    m.enclosure.lo =
        sum_of(middle, negative, up ? none : radius, true, exponent).rounded(direction::down);
  if (!unlimited || down)
    m.enclosure.hi =
        sum_of(middle, negative, down ? none : radius, false, exponent).rounded(direction::up);
  return m;
}

std::optional<meaning> take_literal(reader& text) {
  if (auto word = take_word(text))
    return word;
  return text.take("[") ? take_bracketed(text) : take_uncertain(text);
}

bool is_nai(std::string_view literal) {
  reader text(literal);
  if (!text.take("["))
    return false;
  text.skip_blanks();
  if (!text.take("nai"))
    return false;
  text.skip_blanks();
  return text.take("]") && text.at_end();
}

} // namespace

namespace inside {

signalling<bounds> text_to_interval(std::string_view text) {
  reader r(text);
  const auto m = take_literal(r);
  if (!m || !r.at_end())
    return {bounds::empty(), exception::undefined_operation};
  return {m->enclosure, m->signal};
}

signalling<decorated_bounds> text_to_decorated(std::string_view text) {
  const signalling<decorated_bounds> failure{decorated_bounds::nai(),
                                             exception::undefined_operation};
  if (is_nai(text))
    return {decorated_bounds::nai()};
  reader r(text);
  const auto m = take_literal(r);
  if (!m || m->signal == exception::undefined_operation)
    return failure;
  const decoration best = new_dec(m->enclosure).label;
  if (r.at_end())
    return {{m->enclosure, best}, m->signal};
  if (!r.take("_"))
    return failure;
  using enum decoration;
  const decoration written = r.take("com")   ? com
                             : r.take("dac") ? dac
                             : r.take("def") ? def
                             : r.take("trv") ? trv
                                             : ill;
  const decoration possible = m->enclosure.is_empty() ? trv : m->bounded ? com : dac;
  if (!r.at_end() || written == ill || written > possible)
    return failure;
  return {{m->enclosure, std::min(written, best)}, m->signal};
}

} // namespace inside

signalling<bounds> text_to_interval(std::string_view text) {
  return at_border<inside::text_to_interval>(text);
}
signalling<decorated_bounds> text_to_decorated(std::string_view text) {
  return at_border<inside::text_to_decorated>(text);
}

} // namespace graze
