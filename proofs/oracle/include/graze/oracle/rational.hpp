#pragma once
/// The same questions as geometry.hpp and lines.hpp, answered a second time by clipping t-intervals in
/// GMP's rationals: slow, short, and without a line in common with the fast answers.
#include <gmpxx.h>
#include <graze/oracle/geometry.hpp>
#include <optional>
#include <utility>

namespace graze::oracle::rational {

/// As graze::oracle::touches, crosses, owns.
bool touches(const point& origin, const point& direction, const point& lo, const point& hi);
bool crosses(const point& origin, const point& direction, const point& lo, const point& hi);
bool owns(const point& origin, const point& direction, const point& lo, const point& hi,
          unsigned closed_far = 0);

/// The t >= 0 at which the ray is in the closed box, first and last; nothing if it misses it.
std::optional<std::pair<mpq_class, mpq_class>> range_in(const point& origin, const point& direction,
                                                        const point& lo, const point& hi);

/// {origin + t velocity : first <= t}, to t = last if there is one; velocity not 0.
struct line {
  std::array<mpq_class, 3> origin, velocity;
  mpq_class first = 0;
  std::optional<mpq_class> last{};
};
line ray_of(const point& origin, const point& direction);
/// t = 0 at `origin`, 1 at `end`.
line segment_of(const point& origin, const point& end);

/// lo <= hi; flat where they are equal.
struct box {
  std::array<mpq_class, 3> lo, hi;
};
box box_of(const point& lo, const point& hi);

/// The line has a point in the box of which, where bit a of the masks is set, the lower and the upper plane
/// of axis a are a part.
bool meets(const line& l, const box& b, unsigned lower_closed, unsigned upper_closed);
/// The same questions for these. The interior of a flat box is that within its plane, line or point; on
/// an axis where it is flat the half-open box is closed.
bool touches(const line& l, const box& b);
bool crosses(const line& l, const box& b);
bool owns(const line& l, const box& b, unsigned closed_far = 0);
/// The first and last t at which the line is in the closed box.
std::optional<std::pair<mpq_class, mpq_class>> range_in(const line& l, const box& b);

/// What a line and a closed box have in common. Faces: bit 2 axis, and the next one for the upper face;
/// those that are reached at the very first t, and at the very last.
struct part {
  mpq_class first, last;
  unsigned entered, left;
};
std::optional<part> common_part(const line& l, const box& b);

/// x rounded to the nearest double, or float, ties to even. By MPFR; subnormal numbers included.
double nearest_double(const mpq_class& x);
double nearest_float(const mpq_class& x);

/// Planes of an axis as those of planes.hpp, by GMP's and MPFR's arithmetic; `plane_added` step by step,
/// and remembered for the axes that were asked about last.
mpq_class plane_exactly(double origin, double spacing, std::uint32_t k);
double plane_rounded(double origin, double spacing, std::uint32_t k);
double plane_multiplied(double origin, double spacing, std::uint32_t k);
double plane_added(double origin, double spacing, std::uint32_t k);
double plane_binary32(double origin, double spacing, std::uint32_t k);

} // namespace graze::oracle::rational
