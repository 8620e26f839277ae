#include <fmt/format.h>
#include <judge/answer_text.hpp>
#include <nlohmann/json.hpp>
#include <report/reproducer/passage.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

std::string reproducer_json(const reproduction& r) {
  nlohmann::ordered_json line;
  line["name"] = reproducer_name(r);
  line["finding"] = name_of(r.kind);
  line["missed_by"] = r.traversal;
  line.update(nlohmann::ordered_json::parse(to_json_line(r.at)));
  return line.dump() + "\n";
}

namespace {

std::string spelled(const octree::box& b) {
  return fmt::format("{} to {}", graze::fuzz::spelled(b.lo), graze::fuzz::spelled(b.hi));
}

std::string answer_line(const reproduction& r) {
  return r.judged.answer.empty() || !r.judged.thrown.empty()
             ? std::string()
             : fmt::format("answer     {}\n", r.judged.answer);
}

/// A finding in a grid, among boxes, or on a segment.
std::string scene_text(const reproduction& r) {
  std::string text =
      fmt::format("{} by {}\n", name_of(r.kind), r.traversal) + scene_lines(r.answered, "");
  if (r.answered != r.at)
    text += "given\n" + scene_lines(r.at, "  ");
  text += fmt::format("what       {}\n", sentence_of(r.kind));
  if (!r.judged.thrown.empty())
    text += fmt::format("exception  {}\n", r.judged.thrown);
  text += answer_line(r);
  for (octant_set left = r.answered.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const auto has = [v](octant_set set) { return (set >> v & 1) != 0; };
    if (!has(r.judged.touches) && !has(r.judged.visited))
      continue;
    text += fmt::format("{:<11}{}: {}: {}, {}\n", r.answered.boxes ? "box" : "cell",
                        cell_name(r.answered, v), spelled(r.answered.cell(v)),
                        has(r.judged.crosses)   ? "crossed"
                        : has(r.judged.touches) ? "touched"
                                                : "not touched",
                        has(r.judged.visited) ? "reported" : "not reported");
  }
  if (!is_fault(r.kind))
    text += fmt::format("judged by  rationals (GMP){}\n",
                        r.judged.oracles_agree ? ", and the filtered exact oracle agrees"
                                               : "; THE FILTERED ORACLE DISAGREES: a bug of graze");
  return text +
         fmt::format("replay     graze-fuzz replay {}.json {}\n", reproducer_name(r), r.options);
}

} // namespace

std::string scene_lines(const trial& t, std::string_view indent) {
  std::string text =
      fmt::format("{}origin     {}\n", indent, graze::fuzz::spelled(t.origin)) +
      (t.end ? fmt::format("{}end        {}\n", indent, graze::fuzz::spelled(*t.end))
             : fmt::format("{}direction  {}\n", indent, graze::fuzz::spelled(t.direction)));
  if (t.boxes) {
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(t.boxes->size(), most); ++i)
      text += fmt::format("{}box        {}\n", indent, spelled((*t.boxes)[i]));
    if (t.boxes->size() > most)
      text += fmt::format("{}... {} more\n", indent, t.boxes->size() - most);
    return text;
  }
  if (t.grid && t.grid->rule == plane_rule::given)
    text += fmt::format("{}grid       {} x {} x {} voxels, planes given\n", indent,
                        t.grid->count[0], t.grid->count[1], t.grid->count[2]);
  else if (t.grid)
    text += fmt::format("{}grid       {} x {} x {} voxels from {}, spacing {}, planes {}\n", indent,
                        t.grid->count[0], t.grid->count[1], t.grid->count[2],
                        graze::fuzz::spelled(t.grid->origin), graze::fuzz::spelled(t.grid->spacing),
                        name_of(t.grid->rule));
  text +=
      fmt::format("{}{}[{}, {}, {}]{}", indent, t.grid ? "voxel      " : "octant     ", t.base[0],
                  t.base[1], t.base[2], t.grid ? "" : fmt::format(" of level {}", t.level));
  if (const int cells = std::popcount(t.all()); t.extent != std::array<std::uint8_t, 3>{1, 1, 1})
    text += fmt::format(", the first of {} x {} x {}{}", t.extent[0], t.extent[1], t.extent[2],
                        t.map ? fmt::format(", {} of them occupied", cells) : "");
  const octree::box first = t.cell(0);
  return text + fmt::format(": {}\n", spelled(first));
}

std::string reproducer_text(const reproduction& r) {
  const trial& t = r.answered;
  if (t.end || t.cells() != cell_kind::cube)
    return scene_text(r);
  const cube box = r.octant();
  const passage p = passage_of(t, box);
  std::string text = fmt::format("{} by {}\n", name_of(r.kind), r.traversal);
  text += fmt::format("root       {} size {}, level {}\n", spelled(t.root.lo), hex(t.root.size),
                      t.level);
  text += fmt::format("origin     {}\ndirection  {}\n", spelled(t.origin), spelled(t.direction));
  if (r.answered != r.at)
    text += fmt::format("given      {}\ntowards    {}\n", spelled(r.at.origin),
                        spelled(r.at.direction));
  if (is_fault(r.kind)) // whatever the octants
    text += fmt::format("block      {} x {} x {} octants of size {} from {}\nwhat       {}\n",
                        t.extent[0], t.extent[1], t.extent[2], hex(box.size),
                        spelled(t.octant(0).lo), sentence_of(r.kind));
  else
    text += fmt::format("octant     {} size {}: {}\n", spelled(box.lo), hex(box.size),
                        fault_of(r.kind)) +
            (std::popcount(t.all()) > 1
                 ? fmt::format("block      {} x {} x {} octants from {}\n", t.extent[0],
                               t.extent[1], t.extent[2], spelled(t.octant(0).lo))
                 : std::string()) +
            fmt::format("claim      {}\n", claim_of(r.kind, r.promises)) + answer_line(r);
  if (!r.judged.thrown.empty())
    text += fmt::format("exception  {}\n", r.judged.thrown);
  if (!is_fault(r.kind)) {
    if (p.range)
      text += fmt::format("passage    t from {} to {}, {:.6g} of the octant's size\n",
                          spelled(p.range->first), spelled(p.range->second), p.chord(t));
    text +=
        fmt::format("margin     its line passes the edge {} = {}, {} = {} at {:.6g} ({:.6g} ulps "
                    "of {})\n",
                    "xyz"[p.along], hex(p.corner[p.along]), "xyz"[p.across],
                    hex(p.corner[p.across]), p.distance.get_d(), p.distance_in_ulps(), hex(p.ulp));
    text += fmt::format("judged by  rationals (GMP){}\n",
                        r.judged.oracles_agree ? ", and the filtered exact oracle agrees"
                                               : "; THE FILTERED ORACLE DISAGREES: a bug of graze");
  }
  text += fmt::format("replay     graze-fuzz replay {}.json {}\n", reproducer_name(r), r.options);
  return text;
}

} // namespace graze::fuzz
