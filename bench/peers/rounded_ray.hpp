#pragma once
/// What becomes of a ray in the hands of a library that keeps it in another form.
#include <cmath>
#include <graze/octree/ray.hpp>
#include <optional>

namespace graze::bench {

/// Not inlined: at -O3, gcc 12.2 drops both conversions where it vectorises two of them (a pair of
/// y and z came back in double precision; -O2 and -fno-tree-slp-vectorize do not).
[[gnu::noinline]] inline double single(double x) {
  return static_cast<double>(static_cast<float>(x));
}
inline octree::vec3 single(const octree::vec3& v) {
  return {single(v[0]), single(v[1]), single(v[2])};
}

inline std::optional<octree::ray> ray_if_any(const octree::vec3& origin,
                                             const octree::vec3& direction) {
  if (const auto r = octree::ray::make(origin, direction))
    return *r;
  return std::nullopt;
}

/// The ray from one point through another, if their difference is a triple of doubles.
inline std::optional<octree::ray> ray_by_points(const octree::vec3& from, const octree::vec3& to) {
  octree::vec3 d{};
  for (unsigned a = 0; a < 3; ++a) {
    d[a] = to[a] - from[a];
    const double part = d[a] - to[a]; // the error of a difference (Knuth)
    if (!std::isfinite(d[a]) || (to[a] - (d[a] - part)) - (from[a] + part) != 0)
      return std::nullopt;
  }
  return ray_if_any(from, d);
}

} // namespace graze::bench
