#pragma once
/// What a tape asks of eight intervals at once. For files compiled for the path's instructions. The
/// bounds are the scalar type's. Arithmetic, powers and polynomials are done in the lanes; of the
/// elementary functions each lane asks the library, unless a lane before it had the same operands,
/// as of an octant's children half have on each axis.
#include <graze/octree/eight.hpp>
#include <graze/octree_formula/evaluate.hpp>

namespace graze::octree::tape {

namespace detail {

/// Bounds of eight intervals.
struct eight_bounds {
  alignas(64) double lo[8], hi[8];
  template <class Path> GRAZE_BATCH_INLINE explicit eight_bounds(const interval8<Path>& x) {
    x.store(lo, hi);
  }
  GRAZE_BATCH_INLINE bounds lane(unsigned i) const { return {lo[i], hi[i]}; }
  GRAZE_BATCH_INLINE bool same(unsigned i, unsigned j) const {
    return lo[i] == lo[j] && hi[i] == hi[j]; // not so of empty ones
  }
};

} // namespace detail

template <class Path>
struct operations<interval8<Path>> : detail::interval_operations<interval8<Path>> {
  using I = interval8<Path>;

  static GRAZE_BATCH_INLINE I sqrt(const I& x) {
    return I::template lanewise<&batch::formulas<Path>::sqrt>(x);
  }
  static I pown(const I& x, int n) {
    if (n > 2 && n <= most_multiplied)
      return multiplied_power(x, n);
    return by_lane(x, [n](const bounds& t) { return functions::pown::value(t, n); });
  }
  static I rootn(const I& x, int n) {
    return by_lane(x, [n](const bounds& t) { return functions::rootn::value(t, n); });
  }
  static I pow(const I& x, const I& y) { return by_lane<&functions::pow::value>(x, y); }
  static I hypot(const I& x, const I& y) { return by_lane<&functions::hypot::value>(x, y); }
  static I atan2(const I& y, const I& x) { return by_lane<&functions::atan2::value>(y, x); }
#define GRAZE_TAPE_FUNCTION(name)                                                                  \
  static I name(const I& x) {                                                                      \
    return by_lane(x, [](const bounds& t) { return functions::name::value(t); });                  \
  }
  GRAZE_TAPE_FUNCTIONS(GRAZE_TAPE_FUNCTION)
#undef GRAZE_TAPE_FUNCTION

private:
  template <class Function> static I by_lane(const I& x, Function f) {
    detail::eight_bounds b(x);
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i) {
      unsigned j = 0;
      while (j < i && !b.same(i, j))
        ++j;
      const bounds v = j < i ? r.lane(j) : f(b.lane(i));
      r.lo[i] = v.lo;
      r.hi[i] = v.hi;
    }
    return I::load(r.lo, r.hi);
  }
  template <auto Function> static I by_lane(const I& x, const I& y) {
    detail::eight_bounds a(x), b(y);
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i) {
      unsigned j = 0;
      while (j < i && !(a.same(i, j) && b.same(i, j)))
        ++j;
      const bounds v = j < i ? r.lane(j) : Function(a.lane(i), b.lane(i));
      r.lo[i] = v.lo;
      r.hi[i] = v.hi;
    }
    return I::load(r.lo, r.hi);
  }
};

template <class Path> struct continuity<interval8<Path>> {
  using I = interval8<Path>;
  static constexpr unsigned everywhere = 0xff;
  static unsigned bits(opcode op, const I& a, const I& b, int n) {
    const detail::eight_bounds first(a), second(b);
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      if (continuous_on(op, first.lane(i), second.lane(i), n))
        mask |= 1u << i;
    return mask;
  }
  static unsigned chosen(const I& a, unsigned if_positive, unsigned if_not) {
    const detail::eight_bounds b(a);
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      mask |= (b.lo[i] > 0 ? if_positive : b.hi[i] <= 0 ? if_not : 0) & 1u << i;
    return mask;
  }
  static GRAZE_BATCH_INLINE I defined(const I& x) {
    return I::template lanewise<&detail::tape_lanes<Path>::defined>(x);
  }
  static I where(unsigned continuous, const I& x) {
    detail::eight_bounds r(x);
    for (unsigned i = 0; i < 8; ++i)
      if ((continuous >> i & 1) == 0) {
        r.lo[i] = -checking::infinity;
        r.hi[i] = checking::infinity;
      }
    return I::load(r.lo, r.hi);
  }
};

} // namespace graze::octree::tape
