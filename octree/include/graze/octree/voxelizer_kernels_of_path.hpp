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

/// The points of the lattice, eight in an octet, 27 and five to spare: numbers of halves.
struct lattice_points {
  alignas(64) std::int64_t of[3][32];
};
consteval lattice_points make_lattice_points() {
  lattice_points r{};
  for (int p = 0; p < 27; ++p) {
    r.of[0][p] = p % 3;
    r.of[1][p] = p / 3 % 3;
    r.of[2][p] = p / 9;
  }
  return r;
}
inline constexpr lattice_points lattice = make_lattice_points();

/// The coordinates of points 8 k to 8 k + 7 on axis a, of the three that there are.
template <class Path>
GRAZE_BATCH_INLINE octet<Path> lattice_coordinates(const double (&three)[8], int a, int k) {
#if defined(__AVX512F__)
  if constexpr (Path::width == 8) {
    octet<Path> r;
    r.part[0] = _mm512_permutexvar_pd(_mm512_load_si512(lattice.of[a] + 8 * k),
                                      _mm512_load_pd(three));
    return r;
  } else
#endif
  {
    alignas(64) double at[8];
    for (int i = 0; i < 8; ++i)
      at[i] = three[lattice.of[a][8 * k + i]];
    return octet<Path>::load(at);
  }
}

/// The three coordinates on each axis; exact in a root_cube, so in any mode.
struct lattice_axes {
  alignas(64) double at[3][8];
  GRAZE_BATCH_INLINE lattice_axes(const double* corner, double half) {
    for (int a = 0; a < 3; ++a) {
      at[a][0] = corner[a];
      at[a][1] = corner[a] + half;
      at[a][2] = at[a][1] + half;
      for (int i = 3; i < 8; ++i)
        at[a][i] = corner[a];
    }
  }
};

template <class Path>
GRAZE_BATCH_INLINE eight_boxes<Path> children_of(const double* corner, double half) {
  alignas(64) const double lo[8] = {corner[0], corner[1], corner[2], 0,
                                    corner[0], corner[1], corner[2], 0};
  const auto at = octet<Path>::load(lo);
  return eight_boxes<Path>::children(at, octet<Path>::add_up(at, octet<Path>::broadcast(half)),
                                     half);
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
    return have_no_zero(f, children_of<Path>(corner, half), 0xff);
  }

  static lattice_signs signs(const F& f, const double* corner, double half) {
    const lattice_axes axes(corner, half);
    lattice_signs r{0, 0};
#pragma GCC unroll 1
    for (int k = 0; k < 4; ++k) {
      eight_boxes<Path> points;
#pragma GCC unroll 3
      for (int a = 0; a < 3; ++a)
        points.lo[a] = points.hi[a] = lattice_coordinates<Path>(axes.at[a], a, k);
      const eight_signs s = signs_at(f, points);
      r.positive |= s.positive << (8 * k);
      r.negative |= s.negative << (8 * k);
    }
    return r;
  }

  static unsigned none_of_one_sign(const F& f, const double* corner, double half) {
    const eight_boxes<Path> b = children_of<Path>(corner, half);
    const I x = b.axis(0), y = b.axis(1), z = b.axis(2);
    using d = dual<I>;
    const d at = f(d::variable(x, 0), d::variable(y, 1), d::variable(z, 2));
    const unsigned monotone = excludes_zero(at.partial[0]) & excludes_zero(at.partial[1]) &
                              excludes_zero(at.partial[2]);
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
  return {&k::no_zero, &k::signs, &k::none_of_one_sign};
}

} // namespace graze::octree
