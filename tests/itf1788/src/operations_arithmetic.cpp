#include "operation.hpp"
#include <fmt/format.h>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::itf1788 {

namespace {

/// The operator f on the interval type with the backend B, which has code of its own.
template <rounding::Backend B, auto f>
void add_operator(std::vector<result>& all, const auto& operands) {
  std::apply(
      [&](auto... x) {
        const std::string form = fmt::format("an operator of interval<{}>", B::name);
        add_form(all, to_value(f(to_interval<policies<B>>(x)...)), form.c_str());
      },
      operands);
}

template <class F, std::size_t N, auto f, auto c, auto symbol>
std::vector<result> arithmetic(std::span<const value> operands) {
  std::vector<result> all = function<F, N, f, c>(operands);
  if (const auto bare = operands_of<bounds, N>(operands)) {
    add_operator<rounding::nearest, symbol>(all, *bare);
    add_operator<rounding::upward, symbol>(all, *bare);
    add_operator<rounding::switching, symbol>(all, *bare);
    add_operator<rounding::split, symbol>(all, *bare);
  } else if (const auto marked = operands_of<decorated_bounds, N>(operands)) {
    std::apply(
        [&](auto... x) {
          add_form(all, to_value(symbol(decorated<>(x)...)), "an operator of decorated<>");
        },
        *marked);
  }
  return all;
}

#define GRAZE_ARITHMETIC_OPERATION(itl, name, N, symbol)                                           \
  operation { itl, arithmetic<functions::name, N, GRAZE_OVERLOADS(name), graze_##name, symbol> }

constexpr auto minus = [](const auto& x) { return -x; };
constexpr auto plus = [](const auto& x, const auto& y) { return x + y; };
constexpr auto difference = [](const auto& x, const auto& y) { return x - y; };
constexpr auto product = [](const auto& x, const auto& y) { return x * y; };
constexpr auto quotient = [](const auto& x, const auto& y) { return x / y; };
constexpr auto square_of = [](const auto& x) { return graze::sqr(x); };
constexpr auto root_of = [](const auto& x) { return graze::sqrt(x); };
constexpr auto abs_of = [](const auto& x) { return graze::abs(x); };
constexpr auto min_of = [](const auto& x, const auto& y) { return graze::min(x, y); };
constexpr auto max_of = [](const auto& x, const auto& y) { return graze::max(x, y); };

} // namespace

std::span<const operation> arithmetic_operations() {
  static constexpr std::array table{
      GRAZE_OPERATION("pos", pos, 1),
      GRAZE_ARITHMETIC_OPERATION("neg", neg, 1, minus),
      GRAZE_ARITHMETIC_OPERATION("add", add, 2, plus),
      GRAZE_ARITHMETIC_OPERATION("sub", sub, 2, difference),
      GRAZE_ARITHMETIC_OPERATION("mul", mul, 2, product),
      GRAZE_ARITHMETIC_OPERATION("div", div, 2, quotient),
      GRAZE_OPERATION("recip", recip, 1),
      GRAZE_ARITHMETIC_OPERATION("sqr", sqr, 1, square_of),
      GRAZE_ARITHMETIC_OPERATION("sqrt", sqrt, 1, root_of),
      GRAZE_OPERATION("fma", fma, 3),
      GRAZE_ARITHMETIC_OPERATION("abs", abs, 1, abs_of),
      GRAZE_ARITHMETIC_OPERATION("min", min, 2, min_of),
      GRAZE_ARITHMETIC_OPERATION("max", max, 2, max_of),
      GRAZE_OPERATION("sign", sign, 1),
      GRAZE_OPERATION("ceil", ceil, 1),
      GRAZE_OPERATION("floor", floor, 1),
      GRAZE_OPERATION("trunc", trunc, 1),
      GRAZE_OPERATION("roundTiesToEven", round_ties_to_even, 1),
      GRAZE_OPERATION("roundTiesToAway", round_ties_to_away, 1),
  };
  return table;
}

} // namespace graze::itf1788
