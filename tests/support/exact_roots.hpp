#pragma once
/// The exact first root of a scene's surface along a ray.
#include <graze/octree/box.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/oracle/polynomial.hpp>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/roots.hpp>
#include <optional>
#include <type_traits>
#include <vector>

namespace support {

/// The surface along a ray as polynomials: its zeros are theirs (for the union of spheres, seen
/// from outside, the first zero is the first of all nine).
template <class F>
std::vector<graze::oracle::polynomial> along(const F& f, const graze::octree::ray& r) {
  const auto [x, y, z] = graze::oracle::along(r.origin(), r.direction());
  if constexpr (std::is_same_v<F, graze::octree::spheres>) {
    std::vector<graze::oracle::polynomial> parts;
    for (const auto& s : F::parts)
      parts.push_back(F::part(s, x, y, z));
    return parts;
  } else {
    return {f(x, y, z)};
  }
}

/// The least t >= 0 within the closed domain at which f = 0 on the ray, to 2^-100.
template <class F>
std::optional<graze::oracle::root> first_root(const F& f, const graze::octree::ray& r,
                                              const graze::octree::box& domain) {
  const auto range =
      graze::oracle::rational::range_in(r.origin(), r.direction(), domain.lo, domain.hi);
  std::optional<graze::oracle::root> least;
  if (!range)
    return least;
  for (const auto& g : along(f, r))
    if (auto root = graze::oracle::first_root(g, range->first, range->second, 100))
      if (!least || root->lo < least->lo)
        least = std::move(root);
  return least;
}

} // namespace support
