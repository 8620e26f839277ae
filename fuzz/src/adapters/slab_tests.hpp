#pragma once
/// Ray/box tests of others by slabs, in double, written from their papers: made once a ray, from
/// its origin and direction as they are, and asked for boxes by their exact corners, for t >= 0.
/// Each keeps what its authors keep (the inverse direction, its signs).
#include <cmath>
#include <graze/octree/vector.hpp>

namespace graze::fuzz {

using octree::vec3;

/// Williams, Barrus, Morley and Shirley 2005, "An efficient and robust ray-box intersection
/// algorithm", journal of graphics tools 10(1): near and far planes chosen by the signs of the
/// inverse direction, and early exits.
class williams_test {
public:
  williams_test(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

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

private:
  vec3 origin_, inverse_{};
};

/// Ize 2013, "Robust BVH ray traversal", Journal of Computer Graphics Techniques 2(2): slabs, and
/// the far time times 1 + 2 ulps (1.00000024 in single precision, 0x1.0000000000002p0 in double).
class ize_test {
public:
  ize_test(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

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

private:
  vec3 origin_, inverse_{};
};

/// Tavian Barnes 2022, "Fast, branchless ray/bounding box intersections, part 3: boundaries": no
/// sign is looked at; minima and maxima, in an order in which NaN counts as inside.
class tavian_test {
public:
  tavian_test(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = INFINITY;
    for (unsigned a = 0; a < 3; ++a) {
      const double first = (lo[a] - origin_[a]) * inverse_[a];
      const double second = (hi[a] - origin_[a]) * inverse_[a];
      enter = min(max(first, enter), max(second, enter));
      leave = max(min(first, leave), min(second, leave));
    }
    return enter <= leave;
  }

private:
  // as minsd and maxsd: the second operand where one is NaN
  static double min(double x, double y) { return x < y ? x : y; }
  static double max(double x, double y) { return x > y ? x : y; }
  vec3 origin_, inverse_{};
};

/// Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd edition, section 3.9.2:
/// Bounds3::IntersectP with the inverse direction and its signs, in double. The far times are
/// increased by 2 gamma(3), the error of three roundings on either side.
class pbrt_test {
public:
  pbrt_test(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

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
  vec3 origin_, inverse_{};
};

} // namespace graze::fuzz
