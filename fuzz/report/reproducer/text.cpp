#include <fmt/format.h>
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

std::string reproducer_text(const reproduction& r) {
  const trial& t = r.answered;
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
            fmt::format("claim      {}\n", claim_of(r.kind, r.promises));
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
