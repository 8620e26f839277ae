#pragma once
/// The voxelizer's kernels of a path, for a file compiled for its instructions, with optimization:
/// functions that are not templates over the path must not be emitted there (see batch/path.hpp).
#include <graze/octree/inclusion_eight.hpp>
#include <graze/octree/voxelizer_kernels.hpp>

namespace graze::octree {

namespace detail {
/// One partial derivative of the lesser of two numbers, as lesser of dual.hpp has it.
template <class P> struct lesser_partial_lanes {
  using part = batch::part<P>;
  static GRAZE_BATCH_INLINE part of(const part& a, const part& b, const part& da, const part& db) {
    const auto first = P::less(a.hi, b.lo), second = P::less(b.hi, a.lo);
    const auto choose = [&](auto p, auto q, auto both) {
      return P::select(first, p, P::select(second, q, both));
    };
    return {choose(da.lo, db.lo, P::min_or_second(da.lo, db.lo)),
            choose(da.hi, db.hi, P::max_or_second(da.hi, db.hi))};
  }
};

/// An octant's corner, mid-planes and far corner on each axis; exact in a root_cube, so in any
/// mode.
struct octant_planes {
  double at[3][3];
  GRAZE_BATCH_INLINE octant_planes(const double* corner, double half) {
    for (int a = 0; a < 3; ++a) {
      at[a][0] = corner[a];
      at[a][1] = corner[a] + half;
      at[a][2] = at[a][1] + half;
    }
  }
};

/// `zero`, `one` or `two` in each lane: lane i's is the number of sets, of these two, that i is in.
template <class Path>
GRAZE_BATCH_INLINE octet<Path> one_of_three(unsigned at_least_one, unsigned two,
                                            const double (&values)[3]) {
  const auto v = [&](int i) { return octet<Path>::broadcast(values[i]); };
  return chosen(two, v(2), chosen(at_least_one, v(1), v(0)));
}

template <class Path> GRAZE_BATCH_INLINE eight_boxes<Path> children_of(const octant_planes& p) {
  constexpr unsigned upper[3] = {0xaa, 0xcc, 0xf0}; // children on the upper side of each mid-plane
  eight_boxes<Path> r;
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    r.lo[a] = one_of_three<Path>(upper[a], 0, p.at[a]);
    r.hi[a] = one_of_three<Path>(0xff, upper[a], p.at[a]);
  }
  return r;
}

/// The corners of an octant's children are 27 points: number x + 3 y + 9 z is x, y, z halves of the
/// octant away from its lower corner. Five more, to fill octets, are of no account.
/// The set of points 8 k to 8 k + 7 that are at least n halves away on axis a.
consteval unsigned lattice_points(int a, int k, int n) {
  unsigned r = 0;
  for (int i = 0; i < 8; ++i) {
    const int p = 8 * k + i, along[3] = {p % 3, p / 3 % 3, p / 9};
    r |= (along[a] >= n ? 1u : 0u) << i;
  }
  return r;
}
template <class Path, int K> GRAZE_BATCH_INLINE eight_boxes<Path> points(const octant_planes& p) {
  eight_boxes<Path> r;
  r.lo[0] = r.hi[0] = one_of_three<Path>(lattice_points(0, K, 1), lattice_points(0, K, 2), p.at[0]);
  r.lo[1] = r.hi[1] = one_of_three<Path>(lattice_points(1, K, 1), lattice_points(1, K, 2), p.at[1]);
  r.lo[2] = r.hi[2] = one_of_three<Path>(lattice_points(2, K, 1), lattice_points(2, K, 2), p.at[2]);
  return r;
}

/// Bits 0, 1, 3, 4, 9, 10, 12, 13, the points that are the children's lower corners, as bits 0
/// to 7.
GRAZE_BATCH_INLINE unsigned of_children(unsigned points) {
  return (points & 3u) | (points >> 1 & 0xcu) | (points >> 5 & 0x30u) | (points >> 6 & 0xc0u);
}
/// The children with one, or with all, of their corners among the points.
GRAZE_BATCH_INLINE unsigned at_any_corner(unsigned points) {
  points |= points >> 1;
  points |= points >> 3;
  return of_children(points | points >> 9);
}
GRAZE_BATCH_INLINE unsigned at_all_corners(unsigned points) {
  points &= points >> 1;
  points &= points >> 3;
  return of_children(points & points >> 9);
}
} // namespace detail

/// lesser of dual.hpp in each lane: the same operations, so the same bounds.
template <class Path, std::size_t N>
GRAZE_BATCH_INLINE dual<interval8<Path>, N> lesser(const dual<interval8<Path>, N>& a,
                                                   const dual<interval8<Path>, N>& b) {
  using I = interval8<Path>;
  dual<I, N> r{min(a.value, b.value), {}};
  for (std::size_t i = 0; i < N; ++i)
    r.partial[i] = I::template lanewise<&detail::lesser_partial_lanes<Path>::of>(
        a.value, b.value, a.partial[i], b.partial[i]);
  return r;
}

namespace detail {
template <class Path, class F> struct voxelizer_kernel {
  using I = interval8<Path>;

  static unsigned no_zero(const F& f, const double* corner, double half) {
    return have_no_zero(f, children_of<Path>(octant_planes(corner, half)), 0xff);
  }

  template <int K>
  static GRAZE_BATCH_INLINE void look_at(const F& f, const octant_planes& p, eight_signs& all) {
    const eight_signs s = signs_at(f, points<Path, K>(p));
    all.positive |= s.positive << (8 * K);
    all.negative |= s.negative << (8 * K);
  }
  static leaf_signs leaves(const F& f, const double* corner, double half) {
    const octant_planes p(corner, half);
    const unsigned kept = ~have_no_zero(f, children_of<Path>(p), 0xff) & 0xff;
    if (kept == 0)
      return {0, 0, 0};
    eight_signs at{0, 0};
    look_at<0>(f, p, at);
    look_at<1>(f, p, at);
    look_at<2>(f, p, at);
    look_at<3>(f, p, at);
    const unsigned certified = at_any_corner(at.positive) & at_any_corner(at.negative);
    const unsigned one_sign = at_all_corners(at.positive) | at_all_corners(at.negative);
    return {static_cast<std::uint8_t>(kept), static_cast<std::uint8_t>(kept & certified),
            static_cast<std::uint8_t>(kept & one_sign)};
  }

  static unsigned none_of_one_sign(const F& f, const double* corner, double half) {
    const eight_boxes<Path> b = children_of<Path>(octant_planes(corner, half));
    const I x = b.axis(0), y = b.axis(1), z = b.axis(2);
    using d = dual<I>;
    const d at = f(d::variable(x, 0), d::variable(y, 1), d::variable(z, 2));
    const unsigned monotone =
        excludes_zero(at.partial[0]) & excludes_zero(at.partial[1]) & excludes_zero(at.partial[2]);
    const auto centre = [](const I& t) {
      return I::template lanewise<&sign_lanes<Path>::centre>(t);
    };
    const I cx = centre(x), cy = centre(y), cz = centre(z);
    I r = f(cx, cy, cz);
    r = r + at.partial[0] * (x - cx);
    r = r + at.partial[1] * (y - cy);
    r = r + at.partial[2] * (z - cz);
    return monotone | excludes_zero(r);
  }
};
} // namespace detail

template <class Path, Surface F> consteval voxelizer_kernels<F> make_voxelizer_kernels() {
  using k = detail::voxelizer_kernel<Path, F>;
  return {&k::no_zero, &k::leaves, &k::none_of_one_sign};
}

} // namespace graze::octree
