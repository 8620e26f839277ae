#pragma once
/// Axis-parallel boxes: the domain in which a surface is looked at, and octants cut by it.
/// What kernels of a path use is always inlined: see batch/path.hpp.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <cmath>
#include <graze/octree/cube.hpp>

namespace graze::octree {

/// The closed box [lo, hi]; empty where lo[a] > hi[a] on some axis. Units: scene length.
struct box {
  vec3 lo, hi;

  [[nodiscard, gnu::always_inline]] bool empty() const {
    return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2];
  }
  /// Corner `index`: bit a is set where the corner lies on the upper face of axis a.
  [[nodiscard, gnu::always_inline]] vec3 corner(unsigned index) const {
    return {(index & 1u) != 0 ? hi[0] : lo[0], (index & 2u) != 0 ? hi[1] : lo[1],
            (index & 4u) != 0 ? hi[2] : lo[2]};
  }
  friend bool operator==(const box&, const box&) = default;
};

/// The closed box of an octant. Exact for the octants of a root_cube.
[[nodiscard, gnu::always_inline]] inline box closed_box(const cube& c) {
  return {c.lo, {c.hi(0), c.hi(1), c.hi(2)}};
}

[[nodiscard, gnu::always_inline]] inline bool contains(const box& outer, const box& inner) {
  for (int a = 0; a < 3; ++a)
    if (!(outer.lo[a] <= inner.lo[a] && inner.hi[a] <= outer.hi[a]))
      return false;
  return true;
}

/// The common part; empty() when there is none. Exact.
[[nodiscard, gnu::always_inline]] inline box intersection(const box& p, const box& q) {
  box r{};
  for (int a = 0; a < 3; ++a) {
    r.lo[a] = std::max(p.lo[a], q.lo[a]);
    r.hi[a] = std::min(p.hi[a], q.hi[a]);
  }
  return r;
}

/// The smallest cube [-2^E, 2^E]^3 that holds `domain`, so that the corners of its octants are
/// exact doubles down to `level` <= 53. A scene's own domain, such as [-2.5, 2.5]^3, is not so
/// exact. Refuses a domain that is empty, not finite or too large, and a level outside 1..53.
[[nodiscard]] inline expected<root_cube> enclosing_root(const box& domain, int level) {
  double reach = 0;
  for (int a = 0; a < 3; ++a) {
    if (!std::isfinite(domain.lo[a]) || !std::isfinite(domain.hi[a]))
      return unexpected{"domain is not finite"};
    if (domain.lo[a] > domain.hi[a])
      return unexpected{"domain is empty"};
    reach = std::max({reach, std::fabs(domain.lo[a]), std::fabs(domain.hi[a])});
  }
  if (reach == 0)
    return unexpected{"domain is a single point"};
  int exponent = 0;
  if (std::frexp(reach, &exponent) == 0.5)
    --exponent; // reach is itself a power of two
  const double half = std::ldexp(1.0, exponent);
  return root_cube::make({{-half, -half, -half}, 2 * half}, level);
}

} // namespace graze::octree
