#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <nlohmann/json.hpp>
#include <trial/number.hpp>
#include <trial/replay_line.hpp>

namespace graze::fuzz {

namespace {

using json = nlohmann::ordered_json;
/// What is read: its keys are looked up by a tree, so that many of them take no time.
using read_json = nlohmann::json;

/// A user's remarks, and what graze-fuzz writes beside a case (reproducers, campaigns' findings).
constexpr std::array<std::string_view, 6> remarks{"comment",   "name", "finding",
                                                  "missed_by", "kind", "traversal"};

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
  cube cube_of(const read_json& object, const char* key) {
    cube c{{0, 0, 0}, 1};
    const read_json* value = member(object, key);
    if (value == nullptr)
      return c;
    only(*value, {"lo", "size"}, key);
    c.lo = vector(*value, "lo");
    if (const read_json* size = member(*value, "size"))
      c.size = number(*size, "size");
    return c;
  }
  octree::box box_of(const read_json& value) {
    only(value, {"lo", "hi"}, "box");
    return {vector(value, "lo"), vector(value, "hi")};
  }
  std::vector<octree::box> boxes_of(const read_json& value) {
    std::vector<octree::box> boxes;
    if (!value.is_array() || value.empty() || value.size() > max_boxes)
      return refuse(fmt::format("\"boxes\" is not an array of 1 to {} boxes", max_boxes)), boxes;
    for (const read_json& one : value)
      boxes.push_back(box_of(one));
    return boxes;
  }
  std::array<std::uint32_t, 3> counts(const read_json& object, const char* key, std::uint32_t first,
                                      std::uint32_t last) {
    std::array<std::uint32_t, 3> n{};
    const read_json* value = member(object, key);
    if (value == nullptr)
      return n;
    for (unsigned a = 0; a < 3; ++a) {
      if (!value->is_array() || value->size() != 3 || !(*value)[a].is_number_integer() ||
          (*value)[a] < first || (*value)[a] > last)
        return refuse(fmt::format("\"{}\" is not an array of three integers in {}..{}", key, first,
                                  last)),
               n;
      n[a] = (*value)[a].get<std::uint32_t>();
    }
    return n;
  }
  grid_planes grid(const read_json& value) {
    grid_planes g;
    const read_json* planes = member(value, "planes");
    if (planes == nullptr)
      return g;
    if (planes->is_array()) {
      only(value, {"planes"}, "grid");
      return given(*planes);
    }
    only(value, {"origin", "spacing", "count", "planes"}, "grid");
    const auto rule = planes->is_string() ? plane_rule_of(planes->get_ref<const std::string&>())
                                          : std::optional<plane_rule>();
    if (!rule || *rule == plane_rule::given)
      return refuse("\"planes\" is none of \"exact\", \"rounded\", \"multiplied\", \"added\", "
                    "\"float\", nor three arrays of numbers"),
             g;
    g.rule = *rule;
    g.origin = vector(value, "origin");
    g.spacing = vector(value, "spacing");
    g.count = counts(value, "count", 1, max_count);
    return g;
  }
  map_file map_of(const read_json& value) {
    map_file file;
    if (value.is_string()) {
      file.path = value.get<std::string>();
      return file;
    }
    only(value, {"file", "voxel_size", "cell_centred"}, "scene");
    if (const read_json* path = member(value, "file"); path != nullptr && path->is_string())
      file.path = path->get<std::string>();
    else
      refuse("\"file\" of \"scene\" is not a string");
    if (value.is_object() && value.contains("voxel_size")) {
      file.voxel_size = number(value.at("voxel_size"), "voxel_size");
      if (!(file.voxel_size > 0))
        refuse("\"voxel_size\" is not above 0");
    }
    if (value.is_object() && value.contains("cell_centred")) {
      if (!value.at("cell_centred").is_boolean())
        return refuse("\"cell_centred\" is neither true nor false"), file;
      file.cell_centred = value.at("cell_centred").get<bool>();
    }
    return file;
  }
  /// What is not of these names is refused, but for remarks.
  void only(const read_json& object, std::initializer_list<std::string_view> names,
            std::string_view what = {}) {
    if (!object.is_object())
      return what.empty() ? void() : refuse(fmt::format("\"{}\" is not an object", what));
    for (const auto& [key, value] : object.items())
      if (std::find(names.begin(), names.end(), key) == names.end() &&
          !(what.empty() && std::find(remarks.begin(), remarks.end(), key) != remarks.end()))
        return refuse(
            fmt::format("unknown member \"{}\"{}{}: remarks may be members \"comment\" and "
                        "\"name\"",
                        printable(key), what.empty() ? "" : " in ", what));
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

  void refuse(std::string why) {
    if (reason_.empty())
      reason_ = std::move(why);
  }

private:
  grid_planes given(const read_json& arrays) {
    std::array<std::vector<double>, 3> planes;
    if (arrays.size() != 3)
      return refuse("\"planes\" is not three arrays"), grid_planes{};
    for (unsigned a = 0; a < 3; ++a) {
      if (!arrays[a].is_array())
        return refuse("\"planes\" is not three arrays"), grid_planes{};
      for (const read_json& plane : arrays[a])
        planes[a].push_back(number(plane, "planes"));
    }
    return grid_of(std::move(planes));
  }
  /// A name as it may stand in a line of text.
  static std::string printable(std::string_view name) {
    std::string text(name.substr(0, 60));
    for (char& c : text)
      if (c < ' ' || c > '~')
        c = '?';
    return text;
  }

  std::string reason_;
};

json json_of(const octree::box& b) { return {{"lo", hex(b.lo)}, {"hi", hex(b.hi)}}; }

json json_of(const map_file& f) {
  if (f == map_file{f.path})
    return f.path;
  json object{{"file", f.path}};
  if (f.voxel_size != 0)
    object["voxel_size"] = hex(f.voxel_size);
  if (f.cell_centred)
    object["cell_centred"] = true;
  return object;
}

json json_of(const grid_planes& g) {
  json object;
  if (g.rule == plane_rule::given) {
    for (const auto& planes : g.given) {
      json axis = json::array();
      for (const double p : planes)
        axis.push_back(hex(p));
      object["planes"].push_back(axis);
    }
    return object;
  }
  object["origin"] = hex(g.origin);
  object["spacing"] = hex(g.spacing);
  object["count"] = g.count;
  object["planes"] = name_of(g.rule);
  return object;
}

} // namespace

std::string to_json_line(const trial& t) {
  json line;
  line["origin"] = hex(t.origin);
  if (t.end)
    line["end"] = hex(*t.end);
  else
    line["direction"] = hex(t.direction);
  if (t.boxes && t.boxes->size() == 1) {
    line["box"] = json_of(t.boxes->front());
    return line.dump();
  }
  if (t.boxes) {
    for (const octree::box& b : *t.boxes)
      line["boxes"].push_back(json_of(b));
    return line.dump();
  }
  if (t.map) {
    line["scene"] = json_of(t.map->file());
    line["voxel"] = t.base;
  } else if (t.grid) {
    line["grid"] = json_of(*t.grid);
    line["voxel"] = t.base;
  } else {
    line["octant"] = {{"lo", hex(t.octant(0).lo)}, {"size", hex(t.size())}};
    line["root"] = {{"lo", hex(t.root.lo)}, {"size", hex(t.root.size)}};
  }
  if (t.extent != std::array<std::uint8_t, 3>{1, 1, 1})
    line["extent"] = t.extent;
  return line.dump();
}

expected<trial> from_json_line(std::string_view text, const map_source& maps) {
  const read_json line = read_json::parse(text, nullptr, false);
  if (line.is_discarded())
    return unexpected{"not JSON"};
  if (!line.is_object())
    return unexpected{"not a JSON object"};
  reader read;
  const bool segment = line.contains("end");
  const char* const cells = line.contains("boxes")   ? "boxes"
                            : line.contains("box")   ? "box"
                            : line.contains("grid")  ? "grid"
                            : line.contains("scene") ? "scene"
                                                     : "octant";
  const bool of_map = cells == std::string_view("scene"),
             blocks = of_map || cells == std::string_view("grid"),
             octants = cells == std::string_view("octant");
  trial t;
  t.origin = read.vector(line, "origin");
  const vec3 ahead = read.vector(line, segment ? "end" : "direction");
  t = segment ? with_end(t, t.origin, ahead) : with_ray(t, t.origin, ahead);
  if (line.contains("extent") && (blocks || octants))
    t.extent = read.extent(line.at("extent"));
  if (octants) {
    const cube octant = read.cube_of(line, "octant");
    const cube root = line.contains("root") ? read.cube_of(line, "root") : cube{{0, 0, 0}, 1};
    read.only(line, {"origin", segment ? "end" : "direction", "octant", "root", "extent"});
    if (!read.reason().empty())
      return unexpected{read.reason()};
    return trial_of_octant(t, octant, root);
  }
  read.only(line, {"origin", segment ? "end" : "direction", cells, blocks ? "voxel" : cells,
                   blocks ? "extent" : cells});
  if (blocks) {
    if (of_map) {
      const map_file file = read.map_of(line.at("scene"));
      if (read.reason().empty() && !maps)
        read.refuse("this is a line of a map (\"scene\"), which is not read here");
      if (!read.reason().empty())
        return unexpected{read.reason()};
      const auto map = maps(file);
      if (!map)
        return unexpected{map.reason()};
      t.map = *map;
      t.grid = t.map->grid();
    } else {
      t.grid = std::make_shared<const grid_planes>(read.grid(line.at("grid")));
    }
    const auto voxel = read.counts(line, "voxel", 0, max_count - 1);
    std::copy(voxel.begin(), voxel.end(), t.base.begin());
  } else {
    t.boxes = std::make_shared<const std::vector<octree::box>>(
        line.contains("boxes") ? read.boxes_of(line.at("boxes"))
                               : std::vector{read.box_of(line.at("box"))});
  }
  if (!read.reason().empty())
    return unexpected{read.reason()};
  if (const auto well = judgeable(t); !well)
    return unexpected{well.reason()};
  return t;
}

std::string grid_text(const grid_planes& grid) { return json_of(grid).dump(); }

expected<grid_planes> grid_from_text(std::string_view text) {
  const read_json value = read_json::parse(text, nullptr, false);
  if (value.is_discarded())
    return unexpected{"not JSON"};
  if (!value.is_object())
    return unexpected{"not a JSON object"};
  reader read;
  grid_planes g = read.grid(value);
  if (!read.reason().empty())
    return unexpected{read.reason()};
  if (const auto well = judgeable(g); !well)
    return unexpected{well.reason()};
  return g;
}

expected<std::vector<replay_case>> read_replay_file(const std::string& path,
                                                    const map_source& maps) {
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
    auto t = from_json_line(line, maps);
    if (!t)
      return unexpected{fmt::format("{}:{}: {}", path, file->line_number(), t.reason())};
    cases.push_back({file->line_number(), *t});
  }
  if (cases.empty())
    return unexpected{fmt::format("{} holds no replay line", path)};
  return cases;
}

} // namespace graze::fuzz
