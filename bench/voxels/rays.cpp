#include "rays.hpp"
#include <adapters/adapter.hpp>
#include <algorithm>
#include <limits>
#include <utility>

namespace graze::bench {
namespace {

using adapter::to_float;
using peers::octant_index;

/// x moved by -2..2 units in the last place of the precision.
double nudge(double x, precision p, std::mt19937_64& random) {
  const int steps = static_cast<int>(random() % 5) - 2;
  const bool up = steps > 0;
  if (p == precision::single) {
    auto y = static_cast<float>(x);
    for (int i = 0; i < std::abs(steps); ++i)
      y = std::nextafter(y, up ? 4.0f : -4.0f);
    // next to 0 is a subnormal number: exact, and no wider than the rest for a test
    return static_cast<double>(y);
  }
  for (int i = 0; i < std::abs(steps); ++i)
    x = std::nextafter(x, up ? 4.0 : -4.0);
  return x;
}

octree::vec3 on_sphere(double radius, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  octree::vec3 v{};
  double norm = 0;
  for (double& x : v) {
    x = normal(random);
    norm += x * x;
  }
  for (double& x : v)
    x *= radius / std::sqrt(norm);
  return v;
}

} // namespace

occupied_octants sphere_shell(int level) {
  occupied_octants octants{{{-1, -1, -1}, 2}, level, {}, {}};
  const int side = 1 << level, half = side / 2;
  const double square = 0.8 * half * (0.8 * half); // integers beside it: no tie
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        double nearest = 0, farthest = 0;
        for (const int c : {x - half, y - half, z - half}) {
          const double outer = c < 0 ? -c : c + 1;
          farthest += outer * outer;
          nearest += (outer - 1) * (outer - 1);
        }
        if (nearest <= square && square <= farthest)
          octants.indices.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                     static_cast<std::uint32_t>(z)});
      }
  return octants;
}

std::vector<octree::ray> random_rays(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<octree::ray> rays;
  rays.reserve(count);
  while (rays.size() < count) {
    octree::vec3 o = on_sphere(std::sqrt(3.0), random);
    const octree::vec3 to = on_sphere(0.8 * std::cbrt(unit(random)), random);
    octree::vec3 d{};
    for (unsigned a = 0; a < 3; ++a) {
      o[a] = to_float(o[a]);
      d[a] = to_float(to[a] - o[a]);
    }
    rays.push_back(*octree::ray::make(o, d));
  }
  return rays;
}

std::vector<octree::ray> adversarial_rays(const occupied_octants& octants, precision p,
                                          std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto vertex = [&] {
    const octant_index& v = octants.indices[random() % octants.indices.size()];
    octree::vec3 at{};
    for (unsigned a = 0; a < 3; ++a)
      at[a] = octants.root.lo[a] + octants.edge() * (v[a] + random() % 2);
    return at;
  };
  const auto round = [p](double x) { return p == precision::single ? to_float(x) : x; };
  std::vector<octree::ray> rays;
  rays.reserve(count);
  while (rays.size() < count) {
    octree::vec3 o = vertex(), d{};
    switch (rays.size() % 3) {
    case 0: { // from afar to a vertex, or to a point of an edge
      octree::vec3 to = o;
      if (random() % 2 != 0)
        to[random() % 3] += octants.edge() * unit(random);
      o = on_sphere(std::sqrt(3.0), random);
      for (unsigned a = 0; a < 3; ++a) {
        o[a] = round(o[a]);
        d[a] = nudge(round(to[a] - o[a]), p, random);
      }
      break;
    }
    case 1: { // through two vertices, from far before the first
      const octree::vec3 to = vertex();
      const bool exactly = random() % 2 != 0;
      for (unsigned a = 0; a < 3; ++a) {
        d[a] = to[a] - o[a];
        o[a] -= d[a];
        if (!exactly)
          o[a] = nudge(o[a], p, random);
      }
      break;
    }
    default: { // in or beside planes of the grid: one component of the direction is 0, or two are
      const unsigned still = static_cast<unsigned>(random() % 3);
      for (unsigned a = 0; a < 3; ++a) {
        const double cells = static_cast<double>(random() % 7) - 3;
        d[a] = a == still ? 0 : cells * octants.edge();
        o[a] -= 512 * d[a];
        o[a] = nudge(o[a], p, random);
      }
    }
    }
    if (d[0] == 0 && d[1] == 0 && d[2] == 0)
      continue;
    rays.push_back(*octree::ray::make(o, d));
  }
  return rays;
}

} // namespace graze::bench
