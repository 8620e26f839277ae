#pragma once
/// Lines and cells between planes, both of rational numbers: what a line has in common with a cell,
/// by clipping intervals of t. Slow and short; knows nothing of doubles but how planes are rounded.
#include <gmpxx.h>
#include <graze/oracle/geometry.hpp>
#include <optional>

namespace graze::oracle::rational {

using rational_point = std::array<mpq_class, 3>;

/// {origin + t direction : first <= t}, to t = last if there is one; direction not 0.
struct line {
  rational_point origin, direction;
  mpq_class first = 0;
  std::optional<mpq_class> last;
};
line ray_from(const point& origin, const point& direction);
/// t = 0 at `from`, 1 at `to`.
line between(const point& from, const point& to);

/// lower <= upper; bit a of the masks: that plane of axis a belongs to the cell.
struct cell {
  rational_point lower, upper;
  unsigned lower_closed = 7, upper_closed = 7;
};

/// What a line and a closed cell have in common. Faces: bit 2 axis, and the next one for the upper
/// face; those that are reached at the very first t, and at the very last.
struct part {
  mpq_class first, last;
  unsigned entered, left;
};

/// The line has a point in the cell.
bool meets(const line& l, const cell& c);
/// With the closed cell, whatever its masks say.
std::optional<part> common_part(const line& l, const cell& c);

/// x rounded to the nearest double, or float, ties to even. By MPFR; subnormal numbers included.
double nearest_double(const mpq_class& x);
double nearest_float(const mpq_class& x);

} // namespace graze::oracle::rational
