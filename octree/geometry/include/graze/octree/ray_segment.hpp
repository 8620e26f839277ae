#pragma once
/// A segment of a ray, and exact decisions about it.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <cmath>
#include <cstdint>
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
    if (!(first >= 0) || !std::isfinite(first))
      return unexpected{"a segment begins at a finite t >= 0"};
    if (!(first <= last))
      return unexpected{"a segment ends before it begins"};
    ray_segment s;
    s.first_ = first == 0 ? 0 : first; // no negative zero
    s.last_ = last;
    return s;
  }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; } ///< may be infinite
  [[nodiscard]] bool whole() const {
    return first_ == 0 && last_ == std::numeric_limits<double>::infinity();
  }

private:
  double first_ = 0, last_ = std::numeric_limits<double>::infinity();
};

namespace detail {
/// The sign of a sum of products of finite doubles, exact and in any rounding mode: a fixed-point
/// number as wide as all of them. For the few decisions that no filter makes.
class exact_sum {
public:
  void add_product(double x, double y) {
    if (x == 0 || y == 0)
      return;
    const parts a(x), b(y);
    const wide m = static_cast<wide>(a.significand) * b.significand;
    const unsigned shift = static_cast<unsigned>(a.exponent + b.exponent), bit = shift % 64;
    std::size_t i = shift / 64;
    const std::array<std::uint64_t, 3> words{
        static_cast<std::uint64_t>(m << bit),
        static_cast<std::uint64_t>(bit == 0 ? m >> 64 : m >> (64 - bit)),
        bit == 0 ? 0 : static_cast<std::uint64_t>((m >> 64) >> (64 - bit))};
    if (a.negative != b.negative) {
      unsigned char borrow = 0;
      for (std::size_t k = 0; i < word_.size(); ++i, ++k) {
        const std::uint64_t w = k < 3 ? words[k] : 0;
        const std::uint64_t before = word_[i];
        word_[i] = before - w - borrow;
        borrow = before < w || (before == w && borrow != 0);
        if (k >= 2 && borrow == 0)
          break;
      }
    } else {
      unsigned char carry = 0;
      for (std::size_t k = 0; i < word_.size(); ++i, ++k) {
        const std::uint64_t w = k < 3 ? words[k] : 0;
        const std::uint64_t sum = word_[i] + w;
        const bool first_carry = sum < w;
        word_[i] = sum + carry;
        carry = first_carry || word_[i] < sum;
        if (k >= 2 && carry == 0)
          break;
      }
    }
  }
  void add(double x) { add_product(x, 1); }

  [[nodiscard]] int sign() const {
    if (word_.back() >> 63 != 0)
      return -1;
    for (const std::uint64_t w : word_)
      if (w != 0)
        return 1;
    return 0;
  }

private:
  __extension__ using wide = unsigned __int128;
  struct parts {
    std::uint64_t significand;
    int exponent; ///< of the lowest bit, in units of 2^-1074
    bool negative;
    explicit parts(double x) {
      const auto b = __builtin_bit_cast(std::uint64_t, x);
      const int e = static_cast<int>(b >> 52 & 0x7ff);
      significand = (b & 0xf'ffff'ffff'ffff) | (e == 0 ? 0 : std::uint64_t{1} << 52);
      exponent = e == 0 ? 0 : e - 1;
      negative = b >> 63 != 0;
    }
  };
  /// Two's complement, in units of 2^-2148: products end below 2^(2 * 2098), 67 words hold 2^70 of
  /// them.
  std::array<std::uint64_t, 67> word_{};
};

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
