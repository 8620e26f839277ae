#pragma once
/// + - * / sqr sqrt of intervals whose backend rounds two numbers at once (`upward`, `nearest`, on
/// x86-64). The same sets as from the operators that serve every backend: tightest. Without a
/// branch where both operands are bounded and no result overflows, since the signs of bounds are a
/// coin toss to a processor; the rest goes to those operators.
///
/// In here an interval [a, b] is the pair (-a, b). A zero bound is of either sign.
#include <graze/needs_cxx20.hpp>

#include <graze/packed_interval.hpp>

namespace graze {

namespace detail::packed {
using namespace rounding::packed;

template <PackedPolicies P> GRAZE_INLINE pair load(const interval_of<P>& x) {
  if constexpr (OutwardPolicies<P>)
    return x.as_pair();
  else
    return flip_first(pair{x.lower(), x.upper()});
}
template <PackedPolicies P> GRAZE_INLINE interval_of<P> to_interval(pair x) {
  if constexpr (OutwardPolicies<P>)
    return interval_of<P>::from_pair(x);
  else
    return interval_of<P>(-x[0], x[1], true);
}
/// No half is NaN, +inf, or (a double cannot be) more.
GRAZE_INLINE bits below_infinity(pair x) { return (bits)_mm_cmplt_pd(x, both(checking::infinity)); }

// The general operators, on bounds in a register: an operand whose address left the fast path could
// not stay in one.
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_add(pair x, pair y) {
  return load<P>(boost::numeric::operator+(to_interval<P>(x), to_interval<P>(y)));
}
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_sub(pair x, pair y) {
  return load<P>(boost::numeric::operator-(to_interval<P>(x), to_interval<P>(y)));
}
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_mul(pair x, pair y) {
  return load<P>(multiply(to_interval<P>(x), to_interval<P>(y)));
}
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_div(pair x, pair y) {
  return load<P>(divide(to_interval<P>(x), to_interval<P>(y)));
}
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_sqr(pair x) {
  return load<P>(squared(to_interval<P>(x)));
}
template <PackedPolicies P> [[gnu::cold, gnu::noinline]] pair general_sqrt(pair x) {
  return load<P>(root(to_interval<P>(x)));
}

template <class P> using operations = typename P::rounding::backend::pair_operations;

// Sums have no special case: an empty operand's NaN reaches a bound, and where infinities of the
// empty [inf, inf] go, no non-empty set comes out.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> sum(pair x, pair y) {
  const result r = operations<P>::add(x, y);
  if (!all(r.good)) [[unlikely]]
    return to_interval<P>(general_add<P>(x, y));
  return to_interval<P>(r.value);
}
/// x - y = x + -y, and -y, [-d, -c], is the pair (d, -c).
template <PackedPolicies P> GRAZE_INLINE interval_of<P> difference(pair x, pair y) {
  return sum<P>(x, swapped(y));
}

/// The greatest of the four products, of each sign. If no half is infinite or NaN, then no operand
/// was unbounded or empty, but for a factor [0, 0]: a product +inf stays to the end (max gives its
/// second operand for a NaN), as does a NaN of the last product, of which an empty factor always
/// makes one.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> product(pair x, pair y) {
  using op = operations<P>;
  const pair other = negated(swapped(x)), plain = flip_first(y), reversed = swapped(plain);
  const pair r = max(op::mul(x, plain), max(op::mul(x, reversed),
                                            max(op::mul(other, plain), op::mul(other, reversed))));
  if (!all(below_infinity(r) & op::mul_range(x) & op::mul_range(y))) [[unlikely]]
    return to_interval<P>(general_mul<P>(x, y));
  return to_interval<P>(r);
}

/// The pair of a numerator over a divisor between `least` and `greatest`, which are not negative:
/// each half over the one if it is positive and over the other if not.
template <PackedPolicies P>
GRAZE_INLINE interval_of<P> quotient_by_positive(pair x, pair y, pair numerator, pair least,
                                                 pair greatest) {
  using op = operations<P>;
  const bits positive = (bits)_mm_cmpgt_pd(numerator, both(0));
  const pair r = op::div(numerator, select(positive, least, greatest));
  // nothing unbounded or empty, nothing divided by 0, nor by the empty [inf, inf]
  const bits good = below_infinity(r) & below_infinity(least);
  if (!all(good & op::div_range(x) & op::div_range(y))) [[unlikely]]
    return to_interval<P>(general_div<P>(x, y));
  return to_interval<P>(r);
}

/// Three cases by y's signs, since where y has numbers of both no division is needed. For y < 0 it
/// is -x / -y.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> quotient(pair x, pair y) {
  const pair ends = flip_first(y);
  const int negative = _mm_movemask_pd(ends);
  if (negative == 0)
    return quotient_by_positive<P>(x, y, x, _mm_unpacklo_pd(ends, ends),
                                   _mm_unpackhi_pd(ends, ends));
  if (negative == 3) {
    const pair size = negated(ends);
    return quotient_by_positive<P>(x, y, swapped(x), _mm_unpackhi_pd(size, size),
                                   _mm_unpacklo_pd(size, size));
  }
  // c < 0 < d, and x has a number but 0
  const pair size = magnitude(x);
  if (all((bits)_mm_cmpgt_pd(y, both(0)) & (bits)_mm_cmpgt_pd(size, both(0)) &
          below_infinity(size))) [[likely]]
    return interval_of<P>::whole();
  return to_interval<P>(general_div<P>(x, y));
}

/// (near, far) = (min |t|, max |t|); then (-near, far) * (near, far).
template <PackedPolicies P> GRAZE_INLINE interval_of<P> square(pair x) {
  using op = operations<P>;
  const pair ends = flip_first(x), opposite = negated(swapped(ends));
  const pair factor = max(both(0), max(ends, opposite)); // NaN stays
  const pair r = op::mul(flip_first(factor), factor);
  if (!all(op::mul_range(x))) [[unlikely]]
    return to_interval<P>(general_sqr<P>(x));
  return to_interval<P>(r);
}

/// A negative upper bound has a NaN for a root, which makes both bounds NaN.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> square_root(pair x) {
  using op = operations<P>;
  const pair clipped = max(pair{0, -checking::infinity}, flip_first(x));
  if (!all(op::sqrt_range(flip_first(x)))) [[unlikely]]
    return to_interval<P>(general_sqrt<P>(x));
  const pair root = flip_first(op::sqrt_outward(clipped));
  const bits none = (bits)_mm_cmpunord_pd(root, root);
  return to_interval<P>((pair)((bits)root | (bits)_mm_unpackhi_pd((pair)none, (pair)none)));
}

} // namespace detail::packed

// Each takes the scope of its policies first: of `unprotected<upward>` and of `nearest` an empty
// one.

/// Encloses { s + t : s in x, t in y }. Error: 0 ulp per endpoint, as of all of these.
template <PackedPolicies P>
GRAZE_INLINE interval_of<P> operator+(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::sum<P>(detail::packed::load(x), detail::packed::load(y));
}
/// Encloses { s - t : s in x, t in y }.
template <PackedPolicies P>
GRAZE_INLINE interval_of<P> operator-(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::difference<P>(detail::packed::load(x), detail::packed::load(y));
}
/// Encloses { s t : s in x, t in y }.
template <PackedPolicies P>
GRAZE_INLINE interval_of<P> operator*(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::product<P>(detail::packed::load(x), detail::packed::load(y));
}
/// Encloses { s / t : s in x, t in y, t != 0 }; empty for y = [0, 0].
template <PackedPolicies P>
GRAZE_INLINE interval_of<P> operator/(const interval_of<P>& x, const interval_of<P>& y) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::quotient<P>(detail::packed::load(x), detail::packed::load(y));
}
/// Encloses { t^2 : t in x }.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> square(const interval_of<P>& x) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::square<P>(detail::packed::load(x));
}
/// Encloses { sqrt t : t in x, t >= 0 }.
template <PackedPolicies P> GRAZE_INLINE interval_of<P> sqrt(const interval_of<P>& x) {
  [[maybe_unused]] const typename P::rounding scope;
  return detail::packed::square_root<P>(detail::packed::load(x));
}

} // namespace graze
