#include <algorithm>
#include <generate/random.hpp>
#include <generate/site.hpp>
#include <generate/tame.hpp>
#include <limits>

namespace graze::fuzz {

namespace {

constexpr double farthest = 16;    ///< of the origin, in root sizes
constexpr double widest = 0x1p40;  ///< between components, and from 1 or the root's size
constexpr double finest = 0x1p-80; ///< a component of the origin, in root sizes
constexpr double normal = std::numeric_limits<double>::min();

/// What a ray is tame beside: the root; a grid; the smallest box about boxes.
struct frame {
  vec3 lo, hi;
  double size; ///< the largest edge, or 1
};

frame frame_of(const trial& t) {
  frame f{t.root.lo, {t.root.hi(0), t.root.hi(1), t.root.hi(2)}, t.root.size};
  if (t.cells() == cell_kind::cube)
    return f;
  f.size = 0;
  for (unsigned a = 0; a < 3; ++a) {
    if (t.boxes) {
      f.lo[a] = f.hi[a] = t.boxes->front().lo[a];
      for (const octree::box& b : *t.boxes) {
        f.lo[a] = std::min(f.lo[a], b.lo[a]);
        f.hi[a] = std::max(f.hi[a], b.hi[a]);
      }
    } else {
      f.lo[a] = nearest_plane(*t.grid, a, 0);
      f.hi[a] = nearest_plane(*t.grid, a, t.grid->last(a));
    }
    f.size = std::max(f.size, f.hi[a] - f.lo[a]);
  }
  if (!(f.size >= normal && std::isfinite(f.size)))
    f.size = 1;
  return f;
}

double largest_of(const vec3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

bool is_tame(const vec3& point, const frame& f) {
  for (unsigned a = 0; a < 3; ++a) {
    const double x = point[a];
    if (!(f.lo[a] - farthest * f.size <= x) || !(x <= f.hi[a] + farthest * f.size))
      return false;
    if (x != 0 && std::fabs(x) < std::max(normal, finest * f.size))
      return false;
  }
  return true;
}

/// The origin, and a segment's end.
bool has_tame_ends(const trial& t, const frame& f) {
  return is_tame(t.origin, f) && (!t.end || is_tame(*t.end, f));
}

bool has_tame_direction(const trial& t, const frame& f) {
  const double largest = largest_of(t.direction);
  for (const double d : t.direction)
    if (d != 0 && (std::fabs(d) < normal || std::fabs(d) < largest / widest))
      return false;
  return std::min(1.0, f.size) / widest <= largest && largest <= std::max(1.0, f.size) * widest;
}

/// Scaled so that the largest component is from 1 to 2, times 2^up; those that are too small beside it are
/// made larger, or 0.
void tame_direction(random_stream& random, vec3& d, int up) {
  const int largest = std::ilogb(largest_of(d));
  for (double& x : d) {
    if (x == 0)
      continue;
    const int exponent = std::ilogb(x) - largest;
    const double significand = std::ldexp(x, -std::ilogb(x)); // exact, of subnormal numbers too
    if (exponent >= -39)
      x = std::ldexp(significand, exponent + up);
    else
      x = random.one_in(4) ? 0 : std::ldexp(significand, random.between(-39, -20) + up);
  }
}

/// A vertex of the block, or of one of the boxes, or a point of one of their edges.
vec3 place_to_meet(random_stream& random, const trial& t) {
  vec3 place;
  if (t.boxes) {
    const octree::box& b = (*t.boxes)[random.below(static_cast<unsigned>(t.boxes->size()))];
    place = b.corner(random.below(8));
    if (random.coin()) {
      const unsigned along = random.below(3);
      place[along] = b.lo[along] + scaled(static_cast<double>(random.bits(20)), -20) *
                                       (b.hi[along] - b.lo[along]);
    }
    return place;
  }
  for (int a = 0; a < 3; ++a)
    place[a] = t.plane(a, random.below(t.extent[a] + 1u));
  if (random.coin()) {
    const unsigned along = random.below(3);
    place[along] = t.plane(static_cast<int>(along), random.below(t.extent[along])) +
                   scaled(static_cast<double>(random.bits(20)), -20) *
                       (t.grid ? t.plane(static_cast<int>(along), t.extent[along]) -
                                     t.plane(static_cast<int>(along), 0)
                               : t.size());
  }
  return place;
}

/// From nearby: through the place exactly, or along the direction, or aimed at it with bits of its own.
void come_from_nearby(random_stream& random, trial& t, double size) {
  const vec3 place = place_to_meet(random, t);
  const double way = scaled(size / largest_of(t.direction), random.between(-10, 2));
  const unsigned kind = random.below(3);
  for (unsigned a = 0; a < 3; ++a) {
    const double offset = way * t.direction[a];
    if (kind == 0) {
      t.origin[a] = exact_origin(place[a], offset);
    } else if (kind == 1) {
      t.origin[a] = place[a] - offset;
    } else {
      const double away = random_double(random, -10, 2) * size;
      t.origin[a] = t.direction[a] == 0 ? place[a] : place[a] + away;
    }
  }
  if (kind == 1)
    return;
  for (unsigned a = 0; a < 3; ++a)
    t.direction[a] = place[a] - t.origin[a];
  if (kind == 2 && random.coin()) {
    double& x = t.direction[random.below(3)];
    x = step_ulps(x, random.between(-2, 2));
  }
}

/// A segment along the ray of t, which meets the place where it was led to: to there, short of it, or beyond.
trial cut_behind(random_stream& random, const trial& t) {
  const double far = random.one_in(3) ? 1
                                      : scaled(1.0 + static_cast<double>(random.bits(10)),
                                               random.between(-10, -6));
  vec3 end;
  for (unsigned a = 0; a < 3; ++a)
    end[a] = t.origin[a] + far * t.direction[a];
  return with_end(t, t.origin, end);
}

} // namespace

bool is_tame(const trial& t) {
  const frame f = frame_of(t);
  return has_tame_ends(t, f) && has_tame_direction(t, f);
}

trial tamed(const trial& given, std::uint64_t seed, std::uint64_t number) {
  if (is_tame(given))
    return given;
  random_stream random(mix(seed) + 1, number);
  const frame f = frame_of(given);
  for (int attempt = 0; attempt < 16; ++attempt) {
    trial t = given;
    const bool kept = has_tame_direction(t, f); // else a component may change, and with it the line
    if (!kept) {
      const vec3 before = t.direction;
      tame_direction(random, t.direction, random.one_in(4) ? random.between(-20, 20) : 0);
      const double ratio = largest_of(t.direction) / largest_of(before);
      bool same_line = std::isfinite(ratio) && ratio != 0;
      for (unsigned a = 0; a < 3; ++a)
        same_line = same_line && t.direction[a] == before[a] * ratio;
      if (same_line && attempt == 0 && !t.end && is_tame(t))
        return t;
    }
    come_from_nearby(random, t, f.size);
    if (t.end)
      t = cut_behind(random, t);
    if (is_tame(t) && judgeable(t))
      return t;
  }
  trial t = given; // along the first axis, in a face of the block
  for (int a = 0; a < 3; ++a) {
    t.origin[a] = t.boxes ? t.boxes->front().lo[a] : t.plane(a, 0);
    t.direction[a] = a == 0 ? 1 : 0;
  }
  t.origin[0] = f.lo[0] - f.size;
  return t.end ? with_end(t, t.origin, {f.hi[0] + f.size, t.origin[1], t.origin[2]}) : t;
}

} // namespace graze::fuzz
