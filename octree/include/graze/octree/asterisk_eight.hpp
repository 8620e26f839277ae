#pragma once
/// The asterisks over eight boxes at once: the operations of asterisk.hpp, so the same bounds.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/asterisk.hpp>
#include <graze/octree/eight.hpp>

namespace graze::octree {

namespace detail {
template <class P> struct angular_lanes {
  using vector = typename P::vector;
  using mask = typename P::mask;
  using part = batch::part<P>;

  static GRAZE_BATCH_INLINE part lower_end(const part& x) { return {x.lo, x.lo}; }
  static GRAZE_BATCH_INLINE part upper_end(const part& x) { return {x.hi, x.hi}; }
  static GRAZE_BATCH_INLINE part near_rho(const part& z, const part& rho) {
    const vector v = P::select(P::less_equal(P::zero(), z.hi), rho.lo, rho.hi);
    return {v, v};
  }
  static GRAZE_BATCH_INLINE part far_rho(const part& z, const part& rho) {
    const vector v = P::select(P::less_equal(P::zero(), z.lo), rho.hi, rho.lo);
    return {v, v};
  }
  static GRAZE_BATCH_INLINE part between(const part& a, const part& b, const part& above,
                                         const part& below) {
    const vector one = P::broadcast(1), minus = P::broadcast(-1);
    const vector lo = P::min_or_second(a.lo, b.lo), hi = P::max_or_second(a.hi, b.hi);
    const mask turns =
        P::both(P::less_equal(P::zero(), a.hi),
                P::both(P::less_equal(P::zero(), above.hi), P::less_equal(below.lo, P::zero())));
    const mask known = P::both(P::less_equal(a.lo, a.hi), P::less_equal(b.lo, b.hi));
    const mask low = P::both(known, P::less(minus, lo)), high = P::both(known, P::less(hi, one));
    return {P::select(low, lo, minus), P::select(high, P::select(turns, one, hi), one)};
  }
  static GRAZE_BATCH_INLINE part turned(const part& t, const part& a, const part& b) {
    const vector one = P::broadcast(1), minus = P::broadcast(-1), half = P::broadcast(0.5),
                 minus_half = P::broadcast(-0.5);
    const vector lo = P::min_or_second(a.lo, b.lo), hi = P::max_or_second(a.hi, b.hi);
    const mask falls = P::both(P::less_equal(t.lo, half), P::less_equal(half, t.hi)),
               rises = P::both(P::less_equal(t.lo, minus_half), P::less_equal(minus_half, t.hi));
    return {P::select(P::less(minus, lo), P::select(falls, minus, lo), minus),
            P::select(P::less(hi, one), P::select(rises, one, hi), one)};
  }
  static GRAZE_BATCH_INLINE part limited(const part& x, const part& limit) {
    const vector most = limit.hi, least = P::neg(most);
    return {P::select(P::less(least, x.lo), x.lo, least),
            P::select(P::less(x.hi, most), x.hi, most)};
  }
};
} // namespace detail

template <class Path>
struct angular<interval8<Path>>
    : detail::angular_intervals<angular<interval8<Path>>, interval8<Path>> {
  using I = interval8<Path>;
  using lanes = detail::angular_lanes<Path>;
  static GRAZE_BATCH_INLINE I bounds_of(const rational_bounds& c) { return I(c.lo, c.hi); }
  static GRAZE_BATCH_INLINE I magnitude(const I& x) { return abs(x); }
  static GRAZE_BATCH_INLINE I root(const I& x) { return sqrt(x); }
  static GRAZE_BATCH_INLINE I reciprocal(const I& x) { return I(1.0) / x; }
  static GRAZE_BATCH_INLINE I lower_end(const I& x) {
    return I::template lanewise<&lanes::lower_end>(x);
  }
  static GRAZE_BATCH_INLINE I upper_end(const I& x) {
    return I::template lanewise<&lanes::upper_end>(x);
  }
  static GRAZE_BATCH_INLINE void corner(const I& z, const I& rho, bool far, I& u, I& v) {
    u = far ? lower_end(z) : upper_end(z);
    v = far ? I::template lanewise<&lanes::far_rho>(z, rho)
            : I::template lanewise<&lanes::near_rho>(z, rho);
  }
  static GRAZE_BATCH_INLINE I between(const I& a, const I& b, const I& above, const I& below) {
    return I::template lanewise<&lanes::between>(a, b, above, below);
  }
  static GRAZE_BATCH_INLINE I turned(const I& t, const I& a, const I& b) {
    return I::template lanewise<&lanes::turned>(t, a, b);
  }
  static GRAZE_BATCH_INLINE I limited(const I& x, const I& limit) {
    return I::template lanewise<&lanes::limited>(x, limit);
  }
};

} // namespace graze::octree
