#include "scene_options.hpp"

#include <fmt/format.h>
#include <graze/render/scene_text.hpp>
#include <graze/support/files.hpp>
#include <graze/support/text.hpp>

namespace graze::render {
namespace {

constexpr const char* default_domain = "-2,2";

using parameters = std::vector<octree::parameter>;

/// Of "a=0.3" each.
expected<parameters> parameters_from(const std::vector<std::string>& texts, formula_mark& where) {
  parameters all;
  const auto trimmed = [](std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
  };
  for (const std::string_view text : texts) {
    const auto sign = text.find('=');
    if (sign == text.npos)
      return unexpected{
          fmt::format("--set {}: needs a name and a value, as in a=0.3", support::shown(text))};
    where.text = trimmed(text.substr(sign + 1));
    auto made = octree::parameter::make(trimmed(text.substr(0, sign)), where.text, &where.column);
    if (!made)
      return unexpected{"--set: " + made.reason()};
    for (const octree::parameter& other : all)
      if (other.name == made->name)
        return unexpected{fmt::format("--set {}: is given twice", made->name)};
    all.push_back(*std::move(made));
  }
  return in_order(std::move(all));
}

expected<scene> scene_in_file(const std::string& name, const parameters& set, formula_mark& where) {
  const auto text = support::read_file(name, largest_scene_text);
  if (!text)
    return unexpected{text.reason()};
  auto found = scene_from(*text, set, &where);
  if (!found)
    return unexpected{fmt::format("{}: {}", support::shown(name), found.reason())};
  return found;
}

expected<scene> scene_of_formula(const std::string& text, const std::string& domain,
                                 const parameters& set, formula_mark& where) {
  where = {text, 0};
  auto parsed = octree::formula::parse(text, &where.column, set);
  if (!parsed)
    return unexpected{"--formula: " + parsed.reason()};
  where = {};
  const auto box = domain_from(domain);
  if (!box)
    return unexpected{"--domain: " + box.reason()};
  scene s{"formula",
          "",
          *box,
          fitting_camera(*box),
          fitting_lights(*box),
          {{"surface", *std::move(parsed), material{default_body}}},
          {}};
  s.set = set;
  if (const support::status may = check_set(s); !may)
    return unexpected{"--set: " + may.reason()};
  return s;
}

} // namespace

std::vector<CLI::Option*> scene_options::declare(CLI::App& app) {
  return {app.add_option("--scene", scene, "One of " + scene_names() + ",\nor a .json file"),
          app.add_option(
              "--formula", formula,
              "The surface f = 0 or f = g, such as \"x^2 + |y|*z = 1\"; what can be written:\n"
              "docs/formulas.md"),
          app.add_option("--domain", domain,
                         fmt::format("Of --formula: lo,hi for all axes, or x0,x1,y0,y1,z0,z1 (as "
                                     "--domain=-1,1); without it {}",
                                     default_domain)),
          app.add_option(
                 "--set", set,
                 "a=0.3: the value of a name in the formulas, a constant (0.3, 1/3, sqrt(5)) that\n"
                 "is taken exactly; once for each name, before those of a scene file")
              ->allow_extra_args(false)};
}

support::status scene_options::check() const {
  if (!domain.empty() && formula.empty())
    return unexpected{"--domain is of --formula"};
  if (!set.empty() && count() == 0)
    return unexpected{"--set is of --formula and --scene"};
  return {};
}

expected<scene> scene_options::read(formula_mark* where) const {
  formula_mark unused;
  formula_mark& mark = where != nullptr ? *where : unused;
  const auto parameters = parameters_from(set, mark);
  if (!parameters)
    return unexpected{parameters.reason()};
  if (!formula.empty())
    return scene_of_formula(formula, domain.empty() ? default_domain : domain, *parameters, mark);
  if (const render::scene* s = find_scene(scene); s != nullptr) {
    if (!set.empty())
      return unexpected{fmt::format("--set: {} has no names to be set", scene)};
    return *s;
  }
  if (scene.ends_with(".json"))
    return scene_in_file(scene, *parameters, mark);
  return unexpected{fmt::format("unknown scene '{}'; there are {}, and files that end in .json",
                                scene, scene_names())};
}

} // namespace graze::render
