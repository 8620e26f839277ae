#include "scene_options.hpp"

#include <fmt/format.h>
#include <graze/render/scene_text.hpp>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>

namespace graze::render {
namespace {

constexpr const char* default_domain = "-2,2";

expected<scene> scene_in_file(const std::string& name) {
  const auto text = support::read_file(name, largest_scene_text);
  if (!text)
    return unexpected{text.reason()};
  auto found = scene_from(*text);
  if (!found)
    return unexpected{fmt::format("{}: {}", support::shown(name), found.reason())};
  return found;
}

expected<scene> scene_of_formula(const std::string& text, const std::string& domain) {
  auto parsed = octree::formula::parse(text);
  if (!parsed)
    return unexpected{"--formula: " + parsed.reason()};
  const auto box = domain_from(domain);
  if (!box)
    return unexpected{"--domain: " + box.reason()};
  return scene{"formula",
               "",
               *box,
               fitting_camera(*box),
               fitting_lights(*box),
               {{"surface", *std::move(parsed), material{default_body}}},
               {}};
}

} // namespace

std::vector<CLI::Option*> scene_options::declare(CLI::App& app) {
  return {
      app.add_option("--scene", scene, "One of " + scene_names() + ",\nor a .json file"),
      app.add_option("--formula", formula, "The surface f = 0, such as \"x^2 + y^2 + z^2 - 1\""),
      app.add_option("--domain", domain,
                     fmt::format("Of --formula: lo,hi for all axes, or x0,x1,y0,y1,z0,z1 (as "
                                 "--domain=-1,1); without it {}",
                                 default_domain))};
}

support::status scene_options::check() const {
  if (!domain.empty() && formula.empty())
    return unexpected{"--domain is of --formula"};
  return {};
}

expected<scene> scene_options::read() const {
  if (!formula.empty())
    return scene_of_formula(formula, domain.empty() ? default_domain : domain);
  if (const render::scene* s = find_scene(scene); s != nullptr)
    return *s;
  if (scene.ends_with(".json"))
    return scene_in_file(scene);
  return unexpected{fmt::format("unknown scene '{}'; there are {}, and files that end in .json",
                                scene, scene_names())};
}

} // namespace graze::render
