#include <graze/oracle/elementary.hpp>
#include <graze/oracle/reverse.hpp>

namespace graze::oracle::reverse {

namespace {

template <class Function, class... Doubles> rounded_value by_mpfr(Function f, Doubles... x) {
  return {rounded_down(f, x...), rounded_up(f, x...)};
}

const rounded_value plus_infinity = value_below(unbounded),
                    minus_infinity = value_above(-unbounded);

/// u t for a bound u of b, which is not attained where it is infinite.
rounded_value times(double u, place p) {
  const double sign = p.t == 0 ? p.side : p.t;
  if (u == 0 || sign == 0)
    return exact_value(0);
  const bool negative = (u < 0) != (sign < 0);
  if (std::isinf(u) || std::isinf(p.t))
    return negative ? minus_infinity : plus_infinity;
  if (p.side != 0)
    return negative ? value_below(0) : value_above(0);
  return by_mpfr(mpfr_mul, u, p.t);
}
image multiples(const bounds& b, place p) {
  const rounded_value at_lo = times(b.lo, p), at_hi = times(b.hi, p);
  const bool reversed = (p.t == 0 ? p.side : p.t) < 0;
  return reversed ? image{at_hi, at_lo} : image{at_lo, at_hi};
}

/// u^y for u > 0 and real y, each of them a double or infinitely close to one: 0, 1, or unbounded.
rounded_value power(place u, place y) {
  const double exponent_sign = y.t == 0 ? y.side : y.t;
  const double base_side = u.t == 1 ? u.side : u.t - 1;
  if (exponent_sign == 0 || base_side == 0)
    return exact_value(1);
  const bool grows = (exponent_sign > 0) == (base_side > 0);
  if ((u.t == 0 && u.side > 0) || std::isinf(u.t) || std::isinf(y.t))
    return grows ? plus_infinity : value_above(0);
  if (u.side != 0 || y.side != 0)
    return grows ? value_above(1) : value_below(1);
  return by_mpfr(mpfr_pow, u.t, y.t);
}
place member(double end) { return {end, std::isinf(end) ? (end < 0 ? 1 : -1) : 0}; }

image powers_of(place t, const bounds& b) { // { t^y : y in b }
  if (t.t < 0 || (t.t == 0 && t.side < 0))
    return undefined_image;
  if (t.t == 0 && t.side == 0)
    return b.hi > 0 ? single(exact_value(0)) : undefined_image;
  const rounded_value at_lo = power(t, member(b.lo)), at_hi = power(t, member(b.hi));
  const bool falls = t.t < 1 || (t.t == 1 && t.side < 0);
  return falls ? image{at_hi, at_lo} : image{at_lo, at_hi};
}
image powers_to(place t, const bounds& a) { // { u^t : u in a }
  const double sign = t.t == 0 ? t.side : t.t;
  if (a.hi < 0 || (a.hi == 0 && sign <= 0))
    return undefined_image;
  if (a.hi == 0)
    return single(exact_value(0));
  const rounded_value largest_base = power(member(a.hi), t);
  if (a.lo > 0) {
    const rounded_value least_base = power(member(a.lo), t);
    return sign < 0 ? image{largest_base, least_base} : image{least_base, largest_base};
  }
  if (sign > 0)
    return {exact_value(0), largest_base};
  return sign < 0 ? image{largest_base, plus_infinity} : single(exact_value(1));
}

} // namespace

image abs_at(place p) {
  if (std::isinf(p.t))
    return single(plus_infinity);
  return single(p.side == 0 ? exact_value(std::fabs(p.t)) : value_above(0));
}
image sqr_at(place p) {
  return std::isinf(p.t) || p.side != 0 ? abs_at(p) : single(by_mpfr(mpfr_sqr, p.t));
}
image cosh_at(place p) {
  if (std::isinf(p.t))
    return single(plus_infinity);
  return single(p.side == 0 ? by_mpfr(mpfr_cosh, p.t) : value_above(1));
}

image pown_at(place p, int n) {
  if (n == 0)
    return single(exact_value(1));
  const bool at_0 = p.t == 0;
  if (at_0 && p.side == 0)
    return n < 0 ? undefined_image : single(exact_value(0));
  if (at_0 || std::isinf(p.t)) {
    const bool negative = n % 2 != 0 && (at_0 ? p.side : p.t) < 0;
    if (at_0 == (n < 0))
      return single(negative ? minus_infinity : plus_infinity);
    return single(negative ? value_below(0) : value_above(0));
  }
  return single(by_mpfr(
      [n](mpfr_ptr r, mpfr_ptr t, mpfr_rnd_t to) { return mpfr_pow_si(r, t, n, to); }, p.t));
}

reverse_judge of_mul(const bounds& b, const bounds& c) {
  return {[b](place p) { return multiples(b, p); }, {0}, c};
}
reverse_judge of_pow1(const bounds& b, const bounds& c) {
  return {[b](place p) { return powers_of(p, b); }, {0, 1}, c};
}
reverse_judge of_pow2(const bounds& a, const bounds& c) {
  return {[a](place p) { return powers_to(p, a); }, {0}, c};
}

} // namespace graze::oracle::reverse
