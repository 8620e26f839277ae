#include "default_mode.hpp"
#include "grid_walk.hpp"
#include <cassert>
#include <cmath>
#include <graze/oracle/geometry.hpp>
#include <limits>

namespace graze::oracle {
namespace {

[[maybe_unused]] bool legal(const point& origin, const point& direction) {
  bool moves = false;
  for (unsigned a = 0; a < 3; ++a) {
    if (!std::isfinite(origin[a]) || !std::isfinite(direction[a]))
      return false;
    moves |= direction[a] != 0;
  }
  return moves;
}

/// The ray on one axis of the grid: where it is, and when it reaches the planes before it.
struct axis_walk : axis_place {
  static constexpr bool may_end = false;
  void start(double origin_, double direction, std::span<const double> planes_) {
    assert(!planes_.empty() && planes_.size() <= most_planes);
    planes = planes_;
    origin = origin_;
    speed = std::fabs(direction);
    int below = 0, on = 0;
    for (const double p : planes) {
      below += p < origin ? 1 : 0;
      on |= p == origin ? 1 : 0;
    }
    begin(direction < 0 ? -1 : (direction > 0 ? 1 : 0), static_cast<int>(planes.size()), below, on);
    for (int i = 0; i < ahead; ++i)
      times[i] = plane_ahead(i).time();
    times[ahead] = std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] arrival plane_ahead(int i) const {
    return {planes[static_cast<unsigned>(first + i * heading)], origin, speed};
  }
  [[nodiscard]] arrival next() const { return plane_ahead(passed); }

  std::span<const double> planes;
  double origin, speed;
};

[[gnu::noinline]] void walk(const point& origin, const point& direction,
                            const std::array<std::span<const double>, 3>& planes,
                            std::vector<step>& steps) {
  std::array<axis_walk, 3> axes;
  for (unsigned a = 0; a < 3; ++a) {
    axes[a].start(origin[a], direction[a], planes[a]);
    if (axes[a].lost())
      return;
  }
  walk(axes, steps);
}

/// A bound of the t >= 0 in which the ray is in a box: a plane it reaches later, or t = 0.
struct bound {
  bool positive; ///< t > 0, with `when`; otherwise t = 0
  arrival when;
  bool closed;
};

int order(const bound& a, const bound& b) {
  if (!a.positive || !b.positive)
    return (a.positive ? 1 : 0) - (b.positive ? 1 : 0);
  return compare(a.when, b.when);
}

/// Which faces of the box belong to it.
struct faces {
  bool lower, upper;
};

/// The ray has a point in the box. On each axis the points in the box are an interval of t >= 0,
/// and intervals have a common point if every lower bound lies below every upper one, or equals it
/// and both are closed.
[[gnu::noinline]] bool meets(const point& origin, const point& direction, const point& lo,
                             const point& hi, const std::array<faces, 3>& with) {
  std::array<bound, 3> enter, leave; // enter[0..enters), leave[0..leaves)
  unsigned enters = 0, leaves = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const double o = origin[a], d = direction[a];
    const bool from_lo = with[a].lower ? lo[a] <= o : lo[a] < o; // o is inside of the lower face
    const bool from_hi = with[a].upper ? o <= hi[a] : o < hi[a];
    if (d == 0) {
      if (!from_lo || !from_hi)
        return false;
      continue;
    }
    const bool forward = d > 0;
    const double near = forward ? lo[a] : hi[a], far = forward ? hi[a] : lo[a];
    const bool near_closed = forward ? with[a].lower : with[a].upper;
    const bool far_closed = forward ? with[a].upper : with[a].lower;
    if (!(forward ? from_hi : from_lo))
      return false; // behind the far face from the start
    if (lo[a] == hi[a] && !(near_closed && far_closed))
      return false;
    if (o == far) // t = 0 alone
      leave[leaves++] = {false, {}, far_closed};
    else
      leave[leaves++] = {true, arrival{far, o, std::fabs(d)}, far_closed};
    if (o == near)
      enter[enters++] = {false, {}, near_closed};
    else if (forward ? o < near : near < o)
      enter[enters++] = {true, arrival{near, o, std::fabs(d)}, near_closed};
  }
  for (unsigned i = 0; i < enters; ++i)
    for (unsigned j = 0; j < leaves; ++j)
      if (const int sign = order(enter[i], leave[j]);
          sign > 0 || (sign == 0 && !(enter[i].closed && leave[j].closed)))
        return false;
  return true;
}

bool meets_in_default_mode(const point& origin, const point& direction, const point& lo,
                           const point& hi, const std::array<faces, 3>& with) {
  const default_mode scope;
  assert(legal(origin, direction));
  return meets(origin, direction, lo, hi, with);
}

} // namespace

void steps_in_grid(const point& origin, const point& direction,
                   const std::array<std::span<const double>, 3>& planes, std::vector<step>& steps) {
  const default_mode scope;
  assert(legal(origin, direction));
  steps.clear();
  walk(origin, direction, planes, steps);
}

std::vector<step> steps_in_grid(const point& origin, const point& direction,
                                const std::array<std::span<const double>, 3>& planes) {
  std::vector<step> steps;
  steps_in_grid(origin, direction, planes, steps);
  return steps;
}

bool touches(const point& origin, const point& direction, const point& lo, const point& hi) {
  return meets_in_default_mode(origin, direction, lo, hi,
                               {faces{true, true}, faces{true, true}, faces{true, true}});
}

bool crosses(const point& origin, const point& direction, const point& lo, const point& hi) {
  return meets_in_default_mode(origin, direction, lo, hi,
                               {faces{false, false}, faces{false, false}, faces{false, false}});
}

bool owns(const point& origin, const point& direction, const point& lo, const point& hi,
          unsigned closed_far) {
  return meets_in_default_mode(origin, direction, lo, hi,
                               {faces{true, (closed_far & 1u) != 0},
                                faces{true, (closed_far & 2u) != 0},
                                faces{true, (closed_far & 4u) != 0}});
}

} // namespace graze::oracle
