#pragma once
/// The sound method: no touched octant whose ancestors are kept is ever left out.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/descent.hpp>
#include <graze/octree/ray_bounds.hpp>
#include <graze/octree/scaled_direction.hpp>

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

  /// Prepares a ray by its scaled direction, to which scaled t belongs; call it within a scope of
  /// B.
  explicit sound(const ray& r)
      : sound(bounds::prepare(r.origin(), scaled_direction(r.direction()))) {}
  /// A ray as it is prepared, which may be with any direction.
  explicit sound(const std::array<typename bounds::axis, 3>& prepared) : axes_(prepared) {}

  [[nodiscard]] bool enter(const cube& root, state& at) const {
    for (int a = 0; a < 3; ++a) // the root's far faces are closed in both conventions
      at[a] = bounds::template within<convention::closed>(axes_[a], root.lo[a], root.hi(a));
    return bounds::passes(at[0], at[1], at[2]);
  }

  void split(const cube& cell, const state& at, branches<state>& out) const {
    const halves parts = halve(cell, at);
    in_order(passed(parts), parts.origin_side,
             [&](unsigned index) { out.push(index, parts.child(index)); });
  }

  /// The child that comes first, front to back: bit a is set where the origin lies on the upper
  /// side of mid(a).
  [[nodiscard]] unsigned first_child(const cube& cell) const {
    unsigned side = 0;
    for (unsigned a = 0; a < 3; ++a)
      side |= (axes_[a].origin >= cell.mid(static_cast<int>(a)) ? 1u : 0u) << a;
    return side;
  }

  /// What split finds out about one child: its state, and whether it is passed.
  [[nodiscard]] bool enter_child(const cube& cell, unsigned index, state& at) const {
    for (unsigned a = 0; a < 3; ++a)
      at[a] = bounds::part((index >> a & 1) != entry_side(a),
                           bounds::template at_plane<C>(axes_[a], cell.mid(static_cast<int>(a))),
                           at[a]);
    return bounds::passes(at[0], at[1], at[2]);
  }

protected:
  /// A cell's intervals on the lower and upper side of its mid-planes.
  struct halves {
    std::array<std::array<typename bounds::interval, 2>, 3> half; ///< [axis][side]
    unsigned origin_side;                                         ///< first_child

    [[nodiscard]] state child(unsigned index) const {
      return {half[0][index & 1], half[1][index >> 1 & 1], half[2][index >> 2 & 1]};
    }
  };

  /// The side by which the ray enters on an axis.
  [[nodiscard]] unsigned entry_side(unsigned axis) const {
    return axes_[axis].direction == heading::backward ? 1 : 0;
  }
  [[nodiscard]] const std::array<typename bounds::axis, 3>& axes() const { return axes_; }
  [[nodiscard]] bool moves(unsigned axis) const { return axes_[axis].direction != heading::across; }

  [[nodiscard]] halves halve(const cube& cell, const state& at) const {
    halves parts;
    parts.origin_side = first_child(cell);
    for (unsigned a = 0; a < 3; ++a) {
      const auto mid = bounds::template at_plane<C>(axes_[a], cell.mid(static_cast<int>(a)));
      const unsigned entry = entry_side(a);
      parts.half[a][entry] = {at[a].enter, mid.leave};
      parts.half[a][1 - entry] = {mid.enter, at[a].leave};
    }
    return parts;
  }

  /// Bit i is set where pass(xy, z) says so of child i, without a branch: the common interval of
  /// each pair of sides in x and y serves two children.
  template <class Pass> [[nodiscard]] static unsigned children(const halves& parts, Pass pass) {
    std::array<typename bounds::interval, 4> xy;
    for (unsigned i = 0; i < 4; ++i)
      xy[i] = bounds::common(parts.half[0][i & 1], parts.half[1][i >> 1]);
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      mask |= (pass(xy[i & 3], parts.half[2][i >> 2]) ? 1u : 0u) << i;
    return mask;
  }
  [[nodiscard]] static unsigned passed(const halves& parts) {
    return children(parts, [](const auto& xy, const auto& z) { return bounds::passes(xy, z); });
  }

  /// Front to back: the origin's side first, on each axis.
  template <class Visit>
  static void in_order(unsigned mask, unsigned origin_side, const Visit& visit) {
    for (unsigned i = 0; i < 8; ++i)
      if (const unsigned index = i ^ origin_side; (mask >> index & 1) != 0)
        visit(index);
  }

private:
  std::array<typename bounds::axis, 3> axes_;
};

} // namespace graze::octree
