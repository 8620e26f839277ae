#include <fmt/format.h>
#include <graze/oracle/rational.hpp>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>
#include <judge/replay.hpp>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;
/// What is read: its keys are looked up by a tree, so that many of them take no time.
using read_json = nlohmann::json;

json spelled(const vec3& v) { return json::array({hex(v[0]), hex(v[1]), hex(v[2])}); }

/// Reads members of one line and keeps the first reason why that did not work.
class reader {
public:
  const std::string& reason() const { return reason_; }

  const read_json* member(const read_json& object, const char* key) {
    if (!object.is_object() || !object.contains(key))
      return refuse(fmt::format("no \"{}\"", key)), nullptr;
    return &object.at(key);
  }
  double number(const read_json& value, const char* what) {
    std::optional<double> x;
    if (value.is_string())
      x = parse_number(value.get_ref<const std::string&>());
    else if (value.is_number())
      x = value.get<double>();
    if (!x || !std::isfinite(*x))
      return refuse(fmt::format("\"{}\" is not a finite number", what)), 0;
    return *x;
  }
  vec3 vector(const read_json& object, const char* key) {
    vec3 v{};
    const read_json* value = member(object, key);
    if (value == nullptr)
      return v;
    if (!value->is_array() || value->size() != 3)
      return refuse(fmt::format("\"{}\" is not an array of three numbers", key)), v;
    for (unsigned a = 0; a < 3; ++a)
      v[a] = number((*value)[a], key);
    return v;
  }
  cube box(const read_json& object, const char* key) {
    cube c{{0, 0, 0}, 1};
    const read_json* value = member(object, key);
    if (value == nullptr)
      return c;
    c.lo = vector(*value, "lo");
    if (const read_json* size = member(*value, "size"))
      c.size = number(*size, "size");
    return c;
  }
  std::array<std::uint8_t, 3> extent(const read_json& value) {
    std::array<std::uint8_t, 3> e{1, 1, 1};
    for (unsigned a = 0; a < 3; ++a) {
      if (!value.is_array() || value.size() != 3 || !value[a].is_number_integer() || value[a] < 1 ||
          value[a] > max_extent)
        return refuse("\"extent\" is not an array of three integers in 1..4"), e;
      e[a] = value[a].get<std::uint8_t>();
    }
    return e;
  }

private:
  void refuse(std::string why) {
    if (reason_.empty())
      reason_ = std::move(why);
  }
  std::string reason_;
};

bool has(voxel_set set, voxel v) { return (set >> v & 1) != 0; }

} // namespace

std::string to_json_line(const trial& t) {
  json line;
  line["origin"] = spelled(t.origin);
  line["direction"] = spelled(t.direction);
  line["octant"] = {{"lo", spelled(t.octant(0).lo)}, {"size", hex(t.size())}};
  line["root"] = {{"lo", spelled(t.root.lo)}, {"size", hex(t.root.size)}};
  if (t.extent != std::array<std::uint8_t, 3>{1, 1, 1})
    line["extent"] = t.extent;
  return line.dump();
}

expected<trial> from_json_line(std::string_view text) {
  const read_json line = read_json::parse(text, nullptr, false);
  if (line.is_discarded())
    return unexpected{"not JSON"};
  if (!line.is_object())
    return unexpected{"not a JSON object"};
  reader read;
  const vec3 origin = read.vector(line, "origin");
  const vec3 direction = read.vector(line, "direction");
  const cube octant = read.box(line, "octant");
  const cube root = line.contains("root") ? read.box(line, "root") : cube{{0, 0, 0}, 1};
  std::array<std::uint8_t, 3> extent{1, 1, 1};
  if (line.contains("extent"))
    extent = read.extent(line.at("extent"));
  if (!read.reason().empty())
    return unexpected{read.reason()};
  return trial_of_octant(origin, direction, octant, root, extent);
}

expected<std::vector<replay_case>> read_replay_file(const std::string& path) {
  auto file = path == "-" ? expected<support::input_file>(support::input_file::standard_input())
                          : support::input_file::open(path);
  if (!file)
    return unexpected{file.reason()};
  std::vector<replay_case> cases;
  std::string line;
  for (;;) {
    const auto read = file->read_line(line, longest_replay_line);
    if (!read)
      return unexpected{read.reason()};
    if (!*read)
      break;
    if (line.find_first_not_of(" \t\r") == std::string::npos)
      continue;
    if (cases.size() == most_replay_lines)
      return unexpected{fmt::format("{} holds more than {} replay lines", path, most_replay_lines)};
    auto t = from_json_line(line);
    if (!t)
      return unexpected{fmt::format("{}:{}: {}", path, file->line_number(), t.reason())};
    cases.push_back({file->line_number(), *t});
  }
  if (cases.empty())
    return unexpected{fmt::format("{} holds no replay line", path)};
  return cases;
}

replay_result replay(const trial& given, traversal& under_test) {
  visited said;
  ask(under_test, given, said);
  replay_result r;
  r.thrown = said.thrown();
  const auto answered = trial_answered(given, said);
  r.declined = !answered;
  if (r.declined)
    return r;
  const trial& t = *answered;
  r.visited = said.set();
  const unsigned far_faces = t.at_far_face();
  for (voxel_set left = t.all(); left != 0; left &= left - 1) {
    const auto v = static_cast<voxel>(std::countr_zero(left));
    const cube box = t.octant(v);
    const oracle::point hi{box.hi(0), box.hi(1), box.hi(2)};
    const voxel_set only = voxel_set{1} << v;
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
  truth is = truth_of(t);
  r.oracles_agree = is.touched == r.touches && is.crossed == r.crosses && is.owned == r.owns;
  is.touched = r.touches;
  is.crossed = r.crosses;
  is.owned = r.owns;
  r.findings = judge(t, is, said, under_test.promises()).findings;
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
    for (voxel_set left = c.at.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<voxel>(std::countr_zero(left));
      line["octants"].push_back({{"lo", spelled(c.at.octant(v).lo)},
                                 {"touches", has(r.touches, v)},
                                 {"crosses", has(r.crosses, v)},
                                 {"owns", has(r.owns, v)},
                                 {"visited", has(r.visited, v)}});
    }
  return support::json_line(line);
}

} // namespace graze::fuzz
