#pragma once
/// What is proven of the point that a ray hits, in doubles.
#include <graze/octree/along_ray.hpp>
#include <graze/octree/surface_traversal.hpp>
#include <limits>

namespace graze::render {

/// Bounds, each below and above. NaN where nothing is proven: of what was not cast all, of what is no
/// hit point and normal, of a hit the normal where f's gradient is not proven to differ from 0.
struct proof {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  /// Of the distance from the ray's origin to the first root; of an undecided ray to where one may be;
  /// infinity and infinity where there is none. Scene length.
  double depth_lower = none, depth_upper = none;
  octree::box point{{none, none, none}, {none, none, none}}; ///< holds the first root
  /// Of grad f / |grad f| at the first root, a component at a time: towards where f > 0, not towards the
  /// eye. Of a crease both sides' normals, and what is between.
  octree::box normal{{none, none, none}, {none, none, none}};
};

namespace detail {
/// Encloses g[a] / |g| over g, from g[a] and the sum of the others' squares, in which it is monotone.
/// Within [-1, 1]. Error: some ulps.
template <rounding::Backend B>
octree::bound<B> unit_component(const octree::bound3<B>& g, std::size_t a) {
  double least = 0, most = 0; // of the others' squares
  for (std::size_t other = 0; other < 3; ++other) {
    if (other == a)
      continue;
    const double lo = g[other].lower(), hi = g[other].upper();
    const double far = std::max(-lo, hi), near = lo > 0 ? lo : hi < 0 ? -hi : 0;
    least = B::add_down(least, B::mul_down(near, near));
    most = B::add_up(most, B::mul_up(far, far));
  }
  // |x| / sqrt(x^2 + others): rises with |x|, falls with the others
  const auto down = [&](double x) {
    const double part = B::div_down(x, B::sqrt_up(B::add_up(B::mul_up(x, x), most)));
    return part > 0 ? std::min(part, 1.0) : 0.0; // of NaN, inf / inf, nothing is known
  };
  const auto up = [&](double x) {
    const double part = B::div_up(x, B::sqrt_down(B::add_down(B::mul_down(x, x), least)));
    return part < 1 ? part : 1.0;
  };
  const double lo = g[a].lower(), hi = g[a].upper();
  return octree::bound<B>(lo > 0   ? down(lo)
                          : lo < 0 ? -up(-lo)
                                   : 0.0,
                          hi < 0   ? -down(-hi)
                          : hi > 0 ? up(hi)
                                   : 0.0);
}
} // namespace detail

/// Of a ray and how it ended. Within a scope of B.
template <octree::Surface F, rounding::Backend B>
[[nodiscard]] proof prove(const F& f, const octree::ray& r, const octree::surface_hit& hit) {
  proof p;
  p.depth_lower = p.depth_upper = std::numeric_limits<double>::infinity();
  if (octree::is_free(hit.outcome))
    return p;
  double least = 0, most = 0; // of the direction's square
  for (const double d : r.direction()) {
    least = B::add_down(least, B::mul_down(d, d));
    most = B::add_up(most, B::mul_up(d, d));
  }
  p.depth_lower = B::mul_down(hit.t_near, B::sqrt_down(least));
  p.depth_upper = B::mul_up(hit.t_far, B::sqrt_up(most));
  if (hit.outcome != octree::verdict::hit)
    return p;
  const octree::bound3<B> at = octree::along_ray<F, B>(f, r).points(hit.t_near, hit.t_far);
  const octree::bound3<B> gradient = octree::value_and_gradient<B>(f, at).partial;
  bool known = true, differs = false;
  for (std::size_t a = 0; a < 3; ++a) {
    p.point.lo[a] = at[a].lower();
    p.point.hi[a] = at[a].upper();
    known = known && gradient[a].lower() <= gradient[a].upper();
    differs = differs || octree::excludes_zero(gradient[a]);
  }
  if (!known || !differs)
    return p;
  for (std::size_t a = 0; a < 3; ++a) {
    const octree::bound<B> n = detail::unit_component<B>(gradient, a);
    p.normal.lo[a] = n.lower();
    p.normal.hi[a] = n.upper();
  }
  return p;
}

} // namespace graze::render
