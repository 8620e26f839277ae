#pragma once
/// Voxelization with the children of an octant in the lanes of a path: the octree of voxelize(),
/// byte for byte.
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
  alignas(64) long long of[3][32];
};
consteval lattice_indices make_lattice_indices() {
  lattice_indices r{};
  for (int k = 0; k < 32; ++k) {
    const int point = k < 27 ? k : 26, digits[3] = {point % 3, point / 3 % 3, point / 9};
    for (int a = 0; a < 3; ++a)
      r.of[a][k] = 4 * digits[a] + a;
  }
  return r;
}
inline constexpr lattice_indices indices_of_lattice = make_lattice_indices();

/// Certified signs at the 27 points, as bits.
template <class Path, class F>
GRAZE_BATCH_INLINE eight_signs lattice_signs(const F& f, const octet<Path>& corner,
                                             const octet<Path>& mid, double half) {
  using lanes = octet<Path>;
  const lanes far = lanes::add_up(mid, lanes::broadcast(half));
  const lanes near = chosen(0x70, mid, corner);
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
      const long long* const from = indices_of_lattice.of[a] + 8 * eight;
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
        points.lo[a] = lanes::load(x);
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

template <class Path, Surface F> class voxelization_eight {
public:
  using B = backend_beside<Path>;
  using lanes = octet<Path>;
  using inner = sparse_octree::builder::inner;

  voxelization_eight(const F& f, const box& domain, int level, sparse_octree::room& out)
      : f_(f), domain_(domain), last_level_(level), out_(out) {}

  inner whole(const cube& root) {
    return node(sound_eight<Path, convention::owned>::corner(root), root.size / 2, 0, true);
  }

private:
  /// The node of the octant with this lower corner, above the last level; mask 0 if nothing is left
  /// in it. `cut`: it may reach out of the domain.
  inner node(const lanes& corner, double half, int level, bool cut) {
    const lanes mid = lanes::add_up(corner, lanes::broadcast(half));
    auto boxes = eight_boxes<Path>::children(corner, mid, half);
    unsigned outside = 0;
    if (cut) {
      const cube cell = cube_at(corner, 2 * half);
      cut = false;
      for (int a = 0; a < 3; ++a)
        cut = cut || cell.lo[a] < domain_.lo[a] || domain_.hi[a] < cell.hi(a);
      if (cut)
        outside = boxes.cut(domain_);
    }
    const unsigned kept = ~(have_no_zero(f_, boxes, ~outside) | outside) & 0xff;
    return level + 1 == last_level_ ? leaves_below(corner, mid, half, kept, cut)
                                    : nodes_below(corner, mid, half, level, kept, cut);
  }

  inner nodes_below(const lanes& corner, const lanes& mid, double half, int level, unsigned kept,
                    bool cut) {
    inner found[8];
    unsigned count = 0, mask = 0;
    for (unsigned rest = kept; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      const inner n = node(chosen(i << 4 | i, mid, corner), half / 2, level + 1, cut);
      if (n.mask == 0)
        continue;
      found[count++] = n;
      mask |= 1u << i;
    }
    const inner r{static_cast<std::uint8_t>(mask), static_cast<std::uint32_t>(out_.nodes)};
    if (room_for_eight())
      for (unsigned i = 0; i < count; ++i) {
        out_.masks[out_.nodes] = found[i].mask;
        out_.first_children[out_.nodes++] = found[i].first_child;
      }
    return r;
  }

  inner leaves_below(const lanes& corner, const lanes& mid, double half, unsigned kept, bool cut) {
    inner r{0, static_cast<std::uint32_t>(out_.leaf_count)};
    if (kept == 0 || !room_for_eight())
      return r;
    unsigned certified = 0;
    if (!cut) {
      const eight_signs s = lattice_signs(f_, corner, mid, half);
      certified = children_with(s.positive) & children_with(s.negative);
    }
    if ((kept & ~certified) == 0) [[likely]] {
      r.mask = static_cast<std::uint8_t>(kept);
      for (unsigned i = 0; i < 8; ++i) // those beyond the count are written over
        out_.leaves[out_.leaf_count + i] = content::certified;
      out_.leaf_count += static_cast<unsigned>(std::popcount(kept));
      return r;
    }
    for (unsigned rest = kept; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      content c = content::certified;
      if ((certified >> i & 1) == 0) {
        const box b = closed_box(cube_at(corner, 2 * half).child(i));
        c = leaf_content<B>(f_, cut ? intersection(b, domain_) : b);
      }
      if (c == content::none)
        continue;
      out_.leaves[out_.leaf_count++] = c;
      r.mask = static_cast<std::uint8_t>(r.mask | 1u << i);
    }
    return r;
  }

  bool room_for_eight() {
    constexpr std::size_t most = 0xffff'ffff - 8; // indices are 32 bits wide
    out_.overflowed = out_.overflowed || out_.nodes > most || out_.leaf_count > most;
    if (out_.overflowed)
      return false;
    if (out_.nodes + 8 > out_.most_nodes || out_.leaf_count + 8 > out_.most_leaves) [[unlikely]]
      out_.more(out_);
    return true;
  }

  static GRAZE_BATCH_INLINE cube cube_at(const lanes& corner, double size) {
    alignas(64) double lo[8];
    corner.store(lo);
    return {{lo[0], lo[1], lo[2]}, size};
  }

  const F& f_;
  box domain_;
  int last_level_;
  sparse_octree::room& out_;
};
} // namespace detail

} // namespace graze::octree
