#pragma once
/// What intervals prove about a surface: enclosures of f and of its gradient on a box, certified
/// signs at points, and what they say about the zeros in a box. Every function here is called
/// within a scope of the backend of its interval type.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <graze/octree/box.hpp>
#include <graze/octree/children.hpp>
#include <graze/octree/dual.hpp>
#include <graze/octree/surface.hpp>

namespace graze::octree {

/// The interval type whose operations leave the rounding mode alone.
template <rounding::Backend B> using bound = graze::unprotected<B>;
template <rounding::Backend B> using bound3 = std::array<bound<B>, 3>;

/// f has no zero where its enclosure is v. False also for a NaN bound: nothing is proven then.
template <class I> [[nodiscard]] bool excludes_zero(const I& v) {
  return v.lower() > 0 || v.upper() < 0;
}

/// -1 or +1 where every number in v has that sign; 0 where it is unknown.
template <class I> [[nodiscard]] int certified_sign(const I& v) {
  return v.lower() > 0 ? 1 : (v.upper() < 0 ? -1 : 0);
}

template <rounding::Backend B> [[nodiscard]] bound3<B> intervals(const box& b) {
  return {bound<B>(b.lo[0], b.hi[0]), bound<B>(b.lo[1], b.hi[1]), bound<B>(b.lo[2], b.hi[2])};
}

/// Encloses { f(p) : p in x }: the natural interval extension.
template <rounding::Backend B, Surface F>
[[nodiscard]] bound<B> natural_extension(const F& f, const bound3<B>& x) {
  return f(x[0], x[1], x[2]);
}

/// Encloses f and its three partial derivatives on x.
template <rounding::Backend B, Surface F>
[[nodiscard]] dual<bound<B>> value_and_gradient(const F& f, const bound3<B>& x) {
  using d = dual<bound<B>>;
  return f(d::variable(x[0], 0), d::variable(x[1], 1), d::variable(x[2], 2));
}

namespace detail {
/// A number of [lo, hi] near its middle. Halves are added, since the sum may overflow, and the
/// result is clamped, since halves of subnormal numbers are rounded.
template <class P>
GRAZE_BATCH_INLINE typename P::vector centre(typename P::vector lo, typename P::vector hi) {
  const auto half = P::broadcast(0.5);
  return P::min_or_second(P::max_or_second(P::add_up(P::mul_up(lo, half), P::mul_up(hi, half)), lo),
                          hi);
}
} // namespace detail

/// Encloses { f(p) : p in x } by f(c) + gradient(x) . (x - c), c a point of x near its centre.
template <rounding::Backend B, Surface F>
[[nodiscard]] bound<B> mean_value_form(const F& f, const bound3<B>& x, const bound3<B>& gradient) {
  bound3<B> centre;
  for (int a = 0; a < 3; ++a)
    centre[a] = bound<B>(detail::centre<scalar_path<B>>(x[a].lower(), x[a].upper()));
  bound<B> r = natural_extension<B>(f, centre);
  for (int a = 0; a < 3; ++a)
    r = r + gradient[a] * (x[a] - centre[a]);
  return r;
}

/// True only if f is proven to have no zero in b: by the natural extension or, where that may be
/// loose, by the mean value form.
template <rounding::Backend B, Surface F> [[nodiscard]] bool has_no_zero(const F& f, const box& b) {
  const bound3<B> x = intervals<B>(b);
  if (excludes_zero(natural_extension<B>(f, x)))
    return true;
  if constexpr (!natural_extension_suffices<F>())
    return !natural_extension_suffices(f) &&
           excludes_zero(mean_value_form<B>(f, x, value_and_gradient<B>(f, x).partial));
  return false;
}

/// Proven: f is defined and continuous on all of x, so that opposite signs in x mean a zero there.
template <rounding::Backend B, Surface F>
[[nodiscard]] bool is_continuous_on(const F& f, const bound3<B>& x) {
  if constexpr (requires { f.template continuous_on<B>(x); })
    return f.template continuous_on<B>(x);
  return is_continuous(f);
}

/// The sign of f at a point, proven; 0 where it is unknown, which a zero always is.
template <rounding::Backend B, Surface F>
[[nodiscard]] int certified_sign_at(const F& f, const vec3& p) {
  return certified_sign(f(bound<B>(p[0]), bound<B>(p[1]), bound<B>(p[2])));
}

/// The paper's last-level test (section 2.5), made rigorous: opposite certified signs at two
/// corners prove a zero; all eight equal and f proven monotone in each variable prove that there is
/// none, since f then lies between its values at two corners. The paper's test in doubles proves
/// neither.
template <rounding::Backend B, Surface F>
[[nodiscard]] content leaf_content(const F& f, const box& b) {
  unsigned positive = 0, negative = 0;
  for (const unsigned corner : {0u, 7u, 1u, 6u, 2u, 5u, 3u, 4u}) { // far corners differ soonest
    const int sign = certified_sign_at<B>(f, b.corner(corner));
    positive += sign > 0;
    negative += sign < 0;
    if (positive != 0 && negative != 0)
      return is_continuous_on<B>(f, intervals<B>(b)) ? content::certified : content::possible;
  }
  if (positive != 8 && negative != 8)
    return content::possible;
  const bound3<B> x = intervals<B>(b);
  const dual<bound<B>> at = value_and_gradient<B>(f, x);
  const bool monotone = certified_sign(at.partial[0]) != 0 && certified_sign(at.partial[1]) != 0 &&
                        certified_sign(at.partial[2]) != 0;
  if (monotone || excludes_zero(mean_value_form<B>(f, x, at.partial)))
    return content::none;
  return content::possible;
}

/// The gradient of f at p, which is normal to the surface there; not of unit length. Rounded to
/// nearest, no bound: for shading.
template <Surface F> [[nodiscard]] vec3 normal(const F& f, const vec3& p) {
  using d = dual<double>;
  return f(d::variable(p[0], 0), d::variable(p[1], 1), d::variable(p[2], 2)).partial;
}

} // namespace graze::octree
