#include <graze/oracle/rational.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;
bool has(octant_set set, octant_number v) { return (set >> v & 1) != 0; }

} // namespace

replay_result replay(const trial& given, traversal& under_test) {
  visited answer;
  ask(under_test, given, answer);
  replay_result r;
  r.thrown = answer.thrown();
  const auto answered = trial_answered(given, answer);
  r.declined = !answered;
  if (r.declined)
    return r;
  const trial& t = *answered;
  r.visited = answer.set();
  const unsigned far_faces = t.at_far_face();
  for (octant_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const cube box = t.octant(v);
    const oracle::point hi{box.hi(0), box.hi(1), box.hi(2)};
    const octant_set only = octant_set{1} << v;
    unsigned closed = 0; // the faces of this octant that are the root's far faces
    for (unsigned a = 0; a < 3; ++a)
      if ((far_faces >> a & 1) != 0 && (v >> (2 * a) & 3) + 1u == t.extent[a])
        closed |= 1u << a;
    if (oracle::rational::touches(t.origin, t.direction, box.lo, hi))
      r.touches |= only;
    if (oracle::rational::crosses(t.origin, t.direction, box.lo, hi))
      r.crosses |= only;
    if (oracle::rational::owns(t.origin, t.direction, box.lo, hi, closed))
      r.owns |= only;
  }
  // order and gaps need the steps, which are only told by the fast oracle
  truth exact = truth_of(t);
  r.oracles_agree =
      exact.touched == r.touches && exact.crossed == r.crosses && exact.owned == r.owns;
  exact.touched = r.touches;
  exact.crossed = r.crosses;
  exact.owned = r.owns;
  r.findings = judge(t, exact, answer, under_test.promises()).findings;
  return r;
}

std::string to_json_line(const replay_case& c, const replay_result& r,
                         std::string_view traversal_name) {
  json line;
  line["line"] = c.line;
  line["traversal"] = traversal_name;
  line["touches"] = r.touches != 0;
  line["crosses"] = r.crosses != 0;
  line["owns"] = r.owns != 0;
  line["visited"] = r.visited != 0;
  line["findings"] = json::array();
  for (unsigned k = 0; k < finding_kinds; ++k)
    if ((r.findings >> k & 1) != 0)
      line["findings"].push_back(name_of(static_cast<finding>(k)));
  line["oracles_agree"] = r.oracles_agree;
  if (r.declined)
    line["declined"] = true;
  if (!r.thrown.empty())
    line["exception"] = r.thrown;
  if (std::popcount(c.at.all()) > 1)
    for (octant_set left = c.at.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<octant_number>(std::countr_zero(left));
      line["octants"].push_back({{"lo", hex(c.at.octant(v).lo)},
                                 {"touches", has(r.touches, v)},
                                 {"crosses", has(r.crosses, v)},
                                 {"owns", has(r.owns, v)},
                                 {"visited", has(r.visited, v)}});
    }
  return support::json_line(line);
}

} // namespace graze::fuzz
