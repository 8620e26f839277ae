#pragma once
/// The exact ray/octant test: no octant too many, none too few, for every finite ray.
///
/// On each axis along which it moves, the ray is within a box from its arrival at one plane (enter)
/// to its arrival at the other (leave). It meets the box if and only if no leave lies before t = 0
/// and none lies before the enter of another axis: intervals that meet in pairs have a common
/// point. Each comparison is the sign of a 2x2 determinant (determinant_sign.hpp). Half-open boxes
/// differ only where two arrivals are equal.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <graze/octree/determinant_sign.hpp>
#include <graze/octree/ray.hpp>
#include <graze/octree/ray_bounds.hpp>
#include <graze/rounding/hardware.hpp>
#include <limits>

namespace graze::octree {

/// A power of two that takes a direction's largest component into [2^-474, 2^424], where products
/// of two components neither underflow nor overflow.
inline double direction_scale(const vec3& d) {
  const double largest = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
  return largest < 0x1p-400 ? 0x1p600 : (largest > 0x1p400 ? 0x1p-600 : 1);
}
/// direction_scale leaves this component exact: 2^-422 * 2^-600 is the least normal number, and
/// scaling up never rounds.
inline bool scales_exactly(double component, double scale) {
  return (scale >= 1) | (std::fabs(component) >= 0x1p-422) | (component == 0);
}

/// A ray prepared for exact decisions. May be made and asked in any rounding mode, and gives the
/// same answers in each; where subnormal operands count as zero (DAZ) they are not to be trusted:
/// it is for loops, within a scope of any backend that sets a mode, or once rounding::refusal() has
/// nothing to say. touches() and owns() below take a scope themselves. A cube's lo + size must be
/// exact doubles, as they are for every octant of a root_cube.
class exact_touch {
public:
  explicit exact_touch(const ray& r) : direction_(r.direction()) {
    // Comparisons are homogeneous in the direction. A power of two keeps the filter's products away
    // from underflow and overflow; a component that it would round gets NaN, which the filter
    // leaves to the integers.
    const double scale = direction_scale(direction_);
    constexpr std::array<unsigned, 3> pairs_to{0x14, 0x21, 0x0a}; // of `pairs`, by their exit
    for (unsigned a = 0; a < 3; ++a) {
      const double d = direction_[a], speed = std::fabs(d);
      const bool exact = scales_exactly(d, scale);
      constexpr auto nan = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
      speed_[a] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(speed * scale) |
                                        (nan & mask_of(!exact)));
      backward_[a] = mask_of(d < 0);
      still_[a] = d == 0;
      origin_[a] = negate_if(backward_[a], r.origin()[a]);
      moving_pairs_ |= pairs_to[a] & static_cast<unsigned>(mask_of(d != 0));
    }
  }

  /// The ray meets the closed cube. Exact.
  [[nodiscard]] bool touches(const cube& c) const { return meets<convention::closed>(c); }

  /// The ray has a point in the half-open cube, lo <= x < lo + size on each axis; an axis in
  /// `closed_far` (bit a) is closed at its upper face, as an octant at the root's far face is.
  /// Exact.
  [[nodiscard]] bool owns(const cube& c, unsigned closed_far = 0) const {
    return meets<convention::owned>(c, closed_far);
  }

  /// touches() for the convention `closed`, owns() for `owned`. The sign of each operand is a coin
  /// toss, so that all is computed and then decided.
  template <convention C>
  [[nodiscard]] bool meets(const cube& c, [[maybe_unused]] unsigned closed_far = 0) const {
    // every axis reflected to go forward: it enters at `near` and leaves at `far`
    vec3 near, far, to_near, to_far;
    std::array<bool, 3> near_closed, far_closed;
    bool outside = false, certain = true;
    unsigned entering_pairs = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const double o = origin_[a], lo = c.lo[a], hi = c.hi(static_cast<int>(a));
      const bool hi_closed = C == convention::closed || (closed_far >> a & 1) != 0;
      const bool backward = backward_[a] != 0;
      near[a] = negate_if(backward_[a], select(backward_[a], hi, lo));
      far[a] = negate_if(backward_[a], select(backward_[a], lo, hi));
      near_closed[a] = hi_closed | !backward;
      far_closed[a] = hi_closed | backward;
      // within(t = 0): at an open face it is not
      const double first = near[a], last = far[a];
      const bool with_near = near_closed[a], with_far = far_closed[a];
      const bool after_near = (first < o) | ((first == o) & with_near);
      const bool before_far = (o < last) | ((o == last) & with_far);
      outside |= (!before_far) | (still_[a] & !after_near);
      entering_pairs |= unsigned{!after_near} * 3u << (2 * a);
      to_near[a] = near[a] - o;
      to_far[a] = far[a] - o;
      certain &= to_near[a] <= certain_distance;
      certain &= to_far[a] <= certain_distance;
    }
    if (outside)
      return false;
    // t of entry on axis a against t of exit on axis b, both times both speeds
    unsigned later = 0, earlier = 0;
    for (unsigned i = 0; i < pairs.size(); ++i) {
      const unsigned a = pairs[i][0], b = pairs[i][1];
      const double entry = to_near[a] * speed_[b], exit = to_far[b] * speed_[a];
      later |= unsigned{certainly_greater(entry, exit)} << i;
      earlier |= unsigned{certainly_greater(exit, entry)} << i;
    }
    const unsigned relevant = entering_pairs & moving_pairs_;
    if (certain & ((later & relevant) != 0))
      return false;
    for (unsigned left = certain ? relevant & ~earlier : relevant; left != 0; left &= left - 1) {
      const auto [a, b] = pairs[static_cast<unsigned>(std::countr_zero(left))];
      const int sign = determinant_sign({near[a], origin_[a]}, direction_[b], {far[b], origin_[b]},
                                        direction_[a]);
      if (sign > 0 || (sign == 0 && !(near_closed[a] && far_closed[b])))
        return false;
    }
    return true;
  }

private:
  /// (axis of the entry, axis of the exit)
  static constexpr std::array<std::array<std::uint8_t, 2>, 6> pairs{
      {{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}};

  // Selections in integers: a compiler makes branches of others, and half of them are mispredicted.
  static std::uint64_t mask_of(bool b) { return std::uint64_t{0} - std::uint64_t{b}; }
  static double negate_if(std::uint64_t mask, double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (mask & std::uint64_t{1} << 63));
  }
  static double select(std::uint64_t mask, double x, double y) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) & mask) |
                                 (std::bit_cast<std::uint64_t>(y) & ~mask));
  }

  vec3 origin_; ///< negated where the ray goes backward
  vec3 direction_;
  vec3 speed_; ///< |direction| times a power of two; NaN where that is not exact
  std::array<std::uint64_t, 3> backward_; ///< all bits set, or none
  std::array<bool, 3> still_;
  unsigned moving_pairs_ = 0;
};

namespace detail {
template <convention C>
[[gnu::noinline]] bool meets_within_scope(const ray& r, const cube& c, unsigned closed_far) {
  return exact_touch(r).meets<C>(c, closed_far);
}
template <convention C> bool meets(const ray& r, const cube& c, unsigned closed_far) {
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  return meets_within_scope<C>(r, c, closed_far);
}
} // namespace detail

/// The ray meets the closed cube: exact, for every finite ray, in any environment.
[[nodiscard]] inline bool touches(const ray& r, const cube& c) {
  return detail::meets<convention::closed>(r, c, 0);
}

/// The ray has a point in the half-open cube (exact_touch::owns).
[[nodiscard]] inline bool owns(const ray& r, const cube& c, unsigned closed_far = 0) {
  return detail::meets<convention::owned>(r, c, closed_far);
}

} // namespace graze::octree
