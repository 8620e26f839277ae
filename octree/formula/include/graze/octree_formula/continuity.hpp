#pragma once
/// Where the operations of a tape are proven to be defined and continuous.
#include <graze/octree_formula/operations.hpp>

namespace graze::octree::tape {

/// The operation is defined and continuous at every point of R or R^2.
GRAZE_BATCH_INLINE constexpr bool continuous_everywhere(opcode op, int n) {
  switch (op) {
  case opcode::pown:
    return n >= 0;
  case opcode::rootn:
    return n > 0 && n % 2 != 0;
  case opcode::div:
  case opcode::recip:
  case opcode::sqrt:
  case opcode::pow:
  case opcode::atan2:
  case opcode::select:
  case opcode::log:
  case opcode::log2:
  case opcode::log10:
  case opcode::logp1:
  case opcode::tan:
  case opcode::cot:
  case opcode::sec:
  case opcode::csc:
  case opcode::asin:
  case opcode::acos:
  case opcode::coth:
  case opcode::csch:
  case opcode::acosh:
  case opcode::atanh:
  case opcode::acoth:
  case opcode::sign:
  case opcode::floor:
  case opcode::ceil:
  case opcode::trunc:
    return false;
  default:
    return true;
  }
}

/// Proven: the operation is defined at every point of the operands' box, and its restriction to the
/// box is continuous. For those that are not continuous everywhere, but `select`, of which
/// continuity<N>::chosen knows. Source: the decorations of IEEE 1788 (graze/decoration.hpp).
bool continuous_on(opcode op, const bounds& a, const bounds& b, int n);

/// How a number type says where: one bit for an interval, one for each lane of eight. None for
/// numbers that enclose nothing.
template <class N> struct continuity {
  static constexpr unsigned everywhere = 0;
  static unsigned bits(opcode, const N&, const N&, int) { return everywhere; }
  static unsigned chosen(const N&, unsigned, unsigned) { return everywhere; }
};
template <class Policies> struct continuity<boost::numeric::interval<double, Policies>> {
  using interval = boost::numeric::interval<double, Policies>;
  static constexpr unsigned everywhere = 1;
  static unsigned bits(opcode op, const interval& a, const interval& b, int n) {
    return continuous_on(op, to_bounds(a), to_bounds(b), n) ? 1 : 0;
  }
  /// Of `select`: what is known of the operand that is chosen on the whole box; nothing where that
  /// is not decided.
  static unsigned chosen(const interval& a, unsigned if_positive, unsigned if_not) {
    return a.lower() > 0 ? if_positive : a.upper() <= 0 ? if_not : 0;
  }
  /// The value, or 1 where there is none; see formula_surface.
  static interval defined(const interval& x) {
    return lanewise<interval>::template apply<&detail::tape_lanes<batch::portable>::defined>(x);
  }
  /// x where f is continuous, else no bound.
  static interval where(unsigned continuous, const interval& x) {
    return continuous != 0 ? x : interval::whole();
  }
};

} // namespace graze::octree::tape
