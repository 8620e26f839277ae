// Sums of monomials over shared nodes: how they are made, and how they become nodes.
#include "expressions.hpp"

#include "exact_polynomial.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <graze/octree_formula/continuity.hpp>
#include <numeric>

namespace graze::octree::tape {
namespace {

using interval = number::interval;
using o = operations<interval>;

bool is_exact(const number& x) { return x.lower() == x.upper(); }
bool is_exactly(const number& x, double value) { return x.lower() == value && x.upper() == value; }
bool is_bounded(const number& x) { return to_bounds(x.enclosure()).is_common(); }
bool is_empty(const number& x) { return to_bounds(x.enclosure()).is_empty(); }
bool is_continuous_at(opcode op, const number& x, const number& y, std::int32_t n) {
  return continuous_everywhere(op, n) ||
         continuous_on(op, to_bounds(x.enclosure()), to_bounds(y.enclosure()), n);
}
bool excludes_zero(const number& x) { return x.lower() > 0 || x.upper() < 0; }

/// Its enclosure is graze::pown's; known where that needs few bits.
number power_of(const number& x, std::int32_t n) {
  const number rounded(o::pown(x.enclosure(), n));
  const auto exact = x.exact();
  if (rounded.is_known() || !exact || (n < 0 && exact->is_zero()))
    return rounded;
  const auto size = static_cast<std::uint64_t>(std::abs(n));
  const integer above = numerator_of(*exact), below = denominator_of(*exact);
  if (std::max(bits_of(above), bits_of(below)) * size > number::most_bits)
    return rounded;
  const auto exponent = static_cast<unsigned>(size);
  const rational power(pow(above, exponent), pow(below, exponent));
  return number(n < 0 ? rational(1 / power) : power);
}

std::optional<number> folded(opcode op, const number& x, const number& y) {
  const interval &a = x.enclosure(), &b = y.enclosure();
  switch (op) {
  case opcode::recip:
    return number(1.0) / x;
  case opcode::div:
    return x / y;
  case opcode::sqr:
    return power_of(x, 2);
  case opcode::sqrt:
    return number(o::sqrt(a));
  case opcode::abs:
    return x.lower() >= 0 ? x : x.upper() <= 0 ? -x : number(o::abs(a));
  case opcode::min:
    return number(o::min(a, b));
  case opcode::max:
    return number(o::max(a, b));
  case opcode::pow:
    return number(o::pow(a, b));
  case opcode::hypot:
    return number(o::hypot(a, b));
  case opcode::atan2:
    return number(o::atan2(a, b));
#define GRAZE_TAPE_FOLD(name)                                                                      \
  case opcode::name:                                                                               \
    return number(o::name(a));
    GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_FOLD)
#undef GRAZE_TAPE_FOLD
  default:
    return std::nullopt;
  }
}

bool is_commutative(opcode op) {
  return op == opcode::add || op == opcode::mul || op == opcode::min || op == opcode::max ||
         op == opcode::hypot;
}

} // namespace

/// The nodes that a node is made of.
struct expressions::operand_list {
  std::size_t size = 0;
  std::array<node, 3> nodes{};
  [[nodiscard]] node* begin() { return nodes.data(); }
  [[nodiscard]] node* end() { return nodes.data() + size; }
  [[nodiscard]] const node* begin() const { return nodes.data(); }
  [[nodiscard]] const node* end() const { return nodes.data() + size; }
};

/// The terms of a sum over one base: ascending exponents and their coefficients.
struct expressions::univariate {
  node base;
  std::vector<std::pair<std::int32_t, number>> terms;
};

expressions::expressions() {
  for (int axis = 0; axis < 3; ++axis)
    intern(opcode::variable, 0, 0, axis);
}

sum_form expressions::variable(int axis) const { return of_node(static_cast<node>(axis)); }

sum_form expressions::constant(const number& value) {
  if (is_exactly(value, 0))
    return {};
  return {{{}, value}};
}

std::optional<number> expressions::as_constant(const sum_form& f) {
  if (f.empty())
    return number(0.0);
  if (f.size() == 1 && f.begin()->first.empty())
    return f.begin()->second;
  return std::nullopt;
}

expressions::result expressions::refuse(const char* why) {
  reason_ = why;
  return std::nullopt;
}

bool expressions::continuous(const monomial& m) const {
  return std::all_of(m.begin(), m.end(), [this](const factor& f) { return continuous_[f.base]; });
}

void expressions::accumulate(sum_form& f, const monomial& m, const number& coefficient) const {
  const auto [at, is_new] = f.try_emplace(m, coefficient);
  if (!is_new)
    at->second = at->second + coefficient;
  if (is_exactly(at->second, 0) && continuous(m))
    f.erase(at);
}

expressions::result expressions::add(sum_form f, const sum_form& g) {
  for (const auto& [m, coefficient] : g) {
    accumulate(f, m, coefficient);
    if (const auto at = f.find(m); at != f.end() && !is_bounded(at->second))
      return refuse("the sum of constants overflows");
  }
  return f;
}

expressions::result expressions::sub(sum_form f, const sum_form& g) {
  return add(std::move(f), *neg(g));
}

expressions::result expressions::neg(sum_form f) {
  for (auto& [m, coefficient] : f)
    coefficient = -coefficient;
  return f;
}

expressions::result expressions::scaled(sum_form f, const number& factor) {
  sum_form r;
  for (auto& [m, coefficient] : f) {
    const number product = coefficient * factor;
    if (!is_bounded(product))
      return refuse("the product of constants overflows");
    accumulate(r, m, product);
  }
  return r;
}

expressions::result expressions::mul(sum_form f, sum_form g) {
  if (const auto c = as_constant(g))
    return scaled(std::move(f), *c);
  if (const auto c = as_constant(f))
    return scaled(std::move(g), *c);
  // Two sums over the same base, of a low degree and with exact coefficients, are multiplied out:
  // a polynomial's range is found exactly, a product's is not.
  constexpr int most_degree = 4;
  std::optional<node> base;
  int degree = 0;
  bool expands = f.size() > 1 || g.size() > 1;
  for (const sum_form* s : {&f, &g}) {
    int highest = 0;
    for (const auto& [m, coefficient] : *s) {
      expands = expands && m.size() <= 1 && is_exact(coefficient);
      if (m.empty())
        continue;
      expands = expands && (!base || *base == m[0].base);
      base = m[0].base;
      highest = std::max(highest, m[0].exponent);
    }
    degree += std::min(highest, most_degree + 1);
  }
  if (expands && degree <= most_degree && f != g) {
    sum_form r;
    bool exact = true;
    for (const auto& [m, c] : f)
      for (const auto& [n, d] : g) {
        const int exponent = (m.empty() ? 0 : m[0].exponent) + (n.empty() ? 0 : n[0].exponent);
        const number product = c * d;
        accumulate(r, exponent == 0 ? monomial{} : monomial{{*base, exponent}}, product);
        exact = exact && is_exact(product) && is_bounded(product);
      }
    for (const auto& [m, c] : r)
      exact = exact && is_exact(c);
    if (exact)
      return r;
  }
  // coefficient * product of powers
  number coefficient(1.0);
  std::map<node, std::int64_t> powers;
  for (const sum_form* s : {&f, &g}) {
    if (s->size() == 1) {
      coefficient = coefficient * s->begin()->second;
      for (const factor& x : s->begin()->first)
        powers[x.base] += x.exponent;
    } else {
      powers[emit(*s)] += 1;
    }
  }
  monomial m;
  for (const auto& [b, exponent] : powers) {
    if (exponent > most_exponent)
      return refuse("the exponent is too large");
    m.push_back({b, static_cast<std::int32_t>(exponent)});
  }
  if (!is_bounded(coefficient))
    return refuse("the product of constants overflows");
  sum_form r;
  accumulate(r, m, coefficient);
  return r;
}

expressions::result expressions::div(const sum_form& f, const sum_form& g) {
  if (const auto c = as_constant(g)) {
    if (is_exactly(*c, 0))
      return refuse("division by zero");
    if (excludes_zero(*c)) {
      if (const auto d = as_constant(f))
        return binary(opcode::div, f, g);
      // f / c = (1/c) f rounds 1/c; a power of two has an exact reciprocal
      const number inverse = number(1.0) / *c;
      if (!is_bounded(inverse))
        return refuse("the reciprocal of a constant overflows");
      return scaled(f, inverse);
    }
  }
  if (const auto c = as_constant(f); c && is_exactly(*c, 1))
    return unary(opcode::recip, g);
  return binary(opcode::div, f, g);
}

expressions::result expressions::integer_power(const sum_form& f, std::int64_t n) {
  if (n > most_exponent || n < -most_exponent)
    return refuse("the exponent is too large");
  const auto exponent = static_cast<std::int32_t>(n);
  if (const auto c = as_constant(f)) {
    const number value = power_of(*c, exponent);
    if (is_empty(value))
      return refuse("0 has no negative powers");
    if (is_bounded(value) && is_continuous_at(opcode::pown, *c, *c, exponent))
      return constant(value);
    if (!is_bounded(value) && n > 0)
      return refuse("the power overflows");
    return of_node(intern(opcode::pown, emit(f), 0, exponent));
  }
  if (exponent == 1)
    return f;
  const bool single = f.size() == 1;
  if (exponent <= 0) {
    const node base = emit(f);
    if (exponent == 0 && continuous_[base])
      return constant(number(1.0));
    return of_node(exponent == -1 ? intern(opcode::recip, base)
                                  : intern(opcode::pown, base, 0, exponent));
  }
  const number coefficient = single ? power_of(f.begin()->second, exponent) : number(1.0);
  if (!is_bounded(coefficient))
    return refuse("the power of a constant overflows");
  monomial m;
  if (single) {
    m = f.begin()->first;
    for (factor& x : m) {
      if (std::int64_t{x.exponent} * exponent > most_exponent)
        return refuse("the exponent is too large");
      x.exponent *= exponent;
    }
  } else {
    m = {{emit(f), exponent}};
  }
  sum_form r;
  accumulate(r, m, coefficient);
  return r;
}

expressions::result expressions::power(const sum_form& f, const sum_form& g) {
  const auto c = as_constant(g);
  if (c && mag(c->enclosure()) > most_exponent)
    return refuse("the exponent is too large");
  if (c && is_exact(*c)) {
    const double n = c->lower();
    if (n == std::floor(n))
      return integer_power(f, static_cast<std::int64_t>(n));
    if (n == 0.5)
      return unary(opcode::sqrt, f);
  }
  return binary(opcode::pow, f, g);
}

expressions::result expressions::root(const sum_form& f, std::int64_t n) {
  if (n == 0 || n > most_exponent || n < -most_exponent)
    return refuse(n == 0 ? "there is no root of order 0" : "the order of the root is too large");
  if (n == 1)
    return f;
  if (n == 2)
    return unary(opcode::sqrt, f);
  const auto order = static_cast<std::int32_t>(n);
  if (const auto c = as_constant(f)) {
    const number value(o::rootn(c->enclosure(), order));
    if (is_empty(value))
      return refuse("the root of this constant is not defined");
    if (is_bounded(value) && is_continuous_at(opcode::rootn, *c, *c, order))
      return constant(value);
  }
  return of_node(intern(opcode::rootn, emit(f), 0, order));
}

expressions::result expressions::unary(opcode op, const sum_form& f) {
  if (const auto c = as_constant(f)) {
    const auto value = folded(op, *c, *c);
    if (!value || is_empty(*value))
      return refuse("the function is not defined at this constant");
    if (is_bounded(*value) && is_continuous_at(op, *c, *c, 0))
      return constant(*value);
    if (!is_bounded(*value) && is_exact(*c))
      return refuse("the function overflows at this constant");
  }
  if (op == opcode::sqr)
    return integer_power(f, 2);
  return of_node(intern(op, emit(f)));
}

expressions::result expressions::binary(opcode op, const sum_form& f, const sum_form& g) {
  const auto c = as_constant(f), d = as_constant(g);
  if (c && d) {
    const auto value = folded(op, *c, *d);
    if (!value || is_empty(*value))
      return refuse("the function is not defined at these constants");
    if (is_bounded(*value) && is_continuous_at(op, *c, *d, 0))
      return constant(*value);
    if (!is_bounded(*value) && is_exact(*c) && is_exact(*d))
      return refuse("the function overflows at these constants");
  }
  const node a = emit(f), b = emit(g);
  if (a == b && (op == opcode::min || op == opcode::max))
    return of_node(a);
  return of_node(intern(op, a, b));
}

/// Where p - q = c f for a constant c != 0, the choice is the greater of p and q, or the lesser:
/// that is continuous.
expressions::result expressions::select(const sum_form& f, const sum_form& if_positive,
                                        const sum_form& if_not) {
  if (const auto c = as_constant(f)) {
    if (c->lower() > 0)
      return if_positive;
    if (c->upper() <= 0)
      return if_not;
  }
  if (const auto d = sub(if_positive, if_not); d && d->size() == f.size() && !f.empty()) {
    const number c = d->begin()->second / f.begin()->second;
    const auto multiple = is_exact(c) && excludes_zero(c) ? scaled(f, c) : std::nullopt;
    const auto is_same = [](const auto& s, const auto& t) {
      return s.first == t.first && is_exact(s.second) && is_exact(t.second) &&
             s.second.lower() == t.second.lower();
    };
    if (multiple && std::equal(d->begin(), d->end(), multiple->begin(), multiple->end(), is_same))
      return binary(c.lower() > 0 ? opcode::max : opcode::min, if_positive, if_not);
  }
  const node condition = emit(f), a = emit(if_positive), b = emit(if_not);
  if (a == b && continuous_[condition])
    return of_node(a);
  return of_node(intern(opcode::select, condition, a, static_cast<std::int32_t>(b)));
}

node expressions::intern(opcode op, node a, node b, std::int32_t n) {
  if (is_commutative(op) && b < a)
    std::swap(a, b);
  const operation key{op, a, b, n};
  const auto [at, is_new] = known_.try_emplace(key, static_cast<node>(nodes_.size()));
  if (is_new) {
    nodes_.push_back(key);
    const bool leaf = op == opcode::variable || op == opcode::constant;
    continuous_.push_back(leaf ||
                          (continuous_everywhere(op, n) && continuous_[a] && continuous_[b]));
  }
  return at->second;
}

std::int32_t expressions::constant_index(const number& value) {
  const double lo = value.lower() + 0.0, hi = value.upper() + 0.0;
  const auto exact = lo < hi ? value.exact() : std::nullopt;
  const auto [at, is_new] = known_constants_.try_emplace(
      {std::bit_cast<std::uint64_t>(lo), std::bit_cast<std::uint64_t>(hi),
       exact ? numerator_of(*exact) : integer(0), exact ? denominator_of(*exact) : integer(0)},
      static_cast<std::int32_t>(program_.constants.size()));
  if (is_new)
    add_constant(value);
  return at->second;
}

void expressions::add_constant(const number& value) {
  program_.constants.push_back({value.lower() + 0.0, value.upper() + 0.0, mid(value.enclosure())});
  constants_.push_back(value);
}

node expressions::product_with(node n, const number& coefficient) {
  if (is_exactly(coefficient, 1))
    return n;
  if (is_exactly(coefficient, -1))
    return intern(opcode::neg, n);
  return intern(opcode::mul_constant, n, 0, constant_index(coefficient));
}

node expressions::power_node(node base, std::int32_t exponent) {
  if (exponent == 1)
    return base;
  if (exponent == 2)
    return intern(opcode::sqr, base);
  if (exponent == 4)
    return intern(opcode::sqr, intern(opcode::sqr, base));
  return intern(opcode::pown, base, 0, exponent);
}

node expressions::monomial_node(const monomial& m) {
  node r = power_node(m[0].base, m[0].exponent);
  for (std::size_t i = 1; i < m.size(); ++i)
    r = intern(opcode::mul, r, power_node(m[i].base, m[i].exponent));
  return r;
}

std::uint32_t expressions::store(const std::vector<number>& coefficients,
                                 std::uint32_t derivative) {
  const auto index = static_cast<std::uint32_t>(program_.polynomials.size());
  program_.polynomials.push_back({static_cast<std::uint32_t>(program_.constants.size()),
                                  static_cast<std::uint32_t>(coefficients.size() - 1),
                                  static_cast<std::uint32_t>(program_.turns.size()), 0,
                                  derivative});
  for (const number& c : coefficients)
    add_constant(c);
  return index;
}

std::optional<node> expressions::polynomial_node(const std::vector<number>& p, node at) {
  const auto derivative_of = [](const std::vector<number>& coefficients) {
    std::vector<number> r;
    for (std::size_t i = 0; i + 1 < coefficients.size(); ++i)
      r.push_back(coefficients[i] * number(static_cast<double>(coefficients.size() - 1 - i)));
    return r;
  };
  std::pair<node, std::vector<std::int32_t>> key{at, {}};
  for (const number& c : p)
    key.second.push_back(constant_index(c));
  if (const auto known = known_polynomials_.find(key); known != known_polynomials_.end())
    return known->second;
  if (polynomials_left_ <= 0)
    return std::nullopt;
  --polynomials_left_;
  const std::vector<number> slope = derivative_of(p), curvature = derivative_of(slope);
  if (!std::all_of(slope.begin(), slope.end(), is_bounded) ||
      !std::all_of(curvature.begin(), curvature.end(), is_bounded))
    return std::nullopt;
  const auto turns = turns_of(p, slope), slope_turns = turns_of(slope, curvature);
  if (!turns || !slope_turns)
    return std::nullopt;
  const std::uint32_t of_slope = store(slope, 0);
  program_.turns.insert(program_.turns.end(), slope_turns->begin(), slope_turns->end());
  program_.polynomials[of_slope].turns = static_cast<std::uint32_t>(slope_turns->size());
  const std::uint32_t index = store(p, of_slope);
  program_.turns.insert(program_.turns.end(), turns->begin(), turns->end());
  program_.polynomials[index].turns = static_cast<std::uint32_t>(turns->size());
  return known_polynomials_[key] =
             intern(opcode::polynomial, at, 0, static_cast<std::int32_t>(index));
}

/// The sum of its terms, by the form whose range is tightest; what it has beside the node is added
/// to constant_part.
node expressions::emit(const univariate& p, number& constant_part) {
  constexpr std::int32_t most_degree = 32;
  if (p.terms.size() == 1)
    return product_with(power_node(p.base, p.terms[0].first), p.terms[0].second);
  std::int32_t divisor = 0;
  for (const auto& [exponent, coefficient] : p.terms)
    divisor = std::gcd(divisor, exponent);
  const node at = power_node(p.base, divisor);
  const std::int32_t degree = p.terms.back().first / divisor;
  std::vector<number> coefficients;
  if (degree <= most_degree) {
    coefficients.assign(static_cast<std::size_t>(degree) + 1, number(0.0));
    for (const auto& [exponent, coefficient] : p.terms)
      coefficients[static_cast<std::size_t>(degree - exponent / divisor)] = coefficient;
  }
  // a t^2 + b t = a (t + b/(2a))^2 - b^2/(4a), where that is exact
  if (degree == 2 && excludes_zero(coefficients[0])) {
    const number &a = coefficients[0], &b = coefficients[1];
    const number shift = b / (number(2.0) * a), least = b * shift / number(2.0);
    const number sum = constant_part - least;
    if (is_exact(a) && is_exact(b) && is_exact(shift) && is_exact(least) && is_bounded(sum)) {
      constant_part = sum;
      const node shifted = intern(opcode::add_constant, at, 0, constant_index(shift));
      return product_with(power_node(shifted, 2), a);
    }
  }
  if (!coefficients.empty())
    if (const auto n = polynomial_node(coefficients, at))
      return *n;
  std::optional<node> r;
  for (const auto& [exponent, coefficient] : p.terms) {
    const node term = product_with(power_node(p.base, exponent), coefficient);
    r = r ? intern(opcode::add, *r, term) : term;
  }
  return *r;
}

node expressions::emit(const sum_form& f) {
  if (const auto c = as_constant(f))
    return constant_node(*c);
  number constant_part(0.0);
  std::map<node, univariate> groups;
  std::vector<std::pair<node, bool>> terms; // and whether it is subtracted
  for (const auto& [m, coefficient] : f) {
    if (m.empty()) {
      constant_part = coefficient;
    } else if (m.size() == 1 && !is_exactly(coefficient, 0)) {
      groups.try_emplace(m[0].base, univariate{m[0].base, {}})
          .first->second.terms.emplace_back(m[0].exponent, coefficient);
    } else if (coefficient.upper() < 0) {
      terms.emplace_back(product_with(monomial_node(m), -coefficient), true);
    } else {
      terms.emplace_back(product_with(monomial_node(m), coefficient), false);
    }
  }
  std::vector<std::pair<node, bool>> first;
  for (auto& [base, p] : groups) {
    const bool negative = p.terms.back().second.upper() < 0;
    if (negative)
      for (auto& [exponent, coefficient] : p.terms)
        coefficient = -coefficient;
    number beside(0.0);
    const node n = emit(p, beside);
    constant_part = negative ? constant_part - beside : constant_part + beside;
    first.emplace_back(n, negative);
  }
  terms.insert(terms.begin(), first.begin(), first.end());
  // one that is added first, if there is one
  const auto added =
      std::find_if(terms.begin(), terms.end(), [](const auto& t) { return !t.second; });
  if (added != terms.end())
    std::rotate(terms.begin(), added, added + 1);
  node r = terms[0].second ? intern(opcode::neg, terms[0].first) : terms[0].first;
  for (std::size_t i = 1; i < terms.size(); ++i)
    r = intern(terms[i].second ? opcode::sub : opcode::add, r, terms[i].first);
  if (!is_exactly(constant_part, 0))
    r = intern(opcode::add_constant, r, 0, constant_index(constant_part));
  return r;
}

std::optional<program> expressions::compile(const sum_form& f) {
  const node root = emit(f);
  const auto operands_of = [this](node n) -> operand_list {
    const operation& x = nodes_[n];
    switch (x.op) {
    case opcode::variable:
    case opcode::constant:
      return {};
    case opcode::select:
      return {3, {x.a, x.b, static_cast<node>(x.n)}};
    case opcode::add:
    case opcode::sub:
    case opcode::mul:
    case opcode::div:
    case opcode::min:
    case opcode::max:
    case opcode::pow:
    case opcode::hypot:
    case opcode::atan2:
      return {2, {x.a, x.b}};
    default:
      return {1, {x.a}};
    }
  };

  // Registers that a node needs if it is a tree's (Sethi and Ullman): the operand that needs more
  // is first. Operands have lower numbers.
  std::vector<std::uint32_t> need(nodes_.size(), 1);
  const auto in_order = [&](operand_list all) {
    std::stable_sort(all.begin(), all.end(), [&](node s, node t) { return need[s] > need[t]; });
    return all;
  };
  for (node n = 0; n < nodes_.size(); ++n) {
    std::uint32_t kept = 0;
    for (const node operand : in_order(operands_of(n)))
      need[n] = std::max(need[n], need[operand] + kept++);
  }

  // Operands before what uses them, each as late as that allows: post-order.
  std::vector<node> order;
  std::vector<std::uint8_t> seen(nodes_.size(), 0);
  std::vector<std::uint32_t> uses(nodes_.size(), 0);
  std::vector<std::pair<node, std::size_t>> path{{root, 0}};
  seen[root] = 1;
  while (!path.empty()) {
    auto& [n, next] = path.back();
    if (const operand_list all = operands_of(n); next < all.size) {
      const node operand = in_order(all).nodes[next++];
      ++uses[operand];
      if (seen[operand] == 0) {
        seen[operand] = 1;
        path.emplace_back(operand, 0);
      }
      continue;
    }
    if (nodes_[n].op != opcode::variable)
      order.push_back(n);
    path.pop_back();
  }

  std::vector<std::uint8_t> place(nodes_.size(), 0), variables(nodes_.size(), 0);
  std::vector<bool> tight(nodes_.size(), true);
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    place[axis] = axis;
    variables[axis] = static_cast<std::uint8_t>(1u << axis);
  }
  std::vector<std::uint8_t> unused;
  for (unsigned r = program::most_registers; r > 3; --r)
    unused.push_back(static_cast<std::uint8_t>(r - 1));
  program& p = program_;
  p.continuous = continuous_[root];
  for (const node n : order) {
    const operation& x = nodes_[n];
    const operand_list operands = operands_of(n);
    bool apart = true, all_tight = x.op != opcode::select;
    for (const node operand : operands) {
      apart = apart && (variables[n] & variables[operand]) == 0;
      all_tight = all_tight && tight[operand];
      variables[n] = static_cast<std::uint8_t>(variables[n] | variables[operand]);
    }
    tight[n] = all_tight && (apart || x.op == opcode::min || x.op == opcode::max);
    const auto place_of = [&](std::size_t i) {
      return i < operands.size ? place[operands.nodes[i]] : std::uint8_t{0};
    };
    const std::uint8_t a = place_of(0), b = place_of(1);
    const std::int32_t last = operands.size == 3 ? place_of(2) : x.n;
    for (const node operand : operands)
      if (--uses[operand] == 0 && operand > 2)
        unused.push_back(place[operand]);
    if (unused.empty())
      return std::nullopt;
    place[n] = unused.back();
    unused.pop_back();
    p.registers = std::max<std::uint8_t>(p.registers, static_cast<std::uint8_t>(place[n] + 1));
    if (const auto note = notes_.find(n); note != notes_.end() && x.op == opcode::pow)
      p.notes.push_back({p.code.size(), note->second});
    p.code.push_back({x.op, place[n], a, b, last});
  }
  p.result = place[root];
  p.tight = tight[root];
  p.exact = exact_polynomial_of(p, constants_);
  return std::move(program_);
}

} // namespace graze::octree::tape
