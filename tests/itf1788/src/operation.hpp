#pragma once
/// How the tables of operations are made: each operation by its name, in every form of calling it.
#include <array>
#include <graze/decorated.hpp>
#include <graze/graze.h>
#include <graze/interval.hpp>
#include <graze/itf1788/operations.hpp>
#include <limits>
#include <optional>
#include <tuple>

namespace graze::itf1788 {

struct operation {
  std::string_view name;
  std::vector<result> (*run)(std::span<const value>);
};

// One table per family, in operations_<family>.cpp.
std::span<const operation> arithmetic_operations();
std::span<const operation> elementary_operations();
std::span<const operation> reverse_operations();
std::span<const operation> set_operations();         // sets, comparisons, numbers
std::span<const operation> constructor_operations(); // constructors, parts, text, reductions

/// The first N operands if all are a T.
template <class T, std::size_t N>
std::optional<std::array<T, N>> operands_of(std::span<const value> operands) {
  std::array<T, N> all{};
  if (operands.size() < N)
    return std::nullopt;
  for (std::size_t i = 0; i < N; ++i) {
    const T* x = std::get_if<T>(&operands[i]);
    if (x == nullptr)
      return std::nullopt;
    all[i] = *x;
  }
  return all;
}

/// The operand i if it is an integer that an int holds.
inline std::optional<int> int_operand(std::span<const value> operands, std::size_t i) {
  const auto* n = i < operands.size() ? std::get_if<std::int64_t>(&operands[i]) : nullptr;
  if (n == nullptr || *n < std::numeric_limits<int>::min() || *n > std::numeric_limits<int>::max())
    return std::nullopt;
  return static_cast<int>(*n);
}

/// The only result of an operation that has one form and signals nothing.
inline std::vector<result> single_result(value v) { return {result{{std::move(v)}}}; }
inline void add_form(std::vector<result>& all, value v, const char* form) {
  all.push_back({{std::move(v)}, "", form});
}

inline graze_interval to_c(const bounds& x) { return {x.lo, x.hi}; }
inline int to_c(int n) { return n; }

// What a form gives, as a value.
template <Policies P> value to_value(const interval_of<P>& x) { return to_bounds(x); }
inline value to_value(const decorated_bounds& x) { return x; }
inline value to_value(const graze_interval& x) { return bounds{x.inf, x.sup}; }
inline value to_value(double x) { return x; }
inline value to_value(bool b) { return b; }

/// The library's functions of a name are overloaded: one object for all of them.
#define GRAZE_OVERLOADS(name)                                                                      \
  [](const auto&... x) -> decltype(graze::name(x...)) { return graze::name(x...); }

/// The function on intervals `f`, and the C function `c`. A C function that takes one interval more
/// is a reverse operation, told that the solution may be anywhere.
template <auto f, auto c, class... Integer>
void add_bare_forms(std::vector<result>& all, const auto& operands, Integer... n) {
  std::apply(
      [&](auto... x) {
        if constexpr (std::is_invocable_v<decltype(f), decltype(interval<>(x.lo))..., Integer...>)
          add_form(all, to_value(f(to_interval<policies<rounding::nearest>>(x)..., n...)),
                   "interval<>");
        if constexpr (std::is_invocable_v<decltype(c), decltype(to_c(x))..., Integer...>)
          add_form(all, to_value(c(to_c(x)..., n...)), "graze.h");
        else
          add_form(all, to_value(c(to_c(x)..., graze_entire(), n...)), "graze.h");
      },
      operands);
}
template <auto f, class... Integer>
void add_decorated_forms(std::vector<result>& all, const auto& operands, Integer... n) {
  std::apply(
      [&](auto... x) {
        if constexpr (std::is_invocable_v<decltype(f), decltype(decorated<>(x))..., Integer...>)
          add_form(all, to_value(f(decorated<>(x)..., n...)), "decorated<>");
      },
      operands);
}

/// F of N intervals and the integers n; see add_bare_forms.
template <class F, std::size_t N, auto f, auto c, class... Integer>
std::vector<result> function_forms(std::span<const value> operands, Integer... n) {
  std::vector<result> all;
  if (const auto bare = operands_of<bounds, N>(operands)) {
    all = single_result(std::apply([n...](auto... x) { return F::value(x..., n...); }, *bare));
    add_bare_forms<f, c>(all, *bare, n...);
  } else if (const auto marked = operands_of<decorated_bounds, N>(operands)) {
    all = single_result(
        std::apply([n...](auto... x) { return apply_decorated<F>(x..., n...); }, *marked));
    add_decorated_forms<f>(all, *marked, n...);
  }
  return all;
}
template <class F, std::size_t N, auto f, auto c>
std::vector<result> function(std::span<const value> operands) {
  return function_forms<F, N, f, c>(operands);
}
template <class F, std::size_t N, auto f, auto c>
std::vector<result> function_with_integer(std::span<const value> operands) {
  const auto n = int_operand(operands, N);
  return n ? function_forms<F, N, f, c>(operands, *n) : std::vector<result>{};
}

/// The row of a table for functions::name of N intervals, called `itl` in .itl files.
#define GRAZE_OPERATION(itl, name, N)                                                              \
  operation { itl, function<functions::name, N, GRAZE_OVERLOADS(name), graze_##name> }
/// The same with an integer behind the intervals.
#define GRAZE_OPERATION_WITH_INTEGER(itl, name, N)                                                 \
  operation { itl, function_with_integer<functions::name, N, GRAZE_OVERLOADS(name), graze_##name> }

} // namespace graze::itf1788
