#pragma once
/// Boxes, domains and rays on which twins are likeliest to part.
#include <cmath>
#include <graze/octree/box.hpp>
#include <graze/octree/ray.hpp>
#include <graze/oracle/random_bits.hpp>
#include <limits>
#include <span>
#include <vector>

namespace graze::twins {

using octree::box;
using octree::ray;
using octree::vec3;

class random_source {
public:
  explicit random_source(std::uint64_t seed) : bits_(seed) {}
  std::size_t below(std::size_t n) { return bits_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  /// In [lo, hi].
  double in(double lo, double hi) {
    const double t = static_cast<double>(bits_() >> 11) * 0x1p-53;
    return std::min(std::max(lo, lo + (hi - lo) * t), hi);
  }
  int between(int lo, int hi) {
    return lo + static_cast<int>(below(static_cast<std::size_t>(hi - lo + 1)));
  }

private:
  oracle::random_bits bits_;
};

/// Where formulas turn, jump, have poles or lose precision.
inline double some_place(random_source& random) {
  static constexpr double places[] = {0,
                                      -0.0,
                                      1,
                                      -1,
                                      0.5,
                                      -0.5,
                                      2,
                                      1.5,
                                      -2,
                                      0.25,
                                      1.75,
                                      2.5,
                                      -2.5,
                                      3,
                                      0x1.279a74590331cp-1,
                                      -0x1.279a74590331dp-1,
                                      0x1.921fb54442d18p+0,
                                      0x1.921fb54442d18p+1,
                                      0x1.94c583ada5b53p+0,
                                      0x1p-1074,
                                      -0x1p-1074,
                                      0x1p-1022,
                                      1e-160,
                                      -1e-160,
                                      1e160,
                                      1e300,
                                      -1e300,
                                      0x1.fffffffffffffp+1023};
  return places[random.below(std::size(places))];
}

/// One side of a box: a point, two neighbours, subnormal, at 0, huge, asymmetric, or ordinary.
/// Bounds are finite.
inline void some_side(random_source& random, double& lo, double& hi) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double at = random.one_in(3) ? some_place(random) : random.in(-3, 3);
  const double size = std::ldexp(random.in(0.5, 1), -random.between(-2, 56));
  lo = hi = at;
  switch (random.below(10)) {
  case 0:
    break;
  case 1: // two neighbours
    (random.one_in(2) ? lo : hi) = std::nextafter(at, 0);
    break;
  case 2: { // subnormal
    lo = std::ldexp(random.between(-8, 8), -1074);
    hi = std::ldexp(random.between(-8, 8), -1074);
    break;
  }
  case 3: // at 0 from either side
    (random.one_in(2) ? lo : hi) = random.one_in(2) ? 0.0 : -0.0;
    break;
  case 4: // a few ulps
    for (int k = random.between(1, 3); k > 0; --k)
      hi = std::nextafter(hi, infinity);
    break;
  case 5: // far in one direction
    (random.one_in(2) ? lo : hi) *= std::ldexp(1.0, random.between(1, 40));
    break;
  default:
    lo -= random.one_in(2) ? size : 0;
    hi += random.one_in(2) ? size : 0;
  }
  if (lo > hi)
    std::swap(lo, hi);
  constexpr double most = std::numeric_limits<double>::max();
  lo = std::max(lo, -most);
  hi = std::min(hi, most);
}

/// Domains that are flat, subnormal, huge, a few ulps wide, at 0, asymmetric; ordinary ones first.
inline std::vector<box> some_domains() {
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  return {{{-1.25, -1, -1.5}, {1, 1.5, 1.25}},
          {{0, 0, 0}, {1, 1, 1}},
          {{0.5, -1, -1}, {0.5, 1, 1}},
          {{-1, 0, -1}, {2, 0, 1}},
          {{0.25, -0.5, -1}, {0.25, -0.5, 1}},
          {{0x1p-1074, -1, -1}, {0x1p-1074, 1, 1}},
          {{-0x1p-1060, -0x1p-1062, 0}, {0x1p-1060, 0x1p-1061, 0x1p-1060}},
          {{-1e300, -1e299, 0}, {1e300, 1e300, 1e298}},
          {{1, below, 1}, {above, above, 1}},
          {{0.125, -3, 1}, {0.1875, 3, 1.5}},
          {{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}}};
}

/// Rays that meet the domain or just do not: from outside and inside, along axes and faces, with
/// components 0, subnormal and huge.
inline std::vector<ray> some_rays(random_source& random, const box& domain, std::size_t count) {
  std::vector<ray> rays;
  vec3 reach;
  double most = 0;
  for (int a = 0; a < 3; ++a) {
    reach[a] = std::max(std::fabs(domain.lo[a]), std::fabs(domain.hi[a]));
    most = std::max(most, reach[a]);
  }
  while (rays.size() < count) {
    vec3 o, d;
    const bool inside = random.one_in(3);
    const int scale = random.one_in(4) ? 60 * random.between(-4, 4) : 0;
    for (int a = 0; a < 3; ++a) {
      const double to = random.one_in(5) ? (random.one_in(2) ? domain.lo[a] : domain.hi[a])
                                         : random.in(domain.lo[a], domain.hi[a]);
      o[a] = inside ? random.in(domain.lo[a], domain.hi[a]) : random.in(-1, 1) * most;
      if (random.one_in(6))
        o[a] = to;
      d[a] = random.one_in(6) ? 0 : to - o[a];
      if (random.one_in(12))
        d[a] = std::ldexp(random.between(-3, 3), -1074);
      else
        d[a] = std::ldexp(d[a], scale);
      if (!inside)
        o[a] -= random.one_in(3) ? d[a] : 0;
    }
    if (const auto r = ray::make(o, d))
      rays.push_back(*r);
  }
  return rays;
}

} // namespace graze::twins
