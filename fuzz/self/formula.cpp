/// The subject `formula`: text formulas, damaged ones, and their values by MPFR.
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <graze/octree_formula.hpp>
#include <graze/oracle/formula_tree.hpp>
#include <graze/rounding/nearest.hpp>
#include <self/formula.hpp>

#include <self/damage.hpp>

namespace graze::fuzz::self {

namespace {

using oracle::random_bits, oracle::real, oracle::tree;
using anywhere = interval<rounding::nearest>;

std::shared_ptr<tree> some_formula(random_bits& random) {
  return oracle::some_tree(random, 1 + static_cast<int>(random() % 5), random() % 3 == 0);
}

/// A refusal names a column of the text, in bytes and, no larger, in characters.
void check_refusal(const std::string& text, const std::string& reason, std::size_t column,
                   observations& out) {
  std::size_t characters = 0;
  if (std::sscanf(reason.c_str(), "column %zu: ", &characters) != 1 || characters < 1 ||
      characters > column || column > text.size() + 1)
    out.push_back({flaw::no_reason, fmt::format("refused at column {} of {}: {} (the text: {})",
                                                column, text.size(), reason, text)});
}

/// Any text is a formula, or refused where it goes wrong.
void text(std::uint64_t seed, std::uint64_t index, observations& out) {
  random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
  std::string written = some_formula(random)->text;
  damaged(written, some_formula(random)->text, random);
  std::size_t column = 0;
  const auto f = octree::formula::parse(written, &column);
  if (!f) {
    check_refusal(written, f.reason(), column, out);
    return;
  }
  // blanks around it change nothing
  const auto again = octree::formula::parse(" " + written + " ");
  const anywhere x(0.5, 0.75), y(-1.0, 0.25), z(2.0);
  const auto value = [&](const octree::formula& form) { return form.surface()(x, y, z); };
  if (!again || value(*f).lower() != value(*again).lower() ||
      value(*f).upper() != value(*again).upper())
    out.push_back({flaw::difference, "another formula with blanks around it: " + written});
}

/// One coordinate of a box, and three points of it.
struct side {
  anywhere bounds;
  std::array<double, 3> points;
};
side some_side(random_bits& random) {
  static constexpr std::array<double, 9> places{0, 1, -1, 0.5, -0.5, 2, 1.5, -2, 3};
  const double at = random() % 3 == 0 ? places[random() % places.size()]
                                      : std::ldexp(static_cast<double>(random() % 5000), -10) - 2.5;
  const double length = random() % 8 == 0 ? 0 : std::ldexp(1.0, -static_cast<int>(random() % 45));
  const double lo = at - (random() % 2 == 0 ? length : 0), hi = at + length;
  return {anywhere(lo, hi), {lo, hi, std::clamp(lo / 2 + hi / 2, lo, hi)}};
}

/// The enclosure over a box holds MPFR's values at points of it.
void values(const changed_enclosure& changed, std::uint64_t seed, std::uint64_t index,
            observations& out) {
  random_bits random(oracle::mix(seed) ^ oracle::mix(~index));
  const auto known = some_formula(random);
  std::size_t column = 0;
  const auto f = octree::formula::parse(known->text, &column);
  if (!f) { // a part that is constant may be undefined, or too large
    check_refusal(known->text, f.reason(), column, out);
    return;
  }
  const std::array<side, 3> box{some_side(random), some_side(random), some_side(random)};
  const anywhere value = f->surface()(box[0].bounds, box[1].bounds, box[2].bounds);
  bounds enclosure{value.lower(), value.upper()};
  if (changed)
    enclosure = changed(enclosure);
  tree::greatest = real("1e60"); // 600 bits then leave an error far below the slack
  for (int k = 0; k < 4; ++k) {
    std::array<double, 3> p{};
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = box[a].points[random() % 3];
    tree::gave_up = false;
    const auto exact = (*known)({real(p[0]), real(p[1]), real(p[2])});
    if (!exact)
      continue;
    const real slack = real("1e-100") * (1 + abs(*exact));
    if (real(enclosure.lo) > *exact + slack || *exact - slack > real(enclosure.hi))
      out.push_back(
          {flaw::unsound, fmt::format("{} at {:a} {:a} {:a} is not in [{:a}, {:a}]", known->text,
                                      p[0], p[1], p[2], enclosure.lo, enclosure.hi)});
  }
}

} // namespace

subject formula_subject(const changed_enclosure& changed) {
  return {"formula",
          "Formulas as text, damaged ones too, and their values against MPFR",
          {part{"text", text},
           part{"values", [changed](std::uint64_t seed, std::uint64_t index, observations& out) {
                  values(changed, seed, index, out);
                }}}};
}

} // namespace graze::fuzz::self
