#pragma once
/// The exact method: in `closed`, the octants that the ray touches and no other; in `owned`, the
/// octants that own a point of the ray and no other, front to back.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <graze/octree/exact_touch.hpp>
#include <graze/octree/sound.hpp>

namespace graze::octree {

/// The bounds of `sound` filter in both directions: outer intervals prove that a child is not met,
/// inner ones that it is; exact_touch decides the rest. A verdict is the truth about its octant, so
/// that a child that passes implies that its parent does.
///
/// Inner intervals cost no arithmetic. The scaled t at which the ray passes a mid-plane lies
/// between the bounds that `sound` computes there: `low`, where its interval of the far side
/// begins, and `upp`, where that of the near side ends. The ray has certainly passed the plane
/// after `upp` and certainly not before `low`.
template <rounding::Backend B, convention C> class exact : sound<B, C> {
  using outer = sound<B, C>;
  using typename outer::halves;

public:
  using typename outer::bounds;
  using typename outer::scope;

  struct state {
    typename outer::state possible; ///< holds the scaled t within the cell, on each axis
    typename outer::state certain;  ///< only scaled t within the cell
    unsigned closed_far;            ///< bit a: the cell ends at the root's far face of axis a
  };

  /// Prepares a ray; call it within a scope of B.
  explicit exact(const ray& r) : outer(r), truth_(r) {}

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    at.closed_far = 7; // the root's far faces are closed in both conventions
    if (!outer::enter(root, at.possible))
      return false;
    for (unsigned a = 0; a < 3; ++a)
      at.certain[a] = bounds::template certainly_within<convention::closed>(
          this->axes()[a], root.lo[a], root.hi(static_cast<int>(a)));
    return certainly_passes(bounds::common(at.certain[0], at.certain[1]), at.certain[2]) ||
           truth_.template meets<C>(root, at.closed_far);
  }

  void split(const cube& cell, const state& at, branches<state>& out) const {
    const halves possible = outer::halve(cell, at.possible);
    halves certain;
    for (unsigned a = 0; a < 3; ++a) {
      const unsigned entry = this->entry_side(a);
      const auto& near = possible.half[a][entry];
      const auto& far = possible.half[a][1 - entry];
      // without motion there is nothing to round: the sides are as in `possible`
      certain.half[a][entry] = {at.certain[a].enter, this->moves(a) ? far.enter : near.leave};
      certain.half[a][1 - entry] = {this->moves(a) ? near.leave : far.enter, at.certain[a].leave};
    }
    unsigned passed = outer::passed(possible);
    for (unsigned unsure = passed & ~outer::children(certain, certainly_passes); unsure != 0;
         unsure &= unsure - 1) {
      const auto index = static_cast<unsigned>(std::countr_zero(unsure));
      if (!truth_.template meets<C>(cell.child(index), at.closed_far & index))
        passed &= ~(1u << index);
    }
    outer::in_order(passed, possible.origin_side, [&](unsigned index) {
      out.push(index, {possible.child(index), certain.child(index), at.closed_far & index});
    });
  }

  using outer::first_child;

  /// What split finds out about one child.
  [[nodiscard]] bool enter_child(const cube& cell, unsigned index, state& at) const {
    at.closed_far &= index;
    for (unsigned a = 0; a < 3; ++a) {
      const auto mid = bounds::template at_plane<C>(this->axes()[a], cell.mid(static_cast<int>(a)));
      const bool beyond = (index >> a & 1) != this->entry_side(a);
      at.possible[a] = bounds::part(beyond, mid, at.possible[a]);
      at.certain[a] = bounds::part(
          beyond, this->moves(a) ? typename bounds::interval{mid.leave, mid.enter} : mid,
          at.certain[a]);
    }
    return bounds::passes(at.possible[0], at.possible[1], at.possible[2]) &&
           (certainly_passes(bounds::common(at.certain[0], at.certain[1]), at.certain[2]) ||
            truth_.template meets<C>(cell.child(index), at.closed_far));
  }

private:
  /// For inner intervals: some t >= 0 is within both. In `owned` one that is at no face, since an
  /// equality of bounds does not say whose face it is.
  static bool certainly_passes(const typename bounds::interval& x,
                               const typename bounds::interval& y) {
    if constexpr (C == convention::closed)
      return bounds::passes(x, y);
    const typename bounds::interval both = bounds::common(x, y);
    return (both.enter < both.leave) & (typename bounds::number(0) < both.leave);
  }

  exact_touch truth_;
};

} // namespace graze::octree
