#include "names.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace graze::octree::tape {
namespace {

using kind = built_in_name::kind;

constexpr built_in_name names[] = {
    {"x", kind::coordinate, opcode::variable, 0},
    {"y", kind::coordinate, opcode::variable, 1},
    {"z", kind::coordinate, opcode::variable, 2},
    {"pi", kind::pi},
    {"\u03c0", kind::pi},
    {"e", kind::e},
    {"r", kind::radius},
    {"rho", kind::distance},
    {"\u03c1", kind::distance},
    {"theta", kind::azimuth},
    {"\u03b8", kind::azimuth},
    {"phi", kind::polar_angle},
    {"\u03c6", kind::polar_angle},
    {"\u03d5", kind::polar_angle},
#define GRAZE_TAPE_NAME(name) {#name, kind::unary, opcode::name},
    GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_NAME)
#undef GRAZE_TAPE_NAME
        {"sqr", kind::unary, opcode::sqr},
    {"sqrt", kind::unary, opcode::sqrt},
    {"abs", kind::unary, opcode::abs},
    {"ln", kind::unary, opcode::log},
    {"log1p", kind::unary, opcode::logp1},
    {"hypot", kind::binary, opcode::hypot},
    {"atan2", kind::binary, opcode::atan2},
    {"min", kind::many, opcode::min},
    {"max", kind::many, opcode::max},
    {"union", kind::many, opcode::min, 1}, // of solids
    {"intersection", kind::many, opcode::max, 1},
    {"difference", kind::difference, opcode::max, 1},
    {"clamp", kind::clamp},
    {"mod", kind::modulo},
    {"if", kind::choice},
    {"pow", kind::power, opcode::pow},
    {"pown", kind::integer_power},
    {"rootn", kind::root},
    {"and", kind::conjunction},
    {"or", kind::disjunction},
    {"not", kind::negation},
};

/// What is not near in letters.
constexpr std::pair<std::string_view, std::string_view> other_spellings[] = {
    {"arcsin", "asin"},  {"arccos", "acos"},  {"arctan", "atan"},  {"arctg", "atan"},
    {"tg", "tan"},       {"ctg", "cot"},      {"cosec", "csc"},    {"sgn", "sign"},
    {"signum", "sign"},  {"fmod", "mod"},     {"power", "pow"},    {"root", "rootn"},
    {"arsinh", "asinh"}, {"arcosh", "acosh"}, {"artanh", "atanh"}, {"fabs", "abs"},
    {"length", "hypot"}};

std::string lower_case(std::string_view name) {
  std::string r(name);
  for (char& c : r)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return r;
}

/// Letters to be put in, left out or changed (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

} // namespace

const built_in_name* find_built_in(std::string_view name) {
  if (name.size() > 16)
    return nullptr;
  const std::string lower = lower_case(name);
  const auto at = std::find_if(std::begin(names), std::end(names),
                               [&](const built_in_name& n) { return n.name == lower; });
  if (at == std::end(names))
    return nullptr;
  // R, PHI and E are people's own
  const bool own = at->what == kind::e || at->what == kind::radius || at->what == kind::distance ||
                   at->what == kind::azimuth || at->what == kind::polar_angle;
  return own && at->name != name ? nullptr : at;
}

std::string nearest_name(std::string_view name, std::span<const std::string> others) {
  if (name.size() < 2 || name.size() > 16)
    return "";
  const std::string lower = lower_case(name);
  for (const auto& [spelling, known] : other_spellings)
    if (spelling == lower)
      return std::string(known);
  std::string nearest;
  std::size_t least = name.size() <= 4 ? 1 : 2;
  const auto look = [&](std::string_view known) {
    if (known.size() < 2 || known.size() > 16)
      return;
    const std::size_t d = distance(lower, lower_case(known));
    if (d < least || (d == least && nearest.empty())) {
      least = d;
      nearest = known;
    }
  };
  for (const std::string& other : others)
    look(other);
  for (const built_in_name& n : names)
    look(n.name);
  return nearest;
}

} // namespace graze::octree::tape
