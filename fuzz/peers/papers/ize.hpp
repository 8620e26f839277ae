#pragma once
#include <cmath>
#include <peers/papers/slabs.hpp>

namespace graze::peers {

/// Ize 2013, "Robust BVH ray traversal", Journal of Computer Graphics Techniques 2(2): slabs, and
/// the far time times 1 + 2 ulps (1.00000024 in single precision, 0x1.0000000000002p0 in double).
class ize : slabs {
public:
  static constexpr char name[] = "ize", title[] = "Ize";
  static constexpr char summary[] = "ray/box test, far side padded by 2 ulps (Ize 2013)";
  using slabs::slabs;

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = INFINITY;
    for (unsigned a = 0; a < 3; ++a) {
      const bool backwards = std::signbit(inverse_[a]);
      const double near = ((backwards ? hi : lo)[a] - origin_[a]) * inverse_[a];
      const double far = ((backwards ? lo : hi)[a] - origin_[a]) * inverse_[a];
      // NaN, where the ray rests in a face's plane, leaves the interval as it was
      enter = near > enter ? near : enter;
      leave = far < leave ? far : leave;
    }
    return enter <= leave * 0x1.0000000000002p0;
  }
};

} // namespace graze::peers
