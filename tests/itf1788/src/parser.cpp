#include "lexer.hpp"
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <graze/itf1788/syntax.hpp>
#include <graze/text.hpp>
#include <limits>
#include <optional>

namespace graze::itf1788 {

namespace {

constexpr std::array overlap_states{"bothEmpty", "firstEmpty",   "secondEmpty", "before",
                                    "meets",     "overlaps",     "starts",      "containedBy",
                                    "finishes",  "equals",       "finishedBy",  "contains",
                                    "startedBy", "overlappedBy", "metBy",       "after"};
constexpr std::array exceptions{"UndefinedOperation", "PossiblyUndefinedOperation",
                                "InvalidOperand", "IntvlPartOfNaI", "IntvlOverflow"};
constexpr std::array decorations{decoration::ill, decoration::trv, decoration::def, decoration::dac,
                                 decoration::com};

constexpr std::size_t most_statements = 200'000;

bool is_one_of(const auto& names, std::string_view word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

std::optional<decoration> decoration_of(std::string_view word) {
  const auto* found = std::find_if(decorations.begin(), decorations.end(),
                                   [&](decoration d) { return word == name_of(d); });
  return found == decorations.end() ? std::nullopt : std::optional(*found);
}

/// The word without its suffix f or l, and whether it had one.
struct suffixed {
  std::string_view stem;
  bool other_format;
};
suffixed without_suffix(std::string_view word) {
  const bool has = !word.empty() && std::string_view("fFlL").find(word.back()) != word.npos;
  return {has ? word.substr(0, word.size() - 1) : word, has};
}

/// A number, or nothing at all.
std::optional<value> special_number(std::string_view word) {
  for (const bool suffix : {false, true}) {
    const suffixed s = suffix ? without_suffix(word) : suffixed{word, false};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool is_number =
        s.stem == "NaN" || s.stem == "infinity" || s.stem == "+infinity" || s.stem == "-infinity";
    if (is_number && s.other_format)
      return other_format{std::string(word)};
    if (is_number)
      return s.stem == "NaN"         ? std::numeric_limits<double>::quiet_NaN()
             : s.stem.front() == '-' ? -infinity
                                     : infinity;
  }
  return std::nullopt;
}

/// A refusal travels up as an exception of this file; parse() makes a value of it.
struct refusal {
  int line;
  std::string reason;
};

class parser {
public:
  explicit parser(std::string_view text) : lexer_(text) { advance(); }

  std::vector<statement> file() {
    std::vector<statement> all;
    do
      testcase(all);
    while (here_.kind != token_kind::end);
    return all;
  }

private:
  lexer lexer_;
  token here_;
  std::string_view last_; // the token before here_

  void advance() {
    last_ = here_.written;
    here_ = lexer_.next();
    // a character without a meaning is a literal that is not known: of its statement alone
    if (here_.kind == token_kind::error && here_.written.empty())
      throw refusal{here_.line, here_.why};
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    if (here_.kind == token_kind::error)
      throw refusal{here_.line, fmt::format("{} ('{}')", here_.why, here_.written)};
    throw refusal{here_.line,
                  fmt::format("expected {}, found {}", expected,
                              here_.kind == token_kind::end ? "the end of the file"
                                                            : fmt::format("'{}'", here_.written))};
  }

  [[nodiscard]] bool is(std::string_view symbol) const {
    return here_.kind == token_kind::symbol && here_.written == symbol;
  }
  bool accept(std::string_view symbol) {
    const bool found = is(symbol);
    if (found)
      advance();
    return found;
  }
  void require(std::string_view symbol, const char* where) {
    if (!accept(symbol))
      refuse(fmt::format("'{}' {}", symbol, where));
  }
  std::string_view require_word(const char* refusal) {
    if (here_.kind != token_kind::word)
      refuse(refusal);
    advance();
    return last_;
  }

  void testcase(std::vector<statement>& all) {
    if (here_.kind != token_kind::word || here_.written != "testcase")
      refuse("'testcase'");
    advance();
    require_word("the name of the testcase");
    while (accept("."))
      require_word("the name of the testcase");
    require("{", "after the name of the testcase");
    do {
      if (all.size() == most_statements)
        throw refusal{here_.line, fmt::format("more than {} statements", most_statements)};
      all.push_back(test());
    } while (!accept("}"));
  }

  statement test() {
    statement s;
    s.line = here_.line;
    const char* const begin = here_.written.data();
    s.operation = require_word("an operation");
    s.operands = literals(true);
    if (accept("="))
      s.tightest = at_least_one();
    if (accept("<=")) {
      s.accurate = at_least_one();
      for (const value& v : s.accurate)
        if (!std::holds_alternative<bounds>(v) && !std::holds_alternative<decorated_bounds>(v))
          throw refusal{here_.line, "only intervals can stand after '<='"};
      if (!s.tightest.empty() && s.tightest.size() != s.accurate.size())
        throw refusal{here_.line, "not as many results after '<=' as after '='"};
    }
    if (s.tightest.empty() && s.accurate.empty())
      refuse("'=' and a result");
    if (here_.kind == token_kind::word && here_.written == "signal") {
      advance();
      if (!is_one_of(exceptions, here_.written))
        refuse("the name of an exception");
      s.signal = here_.written;
      advance();
    }
    s.written = in_one_line(text_from(begin));
    require(";", "after the statement");
    return s;
  }

  /// What was read since the token that begins there.
  [[nodiscard]] std::string_view text_from(const char* begin) const {
    return {begin, static_cast<std::size_t>(last_.data() + last_.size() - begin)};
  }

  /// Without line breaks and indentation, for reports.
  static std::string in_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
      const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
      if (!blank)
        line += c;
      else if (!line.empty() && line.back() != ' ')
        line += ' ';
    }
    while (!line.empty() && line.back() == ' ')
      line.pop_back();
    return line;
  }

  std::vector<value> at_least_one() {
    std::vector<value> all = literals(false);
    if (all.empty())
      refuse("a result");
    return all;
  }

  /// here_ is the first token of its line.
  [[nodiscard]] bool at_line_begin() const {
    return std::string_view(last_.data(),
                            static_cast<std::size_t>(here_.written.data() - last_.data()))
               .find('\n') != std::string_view::npos;
  }

  std::vector<value> literals(bool operands) {
    std::vector<value> all;
    while (!is("=") && !is("<=") && !is(";") &&
           !(here_.kind == token_kind::word && here_.written == "signal"))
      all.push_back(literal(operands));
    return all;
  }

  /// `operand`: not a result, which the next statement may follow where a ";" is missing.
  value literal(bool operand = true) {
    if (accept("["))
      return interval();
    if (accept("{"))
      return array();
    if (here_.kind == token_kind::number)
      return number_or_integer();
    if (here_.kind == token_kind::text)
      return text();
    if (here_.kind != token_kind::word && here_.kind != token_kind::error)
      refuse("a literal");
    const std::string_view word = here_.written;
    value v;
    if (word == "true" || word == "false")
      v = word == "true";
    else if (const auto d = decoration_of(word))
      v = *d;
    else if (is_one_of(overlap_states, word))
      v = overlap_name{std::string(word)};
    else if (const auto x = special_number(word))
      v = *x;
    else if (operand || !at_line_begin())
      v = other_format{std::string(word)}; // unknown: the statement is not supported
    else
      refuse("a literal"); // the next statement: this one has no end
    advance();
    return v;
  }

  value text() {
    std::string content;
    const std::string_view inner = here_.written.substr(1, here_.written.size() - 2);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      if (inner[i] == '\\')
        ++i;
      content += inner[i];
    }
    advance();
    return content;
  }

  /// A number that is no double, whatever it is rounded to: a hexadecimal one is meant exactly, and
  /// so is a decimal one of more than the 17 digits that tell any two doubles apart. With fewer it
  /// means the nearest double.
  static bool is_no_double(const std::string& written, bool hexadecimal) {
    std::size_t digits = 0;
    for (const char c : written) {
      if (c == 'e' || c == 'E')
        break;
      digits += '0' <= c && c <= '9' ? 1 : 0;
    }
    if (!hexadecimal && digits <= 17)
      return false;
    const auto exact = text_to_interval("[" + written + "]");
    return exact.signal != exception::none || exact.value.lo != exact.value.hi;
  }

  /// The rounding is to nearest and of this process' C locale.
  value number_or_integer() {
    const std::string written(here_.written);
    const bool hexadecimal = written.find_first_of("xX") != std::string::npos;
    const bool is_float = written.find_first_of(hexadecimal ? ".pP" : ".eE") != std::string::npos ||
                          (!hexadecimal && written.find_first_of("fF") != std::string::npos);
    char* end = nullptr;
    errno = 0;
    value v = other_format{written}; // of another format, or nothing known
    if (!is_float) {
      const std::int64_t n{std::strtoll(written.c_str(), &end, hexadecimal ? 16 : 10)};
      if (errno != ERANGE && std::string_view(end).find_first_not_of("uUlL") == std::string::npos)
        v = n;
    } else {
      const double x = std::strtod(written.c_str(), &end);
      const bool exponent = written.find_first_of("pP") != std::string::npos;
      if (*end == '\0' && (!hexadecimal || exponent) && !is_no_double(written, hexadecimal))
        v = x;
    }
    advance();
    return v;
  }

  /// A number of an interval or an array; an integer stands for the double that it is.
  value number() {
    if (is("[") || is("{")) // neither is one, and nested they would take the stack
      refuse("a number");
    const std::string written(here_.written);
    value v = literal();
    if (const auto* n = std::get_if<std::int64_t>(&v)) {
      constexpr std::int64_t most = std::int64_t{1} << 53;
      return -most <= *n && *n <= most ? value(static_cast<double>(*n))
                                       : value(other_format{written});
    }
    if (!std::holds_alternative<double>(v) && !std::holds_alternative<other_format>(v))
      throw refusal{here_.line, fmt::format("expected a number, found {}", to_text(v))};
    return v;
  }

  value array() {
    std::vector<double> numbers;
    std::optional<other_format> other;
    for (bool more = !is("}"); more; more = accept(",")) {
      const value v = number();
      if (const auto* x = std::get_if<double>(&v))
        numbers.push_back(*x);
      else
        other = std::get<other_format>(v);
    }
    require("}", "after the numbers");
    return other ? value(*other) : value(numbers);
  }

  value interval() {
    const int line = here_.line;
    const char* const begin = last_.data(); // "["
    bounds x = bounds::entire();
    bool other = false, nai = false;
    const suffixed word = without_suffix(here_.written);
    const auto names = [&](std::string_view name) {
      return here_.kind == token_kind::word && (here_.written == name || word.stem == name);
    };
    if (names("empty") || names("entire") || names("nai")) {
      nai = names("nai");
      other = here_.written == word.stem ? false : word.other_format;
      if (!names("entire"))
        x = bounds::empty();
      advance();
    } else {
      const value lower = number();
      require(",", "between the bounds of an interval");
      const value upper = number();
      if (const auto *lo = std::get_if<double>(&lower), *hi = std::get_if<double>(&upper);
          lo != nullptr && hi != nullptr) {
        if (checking::is_empty(*lo, *hi))
          throw refusal{line, "an interval without members: [" + to_text(lower) + ", " +
                                  to_text(upper) + "] (write [empty])"};
        x = {*lo, *hi};
      } else {
        other = true;
      }
    }
    require("]", "at the end of an interval");
    value v = x;
    if (nai)
      v = decorated_bounds::nai();
    else if (accept("_"))
      v = decorated_bounds{x, required_decoration(x, other, line)};
    if (other)
      v = other_format{in_one_line(text_from(begin))};
    return v;
  }

  decoration required_decoration(const bounds& x, bool unknown, int line) {
    const auto d = here_.kind == token_kind::word ? decoration_of(here_.written) : std::nullopt;
    if (!d || *d == decoration::ill)
      refuse("a decoration (com, dac, def, trv)");
    if (!unknown && *d > (x.is_empty()    ? decoration::trv
                          : x.is_common() ? decoration::com
                                          : decoration::dac))
      throw refusal{line, to_text(x) + " cannot be decorated " + name_of(*d)};
    advance();
    return *d;
  }
};

} // namespace

expected<std::vector<statement>> parse(std::string_view text, const std::string& name) {
  try {
    return parser(text).file();
  } catch (const refusal& r) {
    return unexpected{name + ":" + std::to_string(r.line) + ": " + r.reason};
  }
}

} // namespace graze::itf1788
