#pragma once
/// The sound method with the eight children in the lanes of a path: the verdicts of sound<B, C>.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <graze/octree/descent.hpp>
#include <graze/octree/octet.hpp>
#include <graze/octree/ray_bounds.hpp>
#include <graze/octree/scaled_direction.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>
#include <type_traits>

namespace graze::octree {

/// The scalar backend that goes with a path. A type of its own for each path: what is instantiated
/// with it in a file compiled for the path's instructions is never chosen by the linker for
/// another.
/// It is `upward`, whose scope serves all x86-64 paths, since embedded rounding looks at no mode.
template <class Path>
struct backend_beside : std::conditional_t<std::is_same_v<typename Path::vector, double>,
                                           rounding::nearest, rounding::upward> {};

/// One ray against the eight children of an octant in one pass.
///
/// All is seen in a mirror in which the ray goes forward on every axis: on an axis along which it
/// goes backward, coordinates change their signs. That is exact, and makes lowb(p, q) and
/// uppb(p, q) of ray_bounds the only functions: leave = uppb(mid, o), enter = lowb(mid, o). And
/// enter is kept as -enter = -lowb(mid, o) = uppb(o, mid), so that all six bounds of the mid-planes
/// are one subtraction, one choice and one multiplication, all rounded up. Lanes 0 to 2 have leave
/// on x, y, z; lanes 4 to 6 have -enter; lanes 3 and 7 are not used.
template <class Path, convention C> class sound_eight {
public:
  using path = Path;
  using numbers = octet<Path>;
  using backend = backend_beside<Path>;
  using bounds = ray_bounds<backend>;
  using scope = typename backend::scope;
  using state = numbers;

  /// What one pass finds out about an octant's children.
  struct halves {
    numbers mid;      ///< the mid-planes' coordinates, on x, y, z in lanes 0 to 2 and 4 to 6
    numbers at_mid;   ///< the bounds at the mid-planes
    unsigned passed;  ///< bit i: child i XOR mirror() is passed
    unsigned nearest; ///< the child that comes first, XOR mirror()
  };

  /// Prepares a ray by its scaled direction, as sound does; call it within a scope.
  explicit GRAZE_BATCH_INLINE sound_eight(const ray& r)
      : sound_eight(bounds::prepare(r.origin(), scaled_direction(r.direction()))) {}
  /// A ray as it is prepared, which may be with any direction.
  explicit GRAZE_BATCH_INLINE sound_eight(const std::array<typename bounds::axis, 3>& prepared)
      : axes_(prepared) {
    constexpr double tiny = std::numeric_limits<double>::denorm_min();
    alignas(64) double origin[8]{}, down[8]{}, up[8]{}, signs[8]{}, at_least[8]{};
    for (unsigned a = 0; a < 3; ++a) {
      const double o = axes_[a].origin;
      const bool backward = axes_[a].direction == heading::backward;
      mirror_ |= (backward ? 1u : 0u) << a;
      across_ |= (axes_[a].direction == heading::across ? 0x11u : 0u) << a;
      signs[a] = backward ? -0.0 : 0.0;
      signs[a + 4] = backward ? 0.0 : -0.0;
      origin[a] = backward ? -o : o;
      origin[a + 4] = backward ? o : -o;
      down[a] = down[a + 4] = axes_[a].c_down;
      up[a] = up[a + 4] = axes_[a].c_up;
      at_least[a] = C == convention::owned ? tiny : 0;
    }
    origin_ = numbers::load(origin);
    c_down_ = numbers::load(down);
    c_up_ = numbers::load(up);
    signs_ = numbers::load(signs);
    at_least_ = numbers::load(at_least);
  }

  /// Bit a: the ray goes backward on axis a.
  [[nodiscard]] GRAZE_BATCH_INLINE unsigned mirror() const { return mirror_; }

  [[nodiscard]] GRAZE_BATCH_INLINE bool enter(const cube& root, state& at) const {
    std::array<typename bounds::interval, 3> t;
    alignas(64) double ends[8]{};
    for (unsigned a = 0; a < 3; ++a) { // the root's far faces are closed in both conventions
      t[a] = bounds::template within<convention::closed>(axes_[a], root.lo[a],
                                                         root.hi(static_cast<int>(a)));
      ends[a] = t[a].leave;
      ends[a + 4] = -t[a].enter;
    }
    at = numbers::load(ends);
    return bounds::passes(t[0], t[1], t[2]);
  }

  /// The lower corner of an octant, as `open` takes it.
  [[nodiscard]] static GRAZE_BATCH_INLINE numbers corner(const cube& cell) {
    alignas(64) const double lo[8] = {cell.lo[0], cell.lo[1], cell.lo[2], 0,
                                      cell.lo[0], cell.lo[1], cell.lo[2], 0};
    return numbers::load(lo);
  }

  /// The pass. `half` is half of the octant's size, `at` what enter or child_state gave for it.
  [[nodiscard]] GRAZE_BATCH_INLINE halves open(const numbers& corner, double half,
                                               const state& at) const {
    halves r;
    r.mid = numbers::add_up(corner, numbers::broadcast(half)); // exact in a root_cube
    // uppb(p, q) of ray_bounds in each lane
    const numbers u = numbers::sub_up(mirrored(r.mid), origin_);
    const numbers zero = numbers::broadcast(0);
    numbers c;
    unsigned positive = 0;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < numbers::count; ++i) {
      const auto m = Path::less(zero.part[i], u.part[i]);
      c.part[i] = Path::select(m, c_up_.part[i], c_down_.part[i]);
      positive |= Path::bits(m) << (i * numbers::width);
    }
    r.at_mid = numbers::mul_up(c, u);
    if (across_ != 0) [[unlikely]]
      r.at_mid = across(u, r.at_mid);
    r.nearest = on_upper_side(positive) ^ mirror_;

    const numbers leave =
        numbers::min(numbers::min(spread<0, 0>(r.at_mid, at), spread<1, 1>(r.at_mid, at)),
                     spread<2, 2>(r.at_mid, at));
    const numbers minus_enter =
        numbers::min(numbers::min(spread<4, 0>(at, r.at_mid), spread<5, 1>(at, r.at_mid)),
                     numbers::min(spread<6, 2>(at, r.at_mid), zero));
    r.passed = numbers::less_equal(numbers::neg(minus_enter), leave);
    return r;
  }

  /// The state of the child `mirrored_index` (its index XOR mirror()).
  [[nodiscard]] static GRAZE_BATCH_INLINE state child_state(const halves& h, const state& at,
                                                            unsigned mirrored_index) {
    return child_state(h.at_mid, at, mirrored_index);
  }
  [[nodiscard]] static GRAZE_BATCH_INLINE state child_state(const numbers& at_mid, const state& at,
                                                            unsigned mirrored_index) {
    return chosen(mirrored_index << 4 | (mirrored_index ^ 7u), at_mid, at);
  }
  /// The lower corner of the child `index`.
  [[nodiscard]] static GRAZE_BATCH_INLINE numbers child_corner(const numbers& corner,
                                                               const numbers& mid, unsigned index) {
    return chosen(index << 4 | index, mid, corner);
  }

  /// As the Method concept asks; descents of one's own do better with `open`.
  GRAZE_BATCH_INLINE void split(const cube& cell, const state& at, branches<state>& out) const {
    const halves h = open(corner(cell), cell.size / 2, at);
    const unsigned first = h.nearest;
    for (unsigned rest = reordered(h.passed, first); rest != 0; rest &= rest - 1) {
      const unsigned i = static_cast<unsigned>(std::countr_zero(rest)) ^ first;
      out.push(i ^ mirror_, child_state(h, at, i));
    }
  }

private:
  GRAZE_BATCH_INLINE numbers mirrored(const numbers& x) const {
    numbers r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < numbers::count; ++i)
      r.part[i] = exclusive_or(x.part[i], signs_.part[i]);
    return r;
  }
  using vector = typename Path::vector;
  static GRAZE_BATCH_INLINE vector exclusive_or(vector x, vector y) {
    if constexpr (Path::width == 1) {
      return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^
                                   std::bit_cast<std::uint64_t>(y));
    } else {
#if defined(__x86_64__)
      typedef long long integers __attribute__((vector_size(sizeof(vector))));
      return (vector)((integers)x ^ (integers)y);
#endif
    }
  }

  /// Bits a where origin >= mid, out of the mirror, from the lanes in which u > 0: those tell
  /// mid > origin in lane a of an axis that is not mirrored, in lane a + 4 of one that is.
  GRAZE_BATCH_INLINE unsigned on_upper_side(unsigned positive) const {
    return ((~positive & ~mirror_) | (~(positive >> 4) & mirror_)) & 7u;
  }

  /// On the axes along which the ray does not move, containment takes the bounds' place.
  GRAZE_BATCH_INLINE numbers across(const numbers& u, const numbers& at_mid) const {
    const unsigned within = numbers::less_equal(at_least_, u);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return chosen(across_,
                  chosen(within, numbers::broadcast(infinity), numbers::broadcast(-infinity)),
                  at_mid);
  }

  numbers origin_, c_down_, c_up_, signs_, at_least_;
  std::array<typename bounds::axis, 3> axes_;
  unsigned mirror_ = 0, across_ = 0;
};

} // namespace graze::octree
