#include "operation.hpp"
#include <graze/construct.hpp>
#include <graze/reductions.hpp>
#include <graze/text.hpp>

namespace graze::itf1788 {

namespace {

template <class T> std::vector<result> signalled(const signalling<T>& s) {
  return {result{{s.value}, name_of(s.signal)}};
}

/// A number, which may be written as an integer.
std::optional<double> number_operand(std::span<const value> operands, std::size_t i) {
  if (i >= operands.size())
    return std::nullopt;
  if (const auto* n = std::get_if<std::int64_t>(&operands[i]))
    return static_cast<double>(*n);
  const auto* x = std::get_if<double>(&operands[i]);
  return x == nullptr ? std::nullopt : std::optional(*x);
}

/// The C functions tell the exception's name, or NULL.
result from_c(const graze_interval& x, const char* signal) {
  return {{to_value(x)}, signal == nullptr ? "" : signal, "graze.h"};
}

std::vector<result> from_numbers(std::span<const value> operands) {
  const auto lower = number_operand(operands, 0), upper = number_operand(operands, 1);
  if (!lower || !upper)
    return {};
  std::vector<result> all = signalled(nums_to_interval(*lower, *upper));
  graze_interval x{};
  const bool is_interval = graze_nums_to_interval(*lower, *upper, &x);
  all.push_back(from_c(x, is_interval ? nullptr : "UndefinedOperation"));
  return all;
}
std::vector<result> decorated_from_numbers(std::span<const value> operands) {
  const auto lower = number_operand(operands, 0), upper = number_operand(operands, 1);
  return lower && upper ? signalled(nums_to_decorated(*lower, *upper)) : std::vector<result>{};
}

std::vector<result> from_text(std::span<const value> operands) {
  const auto text = operands_of<std::string, 1>(operands);
  if (!text)
    return {};
  std::vector<result> all = signalled(text_to_interval((*text)[0]));
  graze_interval x{};
  const char* const signal = graze_text_to_interval((*text)[0].c_str(), &x);
  all.push_back(from_c(x, signal));
  return all;
}
std::vector<result> decorated_from_text(std::span<const value> operands) {
  const auto text = operands_of<std::string, 1>(operands);
  return text ? signalled(text_to_decorated((*text)[0])) : std::vector<result>{};
}

std::vector<result> new_dec(std::span<const value> operands) {
  const auto x = operands_of<bounds, 1>(operands);
  return x ? single_result(graze::new_dec((*x)[0])) : std::vector<result>{};
}

std::vector<result> set_dec(std::span<const value> operands) {
  const auto x = operands_of<bounds, 1>(operands);
  const auto* d = operands.size() < 2 ? nullptr : std::get_if<decoration>(&operands[1]);
  return x && d != nullptr ? signalled(graze::set_dec((*x)[0], *d)) : std::vector<result>{};
}

std::vector<result> interval_part(std::span<const value> operands) {
  const auto x = operands_of<decorated_bounds, 1>(operands);
  return x ? signalled(graze::interval_part((*x)[0])) : std::vector<result>{};
}

std::vector<result> decoration_part(std::span<const value> operands) {
  const auto x = operands_of<decorated_bounds, 1>(operands);
  return x ? single_result(graze::decoration_part((*x)[0])) : std::vector<result>{};
}

using numbers = std::vector<double>;

constexpr int c_direction(rounded to) {
  return to == rounded::nearest ? 0 : to == rounded::up ? 1 : -1;
}

template <auto reduce, auto c, rounded to>
std::vector<result> sum_of(std::span<const value> operands) {
  const auto x = operands_of<numbers, 1>(operands);
  if (!x)
    return {};
  const numbers& all_numbers = (*x)[0];
  std::vector<result> all = single_result(reduce(all_numbers, to));
  add_form(all, c(all_numbers.data(), all_numbers.size(), c_direction(to)), "graze.h");
  return all;
}

template <rounded to> std::vector<result> dot_of(std::span<const value> operands) {
  const auto x = operands_of<numbers, 2>(operands);
  if (!x || (*x)[0].size() != (*x)[1].size())
    return {};
  const auto& [first, second] = *x;
  std::vector<result> all = single_result(dot(first, second, to));
  add_form(all, graze_dot(first.data(), second.data(), first.size(), c_direction(to)), "graze.h");
  return all;
}

} // namespace

std::span<const operation> constructor_operations() {
  static constexpr std::array table{
      operation{"b-numsToInterval", from_numbers},
      operation{"d-numsToInterval", decorated_from_numbers},
      operation{"b-textToInterval", from_text},
      operation{"d-textToInterval", decorated_from_text},
      operation{"newDec", new_dec},
      operation{"setDec", set_dec},
      operation{"intervalPart", interval_part},
      operation{"decorationPart", decoration_part},
      operation{"sum_nearest", sum_of<sum, graze_sum, rounded::nearest>},
      operation{"sum_down", sum_of<sum, graze_sum, rounded::down>},
      operation{"sum_up", sum_of<sum, graze_sum, rounded::up>},
      operation{"sum_abs_nearest", sum_of<sum_abs, graze_sum_abs, rounded::nearest>},
      operation{"sum_abs_down", sum_of<sum_abs, graze_sum_abs, rounded::down>},
      operation{"sum_abs_up", sum_of<sum_abs, graze_sum_abs, rounded::up>},
      operation{"sum_sqr_nearest", sum_of<sum_sqr, graze_sum_sqr, rounded::nearest>},
      operation{"sum_sqr_down", sum_of<sum_sqr, graze_sum_sqr, rounded::down>},
      operation{"sum_sqr_up", sum_of<sum_sqr, graze_sum_sqr, rounded::up>},
      operation{"dot_nearest", dot_of<rounded::nearest>},
      operation{"dot_down", dot_of<rounded::down>},
      operation{"dot_up", dot_of<rounded::up>},
  };
  return table;
}

} // namespace graze::itf1788
