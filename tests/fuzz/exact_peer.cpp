/// A traversal behind the line protocol that answers every promise about all cells exactly, through
/// adapter.hpp (FORMAT plain) or in JSON: exact_peer PROMISE CELLS rays|segments FORMAT [FAULT]. A fault:
/// "late", t is off by 2^-30 of itself and more; "none", nothing is ever hit.
#include <adapters/adapter.hpp>
#include <graze/oracle/rational.hpp>
#include <iostream>
#include <judge/exact_cells.hpp>
#include <judge/first.hpp>
#include <nlohmann/json.hpp>

using namespace graze::fuzz;
using nlohmann::json;
namespace rational = graze::oracle::rational;

namespace {

struct exact_answer {
  std::vector<octant_number> list;
  std::optional<octant_number> first;
  double t = 0;
  bool hit = false;
  std::optional<std::uint64_t> count;
};

exact_answer answer_to(const trial& t, std::string_view promised, std::string_view fault) {
  const truth exact = truth_of(t);
  exact_answer a;
  if (fault != "none") {
    const octant_set listed = promised == "exactly-owned" ? exact.owned : exact.touched;
    for (unsigned i = 0; promised == "exactly-owned" && i < exact.owners; ++i)
      a.list.push_back(exact.owner_order[i]);
    for (octant_set left = promised == "exactly-owned" ? 0 : listed; left != 0; left &= left - 1)
      a.list.push_back(static_cast<octant_number>(std::countr_zero(left)));
    if (exact.soonest != 0)
      a.first = static_cast<octant_number>(std::countr_zero(exact.soonest));
    a.hit = exact.crossed != 0;
  }
  if (a.first)
    a.t = rational::range_in(rational_line(t), rational_cell(t, *a.first))->first.get_d();
  if (fault == "late")
    a.t += std::fabs(a.t) * 0x1p-30 + 0x1p-30;
  if (const auto crossings = crossings_of(t))
    a.count = crossings->number.value_or(crossings->odd ? 1 : 0);
  return a;
}

adapter::index3 place_of(const trial& t, octant_number v) {
  if (t.boxes)
    return {v, 0, 0};
  return {t.base[0] + (v & 3u), t.base[1] + (v >> 2 & 3u), t.base[2] + (v >> 4)};
}

trial trial_of(const adapter::request& r, bool segment) {
  trial t;
  for (unsigned a = 0; a < 3; ++a) {
    t.base[a] = r.base[a];
    t.extent[a] = static_cast<std::uint8_t>(std::max<std::uint64_t>(1, r.extent[a]));
  }
  if (!r.boxes.empty()) {
    std::vector<graze::octree::box> boxes;
    for (const adapter::cell& c : r.boxes)
      boxes.push_back({c.lo, c.hi});
    t.boxes = std::make_shared<const std::vector<graze::octree::box>>(boxes);
  } else if (!r.planes.empty()) {
    grid_planes g;
    g.rule = *plane_rule_of(r.planes);
    g.origin = r.from;
    g.spacing = r.spacing;
    for (unsigned a = 0; a < 3; ++a)
      g.count[a] = static_cast<std::uint32_t>(r.count[a]);
    t.grid =
        std::make_shared<const grid_planes>(g.rule == plane_rule::given ? grid_of(r.given) : g);
    for (unsigned a = 0; a < 3; ++a) // what adapters are told of the planes is so
      for (const unsigned side : {0u, 1u})
        if (r.corner(r.base, side)[a] !=
            nearest_plane(*t.grid, a, static_cast<std::uint32_t>(r.base[a] + side)))
          std::abort();
  } else {
    t.root = {r.lo, r.size};
    t.level = r.level;
  }
  return segment ? with_end(t, r.origin, r.end) : with_ray(t, r.origin, r.direction);
}

/// The members of a JSON request, from `bits`.
adapter::request request_of(const json& line, bool segment) {
  adapter::request r;
  const json& bits = line["bits"];
  const auto vector = [](const json& words) {
    adapter::vec3 v{};
    for (unsigned a = 0; a < 3; ++a)
      v[a] = *number_of_bits(words[a].get<std::string>());
    return v;
  };
  r.origin = vector(bits["origin"]);
  (segment ? r.end : r.direction) = vector(bits[segment ? "end" : "direction"]);
  if (line.contains("boxes")) {
    for (const json& b : bits["boxes"])
      r.boxes.push_back({{r.boxes.size(), 0, 0}, vector(b["lo"]), vector(b["hi"])});
    return r;
  }
  r.base = line["base"].get<adapter::index3>();
  r.extent = line["extent"].get<adapter::index3>();
  if (!line.contains("grid")) {
    r.lo = vector(bits["root"]["lo"]);
    r.size = *number_of_bits(bits["root"]["size"].get<std::string>());
    r.level = line["level"].get<int>();
    return r;
  }
  const json& grid = bits["grid"];
  if (grid.contains("planes")) {
    r.planes = "given";
    for (unsigned a = 0; a < 3; ++a)
      for (const json& p : grid["planes"][a])
        r.given[a].push_back(*number_of_bits(p.get<std::string>()));
    return r;
  }
  r.planes = line["grid"]["planes"].get<std::string>();
  r.from = vector(grid["origin"]);
  r.spacing = vector(grid["spacing"]);
  r.count = line["grid"]["count"].get<adapter::index3>();
  return r;
}

json place_json(const trial& t, octant_number v) {
  const adapter::index3 place = place_of(t, v);
  return t.boxes ? json(place[0]) : json(place);
}

int serve_json(const std::string& promised, const std::string& cells, bool segment,
               const std::string& fault) {
  std::cout << json{{"promise", promised}, {"cells", cells}, {"segments", segment}, {"batch", 17}}
            << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    json answers = json::array();
    const json message = json::parse(line);
    for (const json& request : message["batch"]) {
      const trial t = trial_of(request_of(request, segment), segment);
      const exact_answer a = answer_to(t, promised, fault);
      json said{{"id", request["id"]}, {"echo", request.value("echo", json())}};
      if (promised == "any") {
        said["hit"] = a.hit;
      } else if (promised == "count") {
        said[a.count ? "count" : "skip"] = a.count ? json(*a.count) : json(true);
      } else if (promised.starts_with("first")) {
        said["first"] = a.first ? place_json(t, *a.first) : json();
        if (std::isfinite(a.t)) // there are none beyond
          said["t"] = a.t;
      } else {
        said["visited"] = json::array();
        for (const octant_number v : a.list)
          said["visited"].push_back(place_json(t, v));
      }
      answers.push_back(said);
    }
    std::cout << json{{"answers", answers}} << std::endl;
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 5)
    return 2;
  const std::string promised = argv[1], cells = argv[2], fault = argc > 5 ? argv[5] : "";
  const bool segment = argv[3] == std::string("segments");
  if (argv[4] == std::string("json"))
    return serve_json(promised, cells, segment, fault);
  const adapter::hello hello{
      .promise = promised.c_str(), .cells = cells.c_str(), .segments = segment};
  return adapter::serve(hello, [&](const adapter::request& r, adapter::answer& out) {
    const trial t = trial_of(r, segment);
    const exact_answer a = answer_to(t, promised, fault);
    if (promised == "any")
      return out.hit(a.hit);
    if (promised == "count")
      return a.count ? out.count(*a.count) : out.skip();
    if (promised.starts_with("first")) {
      if (a.first)
        out.first({place_of(t, *a.first), {}, {}}, a.t);
      return;
    }
    for (const octant_number v : a.list)
      out.visit(place_of(t, v));
  });
}
