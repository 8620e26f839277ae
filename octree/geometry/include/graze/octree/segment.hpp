#pragma once
/// The segment between two points.
#include <graze/needs_cxx20.hpp>

#include <cmath>
#include <graze/expected.hpp>
#include <graze/octree/vector.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::octree {

/// The points {from + t (to - from) : 0 <= t <= 1}, both ends included. The difference is that of
/// the real numbers: it is not rounded, and does not overflow. Units: scene length.
class segment {
public:
  /// Refuses ends that are not finite, and two equal ones.
  [[nodiscard]] static expected<segment> make(const vec3& from, const vec3& to) {
    bool apart = false;
    for (unsigned a = 0; a < 3; ++a) {
      if (!std::isfinite(from[a]) || !std::isfinite(to[a]))
        return unexpected{"an end of the segment is not finite"};
      apart |= !rounding::exact::equal(from[a], to[a]);
    }
    if (!apart)
      return unexpected{"the segment is a point: test a box that is flat on all axes instead, or "
                        "give the point as a ray_segment with first = last"};
    return segment(from, to);
  }
  [[nodiscard]] const vec3& from() const { return from_; }
  [[nodiscard]] const vec3& to() const { return to_; }

private:
  segment(const vec3& from, const vec3& to) : from_(from), to_(to) {}
  vec3 from_, to_;
};

} // namespace graze::octree
