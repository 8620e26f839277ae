#pragma once
/// Octants, and the root cubes in which every octant's corners are exact doubles.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <graze/expected.hpp>
#include <graze/octree/vector.hpp>
#include <graze/rounding/hardware.hpp>

namespace graze::octree {

/// The deepest level of any descent: the significand of a double has 53 bits.
inline constexpr int max_level = 53;

/// condition ? x : y by integers: a compiler makes a branch of that, and a coin toss is
/// mispredicted half of the time.
[[gnu::always_inline]] inline double choose(bool condition, double x, double y) {
  const std::uint64_t mask = std::uint64_t{0} - std::uint64_t{condition};
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) & mask) |
                               (std::bit_cast<std::uint64_t>(y) & ~mask));
}

template <class T> T choose(bool condition, const T& x, const T& y) { return condition ? x : y; }

/// The closed box [lo, lo + size]^3-like; lo[a] + size is exact for every octant of a root_cube.
struct cube {
  vec3 lo;
  double size;

  [[nodiscard, gnu::always_inline]] double hi(int axis) const { return lo[axis] + size; }
  [[nodiscard, gnu::always_inline]] double mid(int axis) const { return lo[axis] + size / 2; }

  /// Child `index`: bit a is set where the child lies on the upper side of mid(a).
  [[nodiscard, gnu::always_inline]] cube child(unsigned index) const {
    return {{choose((index & 1u) != 0, mid(0), lo[0]), choose((index & 2u) != 0, mid(1), lo[1]),
             choose((index & 4u) != 0, mid(2), lo[2])},
            size / 2};
  }

  friend bool operator==(const cube&, const cube&) = default;
};

/// A cube whose octants of level 0..level have corners and mid-planes that are exact doubles.
class root_cube {
public:
  /// Refuses a box that is not finite or not of positive size, a level outside 1..53, and a box in
  /// which an octant's corner would have to be rounded ([0,2^E]^3 is exact to 53, [-2^E,2^E]^3
  /// too).
  [[nodiscard]] static expected<root_cube> make(const cube& box, int level);

  [[nodiscard]] const cube& root_octant() const { return cube_; }
  [[nodiscard]] int level() const { return level_; }

  /// The octant at `index` (0 <= index[a] < 2^level) of `level`. Exact, since it counts from the
  /// middle: lo + index * size would round on some roots ([-3,3]^3 at level 52).
  /// Proof: proofs/coq/Root_cube.v, octant_from_middle.
  [[nodiscard]] cube octant(const std::array<std::uint64_t, 3>& index, int level) const {
    const double size = std::ldexp(cube_.size, -level);
    if (level == 0)
      return cube_;
    cube result{{}, size};
    const auto half = std::int64_t{1} << (level - 1);
    for (int axis = 0; axis < 3; ++axis)
      result.lo[axis] = cube_.mid(axis) +
                        static_cast<double>(static_cast<std::int64_t>(index[axis]) - half) * size;
    return result;
  }

private:
  [[nodiscard]] static expected<root_cube> make_within_scope(const cube& box, int level);
  root_cube(const cube& whole, int level) : cube_(whole), level_(level) {}
  cube cube_;
  int level_;
};

namespace detail {
/// The exponent of the lowest set bit of a finite x != 0.
inline int lowest_bit_exponent(double x) {
  int exponent = 0;
  const auto significand =
      static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  return exponent - 53 + __builtin_ctzll(static_cast<unsigned long long>(significand));
}
} // namespace detail

inline expected<root_cube> root_cube::make(const cube& box, int level) {
  // sums are told from exact ones, to nearest, and planes may be subnormal numbers
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  return make_within_scope(box, level);
}

[[gnu::noinline]] inline expected<root_cube> root_cube::make_within_scope(const cube& box,
                                                                          int level) {
  if (level < 1 || level > max_level)
    return unexpected{"level " + std::to_string(level) + " is outside 1..53"};
  if (!std::isfinite(box.size) || !(box.size > 0))
    return unexpected{"root size is not positive and finite"};
  // Every corner of every octant is lo + k * size * 2^-level, 0 <= k <= 2^level: a multiple of the
  // grid 2^g. It is a double if g >= -1074 and its magnitude is at most 2^53 * 2^g. The octants'
  // own mid-planes are not needed at the last level.
  int grid = detail::lowest_bit_exponent(box.size) - level;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = box.lo[axis];
    const double hi = box.hi(axis);
    if (!std::isfinite(lo) || !std::isfinite(hi))
      return unexpected{"root is not finite"};
    if (const double part = hi - lo; (lo - (hi - part)) + (box.size - part) != 0)
      return unexpected{"the root's far corner is not an exact double"};
    if (lo != 0)
      grid = std::min(grid, detail::lowest_bit_exponent(lo));
    largest = std::max({largest, std::fabs(lo), std::fabs(hi)});
  }
  if (grid < -1074 || largest > std::ldexp(1.0, std::min(grid + 53, 1023)))
    return unexpected{"octants of this root are not exact doubles at level " +
                      std::to_string(level) + ": use graze::octree::grid"};
  return root_cube(box, level);
}

} // namespace graze::octree
