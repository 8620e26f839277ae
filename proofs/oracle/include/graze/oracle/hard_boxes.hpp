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

} // namespace graze::oracle
