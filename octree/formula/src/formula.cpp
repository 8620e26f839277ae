// The parser: recursive descent over the grammar of octree_formula.hpp. It keeps no globals, and
// makes sums of monomials as it reads.
#include <graze/octree_formula.hpp>
#include <graze/rounding/hardware.hpp>

#include "expressions.hpp"

#include <algorithm>
#include <graze/text.hpp>

namespace graze::octree {
namespace {

using tape::exact_literal;
using tape::expressions;
using tape::number;
using tape::opcode;
using tape::sum_form;

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_hexadecimal(char c) {
  return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
}
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

struct unary_name {
  std::string_view name;
  opcode op;
};
constexpr unary_name unary_names[] = {
#define GRAZE_TAPE_NAME(name) {#name, opcode::name},
    GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_NAME)
#undef GRAZE_TAPE_NAME
        {"sqr", opcode::sqr},
    {"sqrt", opcode::sqrt},
    {"abs", opcode::abs},
    {"ln", opcode::log},
    {"log1p", opcode::logp1},
};
struct binary_name {
  std::string_view name;
  opcode op;
  bool of_many; ///< of two or more, from left to right
};
constexpr binary_name binary_names[] = {
    {"min", opcode::min, true},      {"max", opcode::max, true},
    {"union", opcode::min, true},    {"intersection", opcode::max, true},
    {"hypot", opcode::hypot, false}, {"atan2", opcode::atan2, false},
};

class parser {
public:
  explicit parser(std::string_view text) : text_(text) {}

  /// The whole text.
  std::optional<sum_form> formula() {
    blanks();
    if (at_ == text_.size())
      return refuse(at_, "the formula is empty");
    auto f = sum();
    if (f && at_ != text_.size())
      return refuse_here("an operator or the end");
    return f;
  }

  [[nodiscard]] expressions& built() { return built_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] std::size_t position() const { return position_; }

private:
  using result = std::optional<sum_form>;

  std::nullopt_t refuse(std::size_t position, std::string why) {
    position_ = position;
    reason_ = std::move(why);
    return std::nullopt;
  }
  /// What stands here, for a message.
  [[nodiscard]] std::string found() const {
    if (at_ >= text_.size())
      return "the end";
    const char c = text_[at_];
    return c > ' ' && c < 0x7f ? std::string("'").append(1, c).append("'") : "a character";
  }
  std::nullopt_t refuse_here(const char* expected_here) {
    return refuse(at_, std::string("expected ") + expected_here + ", found " + found());
  }
  /// What the builder made of it, or its reason, at this position.
  result checked(result r, std::size_t position) {
    if (!r)
      return refuse(position, built_.reason());
    return r;
  }

  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void blanks() {
    while (at_ < text_.size() && is_blank(text_[at_]))
      ++at_;
  }
  bool accept(char c) {
    if (peek() != c)
      return false;
    ++at_;
    blanks();
    return true;
  }

  result sum() {
    result f = product();
    while (f && (peek() == '+' || peek() == '-')) {
      const std::size_t position = at_;
      const bool plus = accept('+');
      if (!plus)
        accept('-');
      const result g = product();
      if (!g)
        return std::nullopt;
      f = checked(plus ? built_.add(*std::move(f), *g) : built_.sub(*std::move(f), *g), position);
    }
    return f;
  }

  result product() {
    result f = signed_power();
    bool divided = false;
    while (f) {
      const std::size_t position = at_;
      const bool divides = peek() == '/';
      if (accept('*') || accept('/')) {
        result g = signed_power();
        if (!g)
          return std::nullopt;
        f = checked(divides ? built_.div(*f, *g) : built_.mul(*std::move(f), *std::move(g)),
                    position);
        divided = divides;
        continue;
      }
      const bool name = is_letter(peek());
      if (!name && peek() != '(' && !is_digit(peek()) && peek() != '.')
        return f;
      if (last_ == ending::name || (!name && peek() != '('))
        return refuse_here("an operator");
      if (last_ == ending::exponent)
        return refuse(at_, "write * after an exponent: it is not clear where it ends");
      if (divided)
        return refuse(at_, "write a/(b*c) or (a/b)*c: a product without * after / is not clear");
      result g = power();
      if (!g)
        return std::nullopt;
      f = checked(built_.mul(*std::move(f), *std::move(g)), position);
    }
    return f;
  }

  result signed_power() {
    const std::size_t position = at_;
    bool negative = false;
    while (peek() == '+' || peek() == '-') {
      negative = negative != (peek() == '-');
      ++at_;
      blanks();
    }
    result f = power();
    if (f && negative)
      f = checked(built_.neg(*std::move(f)), position);
    return f;
  }

  result power() {
    const bool of_e = peek() == 'e' && !is_letter(peek(1)) && !is_digit(peek(1));
    result f = primary();
    if (!f || peek() != '^')
      return f;
    const std::size_t position = at_;
    accept('^');
    if (!deeper())
      return std::nullopt;
    const result g = signed_power();
    --depth_;
    if (!g)
      return std::nullopt;
    last_ = ending::exponent;
    return checked(of_e ? built_.unary(opcode::exp, *g) : built_.power(*f, *g), position);
  }

  result primary() {
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1))))
      return literal();
    if (is_letter(peek()))
      return named();
    if (peek() != '(')
      return refuse_here("a number, a name or '('");
    const std::size_t position = at_;
    accept('(');
    result f = nested();
    if (f && !accept(')'))
      return refuse_here(("')' for the '(' in column " + std::to_string(position + 1)).c_str());
    last_ = ending::parenthesis;
    return f;
  }

  bool deeper() {
    if (++depth_ <= formula::most_nested)
      return true;
    refuse(at_, "nested more than " + std::to_string(formula::most_nested) + " deep");
    return false;
  }
  result nested() {
    if (!deeper())
      return std::nullopt;
    result f = sum();
    --depth_;
    return f;
  }

  result literal() {
    const std::size_t first = at_;
    bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X') &&
                       (is_hexadecimal(peek(2)) || (peek(2) == '.' && is_hexadecimal(peek(3))));
    at_ += hexadecimal ? 2 : 0;
    const auto digits = [&] {
      while (hexadecimal ? is_hexadecimal(peek()) : is_digit(peek()))
        ++at_;
    };
    digits();
    if (peek() == '.') {
      ++at_;
      digits();
    }
    const char mark = hexadecimal ? 'p' : 'e';
    bool exponent = false;
    if (peek() == mark || peek() == mark - 'a' + 'A') {
      const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
      if (is_digit(peek(1 + sign))) {
        exponent = true;
        at_ += 1 + sign;
        while (is_digit(peek()))
          ++at_;
      }
    }
    if (at_ - first > formula::longest_number)
      return refuse(first, "the number is longer than " + std::to_string(formula::longest_number) +
                               " characters");
    if (peek() == '.')
      return refuse(at_, "a second '.' in a number");
    const std::size_t length = at_ - first;
    std::string text = "[";
    text.append(text_.substr(first, length)).append(hexadecimal && !exponent ? "p0]" : "]");
    const auto value = text_to_interval(text);
    if (value.signal == exception::undefined_operation)
      return refuse(first, "not a number");
    if (!value.value.is_common())
      return refuse(first, "the number is too large for a double");
    last_ = ending::numeral;
    blanks();
    return expressions::constant(
        number({value.value.lo, value.value.hi}, exact_literal(text_.substr(first, length))));
  }

  result named() {
    const std::size_t first = at_;
    while (is_letter(peek()) || is_digit(peek()))
      ++at_;
    const std::string_view name = text_.substr(first, at_ - first);
    blanks();
    last_ = ending::name;
    if (name == "x" || name == "y" || name == "z")
      return built_.variable(name[0] - 'x');
    // pi = 3.14159265358979323846..., e = 2.71828182845904523536..., between neighbouring doubles
    if (name == "pi")
      return expressions::constant(number(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1));
    if (name == "e")
      return expressions::constant(number(0x1.5bf0a8b145769p+1, 0x1.5bf0a8b14576ap+1));
    const bool known = std::any_of(std::begin(unary_names), std::end(unary_names),
                                   [&](const unary_name& u) { return u.name == name; }) ||
                       std::any_of(std::begin(binary_names), std::end(binary_names),
                                   [&](const binary_name& b) { return b.name == name; }) ||
                       name == "difference" || name == "pow" || name == "pown" || name == "rootn";
    if (!known) {
      const std::string shown(name.substr(0, 40));
      const bool product = name.size() <= 3 && name.find_first_not_of("xyz") == name.npos;
      return refuse(first, "unknown name '" + shown + "'" + (product ? "; products need a *" : ""));
    }
    if (!accept('('))
      return refuse_here("'(' after a function's name");
    std::vector<sum_form> operands;
    std::vector<std::size_t> positions;
    do {
      positions.push_back(at_);
      result f = nested();
      if (!f)
        return std::nullopt;
      operands.push_back(*std::move(f));
    } while (accept(','));
    if (!accept(')'))
      return refuse_here("',' or ')'");
    last_ = ending::parenthesis;
    return call(name, first, operands, positions);
  }

  result call(std::string_view name, std::size_t first, const std::vector<sum_form>& operands,
              const std::vector<std::size_t>& positions) {
    const auto wants = [&](const char* count) {
      return refuse(first, std::string(name) + " takes " + count);
    };
    for (const unary_name& u : unary_names)
      if (u.name == name) {
        if (operands.size() != 1)
          return wants("one operand");
        return checked(built_.unary(u.op, operands[0]), first);
      }
    for (const binary_name& b : binary_names)
      if (b.name == name) {
        if (b.of_many ? operands.size() < 2 : operands.size() != 2)
          return wants(b.of_many ? "two or more operands" : "two operands");
        result f = operands[0];
        for (std::size_t i = 1; f && i < operands.size(); ++i)
          f = checked(built_.binary(b.op, *f, operands[i]), first);
        return f;
      }
    if (operands.size() != 2)
      return wants("two operands");
    if (name == "difference")
      return checked(built_.binary(opcode::max, operands[0], *built_.neg(operands[1])), first);
    if (name == "pow")
      return checked(built_.binary(opcode::pow, operands[0], operands[1]), first);
    const auto n = expressions::as_constant(operands[1]);
    if (!n || n->lower() != n->upper() || n->lower() != std::floor(n->lower()))
      return refuse(positions[1], "expected an integer");
    const double bounded = std::clamp(n->lower(), -0x1p40, 0x1p40);
    const auto integer = static_cast<std::int64_t>(bounded);
    return checked(name == "pown" ? built_.integer_power(operands[0], integer)
                                  : built_.root(operands[0], integer),
                   first);
  }

  /// What the last power ended with: it decides what may follow without an operator.
  enum class ending { numeral, name, parenthesis, exponent };

  std::string_view text_;
  std::size_t at_ = 0, depth_ = 0, position_ = 0;
  ending last_ = ending::numeral;
  std::string reason_;
  expressions built_;
};

} // namespace

expected<formula> formula::parse(std::string_view text, std::size_t* column) {
  // A constant below the normal numbers is not 0, whatever the caller's environment is.
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  const auto refused = [column](std::size_t position, const std::string& why) {
    if (column != nullptr)
      *column = position + 1;
    return unexpected{"column " + std::to_string(position + 1) + ": " + why};
  };
  if (text.size() > longest_text)
    return refused(longest_text,
                   "the formula is longer than " + std::to_string(longest_text) + " bytes");
  parser p(text);
  const auto f = p.formula();
  if (!f)
    return refused(p.position(), p.reason());
  auto program = p.built().compile(*f);
  if (!program)
    return refused(0, "the formula needs too many intermediate results at once");
  program->text = text;
  return formula(std::make_shared<const tape::program>(*std::move(program)));
}

} // namespace graze::octree
