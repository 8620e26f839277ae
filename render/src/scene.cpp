// What is made of a scene: its surface, and what casts rays at it.
#include "scene_surface.hpp"
#include "surface_caster.hpp"

#include <cmath>
#include <fmt/format.h>

namespace graze::render {
namespace {

using backend = octree::kernel_backend;

std::string text_of(const solid& shape, const std::vector<object>& objects) {
  if (shape.form == solid::kind::single)
    return fmt::format("({})", objects[shape.single].formula->text());
  if (shape.form == solid::kind::subtract) {
    std::string rest = text_of(shape.parts.front(), objects);
    for (std::size_t i = 1; i < shape.parts.size(); ++i)
      rest = fmt::format("difference({},{})", rest, text_of(shape.parts[i], objects));
    return rest;
  }
  std::vector<std::string> parts;
  for (const solid& part : shape.parts)
    parts.push_back(text_of(part, objects));
  return fmt::format("{}({})", shape.form == solid::kind::unite ? "union" : "intersection",
                     fmt::join(parts, ","));
}

/// The value of the whole and the object that it comes from: the least of a union's, the greatest
/// of an intersection's, of a - b - ... the greatest of a, -b, ...
struct active {
  double value;
  std::size_t object;
};
active active_at(const solid& shape, std::span<const double> values) {
  if (shape.form == solid::kind::single)
    return {values[shape.single], shape.single};
  active found = active_at(shape.parts.front(), values);
  for (std::size_t i = 1; i < shape.parts.size(); ++i) {
    active next = active_at(shape.parts[i], values);
    if (shape.form == solid::kind::subtract)
      next.value = -next.value;
    if (shape.form == solid::kind::unite ? next.value < found.value : next.value > found.value)
      found = next;
  }
  return found;
}

/// Whether a picture can show something: not where f is proven to have no zero in the domain, or
/// nothing at all is proven of it in any of 32^3 parts of the domain.
support::status check_surface(const octree::formula& whole, const octree::box& domain) {
  constexpr int parts = 32;
  const octree::formula_surface f = whole.surface();
  [[maybe_unused]] const backend::scope scope;
  const auto face = [&](std::size_t a, int i) {
    return i == parts ? domain.hi[a]
                      : domain.lo[a] + (domain.hi[a] - domain.lo[a]) * (1.0 / parts) * i;
  };
  bool possible = false;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      for (int k = 0; k < parts; ++k) {
        const octree::box b = {{face(0, i), face(1, j), face(2, k)},
                               {face(0, i + 1), face(1, j + 1), face(2, k + 1)}};
        if (octree::has_no_zero<backend>(f, b))
          continue;
        possible = true;
        if (f.continuous_on<backend>(octree::intervals<backend>(b)))
          return {};
      }
  if (!possible)
    return unexpected{"no surface: the formula is proven to have no zero in the domain"};
  return unexpected{
      "no surface can be proven: wherever the formula may be 0 in the domain, it divides by an "
      "interval that holds 0, or is not proven to be defined and continuous"};
}

template <class F>
expected<std::unique_ptr<caster>> make_caster(const octree::built_in_surface<F>& source,
                                              const octree::box& domain, int octree_level,
                                              int levels, method search) {
  return surface_caster<octree::built_in_surface<F>>::make(source, domain, octree_level, levels,
                                                           search);
}
/// Where a coarse octree of a formula has many leaves, since its surface is large or intervals can tell
/// little of it, it stays coarse: verdicts do not depend on the octree's level, and rays take no longer, but
/// a formula's leaves take microseconds each to find, and there are up to eight times as many a level.
expected<std::unique_ptr<caster>> make_caster(const octree::formula& source,
                                              const octree::box& domain, int octree_level,
                                              int levels, method search) {
  constexpr int coarse_level = 6;
  constexpr std::uint64_t most_coarse_leaves = 1 << 12; // of 2^18
  const auto make = [&](int level) {
    return surface_caster<octree::formula>::make(source, domain, level, levels, search);
  };
  if (search == method::certified || octree_level <= coarse_level)
    return make(octree_level);
  auto coarse = make(coarse_level);
  if (!coarse || (*coarse)->octree_leaves() > most_coarse_leaves)
    return coarse;
  return make(octree_level);
}

} // namespace

expected<octree::formula> whole_formula(const scene& s) {
  if (s.shape.form == solid::kind::single)
    return *s.objects[s.shape.single].formula;
  auto whole = octree::formula::parse(formula_text(s), nullptr, s.set);
  if (!whole)
    return unexpected{"all objects together: " + whole.reason()};
  return whole;
}

expected<octree::formula> proven_surface(const scene& s) {
  auto whole = whole_formula(s);
  if (!whole)
    return whole;
  if (const support::status may = check_surface(*whole, s.domain); !may)
    return unexpected{may.reason()};
  return whole;
}

std::string formula_text(const scene& s) {
  std::string text;
  octree::for_each_built_in([&](const auto& row) {
    if (row.name == s.built_in)
      text = row.formula;
  });
  if (!s.built_in.empty())
    return text;
  if (s.shape.form == solid::kind::single)
    return s.objects[s.shape.single].formula->text();
  return text_of(s.shape, s.objects);
}

std::string note_on(const scene& s) {
  std::vector<std::string> notes;
  for (const object& part : s.objects)
    if (part.formula)
      for (std::string& note : part.formula->notes(s.domain))
        if (std::find(notes.begin(), notes.end(), note) == notes.end())
          notes.push_back(std::move(note));
  constexpr std::size_t most = 3;
  const std::size_t others = notes.size() - std::min(notes.size(), most);
  notes.resize(notes.size() - others);
  return fmt::format("{}{}", fmt::join(notes, " "),
                     others != 0 ? fmt::format(" and {} more", others) : "");
}

std::size_t object_at(const scene& s, const vec3& point) {
  if (s.objects.size() == 1)
    return 0;
  std::vector<double> values;
  for (const object& part : s.objects)
    values.push_back(part.formula->surface()(point[0], point[1], point[2]));
  return active_at(s.shape, values).object;
}

expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels,
                                          method search) {
  return with_surface(s, [&](const auto& source) {
    return make_caster(source, s.domain, octree_level, levels, search);
  });
}

support::status check_domain(const octree::box& domain) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double lo = domain.lo[a], hi = domain.hi[a];
    if (!std::isfinite(lo) || !std::isfinite(hi) || std::max(std::fabs(lo), std::fabs(hi)) > 1e100)
      return unexpected{"the domain is not finite, or beyond 1e100"};
    if (!(lo < hi))
      return unexpected{fmt::format("the domain is empty: {} from {} to {}", "xyz"[a], lo, hi)};
  }
  return {};
}

namespace {
/// A little less than half the longest side, as for the scenes of the table; and the middle.
std::pair<double, vec3> scale_and_middle(const octree::box& domain) {
  double longest = 0;
  vec3 middle;
  for (std::size_t a = 0; a < 3; ++a) {
    longest = std::max(longest, domain.hi[a] - domain.lo[a]);
    middle[a] = domain.lo[a] / 2 + domain.hi[a] / 2;
  }
  return {0.4375 * longest, middle};
}
} // namespace

camera fitting_camera(const octree::box& domain) {
  const auto [scale, middle] = scale_and_middle(domain);
  camera view = camera::standard(scale);
  for (std::size_t a = 0; a < 3; ++a)
    view.eye[a] += middle[a];
  return view;
}

std::vector<light> fitting_lights(const octree::box& domain) {
  const auto [scale, middle] = scale_and_middle(domain);
  std::vector<light> lights = standard_lights(scale);
  for (light& lamp : lights)
    for (std::size_t a = 0; a < 3; ++a)
      lamp.position[a] += middle[a];
  return lights;
}

} // namespace graze::render
