#pragma once
#include <cmath>
#include <peers/papers/slabs.hpp>

namespace graze::peers {

/// Williams, Barrus, Morley and Shirley 2005, "An efficient and robust ray-box intersection
/// algorithm", journal of graphics tools 10(1): near and far planes chosen by the signs of the
/// inverse direction, and early exits.
class williams : slabs {
public:
  static constexpr char name[] = "williams", title[] = "Williams";
  static constexpr char summary[] =
      "ray/box test by slabs (Williams, Barrus, Morley and Shirley 2005)";
  using slabs::slabs;

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const bool backwards = inverse_[a] < 0;
      const double near = ((backwards ? hi : lo)[a] - origin_[a]) * inverse_[a];
      const double far = ((backwards ? lo : hi)[a] - origin_[a]) * inverse_[a];
      if (a == 0) {
        enter = near;
        leave = far;
        continue;
      }
      if (enter > far || near > leave)
        return false;
      if (near > enter)
        enter = near;
      if (far < leave)
        leave = far;
    }
    return enter < INFINITY && leave > 0;
  }
};

} // namespace graze::peers
