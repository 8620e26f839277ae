#pragma once
/// The operations on intervals over a path, each written once. Every one is set-based and tightest:
/// 0 ulp per endpoint, empty in -> empty out, unbounded operands allowed. A zero bound is of either
/// sign, the same on every path.
///
/// Operands are valid: both ends NaN, or lo <= hi, lo < inf, hi > -inf. (What comes of others is
/// not specified.)
#include <graze/needs_cxx20.hpp>

#include <graze/batch/path.hpp>

namespace graze::batch {

template <class P> struct formulas {
  using vector = typename P::vector;
  using mask = typename P::mask;
  using interval = part<P>;

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  GRAZE_BATCH_OPERATION interval neg(const interval& x) { return {P::neg(x.hi), P::neg(x.lo)}; }

  GRAZE_BATCH_OPERATION interval add(const interval& x, const interval& y) {
    return {P::add_down(x.lo, y.lo), P::add_up(x.hi, y.hi)};
  }

  GRAZE_BATCH_OPERATION interval sub(const interval& x, const interval& y) {
    return {P::sub_down(x.lo, y.hi), P::sub_up(x.hi, y.lo)};
  }

  /// The product is linear in either operand, so that its extremes lie at x's ends times that end
  /// of y which their signs ask for (ends_of_product).
  ///
  /// 0 * inf, a NaN, stands for 0. It can be left out of the minimum wherever the other term is a
  /// number, since that is then not above 0 (nor below, in the maximum): e.g. for the minimum,
  /// x.lo = 0 and y.lo = -inf leave x.hi * y.lo, not above 0, if x.hi > 0, and 0 * y.hi if x.hi =
  /// 0; x.lo = -inf and y.hi = 0 leave x.hi * y.hi = 0, or x.hi * y.lo if x.hi > 0. The other cases
  /// are their mirror images: x.hi <= 0 takes the other end of y than x.lo >= 0 does. If both terms
  /// are NaN and no operand is empty, the bound is 0.
  GRAZE_BATCH_OPERATION interval mul(const interval& x, const interval& y) {
    const ends_of_product e(x, y);
    const vector lo = P::min_number(P::mul_down(x.lo, e.down_lo), P::mul_down(x.hi, e.down_hi));
    const vector hi = P::max_number(P::mul_up(x.lo, e.up_lo), P::mul_up(x.hi, e.up_hi));
    const mask is_empty = P::either_nan(x.lo, y.lo);
    const vector nan = P::broadcast(__builtin_nan(""));
    const vector instead = P::select(is_empty, nan, P::zero());
    return {P::number_or(lo, instead), P::number_or(hi, instead)};
  }

  /// { s t + u : s in x, t in y, u in z }, rounded once.
  /// As mul; a term is NaN where the product is, and then stands for z's end, or where the product
  /// is +inf and z.lo = -inf (for the upper bound: -inf and z.hi = +inf): then the bound is z's
  /// end, which is also what the other term gives, or the bound if that is NaN too.
  GRAZE_BATCH_OPERATION interval fma(const interval& x, const interval& y, const interval& z) {
    const ends_of_product e(x, y);
    const typename P::fma_scope mode;
    const vector lo =
        P::min_number(P::fma_down(x.lo, e.down_lo, z.lo), P::fma_down(x.hi, e.down_hi, z.lo));
    const vector hi = P::max_number(P::fma_up(x.lo, e.up_lo, z.hi), P::fma_up(x.hi, e.up_hi, z.hi));
    const mask is_empty = P::either_nan(x.lo, y.lo);
    const vector nan = P::broadcast(__builtin_nan(""));
    return {P::number_or(lo, P::select(is_empty, nan, z.lo)),
            P::number_or(hi, P::select(is_empty, nan, z.hi))};
  }

  /// { s / t : s in x, t in y, t != 0 }; empty for y = [0, 0].
  /// A y below zero is turned with x: x / y = -x / -y. Then y = [c, d] with c = +0 if zero, and
  /// a = x.lo is divided by c if negative, else by d; b = x.hi by c if positive, else by d: a
  /// negative number over +0 is -inf as it should be, and no 0 / 0 or inf / inf occurs. For zero
  /// inside y, c counts as +0 and x as [-m, m], m its magnitude: both quotients are infinite, or
  /// both 0 for x = [0, 0]. Where y = [0, 0], both divisors are NaN.
  ///
  /// Four comparisons, and no more: AVX-512 keeps their results in registers that are few, and a
  /// fifth would make divisions wait for operands (docs/batches.md).
  GRAZE_BATCH_OPERATION interval div(const interval& x, const interval& y) {
    const vector zero = P::zero();
    const mask turn = P::less_equal(y.hi, zero);
    const vector c = P::select(turn, P::neg(y.hi), y.lo);
    const vector d = P::nan_for_zero(P::select(turn, P::neg(y.lo), y.hi));
    const mask inside = P::less(c, zero);
    const vector near = P::abs(P::min_or_second(P::max_or_second(zero, c), d));
    const vector m = P::greater_magnitude(x.lo, x.hi);
    const vector a = P::select(inside, P::neg(m), P::select(turn, P::neg(x.hi), x.lo));
    const vector b = P::select(inside, m, P::select(turn, P::neg(x.lo), x.hi));
    return {P::div_down(a, P::select(P::less(a, zero), near, d)),
            P::div_up(b, P::select(P::less(zero, b), near, d))};
  }

  GRAZE_BATCH_OPERATION interval sqr(const interval& x) {
    const interval m = abs(x);
    return {P::mul_down(m.lo, m.lo), P::mul_up(m.hi, m.hi)};
  }

  /// { sqrt(t) : t in x, t >= 0 }.
  GRAZE_BATCH_OPERATION interval sqrt(const interval& x) {
    const vector hi = P::sqrt_up(x.hi); // NaN where x is empty or negative
    const vector lo = P::sqrt_down(P::max_or_second(P::zero(), x.lo));
    return {P::select(P::either_nan(hi, hi), hi, lo), hi};
  }

  GRAZE_BATCH_OPERATION interval abs(const interval& x) {
    const vector minus_hi = P::neg(x.hi);
    return {P::max_or_second(P::max_or_second(P::zero(), x.lo), minus_hi),
            P::max_or_second(P::neg(x.lo), x.hi)};
  }

  /// { min(s, t) : s in x, t in y }, not the lesser of two intervals.
  GRAZE_BATCH_OPERATION interval min(const interval& x, const interval& y) {
    const mask is_empty =
        P::either_nan(x.lo, x.lo); // an empty y comes through as the second operand
    return {P::select(is_empty, x.lo, P::min_or_second(x.lo, y.lo)),
            P::select(is_empty, x.hi, P::min_or_second(x.hi, y.hi))};
  }
  GRAZE_BATCH_OPERATION interval max(const interval& x, const interval& y) {
    const mask is_empty = P::either_nan(x.lo, x.lo);
    return {P::select(is_empty, x.lo, P::max_or_second(x.lo, y.lo)),
            P::select(is_empty, x.hi, P::max_or_second(x.hi, y.hi))};
  }

  GRAZE_BATCH_OPERATION interval intersection(const interval& x, const interval& y) {
    const interval r{P::max_or_second(x.lo, y.lo), P::min_or_second(x.hi, y.hi)};
    const mask common = overlaps(x, y);
    const vector nan = P::broadcast(__builtin_nan(""));
    return {P::select(common, r.lo, nan), P::select(common, r.hi, nan)};
  }
  GRAZE_BATCH_OPERATION interval hull(const interval& x, const interval& y) {
    return {P::min_number(x.lo, y.lo), P::max_number(x.hi, y.hi)};
  }

  // What is certain of all members, as in the scalar type: true too where an operand is empty.
  GRAZE_BATCH_OPERATION mask certainly_less(const interval& x, const interval& y) {
    return P::either(P::less(x.hi, y.lo), P::either_nan(x.lo, y.lo));
  }
  GRAZE_BATCH_OPERATION mask certainly_less_equal(const interval& x, const interval& y) {
    return P::either(P::less_equal(x.hi, y.lo), P::either_nan(x.lo, y.lo));
  }
  /// The same set.
  GRAZE_BATCH_OPERATION mask equal(const interval& x, const interval& y) {
    return P::either(P::both(P::equal(x.lo, y.lo), P::equal(x.hi, y.hi)),
                     P::both(is_empty(x), is_empty(y)));
  }
  GRAZE_BATCH_OPERATION mask subset(const interval& x, const interval& y) {
    return P::either(P::both(P::less_equal(y.lo, x.lo), P::less_equal(x.hi, y.hi)), is_empty(x));
  }
  /// A common member exists.
  GRAZE_BATCH_OPERATION mask overlaps(const interval& x, const interval& y) {
    return P::both(P::less_equal(x.lo, y.hi), P::less_equal(y.lo, x.hi));
  }
  GRAZE_BATCH_OPERATION mask contains_zero(const interval& x) {
    return P::both(P::less_equal(x.lo, P::zero()), P::less_equal(P::zero(), x.hi));
  }
  GRAZE_BATCH_OPERATION mask is_empty(const interval& x) { return P::either_nan(x.lo, x.lo); }

private:
  /// The end of y by which x.lo and x.hi are multiplied for the lower and for the upper bound.
  struct ends_of_product {
    vector down_lo, down_hi, up_lo, up_hi;
    GRAZE_BATCH_INLINE ends_of_product(const interval& x, const interval& y) {
      const mask below = P::less(x.lo, P::zero()), above = P::less(P::zero(), x.hi);
      down_lo = P::select(below, y.hi, y.lo);
      up_lo = P::select(below, y.lo, y.hi);
      down_hi = P::select(above, y.lo, y.hi);
      up_hi = P::select(above, y.hi, y.lo);
    }
  };
#undef GRAZE_BATCH_OPERATION
};

} // namespace graze::batch
