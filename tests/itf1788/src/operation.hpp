#pragma once
/// How the tables of operations are made.
#include <array>
#include <graze/functions/apply.hpp>
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
inline std::vector<result> one(value v) { return {result{{std::move(v)}}}; }

/// F of N intervals.
template <class F, std::size_t N> std::vector<result> function(std::span<const value> operands) {
  if (const auto bare = operands_of<bounds, N>(operands))
    return one(std::apply([](auto... x) { return F::value(x...); }, *bare));
  if (const auto decorated = operands_of<decorated_bounds, N>(operands))
    return one(std::apply([](auto... x) { return apply_decorated<F>(x...); }, *decorated));
  return {};
}

/// F of N intervals and an integer.
template <class F, std::size_t N>
std::vector<result> function_with_integer(std::span<const value> operands) {
  const auto n = int_operand(operands, N);
  if (!n)
    return {};
  if (const auto bare = operands_of<bounds, N>(operands))
    return one(std::apply([n](auto... x) { return F::value(x..., *n); }, *bare));
  if (const auto decorated = operands_of<decorated_bounds, N>(operands))
    return one(std::apply([n](auto... x) { return apply_decorated<F>(x..., *n); }, *decorated));
  return {};
}

/// A comparison or a number of N intervals: `f` takes bounds and decorated bounds.
template <std::size_t N, auto f> std::vector<result> query(std::span<const value> operands) {
  if (const auto bare = operands_of<bounds, N>(operands))
    return one(std::apply(f, *bare));
  if (const auto decorated = operands_of<decorated_bounds, N>(operands))
    return one(std::apply(f, *decorated));
  return {};
}

} // namespace graze::itf1788
