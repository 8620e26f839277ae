#pragma once
/// The judge of voxelizations with an octant's children in the lanes of a path: the verdicts of
/// scalar_judge. For files compiled for the path's instructions.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/inclusion_eight.hpp>
#include <graze/octree/sound_eight.hpp>
#include <graze/octree/voxelizer.hpp>

namespace graze::octree {

namespace detail {
/// The 27 points at which the corners of an octant's children lie, point k at the coordinates
/// (k % 3, k / 3 % 3, k / 9), each 0 (low face), 1 (mid-plane) or 2 (far face). Five more to fill
/// the last register repeat the point 26.
struct lattice_indices {
  /// Where an axis's coordinate is in the registers (x y z - X Y Z -), (far x y z ...).
  alignas(64) long long index[3][32];
};
consteval lattice_indices make_lattice_indices() {
  lattice_indices r{};
  for (int k = 0; k < 32; ++k) {
    const int point = k < 27 ? k : 26, digits[3] = {point % 3, point / 3 % 3, point / 9};
    for (int a = 0; a < 3; ++a)
      r.index[a][k] = 4 * digits[a] + a;
  }
  return r;
}
inline constexpr lattice_indices indices_of_lattice = make_lattice_indices();

/// Certified signs at the 27 points, as bits.
template <class Path, class F>
GRAZE_BATCH_INLINE eight_signs lattice_signs(const F& f, const octet<Path>& corner,
                                             const octet<Path>& mid, double half) {
  using numbers = octet<Path>;
  const numbers far = numbers::add_up(mid, numbers::broadcast(half));
  const numbers near = chosen(0x70, mid, corner);
  eight_signs s{0, 0};
  alignas(64) double planes[16];
  if constexpr (Path::width != 8) {
    near.store(planes);
    far.store(planes + 8);
  }
#pragma GCC unroll 4
  for (int eight = 0; eight < 4; ++eight) {
    eight_boxes<Path> points;
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const long long* const from = indices_of_lattice.index[a] + 8 * eight;
#if defined(__AVX512F__)
      if constexpr (Path::width == 8)
        points.lo[a].part[0] =
            _mm512_permutex2var_pd(near.part[0], _mm512_load_epi64(from), far.part[0]);
      else
#endif
      {
        alignas(64) double x[8];
        for (int i = 0; i < 8; ++i)
          x[i] = planes[from[i]];
        points.lo[a] = numbers::load(x);
      }
      points.hi[a] = points.lo[a];
    }
    const eight_signs here = signs_at(f, points);
    s.positive |= here.positive << 8 * eight;
    s.negative |= here.negative << 8 * eight;
  }
  return s;
}

/// Bit i: one of the corners of child i is among the points of the lattice.
GRAZE_BATCH_INLINE unsigned children_with(unsigned points) {
  points |= points >> 1;
  points |= points >> 3;
  points |= points >> 9;
  return (points & 3) | (points >> 1 & 0xc) | (points >> 5 & 0x30) | (points >> 6 & 0xc0);
}

} // namespace detail

/// An octant as the lanes have it.
template <class Path> struct eight_octant {
  using numbers = octet<Path>;
  numbers corner; ///< x, y, z in lanes 0 to 2 and 4 to 6
  double half;
  bool cut = true; ///< it may reach out of the domain

  GRAZE_BATCH_INLINE explicit eight_octant(const cube& cell)
      : corner(sound_eight<Path, convention::owned>::corner(cell)), half(cell.size / 2) {}
  GRAZE_BATCH_INLINE eight_octant(const numbers& c, double h, bool may_be_cut)
      : corner(c), half(h), cut(may_be_cut) {}

  [[nodiscard]] GRAZE_BATCH_INLINE numbers mid() const {
    return numbers::add_up(corner, numbers::broadcast(half)); // exact in a root_cube
  }
  [[nodiscard]] GRAZE_BATCH_INLINE eight_octant child(unsigned i) const {
    return {chosen(i << 4 | i, mid(), corner), half / 2, cut};
  }
  [[nodiscard]] GRAZE_BATCH_INLINE cube cell() const {
    alignas(64) double lo[8];
    corner.store(lo);
    return {{lo[0], lo[1], lo[2]}, 2 * half};
  }
};

/// Models ChildrenJudge. `f` must outlive it.
template <class Path, Surface F> class eight_judge {
public:
  using B = backend_beside<Path>;
  using scope = typename B::scope;
  using octant = eight_octant<Path>;
  using numbers = octet<Path>;

  GRAZE_BATCH_INLINE eight_judge(const F& f, const box& domain) : f_(f), domain_(domain) {}

  [[nodiscard]] GRAZE_BATCH_INLINE std::uint8_t open(octant& o) const {
    return static_cast<std::uint8_t>(kept(o, o.mid()));
  }

  [[nodiscard]] GRAZE_BATCH_INLINE leaf_children leaves(octant& o) const {
    const numbers mid = o.mid();
    const unsigned open = kept(o, mid);
    unsigned certified = 0;
    if (open == 0)
      return {};
    if (!o.cut && is_continuous(f_)) {
      const eight_signs s = detail::lattice_signs(f_, o.corner, mid, o.half);
      certified = open & detail::children_with(s.positive) & detail::children_with(s.negative);
    }
    leaf_children r{static_cast<std::uint8_t>(open), static_cast<std::uint8_t>(certified)};
    for (unsigned rest = open & ~certified; rest != 0; rest &= rest - 1) [[unlikely]] {
      const unsigned bit = rest & -rest;
      const box b = closed_box(o.cell().child(static_cast<unsigned>(__builtin_ctz(rest))));
      const content c = leaf_content<B>(f_, o.cut ? intersection(b, domain_) : b);
      if (c == content::none)
        r.mask = static_cast<std::uint8_t>(r.mask & ~bit);
      if (c == content::certified)
        r.certified = static_cast<std::uint8_t>(r.certified | bit);
    }
    return r;
  }

private:
  /// Children that may have a zero.
  GRAZE_BATCH_INLINE unsigned kept(octant& o, const numbers& mid) const {
    auto boxes = eight_boxes<Path>::children(o.corner, mid, o.half);
    unsigned outside = 0;
    if (o.cut) {
      const cube cell = o.cell();
      o.cut = false;
      for (int a = 0; a < 3; ++a)
        o.cut = o.cut || cell.lo[a] < domain_.lo[a] || domain_.hi[a] < cell.hi(a);
      if (o.cut)
        outside = boxes.cut(domain_);
    }
    return ~(have_no_zero(f_, boxes, ~outside) | outside) & 0xff;
  }

  const F& f_;
  box domain_;
};

} // namespace graze::octree
