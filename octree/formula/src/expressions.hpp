#pragma once
/// What the parser builds: sums of monomials over shared nodes, simplified as they are made.
///
/// A rewriting is allowed only if it leaves f the same function: the same real values, defined at
/// the same points. So nothing that may be undefined somewhere is cancelled or multiplied by 0
/// away, and no quotient is reduced.
#include "exact_number.hpp"

#include <compare>
#include <graze/octree_formula/tape.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace graze::octree::tape {

using node = std::uint32_t;

/// base^exponent, exponent > 0.
struct factor {
  node base;
  std::int32_t exponent;
  friend auto operator<=>(const factor&, const factor&) = default;
};
/// A product of powers, ascending by base; empty for 1.
using monomial = std::vector<factor>;
/// The sum of coefficient * monomial; a coefficient is bounded, and is never 0 for sure but where the
/// monomial may be undefined. Empty for 0.
using sum_form = std::map<monomial, number>;

class expressions {
public:
  /// Largest exponent; also of the product of two powers.
  static constexpr std::int32_t most_exponent = 1 << 30;

  expressions();

  [[nodiscard]] sum_form variable(int axis) const;
  [[nodiscard]] static sum_form constant(const number& value);
  /// The number, where it is no more than that.
  [[nodiscard]] static std::optional<number> as_constant(const sum_form& f);

  // Each gives nothing where it is refused; reason() says why.
  using result = std::optional<sum_form>;
  result add(sum_form f, const sum_form& g);
  result sub(sum_form f, const sum_form& g);
  result mul(sum_form f, sum_form g);
  result div(const sum_form& f, const sum_form& g);
  result neg(sum_form f);
  result power(const sum_form& f, const sum_form& g);
  result integer_power(const sum_form& f, std::int64_t n);
  result root(const sum_form& f, std::int64_t n);
  result unary(opcode op, const sum_form& f);
  result binary(opcode op, const sum_form& f, const sum_form& g);
  /// if_positive where f > 0, if_not where f <= 0.
  result select(const sum_form& f, const sum_form& if_positive, const sum_form& if_not);
  /// The same function, as one node: no sum to be copied.
  [[nodiscard]] sum_form shared(const sum_form& f) { return as_constant(f) ? f : of_node(emit(f)); }
  /// A note on the operation that f is, if it is one.
  void note(const sum_form& f, std::string text) {
    if (f.size() == 1 && f.begin()->first.size() == 1)
      notes_.try_emplace(f.begin()->first[0].base, std::move(text));
  }
  /// Nothing, for a reason.
  result refuse(const char* why);
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// The tape of f. Nothing if it needs too many registers.
  std::optional<program> compile(const sum_form& f);

private:
  struct operation {
    opcode op;
    node a = 0, b = 0;
    std::int32_t n = 0;
    friend auto operator<=>(const operation&, const operation&) = default;
  };
  struct univariate;
  struct operand_list;

  result scaled(sum_form f, const number& factor);
  void accumulate(sum_form& f, const monomial& m, const number& coefficient) const;
  [[nodiscard]] bool continuous(const monomial& m) const;
  [[nodiscard]] static sum_form of_node(node n) { return {{{{n, 1}}, number(1.0)}}; }

  node intern(opcode op, node a = 0, node b = 0, std::int32_t n = 0);
  std::int32_t constant_index(const number& value);
  void add_constant(const number& value);
  node constant_node(const number& value) {
    return intern(opcode::constant, 0, 0, constant_index(value));
  }
  node product_with(node n, const number& coefficient);
  node power_node(node base, std::int32_t exponent);
  node monomial_node(const monomial& m);
  /// f as one node.
  node emit(const sum_form& f);
  node emit(const univariate& p, number& constant_part);
  std::optional<node> polynomial_node(const std::vector<number>& coefficients, node at);
  std::uint32_t store(const std::vector<number>& coefficients, std::uint32_t derivative);

  std::vector<operation> nodes_;
  std::vector<bool> continuous_; ///< the node, with all that it is made of, is so everywhere
  std::map<operation, node> known_;
  /// By their bounds, and by what they are between these: 0 / 0 where that is not known.
  std::map<std::tuple<std::uint64_t, std::uint64_t, integer, integer>, std::int32_t>
      known_constants_;
  /// By the base and the constants' indices.
  std::map<std::pair<node, std::vector<std::int32_t>>, node> known_polynomials_;
  std::map<node, std::string> notes_;
  program program_;
  std::vector<number> constants_; ///< the program's
  int polynomials_left_ = 64; ///< for which turns are still looked for: it takes up to 10 ms each
  std::string reason_;
};

/// The turns of a polynomial, the highest coefficient first, its derivative given likewise; see
/// tape::turn. Nothing if the derivative's leading coefficient may be 0 or they are out of range.
std::optional<std::vector<turn>> turns_of(const std::vector<number>& polynomial,
                                          const std::vector<number>& derivative);

} // namespace graze::octree::tape
