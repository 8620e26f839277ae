// Scenes of formulas.
#include "casters.hpp"

#include <cmath>
#include <fmt/format.h>
#include <graze/octree_formula.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

namespace graze::render {
namespace {

using octree::formula, octree::formula_surface;
using backend = octree::kernel_backend;

/// The scene's formulas, compiled; they outlive the surfaces made of them.
struct compiled {
  formula whole;
  std::vector<formula> parts; ///< the objects', by index
};

std::string text_of(const solid& shape, const std::vector<object>& objects) {
  if (shape.how == solid::kind::single)
    return fmt::format("({})", objects[shape.single].formula);
  if (shape.how == solid::kind::subtract) {
    std::string rest = text_of(shape.parts.front(), objects);
    for (std::size_t i = 1; i < shape.parts.size(); ++i)
      rest = fmt::format("difference({},{})", rest, text_of(shape.parts[i], objects));
    return rest;
  }
  std::vector<std::string> parts;
  for (const solid& part : shape.parts)
    parts.push_back(text_of(part, objects));
  return fmt::format("{}({})", shape.how == solid::kind::unite ? "union" : "intersection",
                     fmt::join(parts, ","));
}

/// The value of the whole and the object that it comes from: the least of a union's, the greatest
/// of an intersection's, of a - b - ... the greatest of a, -b, ...
struct active {
  double value;
  std::size_t object;
};
active active_at(const solid& shape, std::span<const double> values) {
  if (shape.how == solid::kind::single)
    return {values[shape.single], shape.single};
  active found = active_at(shape.parts.front(), values);
  for (std::size_t i = 1; i < shape.parts.size(); ++i) {
    active next = active_at(shape.parts[i], values);
    if (shape.how == solid::kind::subtract)
      next.value = -next.value;
    if (shape.how == solid::kind::unite ? next.value < found.value : next.value > found.value)
      found = next;
  }
  return found;
}

/// A lane_caster beside the formulas to which its surface refers.
class formula_caster final : public caster {
public:
  formula_caster(compiled text, solid shape, std::unique_ptr<lane_caster<formula_surface>> work)
      : text_(std::move(text)), shape_(std::move(shape)), work_(std::move(work)) {}

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    work_->first_hits(rays, hits, counts);
  }
  vec3 gradient(const vec3& point) const override { return work_->gradient(point); }
  void depart(std::span<const octree::ray> rays, std::span<const octree::surface_hit> hits,
              std::span<departure> departures) const override {
    work_->depart(rays, hits, departures);
  }
  std::size_t object_at(const vec3& point) const override {
    if (text_.parts.size() == 1)
      return 0;
    std::vector<double> values;
    for (const formula& part : text_.parts)
      values.push_back(part.surface()(point[0], point[1], point[2]));
    return active_at(shape_, values).object;
  }
  std::uint64_t octree_leaves() const override { return work_->octree_leaves(); }

private:
  compiled text_;
  solid shape_;
  std::unique_ptr<lane_caster<formula_surface>> work_;
};

/// Where intervals can tell little of a formula, so that a coarse octree is nearly full, it stays
/// coarse: verdicts do not depend on the octree's level, but its memory does.
expected<std::unique_ptr<lane_caster<formula_surface>>> make_lane_caster(const formula_surface& f,
                                                                         const octree::box& domain,
                                                                         int octree_level,
                                                                         int levels, method by) {
  constexpr int coarse_level = 6;
  constexpr std::uint64_t most_coarse_leaves = 1 << 16; // of 2^18
  if (by == method::certified)
    return lane_caster<formula_surface>::make(f, domain, octree_level, levels, by);
  auto coarse = lane_caster<formula_surface>::make(f, domain, std::min(octree_level, coarse_level),
                                                   levels, by);
  if (!coarse || octree_level <= coarse_level || (*coarse)->octree_leaves() > most_coarse_leaves)
    return coarse;
  return lane_caster<formula_surface>::make(f, domain, octree_level, levels, by);
}

expected<compiled> compile(const scene& s) {
  std::vector<formula> parts;
  for (const object& o : s.objects) {
    auto part = formula::parse(o.formula);
    if (!part)
      return unexpected{part.reason()};
    parts.push_back(*std::move(part));
  }
  auto whole = formula::parse(formula_of(s));
  if (!whole)
    return unexpected{"all objects together: " + whole.reason()};
  return compiled{*std::move(whole), std::move(parts)};
}

/// Whether a picture can show something: not where f is proven to have no zero in the domain, or
/// nothing at all is proven of it in any of 32^3 parts of the domain.
support::status check_surface(const formula_surface& f, const octree::box& domain) {
  constexpr int parts = 32;
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

} // namespace

std::string formula_of(const scene& s) {
  if (!s.built_in.empty() || s.shape.how == solid::kind::single)
    return s.objects[s.shape.single].formula;
  return text_of(s.shape, s.objects);
}

expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels, method by) {
  if (const support::status may = check_domain(s.domain); !may)
    return unexpected{may.reason()};
  if (!s.built_in.empty())
    return prepare_built_in(s, octree_level, levels, by);
  auto text = compile(s);
  if (!text)
    return unexpected{text.reason()};
  if (const support::status may = check_surface(text->whole.surface(), s.domain); !may)
    return unexpected{may.reason()};
  auto work = make_lane_caster(text->whole.surface(), s.domain, octree_level, levels, by);
  if (!work)
    return unexpected{work.reason()};
  return std::unique_ptr<caster>(
      std::make_unique<formula_caster>(*std::move(text), s.shape, *std::move(work)));
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
