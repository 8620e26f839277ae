#pragma once
/// The sound method: no touched octant whose ancestors are kept is ever left out.
#include <graze/octree/descent.hpp>
#include <graze/octree/ray_bounds.hpp>

namespace graze::octree {

/// The paper's traversal with bounds that hold. In `closed`, every octant that the ray touches is
/// passed; in `owned`, every octant that owns a point of the ray, front to back.
/// Nine intervals serve the parent and its eight children; six of their bounds come down from the
/// parent, so that a split evaluates two bounds an axis, and a child that passes implies that its
/// parent does.
template <rounding::Backend B, convention C> class sound {
public:
  using bounds = ray_bounds<B>;
  using scope = typename B::scope;
  /// The intervals of scaled t on the three axes.
  using state = std::array<typename bounds::interval, 3>;

  /// Prepares a ray; call it within a scope of B.
  explicit sound(const ray& r) : axes_(bounds::prepare(r.origin(), r.direction())) {}

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    for (int a = 0; a < 3; ++a) // the root's far faces are closed in both conventions
      at[a] = bounds::template within<convention::closed>(axes_[a], root.lo[a], root.hi(a));
    return bounds::passes(at[0], at[1], at[2]);
  }

  void split(const cube& cell, const state& at, branches<state>& out) const {
    // half[a][s]: the interval of axis a on the lower (s = 0) or upper (s = 1) side of its
    // mid-plane
    std::array<std::array<typename bounds::interval, 2>, 3> half;
    unsigned origin_side = 0;
    for (int a = 0; a < 3; ++a) {
      const double mid = cell.mid(a);
      const unsigned entry_side = axes_[a].direction == heading::backward ? 1 : 0;
      half[a][entry_side] = {at[a].enter, bounds::template leave_at<C>(axes_[a], mid)};
      half[a][1 - entry_side] = {bounds::enter_at(axes_[a], mid), at[a].leave};
      if (axes_[a].origin >= mid)
        origin_side |= 1u << a;
    }
    // bounds::passes for all eight without a branch: each pair of sides in x and y serves two
    // children
    std::array<typename bounds::interval, 4> xy;
    for (unsigned i = 0; i < 4; ++i)
      xy[i] = bounds::common(half[0][i & 1], half[1][i >> 1]);
    unsigned passed = 0;
    for (unsigned i = 0; i < 8; ++i)
      passed |= (bounds::passes(xy[i & 3], half[2][i >> 2]) ? 1u : 0u) << i;
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned index =
          i ^ origin_side; // front to back: the origin's side first, on each axis
      if ((passed >> index & 1) != 0)
        out.push(index, {half[0][index & 1], half[1][index >> 1 & 1], half[2][index >> 2 & 1]});
    }
  }

private:
  std::array<typename bounds::axis, 3> axes_;
};

} // namespace graze::octree
