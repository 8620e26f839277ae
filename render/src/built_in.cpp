// The scenes of the surfaces that are built in.
#include <graze/octree/surfaces.hpp>
#include <graze/render/scene.hpp>

namespace graze::render {
namespace {

/// The colours of the six scenes' bodies; others have the default.
struct painted {
  std::string_view name;
  colour body;
};
constexpr painted bodies[] = {
    {"spheres", {0.80, 0.16, 0.10}},       {"quartdef", {0.10, 0.42, 0.75}},
    {"tanglecube", {0.85, 0.50, 0.06}},    {"holesrot", {0.16, 0.55, 0.20}},
    {"asterisk(3,4)", {0.70, 0.20, 0.45}}, {"asterisk(9,18)", {0.80, 0.65, 0.15}},
};

colour body_of(std::string_view name) {
  for (const painted& p : bodies)
    if (p.name == name)
      return p.body;
  return default_body;
}

} // namespace

std::span<const scene> scenes() {
  static const std::vector<scene> table = [] {
    std::vector<scene> all;
    octree::for_each_built_in([&all](const auto& row) {
      const std::string name(row.name);
      all.push_back({name,
                     name,
                     row.domain(),
                     camera::standard(row.scale),
                     standard_lights(row.scale),
                     {{name, std::nullopt, {body_of(name)}}},
                     {},
                     default_background,
                     {},
                     false,
                     std::nullopt});
    });
    return all;
  }();
  return table;
}

const scene* find_scene(std::string_view name) {
  for (const scene& s : scenes())
    if (s.name == name)
      return &s;
  return nullptr;
}

std::string scene_names() {
  std::string names;
  for (const scene& s : scenes())
    names += (names.empty() ? "" : ", ") + s.name;
  return names;
}

} // namespace graze::render
