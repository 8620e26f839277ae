#include <cmath>
#include <graze/support/text.hpp>
#include <judge/answer_text.hpp>
#include <judge/exact_cells.hpp>
#include <judge/replay.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace rational = oracle::rational;

namespace {

using json = nlohmann::ordered_json;
bool has(octant_set set, octant_number v) { return (set >> v & 1) != 0; }

/// The tightest doubles about x >= 0.
bounds enclosure(const mpq_class& x) {
  constexpr double most = std::numeric_limits<double>::max();
  if (x > mpq_class(most))
    return {most, std::numeric_limits<double>::infinity()};
  const double below = x.get_d(); // towards 0
  if (mpq_class(below) == x)
    return {below, below};
  return {below, std::nextafter(below, std::numeric_limits<double>::infinity())};
}

/// What the rational oracle says, in the place of what the campaign judges by; order and gaps need the
/// steps, which only the fast one has.
truth with_rationals(const trial& t, const truth& fast, replay_result& r) {
  truth exact = fast;
  exact.touched = exact.crossed = exact.owned = exact.soonest = exact.not_after = 0;
  const auto line = rational_line(t);
  std::array<mpq_class, 64> entry;
  std::optional<mpq_class> first, first_crossed;
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const octant_set only = octant_set{1} << v;
    const auto cell = rational_cell(t, v);
    if (!t.boxes && rational::owns(line, cell, far_faces_of(t, v)))
      exact.owned |= only;
    if (!rational::touches(line, cell))
      continue;
    exact.touched |= only;
    const auto range = rational::range_in(line, cell);
    r.passages[v] = {enclosure(range->first), enclosure(range->second)};
    entry[v] = range->first;
    if (!first || entry[v] < *first)
      first = entry[v];
    if (!rational::crosses(line, cell))
      continue;
    exact.crossed |= only;
    if (!first_crossed || entry[v] < *first_crossed) {
      first_crossed = entry[v];
      exact.first_crossed = v;
    }
  }
  for (octant_set left = exact.touched; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    exact.soonest |= octant_set{entry[v] == *first} << v;
    exact.not_after |= octant_set{!first_crossed || entry[v] <= *first_crossed} << v;
  }
  return exact;
}

json member(const bounds& b) { return {b.lo, b.hi}; }

} // namespace

replay_result replay(const trial& given, traversal& under_test) {
  visited answer;
  ask(under_test, given, answer);
  replay_result r;
  r.thrown = answer.thrown();
  r.passages.resize(64);
  const auto answered = trial_answered(given, answer);
  r.declined = !answered;
  if (r.declined)
    return r;
  const trial& t = *answered;
  r.visited = answer.set();
  const truth fast = truth_of(t);
  const truth exact = with_rationals(t, fast, r);
  r.touches = exact.touched;
  r.crosses = exact.crossed;
  r.owns = exact.owned;
  r.oracles_agree = exact.touched == fast.touched && exact.crossed == fast.crossed &&
                    exact.owned == fast.owned && exact.soonest == fast.soonest &&
                    exact.not_after == fast.not_after;
  const verdict v = judge(t, exact, answer, under_test.promises(), allowance_of(under_test));
  r.findings = v.findings;
  if (v.findings != 0)
    r.answer = answer_text(t, exact, answer, under_test.promises(), allowance_of(under_test));
  r.declined = v.declined;
  return r;
}

std::string to_json_line(const replay_case& c, const replay_result& r,
                         std::string_view traversal_name) {
  json line;
  line["line"] = c.line;
  line["traversal"] = traversal_name;
  line["touches"] = r.touches != 0;
  line["crosses"] = r.crosses != 0;
  const auto owned = [&c](bool is) { return c.at.boxes ? json() : json(is); }; // they may overlap
  line["owns"] = owned(r.owns != 0);
  line["visited"] = r.visited != 0;
  const octant_set cells = c.at.all();
  const auto passage = [&r](json& into, octant_number v) {
    const bool there = has(r.touches, v);
    into["enter"] = there ? member(r.passages[v][0]) : json();
    into["leave"] = there ? member(r.passages[v][1]) : json();
  };
  if (std::popcount(cells) == 1)
    passage(line, static_cast<octant_number>(std::countr_zero(cells)));
  line["findings"] = json::array();
  for (unsigned k = 0; k < finding_kinds; ++k)
    if ((r.findings >> k & 1) != 0)
      line["findings"].push_back(name_of(static_cast<finding>(k)));
  line["oracles_agree"] = r.oracles_agree;
  if (r.declined)
    line["declined"] = true;
  if (!r.thrown.empty())
    line["exception"] = r.thrown;
  if (std::popcount(cells) == 1)
    return support::json_line(line);
  for (octant_set left = cells; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    json cell;
    if (c.at.boxes)
      cell["box"] = v;
    else if (c.at.grid)
      cell["voxel"] = {c.at.base[0] + (v & 3u), c.at.base[1] + (v >> 2 & 3u),
                       c.at.base[2] + (v >> 4)};
    else
      cell["lo"] = hex(c.at.octant(v).lo);
    cell["touches"] = has(r.touches, v);
    cell["crosses"] = has(r.crosses, v);
    cell["owns"] = owned(has(r.owns, v));
    cell["visited"] = has(r.visited, v);
    passage(cell, v);
    line[c.at.boxes ? "boxes" : (c.at.grid ? "voxels" : "octants")].push_back(std::move(cell));
  }
  return support::json_line(line);
}

} // namespace graze::fuzz
