#pragma once
/// What becomes of a ray in the hands of a library that keeps it in another form.
#include <adapters/adapter.hpp>
#include <cmath>
#include <graze/octree/ray.hpp>
#include <optional>

namespace graze::peers {

using adapter::to_float;
using octree::vec3;

inline std::optional<octree::ray> ray_if_any(const vec3& origin, const vec3& direction) {
  if (const auto r = octree::ray::make(origin, direction))
    return *r;
  return std::nullopt;
}

/// The ray in float.
inline std::optional<octree::ray> ray_in_float(const octree::ray& r) {
  return ray_if_any(to_float(r.origin()), to_float(r.direction()));
}

/// x - y is a double. (Its error: Knuth.)
inline bool exact_difference(double x, double y) {
  const double difference = x - y, part = difference - x;
  return std::isfinite(difference) && (x - (difference - part)) - (y + part) == 0;
}

/// The ray from one point through another, if their difference is a triple of doubles.
inline std::optional<octree::ray> ray_by_points(const vec3& from, const vec3& to) {
  for (unsigned a = 0; a < 3; ++a)
    if (!exact_difference(to[a], from[a]))
      return std::nullopt;
  return ray_if_any(from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]});
}

} // namespace graze::peers
