// The six scenes of docs/definitions.md.
#include "casters.hpp"

#include <graze/octree/surfaces.hpp>

namespace graze::render {
namespace {

template <class Surface>
expected<std::unique_ptr<caster>> make_caster(const octree::box& domain, int octree_level,
                                              int levels, method by) {
  auto made = lane_caster<Surface>::make(Surface{}, domain, octree_level, levels, by);
  if (!made)
    return unexpected{made.reason()};
  return std::unique_ptr<caster>(*std::move(made));
}

struct row {
  scene what;
  expected<std::unique_ptr<caster>> (*make)(const octree::box&, int octree_level, int levels,
                                            method by);
};

template <class Surface>
row standard(const char* name, const char* formula, double scale, double half, const colour& body) {
  return {{name,
           name,
           {{-half, -half, -half}, {half, half, half}},
           camera::standard(scale),
           standard_lights(scale),
           {{name, formula, {body}}},
           {},
           default_background},
          make_caster<Surface>};
}

std::span<const row> rows() {
  static const std::vector<row> table = {
      standard<octree::spheres>(
          "spheres",
          "nine spheres: (0,0,0) r 1; (1.75,0,0), (-1.75,.25,0), (0,1.75,.25), (0,-1.75,0), "
          "(.25,0,1.75), (0,0,-1.75) r .625; (1.25,1.25,1.25), (-1.25,-1.25,1.25) r .375",
          1.5, 2.5, {0.80, 0.16, 0.10}),
      standard<octree::quartdef>("quartdef", "(x^2-1)^2+(y^2-1)^2+(z^2-1)^2-1", 1.125, 1.5,
                                 {0.10, 0.42, 0.75}),
      standard<octree::tanglecube>("tanglecube", "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8", 2, 2.5,
                                   {0.85, 0.50, 0.06}),
      standard<octree::holesrot>("holesrot", "x^3+y^3+z^3-x-y-z", 2, 2, {0.16, 0.55, 0.20}),
      standard<octree::asterisk<3, 4>>(
          "asterisk(3,4)", "sin(3*atan2(y,x))*sin(4*atan2(hypot(x,y),z)) - hypot(hypot(x,y),z)",
          0.5, 1, {0.70, 0.20, 0.45}),
      standard<octree::asterisk<9, 18>>(
          "asterisk(9,18)", "sin(9*atan2(y,x))*sin(18*atan2(hypot(x,y),z)) - hypot(hypot(x,y),z)",
          0.5, 1, {0.80, 0.65, 0.15}),
  };
  return table;
}

} // namespace

expected<std::unique_ptr<caster>> prepare_built_in(const scene& s, int octree_level, int levels,
                                                   method by) {
  for (const row& r : rows())
    if (r.what.built_in == s.built_in)
      return r.make(s.domain, octree_level, levels, by);
  return unexpected{"there is no surface '" + s.built_in + "'; there are " + scene_names()};
}

std::span<const scene> scenes() {
  static const std::vector<scene> table = [] {
    std::vector<scene> all;
    for (const row& r : rows())
      all.push_back(r.what);
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
