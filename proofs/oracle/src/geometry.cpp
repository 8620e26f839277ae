#include "default_mode.hpp"
#include <cassert>
#include <cmath>
#include <graze/oracle/arrival.hpp>
#include <graze/oracle/geometry.hpp>

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

/// The ray on one axis of the grid: where it is, and when it reaches the next plane.
class axis_walk {
public:
  axis_walk() = default;
  axis_walk(double origin, double direction, std::span<const double> planes)
      : planes_(planes), last_(static_cast<int>(2 * planes.size() - 2)), origin_(origin),
        speed_(std::fabs(direction)), heading_(direction < 0 ? -1 : (direction > 0 ? 1 : 0)) {
    assert(planes.size() >= 2 && planes.size() <= 60);
    int below = 0;
    for (const double p : planes)
      below += p < origin ? 1 : 0;
    const auto k = static_cast<unsigned>(below);
    at_ = k < planes.size() && planes[k] == origin ? 2 * below : 2 * below - 1;
    prepare_next();
  }

  [[nodiscard]] int at() const { return at_; }
  [[nodiscard]] bool in_hull() const { return at_ >= 0 && at_ <= last_; }
  /// Not in the hull, and never to come into it.
  [[nodiscard]] bool lost() const { return !in_hull() && !has_next_; }
  [[nodiscard]] bool has_next() const { return has_next_; }
  [[nodiscard]] const arrival& next() const { return next_; }

  void arrive() {
    assert(has_next_ && at_ % 2 != 0);
    at_ += heading_; // from the space before the plane: the ray has departed from where it was
    prepare_next();
  }
  /// From a plane into the space behind it; no effect where the ray is on no plane or does not
  /// move.
  void depart() {
    if (at_ % 2 == 0)
      at_ += heading_;
  }

private:
  void prepare_next() {
    // at = 2k or 2k - 1 when heading forward below or on plane k: the next plane is (at + 2) / 2
    // resp. (at + 1) / 2, and the mirror image backward. at >= -1, so that nothing is negative
    // here.
    const int next = heading_ > 0 ? (at_ + 2) / 2 : (at_ + 1) / 2 - 1;
    has_next_ = heading_ != 0 && next >= 0 && next < static_cast<int>(planes_.size());
    if (has_next_)
      next_ = arrival(planes_[static_cast<unsigned>(next)], origin_, speed_);
  }

  std::span<const double> planes_;
  int last_, at_;
  double origin_, speed_;
  int heading_;
  bool has_next_;
  arrival next_;
};

[[gnu::noinline]] void walk(const point& origin, const point& direction,
                            const std::array<std::span<const double>, 3>& planes,
                            std::vector<step>& steps) {
  std::array<axis_walk, 3> axes;
  for (unsigned a = 0; a < 3; ++a) {
    axes[a] = axis_walk(origin[a], direction[a], planes[a]);
    if (axes[a].lost())
      return;
  }
  const auto report = [&](bool segment) {
    if (axes[0].in_hull() && axes[1].in_hull() && axes[2].in_hull())
      steps.push_back({{static_cast<place>(axes[0].at()), static_cast<place>(axes[1].at()),
                        static_cast<place>(axes[2].at())},
                       segment});
  };
  report(false);
  while (true) {
    for (axis_walk& axis : axes) {
      axis.depart();
      if (axis.lost())
        return;
    }
    report(true);
    // Some axis moves; it has a plane before it, for it would be lost otherwise.
    unsigned first = 0; // bits: the axes that arrive together, before all others
    const arrival* earliest = nullptr;
    for (unsigned a = 0; a < 3; ++a) {
      if (!axes[a].has_next())
        continue;
      const int order = earliest == nullptr ? -1 : compare(axes[a].next(), *earliest);
      if (order < 0) {
        earliest = &axes[a].next();
        first = 1u << a;
      } else if (order == 0) {
        first |= 1u << a;
      }
    }
    assert(first != 0);
    for (unsigned a = 0; a < 3; ++a)
      if ((first >> a & 1) != 0)
        axes[a].arrive();
    report(false);
  }
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
      leave[leaves++] = {true, arrival(far, o, std::fabs(d)), far_closed};
    if (o == near)
      enter[enters++] = {false, {}, near_closed};
    else if (forward ? o < near : near < o)
      enter[enters++] = {true, arrival(near, o, std::fabs(d)), near_closed};
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
