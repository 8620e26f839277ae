#pragma once
#include <cmath>
#include <peers/papers/slabs.hpp>

namespace graze::peers {

/// Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd edition, section 3.9.2:
/// Bounds3::IntersectP with the inverse direction and its signs, in double. The far times are
/// increased by 2 gamma(3), the error of three roundings on either side.
class pbrt : slabs {
public:
  static constexpr char name[] = "pbrt", title[] = "pbrt";
  static constexpr char summary[] =
      "ray/box test of pbrt: Bounds3::IntersectP, far side padded by gamma(3)";
  using slabs::slabs;

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const bool backwards = inverse_[a] < 0;
      const double near = ((backwards ? hi : lo)[a] - origin_[a]) * inverse_[a];
      const double far = ((backwards ? lo : hi)[a] - origin_[a]) * inverse_[a] * (1 + 2 * gamma(3));
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

private:
  /// The relative error of n roundings: n u / (1 - n u).
  static constexpr double gamma(int n) { return n * 0x1p-53 / (1 - n * 0x1p-53); }
};

} // namespace graze::peers
