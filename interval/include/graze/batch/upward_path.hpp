#pragma once
/// A path from registers whose arithmetic rounds in the mode in force, which is set to upward:
/// lower bounds by negation, RD(t) = -RU(-t), as in the backend `upward`.
#include <graze/needs_cxx20.hpp>

#include <graze/batch/path.hpp>

namespace graze::batch {

template <class Registers> struct upward_path : Registers {
  using vector = typename Registers::vector;
  using mask = typename Registers::mask;
  using scope = upward_scope;
  using R = Registers;

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  GRAZE_BATCH_OPERATION vector add_up(vector x, vector y) { return R::add(x, y); }
  GRAZE_BATCH_OPERATION vector sub_up(vector x, vector y) { return R::sub(x, y); }
  GRAZE_BATCH_OPERATION vector mul_up(vector x, vector y) { return R::mul(x, y); }
  GRAZE_BATCH_OPERATION vector div_up(vector x, vector y) { return R::div(x, y); }
  GRAZE_BATCH_OPERATION vector sqrt_up(vector x) { return R::sqrt(x); }
  GRAZE_BATCH_OPERATION vector add_down(vector x, vector y) { return R::neg(R::sub(R::neg(x), y)); }
  GRAZE_BATCH_OPERATION vector sub_down(vector x, vector y) { return R::neg(R::sub(y, x)); }
  GRAZE_BATCH_OPERATION vector mul_down(vector x, vector y) { return R::neg(R::mul(R::neg(x), y)); }
  GRAZE_BATCH_OPERATION vector div_down(vector x, vector y) { return R::neg(R::div(R::neg(x), y)); }
  /// As rounding::upward::sqrt_down: the root rounded up, or its predecessor if its square exceeds
  /// x.
  GRAZE_BATCH_OPERATION vector sqrt_down(vector x) {
    const vector s = R::sqrt(x);
    return R::predecessor_where(R::less(x, R::mul(s, s)), s);
  }

  // MINPD gives the second operand if either is NaN or both are zeros: NaN replaced by the other
  // operand first, and the two orders joined, give the number, and -0 if there is one.
  GRAZE_BATCH_OPERATION vector min_number(vector p, vector q) {
    const vector a = number_or(p, q), b = number_or(q, p);
    return R::bits_or(R::min_or_second(a, b), R::min_or_second(b, a));
  }
  GRAZE_BATCH_OPERATION vector max_number(vector p, vector q) {
    const vector a = number_or(p, q), b = number_or(q, p);
    return R::bits_and(R::max_or_second(a, b), R::max_or_second(b, a));
  }
  GRAZE_BATCH_OPERATION vector greater_magnitude(vector p, vector q) {
    return R::max_or_second(R::abs(p), R::abs(q));
  }
  GRAZE_BATCH_OPERATION vector number_or(vector p, vector q) {
    return R::select(R::either_nan(p, p), q, p);
  }
  GRAZE_BATCH_OPERATION vector nan_for_zero(vector p) {
    return R::select(R::equal(p, R::zero()), R::broadcast(__builtin_nan("")), p);
  }
#undef GRAZE_BATCH_OPERATION
};

} // namespace graze::batch
