// Scenes of formulas.
#include "casters.hpp"

#include <cmath>
#include <fmt/format.h>
#include <graze/octree/lazy_octree.hpp>
#include <graze/octree_formula.hpp>

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

class formula_caster final : public surface_caster<formula_surface> {
public:
  using judge = octree::scalar_judge<formula_surface, backend>;
  using tree = octree::lazy_octree<judge>;
  using traversal =
      octree::surface_traversal<formula_surface, octree::sound<backend, octree::convention::owned>,
                                backend, tree>;

  static expected<std::unique_ptr<caster>> make(compiled text, const scene& s, int octree_level,
                                                int levels) {
    const auto root = octree::enclosing_root(s.domain, octree_level);
    if (!root)
      return unexpected{root.reason()};
    if (const auto deep = octree::enclosing_root(s.domain, levels); !deep)
      return unexpected{deep.reason()};
    return std::unique_ptr<caster>(new formula_caster(std::move(text), s, *root, levels));
  }

  void first_hits(std::span<const octree::ray> rays, std::span<octree::surface_hit> hits,
                  octree::traversal_counts* counts) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = work_.first_hit(rays[i], counts);
  }
  std::size_t object_at(const vec3& point) const override {
    if (text_.parts.size() == 1)
      return 0;
    std::vector<double> values;
    for (const formula& part : text_.parts)
      values.push_back(part.surface()(point[0], point[1], point[2]));
    return active_at(shape_, values).object;
  }
  std::uint64_t octree_leaves() const override { return tree_.decided_count(); }

private:
  formula_caster(compiled text, const scene& s, const octree::root_cube& root, int levels)
      : surface_caster(text.whole.surface(), s.domain), text_(std::move(text)), shape_(s.shape),
        tree_(judge(f_, domain_), root), work_(traversal::accepted(f_, domain_, tree_, levels)) {}

  compiled text_;
  solid shape_;
  tree tree_;
  traversal work_;
};

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

/// Why a picture would show nothing: f is proven to have no zero in the domain, or nothing at all
/// is proven of it in any of 32^3 parts of the domain. Empty if there may be a surface.
std::string objection_to(const formula_surface& f, const octree::box& domain) {
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
    return "no surface: the formula is proven to have no zero in the domain";
  return "no surface can be proven: wherever the formula may be 0 in the domain, it divides by an "
         "interval that holds 0, or is not proven to be defined and continuous";
}

} // namespace

std::string formula_of(const scene& s) {
  if (!s.built_in.empty() || s.shape.how == solid::kind::single)
    return s.objects[s.shape.single].formula;
  return text_of(s.shape, s.objects);
}

expected<std::unique_ptr<caster>> prepare(const scene& s, int octree_level, int levels) {
  if (const std::string why = objection_to(s.domain); !why.empty())
    return unexpected{why};
  if (!s.built_in.empty())
    return prepare_built_in(s, octree_level, levels);
  auto text = compile(s);
  if (!text)
    return unexpected{text.reason()};
  if (const std::string why = objection_to(text->whole.surface(), s.domain); !why.empty())
    return unexpected{why};
  return formula_caster::make(*std::move(text), s, octree_level, levels);
}

std::string objection_to(const octree::box& domain) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double lo = domain.lo[a], hi = domain.hi[a];
    if (!std::isfinite(lo) || !std::isfinite(hi) || std::max(std::fabs(lo), std::fabs(hi)) > 1e100)
      return "the domain is not finite, or beyond 1e100";
    if (!(lo < hi))
      return fmt::format("the domain is empty: {} from {} to {}", "xyz"[a], lo, hi);
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
