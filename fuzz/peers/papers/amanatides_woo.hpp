#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <graze/octree/vector.hpp>

namespace graze::peers {

using octree::vec3;

/// A grid of cells.
struct cell_grid {
  vec3 lo;                  ///< its lowest corner
  double size;              ///< of a cell
  std::array<int, 3> cells; ///< an axis
};

/// Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing", in double: a step
/// to the next cell on the axis whose plane is nearest in t, which then is increased by the time
/// that the ray takes through a cell.
struct amanatides_woo {
  static constexpr char name[] = "amanatides-woo", title[] = "Amanatides-Woo";
  static constexpr char summary[] = "grid walk by the next plane in t (Amanatides and Woo 1987)";

  /// Calls visit(cell) for the cells on the ray until it returns true. The ray is taken as it is;
  /// where its origin is outside of the grid, the point at which it enters is found by slabs, as the
  /// paper says ("find the point in which the ray enters the grid and take the adjacent voxel").
  template <class Visit>
  static void walk(const cell_grid& grid, const vec3& origin, const vec3& direction,
                   Visit&& visit) {
    double enter = 0, leave = INFINITY;
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = grid.lo[a], hi = lo + grid.cells[a] * grid.size, d = direction[a];
      if (d == 0) {
        if (origin[a] < lo || origin[a] > hi)
          return;
        continue;
      }
      enter = std::max(enter, ((d > 0 ? lo : hi) - origin[a]) / d);
      leave = std::min(leave, ((d > 0 ? hi : lo) - origin[a]) / d);
    }
    if (enter > leave)
      return;

    std::array<int, 3> at{}, step{};
    vec3 next{}, delta{}; // the paper's tMax and tDelta
    for (unsigned a = 0; a < 3; ++a) {
      const double d = direction[a], lo = grid.lo[a];
      const double point = enter > 0 ? origin[a] + enter * d : origin[a];
      at[a] = nearest_cell((point - lo) / grid.size, grid.cells[a]);
      step[a] = d > 0 ? 1 : d < 0 ? -1 : 0;
      next[a] = d == 0 ? INFINITY : (lo + (at[a] + (d > 0 ? 1 : 0)) * grid.size - origin[a]) / d;
      delta[a] = d == 0 ? INFINITY : grid.size / std::fabs(d);
    }
    while (!visit(at)) {
      const unsigned a =
          next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      at[a] += step[a];
      // where all times have overflowed the axis may be one that the ray does not move on: the
      // paper's loop would not end
      if (step[a] == 0 || at[a] < 0 || at[a] >= grid.cells[a])
        return;
      next[a] += delta[a];
    }
  }

private:
  /// The cell of a place in the grid, the nearest one where rounding has left the grid.
  static int nearest_cell(double place, int cells) {
    return !(place > 0) ? 0 : place >= cells ? cells - 1 : static_cast<int>(place);
  }
};

} // namespace graze::peers
