#pragma once
/// Exact decisions about a ray, a part of one, or a segment between two points, and what lies
/// between planes of any kind: boxes, octants, voxels of grids.
///
/// On each axis along which it moves, the line is between two planes from its arrival at one to its
/// arrival at the other; with the line's own first and last t these are four intervals of t, and
/// they have a common point if and only if any two have (Helly in one dimension). Each comparison
/// is the sign of a sum of products (exact_sum.hpp), unless doubles with error bounds decide it.
/// Compiled, for the same answers in every rounding mode, where numbers are flushed, and by every
/// compiler. exact_touch.hpp is faster for a ray and octants.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/passage.hpp>
#include <graze/octree/ray_segment.hpp>
#include <graze/octree/segment.hpp>
#include <graze/octree/slabs.hpp>
#include <optional>

namespace graze::octree {

/// {o + t d : first <= t <= last}, prepared for exact decisions. d is a direction of doubles, or
/// the exact difference of two points.
class exact_line {
public:
  /// A ray, or its segment.
  exact_line(const ray& r, const ray_segment& part = {});
  /// From 0 to 1.
  exact_line(const segment& s);

  /// It has a point in the closed cell. Exact, as are all answers.
  [[nodiscard]] bool touches(const slabs& cell) const;
  /// It has a point in the cell's interior; on an axis on which the cell is flat, in its plane.
  [[nodiscard]] bool crosses(const slabs& cell) const;
  /// It has a point in the half-open cell, lower <= x < upper; closed on the axes in closed_far.
  [[nodiscard]] bool owns(const slabs& cell) const;

  /// When it is in the closed cell; nothing if it does not touch it.
  [[nodiscard]] std::optional<passage> through(const slabs& cell) const;

private:
  struct time;
  struct fraction;
  bool meets(const slabs& cell, unsigned lower_closed, unsigned upper_closed) const;
  bool still_outside(unsigned axis, const slabs& cell, bool lower_closed, bool upper_closed) const;
  [[nodiscard]] time limit_at(double t) const;
  [[nodiscard]] time arrival_at(unsigned axis, const plane_value& p, bool upper) const;
  [[nodiscard]] int order(const time& x, const time& y) const;
  [[nodiscard]] fraction exactly(const time& t) const;

  vec3 origin_;
  vec3 toward_; ///< the direction, or the far end
  vec3 speed_;  ///< |d|, rounded
  std::array<signed char, 3> heading_;
  bool between_points_;
  double first_, last_;
};

/// The line touches the closed box, crosses its interior, has a point in the half-open box, or
/// passes through it. Any finite box with lo <= hi, flat ones included; an empty one is never met.
[[nodiscard]] inline bool touches(const exact_line& l, const slabs& cell) {
  return l.touches(cell);
}
[[nodiscard]] inline bool crosses(const exact_line& l, const slabs& cell) {
  return l.crosses(cell);
}
[[nodiscard]] inline bool owns(const exact_line& l, const slabs& cell) { return l.owns(cell); }
[[nodiscard]] inline std::optional<passage> passage_through(const exact_line& l,
                                                            const slabs& cell) {
  return l.through(cell);
}

} // namespace graze::octree
