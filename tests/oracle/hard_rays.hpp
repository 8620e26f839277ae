#pragma once
/// Rays and grids on which rounding decides: made to pass exactly through, or within an ulp of,
/// vertices, edges and faces, at every magnitude.
#include <algorithm>
#include <cmath>
#include <graze/oracle/geometry.hpp>
#include <limits>
#include <random>

namespace graze::oracle::test {

struct scene {
  point origin, direction;
  std::array<std::vector<double>, 3> planes;

  [[nodiscard]] std::array<std::span<const double>, 3> grid() const {
    return {planes[0], planes[1], planes[2]};
  }
};

class hard_scenes {
public:
  explicit hard_scenes(std::uint64_t seed) : random_(seed) {}

  scene next() {
    while (true) {
      scene s;
      make_grid(s);
      make_ray(s);
      perturb(s);
      if (legal(s))
        return s;
    }
  }

  std::uint64_t below(std::uint64_t n) { return random_() % n; }

private:
  bool chance(unsigned percent) { return below(100) < percent; }
  double sign() { return chance(50) ? 1 : -1; }
  /// A few bits, or all 53, in [1, 2).
  double significand() {
    const auto bits = chance(50) ? below(4) << 50 : random_() >> 12;
    return 1 + std::ldexp(static_cast<double>(bits), -52);
  }
  // One draw a statement here and below: the order of operands is up to the compiler, and the rays
  // are to be the same for all.
  double signed_as_drawn(double x) { return chance(50) ? x : -x; }
  double number(int exponent) {
    const double x = std::ldexp(significand(), exponent);
    return signed_as_drawn(x);
  }
  int exponent() {
    switch (below(8)) {
    case 0:
      return static_cast<int>(below(2098)) - 1074;
    case 1:
      return -1074;
    case 2:
      return -540;
    case 3:
      return 1023;
    default:
      return static_cast<int>(below(9)) - 4;
    }
  }
  double nudged(double x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return std::nextafter(x, chance(50) ? infinity : -infinity);
  }

  void make_grid(scene& s) {
    const unsigned kind = static_cast<unsigned>(below(8));
    const int level = static_cast<int>(below(51));
    for (auto& planes : s.planes) {
      planes.clear();
      const auto count = 2 + below(4);
      if (kind < 5) { // neighbouring octants of the unit cube at some level, and their mid-planes
        const double size = std::ldexp(1.0, -level);
        const double lo = std::floor(std::ldexp(significand() - 1, level)) * size;
        for (unsigned i = 0; i < count; ++i)
          planes.push_back(lo + i * (size / 2));
      } else if (kind == 5) { // small integers
        for (unsigned i = 0; i < count; ++i)
          planes.push_back(-2.0 + static_cast<double>(i));
      } else if (kind == 6) { // one ulp apart
        planes.push_back(number(exponent()));
        while (planes.size() < count)
          planes.push_back(std::nextafter(planes.back(), std::numeric_limits<double>::infinity()));
      } else { // anything
        for (unsigned i = 0; i < count; ++i)
          planes.push_back(chance(20) ? 0 : number(exponent()));
      }
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
      if (planes.size() < 2)
        planes = {-1, 1};
    }
  }

  point target(const scene& s) {
    point v;
    for (unsigned a = 0; a < 3; ++a)
      v[a] = s.planes[a][below(s.planes[a].size())];
    return v;
  }
  point inside(const scene& s) {
    point p;
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = s.planes[a].front(), hi = s.planes[a].back();
      p[a] = lo + (hi / 2 - lo / 2) * (significand() - 1) * 2;
    }
    return p;
  }
  point few_bits() {
    static constexpr std::array<double, 7> values{-2, -1, -0.5, 0, 0.5, 1, 2};
    return {values[below(7)], values[below(7)], values[below(7)]};
  }
  point any_direction() {
    if (chance(40))
      return few_bits();
    if (chance(30))
      return {sign(), sign(), sign()};
    const int common = exponent();
    point d;
    for (double& x : d)
      x = chance(15) ? 0 : number(chance(60) ? common : exponent());
    return d;
  }

  void make_ray(scene& s) {
    const point v = target(s), p = inside(s), d = any_direction();
    const double width = s.planes[0].back() - s.planes[0].front();
    switch (below(9)) {
    case 0: // through a vertex, exactly where the sums are exact
      for (unsigned a = 0; a < 3; ++a) {
        s.direction[a] = d[a];
        s.origin[a] = v[a] - d[a] * width;
      }
      break;
    case 1: // aimed at a vertex from somewhere, with a rounded direction
    case 2: // and at an edge
    case 3: // from far away
      s.origin = p;
      for (unsigned a = 0; a < 3; ++a) {
        s.origin[a] += number(chance(50) ? 7 : exponent());
        s.direction[a] = v[a] - s.origin[a];
      }
      if (chance(50))
        s.direction[below(3)] *= significand();
      break;
    case 4: { // in a face, or along an edge
      s.origin = p;
      s.direction = d;
      const auto first = below(3);
      const unsigned zeros = 1 + static_cast<unsigned>(below(2));
      for (unsigned i = 0; i < zeros; ++i) {
        const auto a = (first + i) % 3;
        s.origin[a] = v[a];
        s.direction[a] = 0;
      }
      if (chance(50))
        s.origin[(first + zeros) % 3] = v[(first + zeros) % 3] - width;
      break;
    }
    case 5: // from a vertex, an edge, a face
      s.origin = p;
      s.direction = d;
      for (unsigned a = 0; a < 3; ++a)
        if (chance(60))
          s.origin[a] = v[a];
      break;
    case 6: // nearly parallel to an axis, through a vertex or near it
      s.direction = d;
      s.origin = v;
      s.direction[below(3)] = chance(50) ? signed_as_drawn(0x1p-1074) : number(-540);
      s.origin[below(3)] -= width;
      break;
    case 7: { // a diagonal with ties: the same distance in units of the direction on two axes
      s.origin = v;
      for (unsigned a = 0; a < 3; ++a) {
        const auto power = static_cast<double>(1u << below(3));
        s.direction[a] = signed_as_drawn(power);
        s.origin[a] -= s.direction[a] * width * static_cast<double>(below(4)) / 2;
      }
      break;
    }
    default:
      s.origin = chance(50) ? p : point{number(exponent()), number(exponent()), number(exponent())};
      s.direction = d;
    }
  }

  void perturb(scene& s) {
    if (chance(20))
      s.origin[below(3)] = nudged(s.origin[below(3)]);
    if (chance(20)) {
      double& x = s.origin[below(3)];
      x = nudged(x);
    }
    if (chance(20)) {
      double& x = s.direction[below(3)];
      if (x != 0)
        x = nudged(x);
    }
    if (chance(20)) {
      const double factor = std::ldexp(1.0, static_cast<int>(below(2000)) - 1000);
      for (double& x : s.direction)
        x *= factor;
    }
    if (chance(5)) {
      const double factor = chance(50) ? 0x1p-1050 : 0x1p+1000; // scene and ray alike
      for (unsigned a = 0; a < 3; ++a) {
        s.origin[a] *= factor;
        for (double& p : s.planes[a])
          p *= factor;
      }
    }
    if (chance(10))
      for (double& x : s.direction)
        x = -x; // all of it behind
  }

  static bool legal(const scene& s) {
    bool moves = false;
    for (unsigned a = 0; a < 3; ++a) {
      if (!std::isfinite(s.origin[a]) || !std::isfinite(s.direction[a]))
        return false;
      moves |= s.direction[a] != 0;
      for (std::size_t i = 0; i < s.planes[a].size(); ++i)
        if (!std::isfinite(s.planes[a][i]) || (i > 0 && !(s.planes[a][i - 1] < s.planes[a][i])))
          return false;
    }
    return moves;
  }

  std::mt19937_64 random_;
};

} // namespace graze::oracle::test
