#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <graze/itf1788/value.hpp>

namespace graze::itf1788 {

namespace {

template <class... Visitors> struct overloaded : Visitors... {
  using Visitors::operator()...;
};

std::string text_of(double x) {
  if (std::isnan(x))
    return "NaN";
  if (std::isinf(x))
    return x < 0 ? "-infinity" : "infinity";
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(x),
                                 std::chars_format::hex);
  return (std::signbit(x) ? "-0x" : "0x") + std::string(digits.data(), end.ptr);
}

std::string text_of(const bounds& x) {
  return x.is_empty() ? "[empty]" : fmt::format("[{}, {}]", text_of(x.lo), text_of(x.hi));
}
std::string text_of(const decorated_bounds& x) {
  return x.is_nai() ? "[nai]" : fmt::format("{}_{}", text_of(x.part), name_of(x.label));
}

bool same_number(double stated, double got) {
  if (std::isnan(stated) || std::isnan(got))
    return std::isnan(stated) && std::isnan(got);
  return stated == got && std::signbit(stated) == std::signbit(got);
}

bool same_set(const bounds& x, const bounds& y) { return x.within(y) && y.within(x); }

} // namespace

std::string to_text(const value& v) {
  return std::visit(overloaded{[](const bounds& x) { return text_of(x); },
                               [](const decorated_bounds& x) { return text_of(x); },
                               [](double x) { return text_of(x); },
                               [](std::int64_t n) { return std::to_string(n); },
                               [](bool b) { return std::string(b ? "true" : "false"); },
                               [](const std::string& s) { return fmt::format("\"{}\"", s); },
                               [](decoration d) { return std::string(name_of(d)); },
                               [](const overlap_name& s) { return s.name; },
                               [](const std::vector<double>& numbers) {
                                 std::string text = "{";
                                 for (const double x : numbers)
                                   text += (text.size() == 1 ? "" : ", ") + text_of(x);
                                 return text + "}";
                               },
                               [](const other_format& x) { return x.written; }},
                    v);
}

std::string kind_of(const value& v) {
  static constexpr std::array names{
      "interval", "decorated interval", "number",        "integer", "boolean",
      "string",   "decoration",         "overlap state", "array",   "literal that is not known"};
  static_assert(names.size() == std::variant_size_v<value>);
  return names.at(v.index());
}

bool same(const value& stated, const value& got) {
  if (std::holds_alternative<std::int64_t>(stated) && std::holds_alternative<double>(got))
    return same_number(static_cast<double>(std::get<std::int64_t>(stated)), std::get<double>(got));
  if (stated.index() != got.index())
    return false;
  return std::visit(
      overloaded{[&](const bounds& x) { return same_set(x, std::get<bounds>(got)); },
                 [&](const decorated_bounds& x) {
                   const auto& y = std::get<decorated_bounds>(got);
                   return x.label == y.label && same_set(x.part, y.part);
                 },
                 [&](double x) { return same_number(x, std::get<double>(got)); },
                 [&](const overlap_name& s) { return s.name == std::get<overlap_name>(got).name; },
                 [](const other_format&) { return false; },
                 [](const std::vector<double>&) { return false; }, // no operation gives an array
                 [&]<class T>(const T& x) { return x == std::get<T>(got); }},
      stated);
}

bool within(const value& got, const value& outer) {
  if (const auto *x = std::get_if<bounds>(&got), *y = std::get_if<bounds>(&outer); x && y)
    return x->within(*y);
  const auto *x = std::get_if<decorated_bounds>(&got), *y = std::get_if<decorated_bounds>(&outer);
  return x != nullptr && y != nullptr && !x->is_nai() && !y->is_nai() && x->label <= y->label &&
         x->part.within(y->part);
}

} // namespace graze::itf1788
