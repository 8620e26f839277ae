#pragma once
/// The same three questions as geometry.hpp, answered a second time by clipping t-intervals in
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

} // namespace graze::oracle::rational
