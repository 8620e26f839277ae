#pragma once
/// The exact ray/octant test: no octant too many, none too few, for every finite ray.
///
/// On each axis along which it moves, the ray is within a box from its arrival at one plane (enter)
/// to its arrival at the other (leave). It meets the box if and only if no leave lies before t = 0
/// and none lies before the enter of another axis: intervals that meet in pairs have a common
/// point. Each comparison is the sign of a 2x2 determinant (determinant_sign.hpp). Half-open boxes
/// differ only where two arrivals are equal.
#include <array>
#include <cmath>
#include <graze/octree/cube.hpp>
#include <graze/octree/determinant_sign.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/ray_bounds.hpp>

namespace graze::octree {

/// A ray prepared for exact decisions. May be made and asked in any rounding mode, and gives the
/// same answers in each; where subnormal operands count as zero (DAZ) they are not to be trusted
/// (rounding::refusal). A cube's lo + size must be exact doubles, as they are for every octant of a
/// root_cube.
class exact_touch {
public:
  explicit exact_touch(const ray& r) : origin_(r.origin()), direction_(r.direction()) {
    // Comparisons are homogeneous in the direction. A power of two keeps the filter's products away
    // from underflow and overflow; a component that it would round gets NaN, which the filter
    // leaves to the integers.
    const double largest =
        std::max({std::fabs(direction_[0]), std::fabs(direction_[1]), std::fabs(direction_[2])});
    const double factor = largest < 0x1p-400 ? 0x1p600 : (largest > 0x1p400 ? 0x1p-600 : 1);
    for (unsigned a = 0; a < 3; ++a) {
      const double speed = std::fabs(direction_[a]);
      const bool exact = factor >= 1 || speed >= 0x1p-422; // 2^-422 * 2^-600 is the least normal
      speed_[a] = exact ? speed * factor : std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// The ray meets the closed cube. Exact.
  [[nodiscard]] bool touches(const cube& c) const { return meets<convention::closed>(c, 0); }

  /// The ray has a point in the half-open cube, lo <= x < lo + size on each axis; an axis in
  /// `closed_far` (bit a) is closed at its upper face, as an octant at the root's far face is.
  /// Exact.
  [[nodiscard]] bool owns(const cube& c, unsigned closed_far = 0) const {
    return meets<convention::owned>(c, closed_far);
  }

  /// touches() for the convention `closed`, owns() for `owned`.
  template <convention C> [[nodiscard]] bool meets(const cube& c, unsigned closed_far) const {
    enum : unsigned { enters = 1, leaves = 2 };
    struct axis {
      exact_distance enter, leave;
      double enter_rounded, leave_rounded;
      unsigned has; ///< arrivals that restrict t >= 0
      bool enter_closed, leave_closed;
    };
    std::array<axis, 3> axes;
    for (unsigned a = 0; a < 3; ++a) {
      const double o = origin_[a], lo = c.lo[a], hi = c.hi(static_cast<int>(a));
      const bool hi_closed = C == convention::closed || (closed_far >> a & 1) != 0;
      axis& x = axes[a];
      x.has = 0;
      if (direction_[a] > 0) {
        if (hi_closed ? hi < o : hi <= o)
          return false; // it has left before t = 0, or leaves an open face at t = 0
        if (o < lo)
          x.has |= enters;
        x.has |= leaves;
        x.enter = {lo, o};
        x.leave = {hi, o};
        x.enter_closed = true;
        x.leave_closed = hi_closed;
      } else if (direction_[a] < 0) {
        if (o < lo)
          return false;
        if (hi_closed ? hi < o : hi <= o)
          x.has |= enters; // at an open face t = 0 itself is excluded
        x.has |= leaves;
        x.enter = {o, hi};
        x.leave = {o, lo};
        x.enter_closed = hi_closed;
        x.leave_closed = true;
      } else {
        if (o < lo || (hi_closed ? hi < o : hi <= o))
          return false;
        continue;
      }
      x.enter_rounded = x.enter.greater - x.enter.less;
      x.leave_rounded = x.leave.greater - x.leave.less;
    }
    // The filter first on every pair: most often one of them says no.
    std::array<std::array<unsigned char, 2>, 6> left;
    unsigned count = 0;
    for (unsigned a = 0; a < 3; ++a) {
      if ((axes[a].has & enters) == 0)
        continue;
      for (unsigned b = 0; b < 3; ++b) {
        if (b == a || (axes[b].has & leaves) == 0)
          continue;
        const int sign =
            filtered_sign(axes[a].enter_rounded, speed_[b], axes[b].leave_rounded, speed_[a]);
        if (sign > 0)
          return false;
        if (sign == 0)
          left[count++] = {static_cast<unsigned char>(a), static_cast<unsigned char>(b)};
      }
    }
    for (unsigned i = 0; i < count; ++i) {
      const unsigned a = left[i][0], b = left[i][1];
      const int sign = determinant_sign(axes[a].enter, direction_[b], axes[b].leave, direction_[a]);
      if (sign > 0)
        return false;
      if (C == convention::owned && sign == 0 && !(axes[a].enter_closed && axes[b].leave_closed))
        return false;
    }
    return true;
  }

private:
  vec3 origin_, direction_;
  vec3 speed_; ///< |direction| times a power of two; NaN where that is not exact
};

/// The ray meets the closed cube: exact, for every finite ray, in every rounding mode.
[[nodiscard]] inline bool touches(const ray& r, const cube& c) { return exact_touch(r).touches(c); }

/// The ray has a point in the half-open cube (exact_touch::owns).
[[nodiscard]] inline bool owns(const ray& r, const cube& c, unsigned closed_far = 0) {
  return exact_touch(r).owns(c, closed_far);
}

} // namespace graze::octree
