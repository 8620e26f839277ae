#include <graze/render/scene_text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <nlohmann/json.hpp>

namespace graze::render {
namespace {

using json = nlohmann::ordered_json;
/// What is read: its keys are looked up by a tree, so that many of them take no time.
using read_json = nlohmann::json;
constexpr int most_nested = 64;
constexpr std::size_t most_parameters = 1000;

/// Thrown within this file only.
struct refusal {
  std::string reason;
  formula_mark where{};
};

/// A value and where it is: "lights[1].intensity".
class value {
public:
  value(const read_json& node, std::string path) : json_(&node), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& why, formula_mark where = {}) const {
    throw refusal{path_.empty() ? why : fmt::format("key {}: {}", path_, why), std::move(where)};
  }
  /// Of an object; its keys must be among these.
  void check_keys(std::initializer_list<const char*> known) const {
    if (!json_->is_object())
      refuse("must be an object, { ... }");
    for (const auto& [key, unused] : json_->items())
      if (std::none_of(known.begin(), known.end(), [&](const char* k) { return key == k; }))
        refuse(fmt::format("there is no key '{}'; there are {}", key, fmt::join(known, ", ")));
  }
  [[nodiscard]] bool is_text() const { return json_->is_string(); }
  [[nodiscard]] bool has(const char* key) const { return json_->contains(key); }
  [[nodiscard]] value at(const char* key) const {
    if (!has(key))
      refuse(fmt::format("the key '{}' is missing", key));
    return {json_->at(key), path_.empty() ? key : fmt::format("{}.{}", path_, key)};
  }
  [[nodiscard]] std::vector<value> elements(std::size_t most) const {
    if (!json_->is_array())
      refuse("must be a list, [ ... ]");
    if (json_->size() > most)
      refuse(fmt::format("has {} elements, more than {}", json_->size(), most));
    std::vector<value> all;
    for (std::size_t i = 0; i < json_->size(); ++i)
      all.emplace_back((*json_)[i], fmt::format("{}[{}]", path_, i));
    return all;
  }
  [[nodiscard]] std::string text() const {
    if (!json_->is_string())
      refuse("must be a text");
    return json_->get<std::string>();
  }
  [[nodiscard]] std::vector<std::string> keys(std::size_t most) const {
    if (!json_->is_object())
      refuse("must be an object, { ... }");
    if (json_->size() > most)
      refuse(fmt::format("has {} keys, more than {}", json_->size(), most));
    std::vector<std::string> all;
    for (const auto& [key, unused] : json_->items())
      all.push_back(key);
    return all;
  }
  /// Of a number: its shortest decimal.
  [[nodiscard]] std::string digits() const {
    if (!json_->is_number())
      refuse("must be a number or a text");
    return json_->dump();
  }
  /// A number within [least, most].
  [[nodiscard]] double number(double least, double most) const {
    if (!json_->is_number())
      refuse("must be a number");
    const auto x = json_->get<double>();
    if (!(x >= least && x <= most))
      refuse(fmt::format("must be {} to {}, not {}", least, most, x));
    return x;
  }
  [[nodiscard]] std::array<double, 3> three(double least, double most) const {
    const auto all = elements(3);
    if (all.size() != 3)
      refuse("must have three elements");
    return {all[0].number(least, most), all[1].number(least, most), all[2].number(least, most)};
  }
  /// The only key of an object that has one.
  [[nodiscard]] std::string only_key() const {
    if (!json_->is_object() || json_->size() != 1)
      refuse("must have one key");
    return json_->begin().key();
  }

private:
  const read_json* json_;
  std::string path_;
};

constexpr double farthest = 1e100;

/// [r, g, b], linear, or a text (colour_from).
colour colour_of(const value& v) {
  if (!v.is_text())
    return v.three(0, 100);
  const auto found = colour_from(v.text());
  if (!found)
    v.refuse(found.reason());
  return *found;
}

material material_from(const value& v, material m) {
  if (v.has("body"))
    m.body = colour_of(v.at("body"));
  if (v.has("inside"))
    m.inside = colour_of(v.at("inside"));
  const auto read = [&](const char* key, double& to, double most) {
    if (v.has(key))
      to = v.at(key).number(0, most);
  };
  read("ambient", m.ambient, 100);
  read("diffuse", m.diffuse, 100);
  read("specular", m.specular, 100);
  read("reflection", m.reflection, 1);
  return m;
}

octree::formula formula_from(const value& v, std::span<const octree::parameter> set) {
  const std::string text = v.text();
  std::size_t column = 0;
  auto parsed = octree::formula::parse(text, &column, set);
  if (!parsed)
    v.refuse(parsed.reason(), {text, column});
  return *std::move(parsed);
}

/// Those that are given, and those of the key that are not among them.
std::vector<octree::parameter> set_from(const value& v, std::span<const octree::parameter> given) {
  std::vector<octree::parameter> all(given.begin(), given.end());
  for (const std::string& name : v.keys(most_parameters)) {
    const value entry = v.at(name.c_str());
    const std::string text = entry.is_text() ? entry.text() : entry.digits();
    formula_mark where{text, 0};
    auto made = octree::parameter::make(name, text, &where.column);
    if (!made)
      entry.refuse(made.reason(), where);
    if (std::none_of(given.begin(), given.end(), [&](const auto& p) { return p.name == name; }))
      all.push_back(*std::move(made));
  }
  return in_order(std::move(all));
}

solid solid_from(const value& v, const std::vector<object>& objects, int nested) {
  if (nested > most_nested)
    v.refuse(fmt::format("is nested more than {} times", most_nested));
  if (v.is_text()) {
    const std::string name = v.text();
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i].name == name)
        return {solid::kind::single, i, {}};
    v.refuse(fmt::format("there is no object '{}'", name));
  }
  solid s;
  const std::string operation = v.only_key();
  if (operation == "union")
    s.form = solid::kind::unite;
  else if (operation == "intersection")
    s.form = solid::kind::intersect;
  else if (operation == "difference")
    s.form = solid::kind::subtract;
  else
    v.refuse(fmt::format("'{}' is none of union, intersection, difference", operation));
  const value parts = v.at(operation.c_str());
  for (const value& part : parts.elements(most_objects))
    s.parts.push_back(solid_from(part, objects, nested + 1));
  if (s.parts.size() < 2)
    parts.refuse("needs two solids or more");
  return s;
}

octree::box domain_of(const value& v) {
  const auto all = v.elements(6);
  octree::box b{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t first = all.size() == 6 ? 2 * a : 0;
    if (all.size() != 2 && all.size() != 6)
      v.refuse("must be [lo, hi] or [x0, x1, y0, y1, z0, z1]");
    b.lo[a] = all[first].number(-farthest, farthest);
    b.hi[a] = all[first + 1].number(-farthest, farthest);
  }
  if (const support::status may = check_domain(b); !may)
    v.refuse(may.reason());
  return b;
}

/// A camera by vectors, or by its scale.
camera camera_from(const value& v) {
  camera c{};
  if (v.has("scale")) {
    v.check_keys({"scale", "at"});
    c = camera::standard(v.at("scale").number(1e-90, 1e90));
    if (v.has("at")) {
      const auto at = v.at("at").three(-farthest, farthest);
      for (std::size_t a = 0; a < 3; ++a)
        c.eye[a] += at[a];
    }
  } else {
    v.check_keys({"eye", "centre", "right", "up"});
    c = {v.at("eye").three(-farthest, farthest), v.at("centre").three(-farthest, farthest),
         v.at("right").three(-farthest, farthest), v.at("up").three(-farthest, farthest)};
  }
  if (const support::status may = c.check(); !may)
    v.refuse(may.reason());
  return c;
}

framing framing_from(const value& v) {
  v.check_keys({"eye", "look_at", "up", "azimuth", "elevation", "fov", "zoom"});
  framing f;
  const auto read = [&](const char* key, std::optional<double>& to) {
    if (v.has(key))
      to = v.at(key).number(-farthest, farthest);
  };
  read("azimuth", f.azimuth);
  read("elevation", f.elevation);
  read("fov", f.fov);
  read("zoom", f.zoom);
  if (v.has("eye"))
    f.eye = v.at("eye").three(-farthest, farthest);
  if (v.has("look_at"))
    f.look_at = v.at("look_at").three(-farthest, farthest);
  if (v.has("up") && v.at("up").is_text()) {
    const auto up = direction_from(v.at("up").text());
    if (!up)
      v.at("up").refuse(up.reason());
    f.up = *up;
  } else if (v.has("up")) {
    f.up = v.at("up").three(-farthest, farthest);
  }
  return f;
}

void read_camera(const value& v, scene& s) {
  s.fitted.reset();
  if (v.has("scale") || v.has("at") || v.has("centre") || v.has("right")) {
    s.view = camera_from(v);
    return;
  }
  s.fitted = framing_from(v);
  const auto shown = frame(*s.fitted, ball_about(s.domain));
  if (!shown)
    v.refuse(shown.reason());
  s.view = shown->view;
}

void read_lights(const value& v, scene& s) {
  s.lit = scene::lamps::given;
  s.lights.clear();
  if (v.is_text()) {
    if (v.text() != "headlight")
      v.refuse("must be a list, [ ... ], or \"headlight\"");
    s.lit = scene::lamps::headlight;
    s.lights = headlight(s.view);
    return;
  }
  for (const value& l : v.elements(most_lights)) {
    l.check_keys({"position", "intensity"});
    s.lights.push_back(
        {l.at("position").three(-farthest, farthest), l.at("intensity").number(0, 1e6)});
  }
}

void read_background(const value& v, scene& s) {
  s.transparent = v.is_text() && v.text() == "transparent";
  if (!s.transparent)
    s.background = colour_of(v);
}

scene scene_of(const value& v, std::span<const octree::parameter> given) {
  v.check_keys({"name", "surface", "formula", "material", "objects", "solid", "set", "domain",
                "camera", "lights", "background", "colour", "inside_colour"});
  const int surfaces = int{v.has("surface")} + int{v.has("formula")} + int{v.has("objects")};
  if (surfaces != 1)
    v.refuse(surfaces == 0 ? "no surface: one of the keys surface, formula, objects is needed"
                           : "surface, formula and objects exclude each other");
  scene s{};
  const std::vector<octree::parameter> set =
      v.has("set") ? set_from(v.at("set"), given)
                   : std::vector<octree::parameter>(given.begin(), given.end());
  s.set = set;
  if (v.has("surface")) {
    const std::string name = v.at("surface").text();
    const scene* found = find_scene(name);
    if (found == nullptr)
      v.at("surface").refuse(fmt::format("there is no '{}'; there are {}", name, scene_names()));
    s = *found;
    s.set = set;
  } else if (v.has("formula")) {
    s.objects.push_back({"surface", formula_from(v.at("formula"), set), material{default_body}});
  } else {
    for (const value& o : v.at("objects").elements(most_objects)) {
      o.check_keys(
          {"name", "formula", "body", "inside", "ambient", "diffuse", "specular", "reflection"});
      const std::string name = o.at("name").text();
      for (const object& other : s.objects)
        if (other.name == name)
          o.at("name").refuse(fmt::format("there are two objects '{}'", name));
      s.objects.push_back(
          {name, formula_from(o.at("formula"), set), material_from(o, material{default_body})});
    }
    if (s.objects.empty())
      v.at("objects").refuse("no surface: the list is empty");
  }
  if (const support::status may = check_set(s); !may)
    v.refuse(may.reason());
  if (v.has("material")) {
    if (v.has("objects"))
      v.at("material").refuse("objects have their own");
    v.at("material").check_keys({"body", "inside", "ambient", "diffuse", "specular", "reflection"});
    s.objects[0].look = material_from(v.at("material"), s.objects[0].look);
  }
  for (const auto& [key, of_material] :
       {std::pair{"colour", "body"}, {"inside_colour", "inside"}}) {
    if (!v.has(key))
      continue;
    if (v.has("objects") || (v.has("material") && v.at("material").has(of_material)))
      v.at(key).refuse(fmt::format("the objects or the material have their own '{}'", of_material));
    const colour chosen = colour_of(v.at(key));
    if (of_material == std::string_view("body"))
      s.objects[0].look.body = chosen;
    else
      s.objects[0].look.inside = chosen;
  }
  if (v.has("solid")) {
    s.shape = solid_from(v.at("solid"), s.objects, 0);
  } else if (s.objects.size() > 1) {
    s.shape.form = solid::kind::unite;
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      s.shape.parts.push_back({solid::kind::single, i, {}});
  }
  if (v.has("name"))
    s.name = v.at("name").text();
  else if (s.built_in.empty())
    s.name = "scene";
  const bool own_domain = v.has("domain");
  if (own_domain)
    s.domain = domain_of(v.at("domain"));
  else if (s.built_in.empty())
    v.refuse("the key 'domain' is missing");
  if (v.has("camera"))
    read_camera(v.at("camera"), s);
  else if (s.built_in.empty())
    s.view = fitting_camera(s.domain);
  if (v.has("lights"))
    read_lights(v.at("lights"), s);
  else if (s.built_in.empty())
    s.lights = fitting_lights(s.domain);
  if (v.has("background"))
    read_background(v.at("background"), s);
  return s;
}

json json_of(const solid& s, const std::vector<object>& objects) {
  if (s.form == solid::kind::single)
    return objects[s.single].name;
  json parts = json::array();
  for (const solid& part : s.parts)
    parts.push_back(json_of(part, objects));
  const char* const operation = s.form == solid::kind::unite       ? "union"
                                : s.form == solid::kind::intersect ? "intersection"
                                                                   : "difference";
  return {{operation, parts}};
}

json json_of(const material& m) {
  json j = {{"body", m.body},
            {"ambient", m.ambient},
            {"diffuse", m.diffuse},
            {"specular", m.specular},
            {"reflection", m.reflection}};
  if (m.inside)
    j["inside"] = *m.inside;
  return j;
}

} // namespace

std::vector<octree::parameter> in_order(std::vector<octree::parameter> set) {
  std::sort(set.begin(), set.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return set;
}

support::status check_set(const scene& s) {
  for (const octree::parameter& p : s.set)
    if (std::none_of(s.objects.begin(), s.objects.end(), [&](const object& part) {
          return part.formula && part.formula->uses(p.name);
        }))
      return unexpected{fmt::format("no formula has the name '{}' that is set", p.name)};
  return {};
}

std::string formula_mark::lines() const {
  if (column == 0 || column > text.size() + 1)
    return {};
  // parts of the text as they are shown, and how many characters these have
  const auto characters = [](std::string_view shown) {
    return static_cast<std::size_t>(std::count_if(shown.begin(), shown.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
  };
  const auto cut = [](std::string& shown, std::size_t first) { // from a whole character
    while (first < shown.size() && (static_cast<unsigned char>(shown[first]) & 0xc0) == 0x80)
      ++first;
    return first;
  };
  constexpr std::size_t most_before = 50, most_after = 40; // bytes, of many more
  constexpr std::size_t whole = octree::formula::longest_text * 4;
  std::string before = support::shown(text.substr(0, column - 1), whole),
              after = support::shown(text.substr(column - 1), whole);
  if (before.size() > most_before)
    before = "..." + before.substr(cut(before, before.size() - most_before));
  if (after.size() > most_after)
    after = after.substr(0, cut(after, most_after)) + "...";
  return fmt::format("  {}{}\n  {:{}}^\n", before, after, "", characters(before));
}

expected<scene> scene_from(std::string_view text, std::span<const octree::parameter> set,
                           formula_mark* where) {
  if (text.size() > largest_scene_text)
    return unexpected{fmt::format("a scene of more than {} bytes", largest_scene_text)};
  try {
    const read_json document = read_json::parse(text);
    return scene_of(value(document, ""), set);
  } catch (const refusal& r) {
    if (where != nullptr)
      *where = r.where;
    return unexpected{r.reason};
  } catch (const json::exception& e) {
    std::string why = e.what(); // "[json.exception...] parse error at line 1, column 3: ..."
    if (const auto end = why.find("] "); end != std::string::npos)
      why.erase(0, end + 2);
    std::replace(why.begin(), why.end(), '\n', ' ');
    return unexpected{why};
  }
}

std::string text_of(const scene& s) {
  json j = {{"name", s.name}};
  if (!s.built_in.empty()) {
    j["surface"] = s.built_in;
    j["material"] = json_of(s.objects[0].look);
  } else {
    j["objects"] = json::array();
    for (const object& o : s.objects) {
      json part = {{"name", o.name}, {"formula", o.formula->text()}};
      part.update(json_of(o.look));
      j["objects"].push_back(std::move(part));
    }
    j["solid"] = json_of(s.shape, s.objects);
    for (const octree::parameter& p : s.set)
      j["set"][p.name] = p.value;
  }
  const octree::box& d = s.domain;
  j["domain"] = {d.lo[0], d.hi[0], d.lo[1], d.hi[1], d.lo[2], d.hi[2]};
  j["camera"] = {
      {"eye", s.view.eye}, {"centre", s.view.centre}, {"right", s.view.right}, {"up", s.view.up}};
  j["lights"] = json::array();
  for (const light& l : s.lights)
    j["lights"].push_back({{"position", l.position}, {"intensity", l.intensity}});
  if (s.transparent)
    j["background"] = "transparent";
  else
    j["background"] = s.background;
  return j.dump(-1, ' ', true, json::error_handler_t::replace);
}

expected<std::vector<double>> numbers_from(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double x = 0;
    const auto [rest, error] = std::from_chars(at, end, x);
    if (error != std::errc{} || (rest != end && *rest != ','))
      return unexpected{fmt::format("column {}: a number is wanted", at - text.data() + 1)};
    numbers.push_back(x);
    if (rest == end)
      return numbers;
    at = rest + 1;
  }
}

expected<octree::box> domain_from(std::string_view text) {
  const auto all = numbers_from(text);
  if (!all)
    return unexpected{all.reason()};
  const std::vector<double>& numbers = *all;
  if (numbers.size() != 2 && numbers.size() != 6)
    return unexpected{
        fmt::format("needs lo,hi or x0,x1,y0,y1,z0,z1, not {} numbers", numbers.size())};
  octree::box b{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t first = numbers.size() == 6 ? 2 * a : 0;
    b.lo[a] = numbers[first];
    b.hi[a] = numbers[first + 1];
  }
  if (const support::status may = check_domain(b); !may)
    return unexpected{may.reason()};
  return b;
}

} // namespace graze::render
