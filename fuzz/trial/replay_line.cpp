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

} // namespace

std::string to_json_line(const trial& t) {
  json line;
  line["origin"] = hex(t.origin);
  line["direction"] = hex(t.direction);
  line["octant"] = {{"lo", hex(t.octant(0).lo)}, {"size", hex(t.size())}};
  line["root"] = {{"lo", hex(t.root.lo)}, {"size", hex(t.root.size)}};
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
  const cube octant = read.cube_of(line, "octant");
  const cube root = line.contains("root") ? read.cube_of(line, "root") : cube{{0, 0, 0}, 1};
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

} // namespace graze::fuzz
