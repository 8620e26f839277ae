// Roots on the domain's faces: the t at which a ray enters or leaves is rounded, but one coordinate
// of the point there is the face's.
#include "closer_look.hpp"

#include <array>
#include <graze/octree/along_ray.hpp>
#include <graze/octree_formula.hpp>
#include <limits>

namespace graze::octree::closer_look {
namespace {

using up = rounding::upward;
using along = along_ray<formula_surface, up>;

/// Where the ray passes a face, at a t in [near, far].
struct crossing {
  double near, far;
  bound3<up> point;
};

/// Where the ray leaves, or enters, the domain, if that is proven to be through one face.
std::optional<crossing> crossing_of(const along& g, const ray& r, const box& domain, bool leaves) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<crossing, 3> planes{};
  for (int a = 0; a < 3; ++a) {
    box slab{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    slab.lo[a] = domain.lo[a];
    slab.hi[a] = domain.hi[a];
    const ray_span s = g.within(slab);
    planes[a].near = leaves ? s.exit_down : s.entry_down;
    planes[a].far = leaves ? s.exit_up : s.entry_up;
  }
  for (int a = 0; a < 3; ++a) {
    const double d = r.direction()[a];
    crossing& c = planes[a];
    bool is_face = d != 0 && c.near > 0;
    for (int b = 0; b < 3; ++b)
      is_face = is_face && (a == b || (leaves ? c.far <= planes[b].near : planes[b].far <= c.near));
    if (!is_face)
      continue;
    c.point = g.points(c.near, c.far);
    c.point[a] = bound<up>((d > 0) == leaves ? domain.hi[a] : domain.lo[a]);
    return c;
  }
  return std::nullopt;
}

} // namespace

std::optional<certified_hit> at_face(const tape::program& f, const ray& r, const box& domain,
                                     const certified_hit& found) {
  if (found.outcome != verdict::undecided)
    return std::nullopt;
  [[maybe_unused]] const up::scope scope;
  const formula_surface surface(f);
  const along g(surface, r);
  const ray_span inside = g.within(domain);
  for (const bool leaves : {false, true}) {
    const auto c = crossing_of(g, r, domain, leaves);
    if (!c || c->far < found.t_near || found.t_far < c->near ||
        !(leaves ? inside.entry_up <= c->near : c->far <= inside.exit_down))
      continue;
    const bound<up> value = surface(c->point[0], c->point[1], c->point[2]);
    if (value.lower() != 0 || value.upper() != 0 || !surface.continuous_on<up>(c->point))
      continue;
    // none is before the least of what found has; entered, it is the first one anyway
    const double near = leaves ? found.t_near : c->near;
    return certified_hit{verdict::hit, g.is_monotone(near, c->far), near, c->far};
  }
  return std::nullopt;
}

} // namespace graze::octree::closer_look
