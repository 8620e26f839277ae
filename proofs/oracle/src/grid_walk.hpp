#pragma once
/// The walk of a line through a grid, for any way in which an axis of it decides what lies where.
#include <array>
#include <cassert>
#include <graze/oracle/arrival.hpp>
#include <graze/oracle/geometry.hpp>

namespace graze::oracle {

constexpr unsigned most_planes = 60;

/// Where a line is on one axis among the planes of a grid, and how many of those before it it has passed.
struct axis_place {
  int heading; ///< the sign of its motion
  int at, last;
  int first;      ///< the plane that is reached first
  int ahead;      ///< planes that it reaches at t > 0
  int passed = 0; ///< of these
  /// arrival::time at each of them, and then infinity.
  std::array<double, most_planes + 1> times;

  /// Of `count` planes `below` lie below the origin, which is on the next one or not.
  void begin(int sign, int count, int below, int on) {
    heading = sign;
    last = 2 * count - 2;
    at = 2 * below - 1 + on;
    first = heading > 0 ? below + on : below - 1;
    ahead = heading > 0 ? count - first : (heading < 0 ? first + 1 : 0);
  }
  [[nodiscard]] bool in_hull() const {
    return static_cast<unsigned>(at) <= static_cast<unsigned>(last);
  }
  /// Not in the hull, and never to come into it.
  [[nodiscard]] bool lost() const { return !in_hull() && passed == ahead; }

  /// From a plane into the space behind it; no effect where the line is on no plane or does not
  /// move.
  void depart() { at += at % 2 == 0 ? heading : 0; }
  /// From the space before the next plane onto it, if so.
  void arrive(bool so) {
    assert(!so || (passed < ahead && at % 2 != 0));
    at += so ? heading : 0;
    passed += so ? 1 : 0;
  }
};

/// The axes that reach their next planes together, before all others; some axis has one.
template <class Axis> unsigned earliest(const std::array<Axis, 3>& axes) {
  const std::array<double, 3> time{axes[0].times[axes[0].passed], axes[1].times[axes[1].passed],
                                   axes[2].times[axes[2].passed]};
  // NaN is after no time that is certain
  unsigned first = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const double x = time[a], y = time[(a + 1) % 3], z = time[(a + 2) % 3];
    first |= unsigned{certainly_before(x, y)} * unsigned{certainly_before(x, z)} << a;
  }
  if (first != 0)
    return first;
  unsigned least = 3;
  for (unsigned a = 0; a < 3; ++a) {
    if (axes[a].passed == axes[a].ahead || (least < 3 && certainly_before(time[least], time[a])))
      continue;
    const int order = least == 3 || certainly_before(time[a], time[least])
                          ? -1
                          : compare_exactly(axes[a].next(), axes[least].next());
    if (order < 0) {
      least = a;
      first = 1u << a;
    } else if (order == 0) {
      first |= 1u << a;
    }
  }
  return first;
}

/// The steps of a line that has started on all three axes. An Axis is an axis_place with next(), the
/// arrival at the next plane, and at_end(): the line ends where it is (Axis::may_end).
template <class Axis> void walk(std::array<Axis, 3>& axes, std::vector<step>& steps) {
  for (const Axis& axis : axes)
    if (axis.lost())
      return;
  const auto report = [&](bool segment) {
    if (axes[0].in_hull() && axes[1].in_hull() && axes[2].in_hull())
      steps.push_back({{static_cast<place>(axes[0].at), static_cast<place>(axes[1].at),
                        static_cast<place>(axes[2].at)},
                       segment});
  };
  report(false);
  while (true) {
    for (Axis& axis : axes)
      axis.depart();
    if (axes[0].lost() || axes[1].lost() || axes[2].lost())
      return;
    report(true);
    if constexpr (Axis::may_end)
      if (axes[0].passed == axes[0].ahead && axes[1].passed == axes[1].ahead &&
          axes[2].passed == axes[2].ahead)
        return report(false); // the end, between planes
    // Some axis moves; it has a plane before it, for it would be lost otherwise.
    const unsigned first = earliest(axes);
    assert(first != 0);
    for (unsigned a = 0; a < 3; ++a)
      axes[a].arrive((first >> a & 1) != 0);
    report(false);
    if constexpr (Axis::may_end)
      if (axes[0].at_end() || axes[1].at_end() || axes[2].at_end())
        return;
  }
}

} // namespace graze::oracle
