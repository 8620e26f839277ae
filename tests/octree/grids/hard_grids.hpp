#pragma once
/// Grids of every rule, and lines that graze their planes, edges and vertices; with the same in
/// rational numbers, made apart from graze::octree.
#include <cmath>
#include <cstdio>
#include <generate/random.hpp>
#include <graze/octree/exact_line.hpp>
#include <graze/octree/grid.hpp>
#include <graze/oracle/rational.hpp>
#include <variant>
#include <vector>

namespace graze::grid_tests {

using namespace graze::octree;
using fuzz::random_stream;
using oracle::rational::nearest_double;
using oracle::rational::nearest_float;

inline constexpr plane_rule computed_rules[]{plane_rule::exact, plane_rule::rounded,
                                             plane_rule::multiplied, plane_rule::added,
                                             plane_rule::binary32};
inline const char* name_of(plane_rule r) {
  switch (r) {
  case plane_rule::exact:
    return "exact";
  case plane_rule::rounded:
    return "rounded";
  case plane_rule::multiplied:
    return "multiplied";
  case plane_rule::added:
    return "added";
  case plane_rule::binary32:
    return "binary32";
  default:
    return "given";
  }
}

struct axis_plan {
  double origin, spacing;
  std::uint32_t count;
};

/// Plane k by the words of plane_rule.hpp.
inline mpq_class plane_by_rule(plane_rule rule, const axis_plan& p, std::uint32_t k) {
  const mpq_class o(p.origin), s(p.spacing);
  switch (rule) {
  case plane_rule::exact:
    return o + k * s;
  case plane_rule::rounded:
    return mpq_class(nearest_double(o + k * s));
  case plane_rule::multiplied:
    return mpq_class(nearest_double(o + mpq_class(nearest_double(k * s))));
  case plane_rule::added: {
    double plane = p.origin;
    for (std::uint32_t i = 0; i < k; ++i)
      plane = nearest_double(mpq_class(plane) + s);
    return mpq_class(plane);
  }
  case plane_rule::binary32:
    return mpq_class(nearest_float(
        mpq_class(nearest_float(o)) +
        mpq_class(nearest_float(mpq_class(nearest_float(k)) * mpq_class(nearest_float(s))))));
  default:
    return 0;
  }
}

/// A grid and some of its planes as rationals.
struct hard_grid {
  grid planes;
  std::array<axis_plan, 3> plan; ///< of a grid that is not given
  double unit;                   ///< about a spacing

  [[nodiscard]] mpq_class plane(unsigned axis, std::uint32_t k) const {
    const int a = static_cast<int>(axis);
    if (planes.rule() == plane_rule::given || planes.flat(a) ||
        (planes.rule() == plane_rule::added && k > 2000))
      return mpq_class(planes.lower(a, k));
    return plane_by_rule(planes.rule(), plan[axis], k);
  }
};

inline double near_one(random_stream& r) {
  return 1 + std::ldexp(static_cast<double>(r.bits(52)), -52);
}

inline double steps_away(double x, int ulps) {
  for (; ulps != 0; ulps += ulps < 0 ? 1 : -1)
    x = std::nextafter(x, ulps < 0 ? -INFINITY : INFINITY);
  return x;
}

/// One of any rule; `most` voxels an axis at the most. Spacings that people have, others, and some
/// at the ends of the doubles.
inline hard_grid make_grid(random_stream& r, std::uint32_t most) {
  static constexpr double spacings[]{0.1, 1.0 / 3, 25.2165, 1e-7, 0.05, 1, 0.25, 0.7};
  for (;;) {
    const plane_rule rule =
        r.one_in(6) ? plane_rule::given : computed_rules[r.below(std::size(computed_rules))];
    // all axes near each other in size, or of any
    const int scale = r.one_in(8) ? (r.coin() ? r.between(-1050, -900) : r.between(900, 1000)) : 0;
    const bool alike = r.coin();
    const double common = spacings[r.below(std::size(spacings))];
    std::array<axis_plan, 3> plan;
    std::array<std::vector<double>, 3> given;
    double unit = 0;
    for (unsigned a = 0; a < 3; ++a) {
      axis_plan& p = plan[a];
      p.spacing = std::ldexp(r.one_in(4) ? std::ldexp(near_one(r), r.between(-12, 4))
                             : alike     ? common
                                         : spacings[r.below(std::size(spacings))],
                             scale);
      p.count = 1 + r.below(r.coin() ? std::min(most, 9u) : most);
      if (r.one_in(10)) { // flat
        p.count = 1;
        p.spacing = 0;
      }
      const double reach = p.spacing * p.count;
      switch (r.below(6)) {
      case 0:
        p.origin = 0;
        break;
      case 1:
        p.origin = -reach / 2;
        break;
      case 2: // far: few bits are left for the voxels
        p.origin = r.sign() * std::ldexp(p.spacing * near_one(r), r.between(10, 50));
        break;
      case 3: // so that a plane is near 0
        p.origin = -p.spacing * r.below(p.count + 1);
        break;
      default:
        p.origin = r.sign() * p.spacing * near_one(r) * r.below(100);
      }
      unit = std::max(unit, p.spacing);
      double x = p.origin;
      for (std::uint32_t k = 0; k <= p.count && (k == 0 || p.spacing != 0); ++k) {
        given[a].push_back(x);
        x = r.one_in(4) ? steps_away(x, 1 + static_cast<int>(r.below(3)))
                        : x + p.spacing * near_one(r) * (r.one_in(9) ? 20 : 1);
      }
    }
    const auto made =
        rule == plane_rule::given
            ? grid::make({std::span<const double>(given[0]), std::span<const double>(given[1]),
                          std::span<const double>(given[2])})
            : grid::make({plan[0].origin, plan[1].origin, plan[2].origin},
                         {plan[0].spacing, plan[1].spacing, plan[2].spacing},
                         {plan[0].count, plan[1].count, plan[2].count}, rule);
    if (made)
      return {*made, plan, unit == 0 ? 1 : unit};
  }
}

/// A ray, a part of one, or a segment between points.
struct hard_line {
  std::variant<ray, segment> given;
  ray_segment part; ///< of a ray

  [[nodiscard]] exact_line prepared() const {
    if (const ray* r = std::get_if<ray>(&given))
      return {*r, part};
    return {std::get<segment>(given)};
  }
  [[nodiscard]] oracle::rational::line rational() const {
    if (const ray* r = std::get_if<ray>(&given)) {
      oracle::rational::line l = oracle::rational::ray_of(r->origin(), r->direction());
      l.first = mpq_class(part.first());
      if (part.last() < INFINITY)
        l.last = mpq_class(part.last());
      return l;
    }
    const segment& s = std::get<segment>(given);
    return oracle::rational::segment_of(s.from(), s.to());
  }
};

/// Planes of doubles about a place in a grid: where lines are aimed.
struct place {
  std::array<std::uint32_t, 3> base, extent; ///< voxels
};

/// A line that grazes something of the place: an edge or a vertex to the last bit where doubles
/// can, within ulps, in a plane, or through somewhere.
inline hard_line make_line(random_stream& r, const hard_grid& g, const place& at) {
  const auto plane_near = [&](unsigned a, std::uint32_t k) {
    return r.coin() ? g.planes.lower(static_cast<int>(a), k)
                    : g.planes.upper(static_cast<int>(a), k);
  };
  const auto some_plane = [&](unsigned a) {
    return plane_near(a, at.base[a] + r.below(at.extent[a] + 1));
  };
  const auto between_planes = [&](unsigned a) {
    const std::uint32_t k = at.base[a] + r.below(at.extent[a]);
    const double lo = g.planes.lower(static_cast<int>(a), k),
                 hi = g.planes.upper(static_cast<int>(a), k + 1);
    return lo + (hi - lo) * (near_one(r) - 1);
  };
  for (;;) {
    vec3 target, origin, direction;
    unsigned on_planes = 7u >> r.below(3); // of the target: a vertex, an edge, a face
    if (r.coin())
      on_planes = (on_planes << 1 | on_planes >> 2) & 7;
    for (unsigned a = 0; a < 3; ++a)
      target[a] = (on_planes >> a & 1) != 0 ? some_plane(a) : between_planes(a);
    if (r.one_in(4))
      for (double& x : target)
        x = steps_away(x, r.between(-2, 2));
    // where it comes from
    const unsigned from = r.below(8);
    for (unsigned a = 0; a < 3; ++a) {
      const double spread = g.unit * std::ldexp(near_one(r), r.between(-3, 12));
      switch (from) {
      case 0: // a vertex of the grid
        origin[a] = some_plane(a);
        break;
      case 1: // its corner: with a direction of spacings, through all vertices of a diagonal
        origin[a] = g.planes.lower(static_cast<int>(a), 0);
        break;
      case 2: // within the place
        origin[a] = between_planes(a);
        break;
      case 3: // on a plane
        origin[a] = r.coin() ? some_plane(a) : between_planes(a);
        break;
      default:
        origin[a] = target[a] + r.sign() * spread;
      }
      direction[a] = target[a] - origin[a];
    }
    if (r.one_in(6)) // in a plane, or along an edge
      for (unsigned a = 0; a < 3; ++a)
        if (r.coin()) {
          origin[a] = steps_away(some_plane(a), r.one_in(3) ? r.between(-1, 1) : 0);
          direction[a] = 0;
        }
    if (from == 1 && g.planes.rule() != plane_rule::given && r.coin())
      for (unsigned a = 0; a < 3; ++a)
        direction[a] = std::ldexp(g.plan[a].spacing, static_cast<int>(r.below(3)));
    if (r.one_in(6))
      for (unsigned a = 0; a < 3; ++a)
        direction[a] = steps_away(direction[a], r.between(-2, 2));
    if (r.one_in(10))
      direction[r.below(3)] = r.sign() * (r.coin() ? 0x1p-1074 : std::ldexp(g.unit, -60));
    if (r.one_in(10)) {
      const int by = r.coin() ? r.between(-1000, -300) : r.between(300, 900);
      for (double& d : direction)
        d = std::ldexp(d, by);
    }
    if (r.one_in(3)) { // a segment: to the target, beyond it, or not so far
      vec3 to = target;
      for (unsigned a = 0; a < 3; ++a) {
        if (direction[a] == 0)
          to[a] = origin[a];
        else if (r.one_in(4))
          to[a] = steps_away(to[a], r.between(-2, 2));
      }
      if (r.one_in(4))
        for (unsigned a = 0; a < 3; ++a)
          to[a] = target[a] + (target[a] - origin[a]) * (r.coin() ? 1 : -0.25);
      if (r.one_in(12)) // the difference is beyond the doubles
        for (unsigned a = 0; a < 3; ++a)
          to[a] = to[a] < origin[a] ? -0x1.fp1023 : 0x1.fp1023;
      if (r.one_in(12)) { // on one axis alone, with the target half-way
        for (unsigned a = 0; a < 3; ++a) {
          const double away = g.unit * near_one(r);
          origin[a] = target[a] - away;
          to[a] = target[a] + away;
        }
        const unsigned a = r.below(3);
        origin[a] = r.coin() ? -0x1.8p1023 : 0x1.8p1023;
        to[a] = -origin[a];
      }
      if (const auto s = segment::make(origin, to))
        return {*s, {}};
      continue;
    }
    const auto made = ray::make(origin, direction);
    if (!made)
      continue;
    ray_segment part;
    if (r.one_in(3)) {
      const auto hard_time = [&] {
        const unsigned a = r.below(3);
        const double t = (some_plane(a) - origin[a]) / direction[a];
        return t > 0 && std::isfinite(t) ? steps_away(t, r.between(-1, 1)) : 0;
      };
      double first = r.coin() ? hard_time() : 0, last = r.coin() ? hard_time() : INFINITY;
      if (last < first)
        std::swap(first, last);
      if (const auto s = ray_segment::make(first, last))
        part = *s;
    }
    return {*made, part};
  }
}

inline place make_place(random_stream& r, const grid& g) {
  place p;
  for (unsigned a = 0; a < 3; ++a) {
    const std::uint32_t n = g.count(static_cast<int>(a));
    p.extent[a] = std::min(n, 1 + r.below(4));
    p.base[a] = r.one_in(3) ? (r.coin() ? 0 : n - p.extent[a]) : r.below(n - p.extent[a] + 1);
  }
  return p;
}

} // namespace graze::grid_tests
