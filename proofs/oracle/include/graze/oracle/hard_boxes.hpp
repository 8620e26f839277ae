#pragma once
/// Bounds on which interval operations go wrong, if they go wrong: hard operands as ends, one-ulp
/// and one-point boxes, boxes about, beside and up to zero, unbounded and empty ones.
#include <algorithm>
#include <graze/bounds.hpp>
#include <graze/oracle/hard_operands.hpp>

namespace graze::oracle {

class hard_boxes {
public:
  explicit hard_boxes(std::uint64_t seed) : numbers(seed) {}

  bounds next() {
    const double infinity = std::numeric_limits<double>::infinity();
    const auto kind = static_cast<hardness>(numbers.below(static_cast<int>(hardness::count)));
    const operands p = numbers.next(kind);
    switch (numbers.below(16)) {
    case 0:
      return bounds::empty();
    case 1:
      return bounds::entire();
    case 2:
      return between(-infinity, p.x);
    case 3:
      return between(p.x, infinity);
    case 4:
      return between(0, std::fabs(p.x));
    case 5:
      return between(-std::fabs(p.x), -0.0);
    case 6:
      return between(0, 0);
    case 7:
    case 8:
      return between(p.x, p.x);
    case 9:
    case 10:
      return between(p.x, hard_operands::step(p.x, 1));
    case 11:
      return between(-std::fabs(p.x), std::fabs(p.y));
    default:
      return between(p.x, p.y);
    }
  }

  hard_operands numbers;

private:
  static bounds between(double x, double y) {
    if (checking::is_empty(std::min(x, y), std::max(x, y)))
      return bounds::empty();
    return {std::min(x, y), std::max(x, y)};
  }
};

/// Intervals that are hard in the ways of hard_operands: half of them from correlated ends, the
/// rest points, one ulp wide, touching zero of either sign, holding it inside, unbounded, entire,
/// empty.
class hard_intervals {
public:
  explicit hard_intervals(std::uint64_t seed) : make_(seed) {}

  /// Operands made for each other: ends of both come from the same pairs.
  void next(bounds& x, bounds& y, bounds& z) {
    const auto [p, q] = make_.next(kind());
    const auto [r, s] = make_.next(kind());
    const auto [t, u] = make_.next(kind());
    x = from_pair(p, make_.coin() ? r : t);
    y = from_pair(q, s);
    z = from_pair(t, make_.coin() ? -p * q : u); // x y + z cancels now and then
  }

  /// For polynomials: near the ends of [-3, 3], wide or thin.
  bounds moderate() {
    const double p = static_cast<double>(make_.below(1 << 20)) * 0x1p-19 * 3 - 3;
    const double w = std::ldexp(static_cast<double>(make_.below(1 << 20)),
                                -20 - static_cast<int>(make_.below(54)));
    return make_.below(100) == 0   ? bounds::empty()
           : make_.below(100) == 0 ? bounds::entire()
                                   : bounds{p, p + w};
  }

private:
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  hardness kind() {
    return static_cast<hardness>(make_.below(static_cast<std::uint64_t>(hardness::count)));
  }
  bounds from_pair(double p, double q) {
    switch (make_.below(10)) {
    case 0:
      q = p;
      break;
    case 1:
      q = hard_operands::step(p, 1);
      break;
    case 2:
      q = make_.coin() ? 0.0 : -0.0;
      break;
    case 3:
      q = make_.coin() ? unbounded : -unbounded;
      break;
    case 4:
      p = make_.coin() ? 0.0 : -0.0;
      q = make_.coin() ? p : -p;
      break;
    case 5:
      q = -q;
      break;
    default:
      break;
    }
    const std::uint64_t rare = make_.below(64);
    if (rare == 0)
      return bounds::entire();
    const double lo = std::min(p, q), hi = std::max(p, q);
    if (rare == 1 || p != p || q != q || lo == unbounded || hi == -unbounded)
      return bounds::empty();
    // min and max take either of two zeros
    return {lo == 0 && hi == 0 ? p : lo, lo == 0 && hi == 0 ? q : hi};
  }

  hard_operands make_;
};

} // namespace graze::oracle
