#pragma once
/// A segment of a ray, and exact decisions about it.
#include <graze/needs_cxx20.hpp>

#include <cmath>
#include <graze/octree/exact_sum.hpp>
#include <graze/octree/exact_touch.hpp>
#include <limits>

namespace graze::octree {

/// The points of a ray with first <= t <= last, both included. Units: the ray's own parameter.
class ray_segment {
public:
  /// The whole ray.
  ray_segment() = default;
  /// Refuses NaN, first < 0, first infinite, and last < first.
  [[nodiscard]] static expected<ray_segment> make(double first, double last) {
    using rounding::exact::is_zero,
        rounding::exact::less; // no subnormal number is 0, in any environment
    if (!rounding::exact::finite(first) || less(first, 0))
      return unexpected{"a segment begins at a finite t >= 0"};
    if (std::isnan(last) || less(last, first))
      return unexpected{"a segment ends before it begins"};
    ray_segment s;
    s.first_ = is_zero(first) ? 0 : first; // no negative zero
    s.last_ = last;
    return s;
  }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; } ///< may be infinite
  [[nodiscard]] bool whole() const {
    return rounding::exact::is_zero(first_) && last_ == std::numeric_limits<double>::infinity();
  }

private:
  double first_ = 0, last_ = std::numeric_limits<double>::infinity();
};

namespace detail {
/// The sign of o + t d - p; exact, for all finite operands.
inline int side_at(double o, double d, double t, double p) {
  exact_sum s;
  s.add(o);
  s.add_product(t, d);
  s.add(-p);
  return s.sign();
}
} // namespace detail

/// The segment has a point in the closed cube (`closed`), or in the half-open one (`owned`; see
/// exact_touch::owns for closed_far). Exact, for every finite ray, in every rounding mode.
/// The parts of the line of t that lie in the cube on each axis, and the segment, are four
/// intervals; they have a common point if and only if any two of them have (Helly in one
/// dimension). The exact ray/octant test decides on three; here each meets the segment.
template <convention C>
[[nodiscard]] bool segment_meets(const exact_touch& touch, const ray& r, const ray_segment& s,
                                 const cube& c, unsigned closed_far) {
  if (!touch.meets<C>(c, closed_far))
    return false;
  if (s.whole())
    return true;
  for (unsigned a = 0; a < 3; ++a) {
    const double o = r.origin()[a], d = r.direction()[a];
    const double lo = c.lo[a], hi = c.hi(static_cast<int>(a));
    if (d == 0)
      continue;
    const bool hi_closed = C == convention::closed || (closed_far >> a & 1) != 0;
    // where the segment begins and ends, relative to the plane that it must not have passed or must
    // have reached
    const double far = d > 0 ? hi : lo, near = d > 0 ? lo : hi;
    const bool far_closed = d > 0 ? hi_closed : true, near_closed = d > 0 ? true : hi_closed;
    const int along = d > 0 ? 1 : -1;
    if (s.first() > 0) {
      const int beyond = along * detail::side_at(o, d, s.first(), far);
      if (beyond > 0 || (beyond == 0 && !far_closed))
        return false;
    }
    if (s.last() < std::numeric_limits<double>::infinity()) {
      const int reached = along * detail::side_at(o, d, s.last(), near);
      if (reached < 0 || (reached == 0 && !near_closed))
        return false;
    }
  }
  return true;
}

} // namespace graze::octree
