#pragma once
/// Where shadow rays and reflected rays begin, so that no sheet of the surface is skipped and the
/// one that was hit is not hit again by rounding. Proof: docs/render.md.
#include <graze/octree/along_ray.hpp>
#include <graze/octree/surface_traversal.hpp>

namespace graze::render {

/// A point from which rays leave a hit.
struct departure {
  octree::vec3 point;
  /// Proven bound of the distance from the exact point that was hit; scene length.
  double shift;
  /// The surface is free of `point`, and of a path from there to the point that was hit, but for
  /// that point itself.
  bool proven;
};

/// A departure from `hit`, which must be a proven hit of `r`: a double point beside the ray at a
/// parameter t before hit.t_near. That there is no zero on the ray in [t, t_near) is what first_hit
/// has proven; that there is none between the ray at t and the point, nor at either, is proven here
/// by f's enclosure on a box that holds both (or by the box being outside of the domain). t goes
/// back by the enclosure's width, at least 4 ulps, doubled until that proof succeeds; not proven
/// where the shift would exceed `longest`. Within a scope of B.
template <octree::Surface F, rounding::Backend B>
[[nodiscard]] departure depart(const F& f, const octree::box& domain, const octree::ray& r,
                               const octree::surface_hit& hit, double longest) {
  const octree::along_ray<F, B> g(f, r);
  const double ulps = 4 * (std::nextafter(hit.t_near, hit.t_far + 1) - hit.t_near);
  for (double back = std::max(hit.t_far - hit.t_near, ulps);; back += back) {
    const double t = std::max(0.0, hit.t_near - back);
    const octree::bound3<B> at = g.points(t, t), passed = g.points(t, hit.t_far);
    departure d{{}, 0, false};
    bool outside = false;
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double lo = at[a].lower(), hi = at[a].upper();
      d.point[a] = std::clamp(lo / 2 + hi / 2, lo, hi);
      const double reach = std::max(B::sub_up(d.point[a], passed[a].lower()),
                                    B::sub_up(passed[a].upper(), d.point[a]));
      square = B::add_up(square, B::mul_up(reach, reach));
      outside = outside || hi < domain.lo[a] || lo > domain.hi[a];
    }
    d.shift = B::sqrt_up(square);
    if (!(d.shift <= longest))
      return d;
    d.proven = outside || octree::excludes_zero(octree::natural_extension<B>(f, at));
    if (d.proven || t == 0)
      return d;
  }
}

} // namespace graze::render
