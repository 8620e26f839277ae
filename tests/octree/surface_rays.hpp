#pragma once
/// Rays for the surface tests that a camera would not make.
#include "surface_judge.hpp"
#include <cmath>
#include <graze/octree/ray.hpp>
#include <vector>

namespace scenes {
using graze::octree::ray;
using graze::octree::vec3;

/// Rays in planes of the octree, along axes, from points inside the domain, with far origins and
/// with directions from tiny to huge.
template <class S> std::vector<ray> awkward(const S& scene, bool from_inside) {
  judge::random_source random(20260 + static_cast<unsigned>(scene.reach * 8));
  std::vector<ray> rays;
  while (rays.size() < 1200) {
    const double far = from_inside ? scene.reach : 4 * scene.reach;
    vec3 o, d;
    for (int a = 0; a < 3; ++a) {
      o[a] = random.in(-far, far);
      d[a] = random.in(-scene.reach, scene.reach) - o[a];
      if (random.below(4) == 0)
        o[a] = std::nearbyint(o[a] * 8) / 8;
      if (random.below(5) == 0)
        d[a] = 0;
      if (random.below(7) == 0)
        d[a] *= 0x1p-30;
    }
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(5)) * 60 - 120);
    for (double& x : d)
      x *= scale;
    if (const auto r = ray::make(o, d))
      rays.push_back(*r);
  }
  return rays;
}

} // namespace scenes
