#pragma once
/// What intervals prove about a surface in the eight children of an octant, in the lanes of a path:
/// the verdicts of inclusion.hpp in each.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/dual.hpp>
#include <graze/octree/eight.hpp>
#include <graze/octree/inclusion.hpp>
#include <graze/octree/octet.hpp>
#include <graze/octree/surface.hpp>
#include <utility>

namespace graze::octree {

/// Eight closed boxes; lane i is child i.
template <class Path> struct eight_boxes {
  using numbers = octet<Path>;
  numbers lo[3], hi[3];

  /// The children of the octant with this lower corner and mid-planes (lanes 0 to 2: x, y, z).
  static GRAZE_BATCH_INLINE eight_boxes children(const numbers& corner, const numbers& mid,
                                                 double half) {
    const numbers far = numbers::add_up(mid, numbers::broadcast(half)); // exact in a root_cube
    return {{spread<0, 0>(corner, mid), spread<1, 1>(corner, mid), spread<2, 2>(corner, mid)},
            {spread<0, 0>(mid, far), spread<1, 1>(mid, far), spread<2, 2>(mid, far)}};
  }
  /// The eight corners of one octant.
  static GRAZE_BATCH_INLINE eight_boxes corners(const numbers& corner, double size) {
    const numbers far = numbers::add_up(corner, numbers::broadcast(size));
    const numbers x = spread<0, 0>(corner, far), y = spread<1, 1>(corner, far),
                  z = spread<2, 2>(corner, far);
    return {{x, y, z}, {x, y, z}};
  }

  /// Cuts them by the domain; the lanes in which nothing is left.
  template <class Box> GRAZE_BATCH_INLINE unsigned cut(const Box& domain) {
    unsigned nothing = 0;
    for (int a = 0; a < 3; ++a) {
      lo[a] = numbers::max(numbers::broadcast(domain.lo[a]), lo[a]);
      hi[a] = numbers::min(numbers::broadcast(domain.hi[a]), hi[a]);
      nothing |= numbers::less(hi[a], lo[a]);
    }
    return nothing;
  }

  [[nodiscard]] GRAZE_BATCH_INLINE interval8<Path> axis(int a) const {
    batch::part<Path> p[numbers::count];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < numbers::count; ++i)
      p[i] = {lo[a].part[i], hi[a].part[i]};
    return interval8<Path>::from_registers(p);
  }
};

namespace detail {
template <class P> struct sign_lanes {
  using mask = typename P::mask;
  static GRAZE_BATCH_INLINE mask positive(const batch::part<P>& x) {
    return P::less(P::zero(), x.lo);
  }
  static GRAZE_BATCH_INLINE mask negative(const batch::part<P>& x) {
    return P::less(x.hi, P::zero());
  }
  static GRAZE_BATCH_INLINE mask either(const batch::part<P>& x) {
    return P::either(positive(x), negative(x));
  }
  static GRAZE_BATCH_INLINE batch::part<P> centre(const batch::part<P>& x) {
    const auto c = detail::centre<P>(x.lo, x.hi);
    return {c, c};
  }
};
} // namespace detail

/// Lanes in which every number is positive; false in a lane that is empty.
template <class Path> GRAZE_BATCH_INLINE unsigned certainly_positive(const interval8<Path>& v) {
  return interval8<Path>::template lanes_where<&detail::sign_lanes<Path>::positive>(v).bits;
}
template <class Path> GRAZE_BATCH_INLINE unsigned certainly_negative(const interval8<Path>& v) {
  return interval8<Path>::template lanes_where<&detail::sign_lanes<Path>::negative>(v).bits;
}
/// excludes_zero of inclusion.hpp in each lane.
template <class Path> GRAZE_BATCH_INLINE unsigned excludes_zero(const interval8<Path>& v) {
  return interval8<Path>::template lanes_where<&detail::sign_lanes<Path>::either>(v).bits;
}

/// mean_value_form of inclusion.hpp in each lane.
template <class Path, class F>
GRAZE_BATCH_INLINE interval8<Path> mean_value_form(const F& f, const interval8<Path>& x,
                                                   const interval8<Path>& y,
                                                   const interval8<Path>& z) {
  using I = interval8<Path>;
  using d = dual<I>;
  const d at = f(d::variable(x, 0), d::variable(y, 1), d::variable(z, 2));
  const auto centre = [](const I& t) {
    return I::template lanewise<&detail::sign_lanes<Path>::centre>(t);
  };
  const I cx = centre(x), cy = centre(y), cz = centre(z);
  I r = f(cx, cy, cz);
  r = r + at.partial[0] * (x - cx);
  r = r + at.partial[1] * (y - cy);
  r = r + at.partial[2] * (z - cz);
  return r;
}

/// has_no_zero of inclusion.hpp in each of `wanted`'s lanes (a bit of the others has no meaning):
/// by the natural extension and, for a surface of which that does not suffice, by the mean value
/// form where it leaves a wanted lane open. Domain: boxes that are not empty in the wanted lanes.
template <class Path, class F>
GRAZE_BATCH_INLINE unsigned have_no_zero(const F& f, const eight_boxes<Path>& b, unsigned wanted) {
  using I = interval8<Path>;
  const I x = b.axis(0), y = b.axis(1), z = b.axis(2);
  unsigned none = excludes_zero(f(x, y, z));
  if constexpr (!natural_extension_suffices<F>()) {
    if ((wanted & ~none) != 0 && !natural_extension_suffices(f))
      none |= excludes_zero(mean_value_form(f, x, y, z));
  } else {
    static_cast<void>(wanted);
  }
  return none;
}

/// Certified signs of f at eight points, as bits.
struct eight_signs {
  unsigned positive, negative;
};
template <class Path, class F>
GRAZE_BATCH_INLINE eight_signs signs_at(const F& f, const eight_boxes<Path>& points) {
  const interval8<Path> v = f(points.axis(0), points.axis(1), points.axis(2));
  return {certainly_positive(v), certainly_negative(v)};
}

} // namespace graze::octree
