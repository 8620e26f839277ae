#include "operation.hpp"
#include <graze/functions/arithmetic.hpp>
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::itf1788 {

namespace {

/// The operator f on the interval type with the backend B, which has code of its own.
template <rounding::Backend B, std::size_t N, auto f>
void add_form(std::vector<result>& all, const std::array<bounds, N>& x) {
  const auto on_intervals = [](auto... b) { return f(to_interval<policies<B>>(b)...); };
  all.push_back(
      {{to_bounds(std::apply(on_intervals, x))}, "", std::string("interval<") + B::name + ">"});
}

template <class F, std::size_t N, auto f>
std::vector<result> arithmetic(std::span<const value> operands) {
  std::vector<result> all = function<F, N>(operands);
  if (const auto bare = operands_of<bounds, N>(operands)) {
    add_form<rounding::nearest, N, f>(all, *bare);
    add_form<rounding::upward, N, f>(all, *bare);
    add_form<rounding::switching, N, f>(all, *bare);
    add_form<rounding::split, N, f>(all, *bare);
  }
  return all;
}

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
      operation{"pos", function<functions::pos, 1>},
      operation{"neg", arithmetic<functions::neg, 1, minus>},
      operation{"add", arithmetic<functions::add, 2, plus>},
      operation{"sub", arithmetic<functions::sub, 2, difference>},
      operation{"mul", arithmetic<functions::mul, 2, product>},
      operation{"div", arithmetic<functions::div, 2, quotient>},
      operation{"recip", function<functions::recip, 1>},
      operation{"sqr", arithmetic<functions::sqr, 1, square_of>},
      operation{"sqrt", arithmetic<functions::sqrt, 1, root_of>},
      operation{"fma", function<functions::fma, 3>},
      operation{"abs", arithmetic<functions::abs, 1, abs_of>},
      operation{"min", arithmetic<functions::min, 2, min_of>},
      operation{"max", arithmetic<functions::max, 2, max_of>},
      operation{"sign", function<functions::sign, 1>},
      operation{"ceil", function<functions::ceil, 1>},
      operation{"floor", function<functions::floor, 1>},
      operation{"trunc", function<functions::trunc, 1>},
      operation{"roundTiesToEven", function<functions::round_ties_to_even, 1>},
      operation{"roundTiesToAway", function<functions::round_ties_to_away, 1>},
  };
  return table;
}

} // namespace graze::itf1788
