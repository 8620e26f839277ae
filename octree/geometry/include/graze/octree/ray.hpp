#pragma once
/// The ray {origin + t direction : t real, t >= 0}.
#include <graze/needs_cxx20.hpp>

#include <cmath>
#include <graze/expected.hpp>
#include <graze/octree/vector.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::octree {

/// A ray with finite components and a direction other than 0. Any finite double is legal,
/// subnormals and 1e308 included. Units: scene length; the direction need not be normalized.
class ray {
public:
  /// Refuses NaN, infinity, and the direction (0,0,0), with the reason.
  [[nodiscard]] static expected<ray> make(const vec3& origin, const vec3& direction) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(origin[axis]))
        return unexpected{"ray origin is not finite"};
      if (!std::isfinite(direction[axis]))
        return unexpected{"ray direction is not finite"};
    }
    using rounding::exact::is_zero; // subnormal numbers are none, in any environment
    if (is_zero(direction[0]) && is_zero(direction[1]) && is_zero(direction[2]))
      return unexpected{"ray direction is zero"};
    return ray(origin, direction);
  }

  [[nodiscard]] const vec3& origin() const { return origin_; }
  [[nodiscard]] const vec3& direction() const { return direction_; }

private:
  ray(const vec3& origin, const vec3& direction) : origin_(origin), direction_(direction) {}
  vec3 origin_, direction_;
};

} // namespace graze::octree
