#pragma once
/// The times at which a ray meets an octant's faces, halved at each level; it misses octants.
#include <algorithm>
#include <graze/octree/descent.hpp>
#include <graze/octree/ray.hpp>
#include <limits>

namespace graze::peers {

using octree::branches;
using octree::cube;
using octree::vec3;

/// Revelles, Urena and Lastra 2000, "An efficient parametric algorithm for octree traversal", in
/// double. The ray is mirrored at the root so that no component of its direction is negative
/// (section 3.2); a child's times are its parent's and their means.
class revelles {
public:
  static constexpr char name[] = "revelles", title[] = "Revelles";
  static constexpr char summary[] = "parametric octree descent (Revelles, Urena and Lastra 2000)";
  struct scope {};
  struct state {
    vec3 in, out; ///< t at the near and the far face of each axis
  };

  explicit revelles(const octree::ray& r) : origin_(r.origin()), direction_(r.direction()) {
    for (unsigned a = 0; a < 3; ++a) {
      mirrored_ |= direction_[a] < 0 ? 1u << a : 0;
      resting_ |= direction_[a] == 0 ? 1u << a : 0;
    }
  }

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = root.lo[a], hi = root.hi(static_cast<int>(a));
      double o = origin_[a], d = direction_[a];
      if (d < 0) {
        o = lo + hi - o;
        d = -d;
      }
      at.in[a] = d == 0 ? (o < lo ? infinity : -infinity) : (lo - o) / d;
      at.out[a] = d == 0 ? (o < hi ? infinity : -infinity) : (hi - o) / d;
    }
    return std::max({at.in[0], at.in[1], at.in[2]}) < std::min({at.out[0], at.out[1], at.out[2]}) &&
           !behind(at);
  }

  void split(const cube& cell, const state& at, branches<state>& out) const {
    for_each_child(cell, at, [&out](unsigned i, const state& part) { out.push(i, part); });
  }

  /// The same for any cell that tells its mid-planes, cell.mid(axis): calls child(index, state).
  template <class Cell, class F>
  void for_each_child(const Cell& cell, const state& at, F&& child) const {
    const vec3 &in = at.in, &out = at.out;
    const vec3 mid{middle(cell, at, 0), middle(cell, at, 1), middle(cell, at, 2)};
    // first_node: the face of entry is that of the last plane entered (tables 1 and 2)
    unsigned index = 0;
    if (in[0] > in[1] && in[0] > in[2])
      index = (mid[1] < in[0] ? 2u : 0u) | (mid[2] < in[0] ? 4u : 0u);
    else if (in[1] > in[2])
      index = (mid[0] < in[1] ? 1u : 0u) | (mid[2] < in[1] ? 4u : 0u);
    else
      index = (mid[0] < in[2] ? 1u : 0u) | (mid[1] < in[2] ? 2u : 0u);
    while (true) {
      const bool x = (index & 1) != 0, y = (index & 2) != 0, z = (index & 4) != 0;
      const state part{{x ? mid[0] : in[0], y ? mid[1] : in[1], z ? mid[2] : in[2]},
                       {x ? out[0] : mid[0], y ? out[1] : mid[1], z ? out[2] : mid[2]}};
      if (!behind(part))
        child(index ^ mirrored_, part);
      // new_node: through the face that is left first (table 3)
      const vec3& to = part.out;
      const unsigned exit = to[0] < to[1] ? (to[0] < to[2] ? 1u : 4u) : (to[1] < to[2] ? 2u : 4u);
      if ((index & exit) != 0)
        return;
      index |= exit;
    }
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static bool behind(const state& at) { return at.out[0] < 0 || at.out[1] < 0 || at.out[2] < 0; }

  /// When the ray is at the mid-plane. An axis without motion (section 3.3) is never at it; +-
  /// infinity says on which side the ray stays.
  template <class Cell> double middle(const Cell& cell, const state& at, unsigned axis) const {
    if ((resting_ >> axis & 1) == 0) [[likely]]
      return 0.5 * (at.in[axis] + at.out[axis]);
    return origin_[axis] < cell.mid(static_cast<int>(axis)) ? infinity : -infinity;
  }

  vec3 origin_, direction_;
  unsigned mirrored_ = 0; ///< bit a: axis a is
  unsigned resting_ = 0;  ///< bit a: the ray does not move on axis a
};

static_assert(octree::Method<revelles>);

} // namespace graze::peers
