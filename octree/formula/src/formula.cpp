// The parser: recursive descent over the grammar of octree_formula.hpp. It keeps no globals, and
// makes sums of monomials as it reads.
#include <graze/octree_formula.hpp>
#include <graze/rounding/hardware.hpp>

#include "characters.hpp"
#include "conditions.hpp"
#include "expressions.hpp"
#include "names.hpp"
#include "scanner.hpp"

#include <algorithm>
#include <cmath>
#include <graze/text.hpp>
#include <set>

namespace graze::octree {
namespace {

using tape::built_in_name;
using tape::condition;
using tape::exact_literal;
using tape::expressions;
using tape::mark;
using tape::number;
using tape::opcode;
using tape::sum_form;
using tape::truth;

/// A number, or a condition.
struct item {
  sum_form value;
  truth is;
};

class parser {
public:
  parser(std::string_view text, std::span<const parameter> set) : text_(text), at_(text) {
    for (const parameter& p : set)
      given_.emplace(p.name, &p);
  }

  /// The whole text.
  std::optional<sum_form> formula() {
    if (at_.at(mark::end))
      return refuse(at_.here().first, "the formula is empty");
    const result f = block();
    if (f && !at_.at(mark::end))
      return refuse_here("an operator or the end");
    return f ? solid(0, *f) : std::nullopt;
  }

  [[nodiscard]] expressions& built() { return built_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] const std::set<std::string>& parameters() const { return used_; }

private:
  using result = std::optional<item>;
  using kind = built_in_name::kind;

  std::nullopt_t refuse(std::size_t position, std::string why) {
    position_ = position;
    reason_ = std::move(why);
    return std::nullopt;
  }
  std::nullopt_t refuse_here(const char* expected_here) {
    return refuse(at_.here().first, std::string("expected ") + expected_here + ", found " +
                                        tape::describe_first(at_.rest()));
  }
  /// What the builder made of it, or its reason, at this position.
  result checked(expressions::result r, std::size_t position) {
    if (!r)
      return refuse(position, built_.reason());
    return item{*std::move(r), nullptr};
  }
  [[nodiscard]] std::string column(std::size_t position) const {
    return std::to_string(tape::count_characters(text_.substr(0, position)) + 1);
  }
  bool is_number(std::size_t position, const item& f) {
    if (!f.is)
      return true;
    refuse(position, "a comparison is no number: if(c, a, b) makes one of it");
    return false;
  }
  /// An operation on numbers.
  template <class Operation>
  result combined(std::size_t position, result f, result g, Operation op) {
    if (!f || !g || !is_number(position, *f) || !is_number(position, *g))
      return std::nullopt;
    return checked(op(std::move(f->value), std::move(g->value)), position);
  }

  // Definitions.

  /// { definition ";" } equation [ ";" ], up to the end or a parenthesis, where its definitions end.
  result block() {
    std::vector<std::string> own;
    result f;
    while (true) {
      const tape::word begin = at_.here();
      const bool has_let = at_.at(mark::name) && at_.text() == "let" && at_.next() == mark::name;
      if (has_let)
        at_.step();
      const bool is_named = at_.at(mark::name) && at_.next() == mark::equal;
      if (has_let && !is_named)
        return refuse(begin.first, "a definition is let name = ...;");
      const std::string name(is_named ? at_.text() : "");
      const std::size_t position = at_.here().first;
      const built_in_name* const known = tape::find_built_in(name);
      const bool is_taken = defined_.contains(name) || given_.contains(name) ||
                            (known != nullptr && !known->may_be_defined());
      const auto refuse_meaning = [&] {
        return refuse(position, quoted(name) + " has a meaning already: it cannot be defined");
      };
      if (!is_named || is_taken) {
        if (has_let || (known != nullptr && (known->is_function() || known->is_joint())))
          return refuse_meaning();
        f = equation();
        if (f && is_named && more_follows())
          return refuse_meaning();
        break;
      }
      at_.step();
      at_.step();
      const bool was_read = read_.contains(name);
      f = disjunction();
      if (!f)
        return std::nullopt;
      if (!more_follows()) {
        if (known == nullptr || has_let)
          return refuse(position, "the definition of " + quoted(name) +
                                      " needs a ';' and a formula after it");
        f = equal(position, built_in_value(*known, position), *std::move(f));
        break;
      }
      if (was_read || read_.contains(name))
        return refuse(position, quoted(name) + " is used before it is defined");
      accept_semicolons(at_);
      defined_.emplace(name, *std::move(f));
      own.push_back(name);
    }
    if (f && at_.at(mark::equal))
      return refuse(at_.here().first, "a second '='");
    accept_semicolons(at_);
    for (const std::string& name : own)
      defined_.erase(name);
    return f;
  }
  static void accept_semicolons(tape::scanner& at) {
    while (at.accept(mark::semicolon)) {
    }
  }
  /// After a ';'.
  [[nodiscard]] bool more_follows() const {
    tape::scanner ahead = at_;
    accept_semicolons(ahead);
    return at_.at(mark::semicolon) && !ahead.at(mark::end) && !ahead.at(mark::close);
  }
  static std::string quoted(std::string_view name) {
    return "'" + std::string(name.substr(0, 40)) + "'";
  }

  /// condition [ "=" condition ]
  result equation() {
    result f = disjunction();
    const std::size_t position = at_.here().first;
    if (!f || !at_.accept(mark::equal))
      return f;
    result g = disjunction();
    return g ? equal(position, std::move(f), *std::move(g)) : std::nullopt;
  }
  result equal(std::size_t position, result f, item g) {
    return combined(position, std::move(f), std::move(g),
                    [&](sum_form a, const sum_form& b) { return built_.sub(std::move(a), b); });
  }

  // Conditions.

  bool is_condition(std::size_t position, const item& f) {
    if (f.is)
      return true;
    refuse(position, "expected a comparison, such as x < 1");
    return false;
  }
  [[nodiscard]] bool at_word(kind what) const {
    if (!at_.at(mark::name) || defined_.contains(at_.text()) || given_.contains(at_.text()))
      return false;
    const built_in_name* const known = tape::find_built_in(at_.text());
    return known != nullptr && known->what == what;
  }

  template <class Part, class Accept>
  result chain(condition::kind what, Part part, Accept accept_word) {
    std::size_t position = at_.here().first;
    result f = part();
    std::vector<truth> parts;
    while (f) {
      const tape::word word = at_.here();
      if (!accept_word())
        break;
      if (word.what == mark::bar && !f->is)
        return refuse(word.first, "write * before |...|: || is between comparisons");
      if (!is_condition(position, *f))
        return std::nullopt;
      parts.push_back(f->is);
      position = at_.here().first;
      f = part();
    }
    if (!f || parts.empty())
      return f;
    if (!is_condition(position, *f))
      return std::nullopt;
    parts.push_back(f->is);
    return item{{}, condition::joined(what, std::move(parts))};
  }
  result disjunction() {
    return chain(
        condition::kind::any, [this] { return conjunction(); },
        [this] {
          if (at_word(kind::disjunction))
            return at_.step(), true;
          return bars_ == 0 && at_.at_two_bars() ? (at_.step(), at_.step(), true) : false;
        });
  }
  result conjunction() {
    return chain(
        condition::kind::all, [this] { return negation(); },
        [this] {
          if (at_word(kind::conjunction))
            return at_.step(), true;
          return at_.accept(mark::conjunction);
        });
  }
  result negation() {
    bool negative = false, any = false;
    while (at_.at(mark::negation) || at_word(kind::negation)) {
      negative = !negative;
      any = true;
      at_.step();
    }
    const std::size_t position = at_.here().first;
    result f = comparison();
    if (!f || !any)
      return f;
    if (!is_condition(position, *f))
      return std::nullopt;
    if (negative)
      f->is = tape::negated(built_, *f->is);
    return f;
  }
  [[nodiscard]] bool at_comparison() const {
    return mark::less <= at_.here().what && at_.here().what <= mark::different &&
           at_.here().what != mark::equal;
  }
  result comparison() {
    result f = sum();
    if (!f || !at_comparison())
      return f;
    const std::size_t position = at_.here().first;
    const mark what = at_.here().what;
    at_.step();
    result g = sum();
    const bool upward = what == mark::less || what == mark::less_equal; // f < g is g - f > 0
    result h = combined(position, std::move(f), std::move(g), [&](sum_form a, sum_form b) {
      return upward ? built_.sub(std::move(b), a) : built_.sub(std::move(a), b);
    });
    if (!h)
      return std::nullopt;
    if (at_comparison())
      return refuse(at_.here().first, "write a < b and b < c");
    using enum condition::kind;
    return item{{},
                condition::compared(what == mark::less || what == mark::greater ? greater
                                    : what == mark::same                        ? same
                                    : what == mark::different                   ? different
                                                                                : at_least,
                                    std::move(h->value))};
  }

  std::optional<sum_form> solid(std::size_t position, const item& f) {
    if (!f.is)
      return f.value;
    auto r = tape::solid(built_, *f.is);
    if (!r)
      return refuse(position, built_.reason());
    return r;
  }

  // Numbers.

  result sum() {
    result f = product();
    while (f && (at_.at(mark::plus) || at_.at(mark::minus))) {
      const std::size_t position = at_.here().first;
      const bool plus = at_.at(mark::plus);
      at_.step();
      f = combined(position, std::move(f), product(), [&](sum_form a, const sum_form& b) {
        return plus ? built_.add(std::move(a), b) : built_.sub(std::move(a), b);
      });
    }
    return f;
  }

  result product() {
    result f = signed_power();
    std::string divided; // the sign, after a quotient
    while (f) {
      const std::size_t position = at_.here().first;
      const mark what = at_.here().what;
      if (what == mark::times || what == mark::divide || what == mark::modulo) {
        divided = what == mark::times ? "" : at_.text();
        at_.step();
        f = combined(position, std::move(f), signed_power(), [&](sum_form a, sum_form b) {
          return what == mark::times    ? built_.mul(std::move(a), std::move(b))
                 : what == mark::divide ? built_.div(a, b)
                                        : modulo(a, b);
        });
        continue;
      }
      const bool name = what == mark::name && !at_word(kind::conjunction) &&
                        !at_word(kind::disjunction) && !at_word(kind::negation);
      const bool bar = what == mark::bar && bars_ == 0 && !at_.at_two_bars();
      if (!name && !bar && what != mark::open && what != mark::numeral)
        return f;
      if (last_ == ending::bar || (bar && last_ == ending::name))
        return refuse(position, "write * beside |...|");
      if (last_ == ending::name || what == mark::numeral)
        return refuse_here("an operator");
      if (last_ == ending::exponent)
        return refuse(position, "write * after an exponent: it is not clear where it ends");
      if (!divided.empty())
        return refuse(position, "write a" + divided + "(b*c) or (a" + divided +
                                    "b)*c: a product without * after " + divided + " is not clear");
      f = combined(position, std::move(f), power(),
                   [&](sum_form a, sum_form b) { return built_.mul(std::move(a), std::move(b)); });
    }
    return f;
  }

  result signed_power() {
    const std::size_t position = at_.here().first;
    bool negative = false;
    while (at_.at(mark::plus) || at_.at(mark::minus)) {
      negative = negative != at_.at(mark::minus);
      at_.step();
    }
    result f = power();
    if (f && negative)
      f = is_number(position, *f) ? checked(built_.neg(std::move(f->value)), position)
                                  : std::nullopt;
    return f;
  }

  result power() {
    const bool of_e = at_word(kind::e);
    const std::size_t first = at_.here().first;
    result f = primary();
    const std::size_t position = at_.here().first;
    if (!f || (!at_.at(mark::power) && !at_.at(mark::exponent)))
      return f;
    const std::string_view base = at_.text(first, at_.last());
    result g;
    if (at_.at(mark::exponent)) {
      const auto digits = tape::exponent_in_ascii(at_.text());
      if (!digits || digits->size() > formula::longest_number)
        return refuse(position, "expected an exponent such as \u00b2 or \u207b\u00b9");
      g = item{expressions::constant(literal_value(*digits)), nullptr};
      at_.step();
      if (at_.at(mark::power))
        return refuse(at_.here().first, "write (x\u00b2)^3 or x^(2^3)");
      last_ = ending::parenthesis; // it is clear where it ends
    } else {
      at_.step();
      if (!deeper())
        return std::nullopt;
      g = signed_power();
      --depth_;
      last_ = ending::exponent;
    }
    const result to = g;
    result r =
        combined(position, std::move(f), std::move(g), [&](const sum_form& a, const sum_form& b) {
          return of_e ? built_.unary(opcode::exp, b) : built_.power(a, b);
        });
    return of_e || !r ? r : noted(std::move(r), base, *to, at_.text(first, at_.last()));
  }

  /// The power; where its exponent is a fraction p/q, q odd, with a note of the real root, which is
  /// defined for x < 0 too.
  result noted(result power, std::string_view base, const item& exponent, std::string_view whole) {
    const auto c = expressions::as_constant(exponent.value);
    if (!power || !c || whole.size() > 60)
      return power;
    for (int q = 3; q <= 15; q += 2)
      for (int p = 1; p <= 4 * q; ++p) {
        const number fraction = number(static_cast<double>(p)) / number(static_cast<double>(q));
        if (p % q == 0 || fraction.lower() != c->lower() || fraction.upper() != c->upper())
          continue;
        const bool in_parentheses = base.starts_with('(') && base.ends_with(')');
        const std::string of(in_parentheses ? base.substr(1, base.size() - 2) : base);
        const std::string root =
            q == 3 ? "cbrt(" + of + ")" : "rootn(" + of + ", " + std::to_string(q) + ")";
        built_.note(power->value, std::string(whole) + " is defined for " + of + " >= 0; " + root +
                                      (p == 1 ? "" : "^" + std::to_string(p)) + "?");
        return power;
      }
    return power;
  }

  result primary() {
    last_ = ending::numeral;
    if (at_.at(mark::numeral))
      return literal();
    if (at_.at(mark::name))
      return named();
    const std::size_t position = at_.here().first;
    const bool bar = at_.at(mark::bar);
    if (!bar && !at_.at(mark::open))
      return refuse_here("a number, a name or '('");
    at_.step();
    const int bars_outside = bars_;
    bars_ = bar ? bars_ + 1 : 0;
    result f = nested(!bar);
    if (f && bar)
      f = combined(position, std::move(f), item{}, [&](const sum_form& a, const sum_form&) {
        return built_.unary(opcode::abs, a);
      });
    if (f && !at_.accept(bar ? mark::bar : mark::close))
      return refuse_here(
          ((bar ? "'|' for the '|' in column " : "')' for the '(' in column ") + column(position))
              .c_str());
    bars_ = bars_outside;
    last_ = bar ? ending::bar : ending::parenthesis;
    return f;
  }

  bool deeper() {
    if (++depth_ <= formula::most_nested)
      return true;
    refuse(at_.here().first, "nested more than " + std::to_string(formula::most_nested) + " deep");
    return false;
  }
  result nested(bool with_definitions = false) {
    if (!deeper())
      return std::nullopt;
    result f = with_definitions ? block() : disjunction();
    --depth_;
    return f;
  }

  static number literal_value(const std::string& decimal) {
    const auto value = text_to_interval("[" + decimal + "]");
    return {{value.value.lo, value.value.hi}, exact_literal(decimal)};
  }
  result literal() {
    const auto [unused, first, last] = at_.here();
    const std::string_view digits = at_.text();
    if (digits.size() > formula::longest_number)
      return refuse(first, "the number is longer than " + std::to_string(formula::longest_number) +
                               " characters");
    if (last < text_.size() && text_[last] == '.')
      return refuse(last, "a second '.' in a number");
    const bool hexadecimal = digits.size() > 1 && (digits[1] == 'x' || digits[1] == 'X');
    const bool exponent = digits.find_first_of("pP") != digits.npos;
    std::string text = "[";
    text.append(digits).append(hexadecimal && !exponent ? "p0]" : "]");
    const auto value = text_to_interval(text);
    if (value.signal == exception::undefined_operation)
      return refuse(first, "not a number");
    if (!value.value.is_common())
      return refuse(first, "the number is too large for a double");
    at_.step();
    return item{
        expressions::constant(number({value.value.lo, value.value.hi}, exact_literal(digits))),
        nullptr};
  }

  result named() {
    const std::size_t first = at_.here().first;
    const std::string name(at_.text());
    at_.step();
    last_ = ending::name;
    if (const auto own = defined_.find(name); own != defined_.end()) {
      copied_ += tape::size_of(own->second.value) + (own->second.is ? own->second.is->size : 0);
      if (copied_ > formula::most_terms)
        return refuse(first, "definitions are used with more than " +
                                 std::to_string(formula::most_terms) + " terms in all");
      return own->second;
    }
    if (const auto own = given_.find(name); own != given_.end())
      return given_value(*own->second, first);
    const built_in_name* const known = tape::find_built_in(name);
    if (known == nullptr || known->is_joint())
      return known == nullptr
                 ? refuse_unknown(first, name)
                 : refuse(first, "expected a number, a name or '(', found " + quoted(name));
    if (!known->is_function()) {
      read_.insert(std::string(known->name));
      read_.insert(name);
      return built_in_value(*known, first);
    }
    if (at_.at(mark::exponent) || at_.at(mark::power))
      return refuse(at_.here().first, "write " + name + "(x)^2 for the power of a function");
    const std::size_t open = at_.here().first;
    if (!at_.accept(mark::open))
      return refuse_here("'(' after a function's name");
    const int bars_outside = std::exchange(bars_, 0);
    std::vector<item> operands;
    std::vector<std::size_t> positions;
    std::string_view first_operand;
    do {
      positions.push_back(at_.here().first);
      result f = nested();
      if (!f)
        return std::nullopt;
      if (operands.empty())
        first_operand = at_.text(positions[0], at_.last());
      operands.push_back(*std::move(f));
    } while (at_.accept(mark::comma));
    if (at_.at(mark::equal))
      return refuse(at_.here().first, "a comparison is ==");
    if (!at_.accept(mark::close))
      return refuse_here(at_.at(mark::end) ? ("')' for the '(' in column " + column(open)).c_str()
                                           : "',' or ')'");
    bars_ = bars_outside;
    last_ = ending::parenthesis;
    if (known->what == kind::power && operands.size() == 2)
      return noted(call(*known, name, first, operands, positions), first_operand, operands[1],
                   at_.text(first, at_.last()));
    return call(*known, name, first, operands, positions);
  }

  std::nullopt_t refuse_unknown(std::size_t first, const std::string& name) {
    const std::string shown = quoted(name);
    if (name.size() <= 3 && name.find_first_not_of("xyzXYZ") == name.npos)
      return refuse(first, "unknown name " + shown + "; products need a *");
    std::vector<std::string> others;
    for (const auto& [other, unused] : defined_)
      others.push_back(other);
    for (const auto& [other, unused] : given_)
      others.push_back(other);
    if (const std::string near = tape::nearest_name(name, others); !near.empty())
      return refuse(first, "unknown name " + shown + "; " + near + "?");
    if (at_.at(mark::open))
      return refuse(first, "unknown function " + shown);
    return refuse(first, "unknown name " + shown + ": define it before the formula, as in " +
                             name.substr(0, 40) + " = 1; ..., or set it");
  }

  result built_in_value(const built_in_name& name, std::size_t position) {
    const auto axis = [&](int a) { return built_.variable(a); };
    const auto radius = [&] { return *built_.binary(opcode::hypot, axis(0), axis(1)); };
    switch (name.what) {
    case kind::coordinate:
      return item{axis(name.which), nullptr};
    // pi = 3.14159265358979323846..., e = 2.71828182845904523536..., between neighbouring doubles
    case kind::pi:
      return item{expressions::constant(number(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1)), {}};
    case kind::e:
      return item{expressions::constant(number(0x1.5bf0a8b145769p+1, 0x1.5bf0a8b14576ap+1)), {}};
    case kind::radius:
      return item{radius(), nullptr};
    case kind::distance:
      return checked(built_.binary(opcode::hypot, radius(), axis(2)), position);
    case kind::azimuth:
      return checked(built_.binary(opcode::atan2, axis(1), axis(0)), position);
    default: // the polar angle
      return checked(built_.binary(opcode::atan2, radius(), axis(2)), position);
    }
  }
  result given_value(const parameter& p, std::size_t position) {
    used_.insert(p.name);
    const auto value = parser(p.value, {}).formula();
    const auto c = value ? expressions::as_constant(*value) : std::nullopt;
    if (!c)
      return refuse(position, "the value of " + quoted(p.name) + " is no constant");
    return item{expressions::constant(*c), nullptr};
  }

  /// In floor's sense: f - g floor(f/g).
  expressions::result modulo(const sum_form& f, const sum_form& g) {
    // a quotient is tight at multiples of g, a product with a reciprocal that is rounded is not
    const auto c = expressions::as_constant(g);
    const bool excludes_zero = c && (c->lower() > 0 || c->upper() < 0);
    const bool rounds = excludes_zero && (number(1.0) / *c).lower() != (number(1.0) / *c).upper();
    const auto quotient = rounds ? built_.binary(opcode::div, f, g) : built_.div(f, g);
    const auto whole = quotient ? built_.unary(opcode::floor, *quotient) : std::nullopt;
    const auto multiple = whole ? built_.mul(g, *whole) : std::nullopt;
    return multiple ? built_.sub(f, *multiple) : std::nullopt;
  }

  result call(const built_in_name& function, const std::string& name, std::size_t first,
              std::vector<item>& operands, const std::vector<std::size_t>& positions) {
    const auto wants = [&](std::size_t least, std::size_t most, const char* count) {
      if (operands.size() >= least && operands.size() <= most)
        return true;
      refuse(first, name + " takes " + count);
      return false;
    };
    if (function.what == kind::choice) {
      if (!wants(3, 3, "three operands: a comparison and two numbers") ||
          !is_condition(positions[0], operands[0]) || !is_number(positions[1], operands[1]) ||
          !is_number(positions[2], operands[2]))
        return std::nullopt;
      return checked(tape::chosen(built_, *operands[0].is, operands[1].value, operands[2].value),
                     first);
    }
    std::vector<sum_form> f;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const bool of_solids = function.which == 1;
      if (!of_solids && !is_number(positions[i], operands[i]))
        return std::nullopt;
      if (of_solids && operands[i].is && operands[i].is->what == condition::kind::same)
        return refuse(positions[i], "f == g is no solid, which could be joined: f <= g is one");
      auto value = solid(positions[i], operands[i]);
      if (!value)
        return std::nullopt;
      f.push_back(*std::move(value));
    }
    switch (function.what) {
    case kind::unary:
      if (!wants(1, 1, "one operand"))
        return std::nullopt;
      return checked(built_.unary(function.op, f[0]), first);
    case kind::many: {
      if (!wants(2, f.size(), "two or more operands"))
        return std::nullopt;
      expressions::result r = f[0];
      for (std::size_t i = 1; r && i < f.size(); ++i)
        r = built_.binary(function.op, *r, f[i]);
      return checked(std::move(r), first);
    }
    case kind::clamp: {
      if (!wants(3, 3, "three operands: a number, the least and the greatest"))
        return std::nullopt;
      const auto r = built_.binary(opcode::max, f[0], f[1]);
      return checked(r ? built_.binary(opcode::min, *r, f[2]) : r, first);
    }
    default:
      break;
    }
    if (!wants(2, 2, "two operands"))
      return std::nullopt;
    if (function.what == kind::binary)
      return checked(built_.binary(function.op, f[0], f[1]), first);
    if (function.what == kind::modulo)
      return checked(modulo(f[0], f[1]), first);
    if (function.what == kind::difference)
      return checked(built_.binary(opcode::max, f[0], *built_.neg(f[1])), first);
    if (function.what == kind::power)
      return checked(built_.binary(opcode::pow, f[0], f[1]), first);
    const auto n = expressions::as_constant(f[1]);
    if (!n || n->lower() != n->upper() || n->lower() != std::floor(n->lower()))
      return refuse(positions[1], "expected an integer");
    const double bounded = std::clamp(n->lower(), -0x1p40, 0x1p40);
    const auto integer = static_cast<std::int64_t>(bounded);
    return checked(function.what == kind::integer_power ? built_.integer_power(f[0], integer)
                                                        : built_.root(f[0], integer),
                   first);
  }

  /// What the last power ended with: it decides what may follow without an operator.
  enum class ending : std::uint8_t { numeral, name, parenthesis, exponent, bar };

  std::string_view text_;
  tape::scanner at_;
  std::size_t depth_ = 0, position_ = 0, copied_ = 0;
  int bars_ = 0; ///< open ones since the last parenthesis
  ending last_ = ending::numeral;
  std::string reason_;
  expressions built_;
  std::map<std::string, item, std::less<>> defined_;
  std::map<std::string, const parameter*, std::less<>> given_;
  std::set<std::string> read_, used_;
};

std::string with_column(std::string_view text, std::size_t position, const std::string& why) {
  const std::size_t column = tape::count_characters(text.substr(0, position)) + 1;
  return "column " + std::to_string(column) + ": " + why;
}

} // namespace

expected<parameter> parameter::make(std::string_view name, std::string_view value,
                                    std::size_t* column) {
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  if (column != nullptr)
    *column = 0;
  const std::string shown(name.substr(0, 40));
  const tape::scanner word(name);
  if (!word.at(tape::mark::name) || word.text() != name || name.size() > longest_name)
    return unexpected{"'" + shown + "' is no name"};
  const built_in_name* const known = tape::find_built_in(name);
  if (known != nullptr && !known->may_be_defined())
    return unexpected{"'" + shown + "' has a meaning already: it cannot be set"};
  if (value.size() > formula::longest_number)
    return unexpected{"the value of '" + shown + "' is longer than " +
                      std::to_string(formula::longest_number) + " characters"};
  parser p(value, {});
  const auto f = p.formula();
  if (!f) {
    if (column != nullptr)
      *column = p.position() + 1;
    return unexpected{"the value of '" + shown +
                      "': " + with_column(value, p.position(), p.reason())};
  }
  if (!expressions::as_constant(*f))
    return unexpected{"the value of '" + shown + "' is no constant"};
  return parameter{std::string(name), std::string(value)};
}

expected<formula> formula::parse(std::string_view text, std::size_t* column,
                                 std::span<const parameter> set) {
  // A constant below the normal numbers is not 0, whatever the caller's environment is.
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  const auto refused = [&](std::size_t position, const std::string& why) {
    if (column != nullptr)
      *column = position + 1;
    return unexpected{with_column(text, position, why)};
  };
  if (text.size() > longest_text)
    return refused(longest_text,
                   "the formula is longer than " + std::to_string(longest_text) + " bytes");
  parser p(text, set);
  const auto f = p.formula();
  if (!f)
    return refused(p.position(), p.reason());
  auto program = p.built().compile(*f);
  if (!program)
    return refused(0, "the formula needs too many intermediate results at once");
  program->text = text;
  program->parameters.assign(p.parameters().begin(), p.parameters().end());
  return formula(std::make_shared<const tape::program>(*std::move(program)));
}

bool formula::uses(std::string_view name) const {
  const auto& all = program_->parameters;
  return std::find(all.begin(), all.end(), name) != all.end();
}

std::vector<std::string> formula::notes(const box& domain) const {
  std::vector<std::string> found;
  for (const tape::note& n : program_->notes) {
    // up to the power: its base on the domain
    tape::program base = *program_;
    base.code.resize(n.instruction);
    base.result = program_->code[n.instruction].a;
    const rounding::upward::scope scope;
    const auto x = intervals<rounding::upward>(domain);
    const auto value = tape::run<false>(base, x[0], x[1], x[2]).value;
    if (!(value.lower() >= 0))
      found.push_back(n.text);
  }
  return found;
}

} // namespace graze::octree
