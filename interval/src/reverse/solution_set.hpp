#pragma once
/// Sets of real solutions, their ends known by correct rounding in both directions, and their hull
/// within an interval.
#include <algorithm>
#include <cmath>
#include <graze/bounds.hpp>
#include <limits>

namespace graze::solutions {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();

inline double before(double x) { return std::nextafter(x, -infinity); }
inline double after(double x) { return std::nextafter(x, infinity); }

/// An end of a set, by the real number r there: r rounded down and r rounded up. For a double d,
/// d <= r iff d <= down, and d >= r iff d >= up. An end that does not belong to the set stands
/// infinitely close to r, inside the set: both statements then hold for it, too.
struct end {
  double down, up;
  end operator-() const { return {-up, -down}; }
};
inline end at(double r) { return {r, r}; }
/// The open ends: of { t > r } and { t < r }, and of sets without a bound.
inline end just_above(double r) { return {r, after(r)}; }
inline end just_below(double r) { return {before(r), r}; }
inline constexpr end unbounded_above = {largest, infinity};
inline constexpr end unbounded_below = {-infinity, -largest};

/// The tightest enclosure of the union of sets, each met with x.
class hull_within {
public:
  explicit hull_within(const bounds& box) : x(box) {}

  /// A non-empty set of solutions from `lo` to `hi`. Two non-empty intervals meet iff neither lies
  /// beyond the other, and the greater of two lower ends, rounded, is the greater rounded one.
  void add(const end& lo, const end& hi) {
    if (!(x.lo <= hi.down && lo.up <= x.hi))
      return;
    const bounds piece = {std::max(x.lo, lo.down), std::min(x.hi, hi.up)};
    hull =
        hull.is_empty() ? piece : bounds{std::min(hull.lo, piece.lo), std::max(hull.hi, piece.hi)};
  }
  /// The same set and its mirror image.
  void add_both_signs(const end& lo, const end& hi) {
    add(lo, hi);
    add(-hi, -lo);
  }
  [[nodiscard]] bounds result() const { return hull; }

private:
  bounds x, hull = bounds::empty();
};

} // namespace graze::solutions
