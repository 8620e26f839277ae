#pragma once
/// A scene's surface in its own type, for what is compiled for each.
#include <graze/octree/surfaces.hpp>
#include <graze/octree_formula.hpp>
#include <graze/render/scene.hpp>

namespace graze::render {

/// The formula of the whole, for a scene of formulas: of one object, its own.
expected<octree::formula> whole_formula(const scene& s);
/// The same. Refuses one of which it is proven that there is
/// no surface in the domain, or nothing at all.
expected<octree::formula> proven_surface(const scene& s);

/// visit(source), whose surface() is the scene's: a built_in_surface, or a formula that its surface
/// refers to. Refuses, with the reason, an empty domain, an unknown surface, and what proven_surface
/// refuses. `visit` gives an expected.
template <class Visit>
auto with_surface(const scene& s, Visit&& visit)
    -> decltype(visit(std::declval<const octree::formula&>())) {
  using result = decltype(visit(std::declval<const octree::formula&>()));
  if (const support::status may = check_domain(s.domain); !may)
    return unexpected{may.reason()};
  if (s.built_in.empty()) {
    const auto whole = proven_surface(s);
    return whole ? visit(*whole) : result(unexpected{whole.reason()});
  }
  result made = unexpected{"there is no surface '" + s.built_in + "'; there are " + scene_names()};
  octree::for_each_built_in([&](const auto& row) {
    if (row.name == s.built_in)
      made = visit(row);
  });
  return made;
}

} // namespace graze::render
