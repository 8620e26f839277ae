#pragma once
/// Exact geometry of a ray or a segment among planes that are no doubles: sums of three. As geometry.hpp
/// for everything that it does not take. Doubles decide where their errors are bounded, GMP's integers
/// elsewhere. Exact in every rounding mode, and where the caller flushes subnormals.
#include <graze/oracle/geometry.hpp>
#include <graze/oracle/planes.hpp>
#include <optional>

namespace graze::oracle {

/// {origin + t direction : t >= 0}; where there is an end {origin + t (end - origin) : 0 <= t <= 1}, the
/// difference not rounded, and the direction has no meaning. end != origin.
struct line {
  point origin, direction;
  std::optional<point> end{};
};

/// A box of planes, lo <= hi; flat where they are equal.
struct planes_box {
  std::array<plane_terms, 3> lo, hi;
};
inline planes_box box_of(const point& lo, const point& hi) {
  planes_box b{};
  for (unsigned a = 0; a < 3; ++a) {
    b.lo[a][0] = lo[a];
    b.hi[a][0] = hi[a];
  }
  return b;
}

/// As steps_in_grid of geometry.hpp, for planes as real numbers and segments: the end, where it lies in
/// the hull, is a point of its own too. Terms of planes are finite and below 2^1020.
void steps_in_grid(const line& l, const std::array<std::span<const plane_terms>, 3>& planes,
                   std::vector<step>& steps);

/// |plane - origin| / |end - origin|, or / |direction|, > 0; sums, not rounded.
struct sum_arrival {
  std::array<double, 4> distance; ///< of which the last is of the origin
  std::array<double, 2> speed;

  /// As arrival::time.
  [[nodiscard]] double time() const;
};
/// The sign of t_a - t_b, exactly.
int compare_exactly(const sum_arrival& a, const sum_arrival& b);
int compare(const sum_arrival& a, const sum_arrival& b);

/// The sign of a sum of doubles, exactly.
int sign_of_sum(std::span<const double> terms);

/// How a line meets a box.
class meeting {
public:
  meeting(const line& l, const planes_box& box);

  /// The line has a point in the closed box.
  [[nodiscard]] bool touches() const { return touches_; }
  /// It has a point in the interior; where the box is flat, in what is the interior within its plane, its
  /// line or its point.
  [[nodiscard]] bool crosses() const { return crosses_; }

  /// The sign of the difference of the t at which two lines that are one come into closed boxes that they
  /// touch.
  friend int compare_entries(const meeting& a, const meeting& b);

private:
  /// A bound of t on one axis: a plane that is reached at t > 0, or t = 0.
  struct bound {
    bool positive;
    sum_arrival when;
    int against_end; ///< the sign of t - 1, where there is an end
    bool flat;       ///< of two faces that are one plane
  };
  void meet(const line& l, const planes_box& box);
  static int order(const bound& a, const bound& b);
  [[nodiscard]] const bound* entry() const;

  std::array<bound, 3> enter_, leave_;
  unsigned enters_ = 0, leaves_ = 0;
  bool touches_ = false, crosses_ = false;
};
int compare_entries(const meeting& a, const meeting& b);

} // namespace graze::oracle
