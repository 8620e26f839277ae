#pragma once
/// + - * / sqr sqrt of intervals whose backend rounds two numbers at once (`upward`, `nearest`, on
/// x86-64). The same sets as from the operators that serve every backend: tightest. Without a
/// branch where both operands are bounded and no result overflows, since the signs of bounds are a
/// coin toss to a processor; the rest goes to those operators.
///
/// In here an interval [a, b] is the pair (-a, b). A zero bound is of either sign.
#include <graze/rounding/packed.hpp>

namespace graze {

/// Policies whose backend has `pair_operations`.
template <class P>
concept PackedPolicies =
    Policies<P> && requires { typename P::rounding::backend::pair_operations; };

namespace detail::packed {
using namespace rounding::packed;

template <Policies P> GRAZE_INLINE pair load(const interval_of<P>& x) {
  return pair{x.lower(), x.upper()};
}
template <Policies P> GRAZE_INLINE interval_of<P> to_interval(pair x) {
  return interval_of<P>(x[0], x[1], true);
}
/// No half is NaN, +inf, or (a double cannot be) more.
GRAZE_INLINE bits below_infinity(pair x) { return (bits)_mm_cmplt_pd(x, both(checking::infinity)); }

// The general operators, on bounds in a register: an operand whose address left the fast path could
// not stay in one.
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_add(pair x, pair y) {
  return load<P>(boost::numeric::operator+(to_interval<P>(x), to_interval<P>(y)));
}
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_sub(pair x, pair y) {
  return load<P>(boost::numeric::operator-(to_interval<P>(x), to_interval<P>(y)));
}
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_mul(pair x, pair y) {
  return load<P>(boost::numeric::operator*(to_interval<P>(x), to_interval<P>(y)));
}
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_div(pair x, pair y) {
  return load<P>(divide(to_interval<P>(x), to_interval<P>(y)));
}
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_sqr(pair x) {
  return load<P>(boost::numeric::square(to_interval<P>(x)));
}
template <Policies P> [[gnu::cold, gnu::noinline]] pair general_sqrt(pair x) {
  return load<P>(boost::numeric::sqrt(to_interval<P>(x)));
}

template <class P> using operations = typename P::rounding::backend::pair_operations;

// Sums have no special case: an empty operand's NaN reaches a bound, and where infinities of the
// empty [inf, inf] go, no non-empty set comes out.
template <Policies P> GRAZE_INLINE interval_of<P> sum(pair x, pair y) {
  const result r = operations<P>::sub_add(flip_first(x), y);
  if (!all(r.good)) [[unlikely]]
    return to_interval<P>(general_add<P>(x, y));
  return to_interval<P>(flip_first(r.value));
}
/// x - y = x + -y, and -y is (d, -c).
template <Policies P> GRAZE_INLINE interval_of<P> difference(pair x, pair y) {
  const result r = operations<P>::add(flip_first(x), swapped(flip_first(y)));
  if (!all(r.good)) [[unlikely]]
    return to_interval<P>(general_sub<P>(x, y));
  return to_interval<P>(flip_first(r.value));
}

/// The greatest of the four products, of each sign. If no half is infinite or NaN, then no operand
/// was unbounded or empty, but for a factor [0, 0]: a product +inf stays to the end (max gives its
/// second operand for a NaN), as does a NaN of the last product, of which an empty factor always
/// makes one.
template <Policies P> GRAZE_INLINE interval_of<P> product(pair x, pair y) {
  using op = operations<P>;
  const pair n = flip_first(x), other = negated(swapped(n)), reversed = swapped(y);
  const pair r = max(op::mul(n, y),
                     max(op::mul(n, reversed), max(op::mul(other, y), op::mul(other, reversed))));
  if (!all(below_infinity(r) & op::mul_range(x) & op::mul_range(y))) [[unlikely]]
    return to_interval<P>(general_mul<P>(x, y));
  return to_interval<P>(flip_first(r));
}

/// (-a, b) over a divisor between `least` and `greatest`, which are not negative: each half over
/// the one if it is positive and over the other if not.
template <Policies P>
GRAZE_INLINE interval_of<P> quotient_by_positive(pair x, pair y, pair numerator, pair least,
                                                 pair greatest) {
  using op = operations<P>;
  const bits positive = (bits)_mm_cmpgt_pd(numerator, both(0));
  const pair r = op::div(numerator, select(positive, least, greatest));
  // nothing unbounded or empty, nothing divided by 0, nor by the empty [inf, inf]
  const bits good = below_infinity(r) & below_infinity(least);
  if (!all(good & op::div_range(x) & op::div_range(y))) [[unlikely]]
    return to_interval<P>(general_div<P>(x, y));
  return to_interval<P>(flip_first(r));
}

/// Three cases by y's signs, since where y has numbers of both no division is needed. For y < 0 it
/// is -x / -y, and -x is (b, -a).
template <Policies P> GRAZE_INLINE interval_of<P> quotient(pair x, pair y) {
  const int negative = _mm_movemask_pd(y);
  if (negative == 0)
    return quotient_by_positive<P>(x, y, flip_first(x), _mm_unpacklo_pd(y, y),
                                   _mm_unpackhi_pd(y, y));
  if (negative == 3) {
    const pair size = negated(y);
    return quotient_by_positive<P>(x, y, swapped(flip_first(x)), _mm_unpackhi_pd(size, size),
                                   _mm_unpacklo_pd(size, size));
  }
  // c < 0 < d, and x has a number but 0
  const pair size = magnitude(x);
  if (all((bits)_mm_cmpgt_pd(flip_first(y), both(0)) & (bits)_mm_cmpgt_pd(size, both(0)) &
          below_infinity(size))) [[likely]]
    return interval_of<P>::whole();
  return to_interval<P>(general_div<P>(x, y));
}

/// (near, far) = (min |t|, max |t|); then (-near, far) * (near, far).
template <Policies P> GRAZE_INLINE interval_of<P> square(pair x) {
  using op = operations<P>;
  const pair factor = max(both(0), max(x, negated(swapped(x)))); // NaN stays
  const pair r = op::mul(flip_first(factor), factor);
  if (!all(op::mul_range(factor))) [[unlikely]]
    return to_interval<P>(general_sqr<P>(x));
  return to_interval<P>(flip_first(r));
}

/// A negative upper bound has a NaN for a root, which makes both bounds NaN.
template <Policies P> GRAZE_INLINE interval_of<P> square_root(pair x) {
  using op = operations<P>;
  const pair clipped = max(pair{0, -checking::infinity}, x);
  if (!all(op::sqrt_range(clipped))) [[unlikely]]
    return to_interval<P>(general_sqrt<P>(x));
  const pair root = op::sqrt_outward(clipped);
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
