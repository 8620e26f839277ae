#include <algorithm>
#include <generate/random.hpp>
#include <generate/site.hpp>
#include <generate/tame.hpp>
#include <limits>

namespace graze::fuzz {

namespace {

constexpr double farthest = 16;     ///< of the origin, in root sizes
constexpr double widest = 0x1p40;   ///< between components, and from 1 or the root's size
constexpr double finest = 0x1p-80;  ///< a component of the origin, in root sizes
constexpr double steepest = 0x1p20; ///< between the edges of cells
constexpr double normal = std::numeric_limits<double>::min();

double largest_of(const vec3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

/// What holds all cells, and its largest edge.
struct frame {
  vec3 lo, hi;
  double size;
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
      f.lo[a] = lowest(t, a);
      f.hi[a] = highest(t, a);
    }
    f.size = std::max(f.size, f.hi[a] - f.lo[a]);
  }
  if (f.size == 0) // a point
    f.size = 1;
  return f;
}

bool has_tame_origin(const trial& t, const frame& f) {
  for (unsigned a = 0; a < 3; ++a) {
    const double o = t.origin[a];
    if (!(f.lo[a] - farthest * f.size <= o) || !(o <= f.hi[a] + farthest * f.size))
      return false;
    if (o != 0 && std::fabs(o) < std::max(normal, finest * f.size))
      return false;
  }
  return true;
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

/// A vertex of the block, or a point of one of its edges.
vec3 place_to_meet(random_stream& random, const trial& t) {
  vec3 place;
  if (t.boxes) {
    const octree::box& b = (*t.boxes)[random.below(static_cast<unsigned>(t.boxes->size()))];
    for (unsigned a = 0; a < 3; ++a)
      place[a] = random.coin() ? b.lo[a] : b.hi[a];
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
    const double plane = t.plane(static_cast<int>(along), random.below(t.extent[along]));
    place[along] = plane + scaled(static_cast<double>(random.bits(20)), -20) * pitch(t, along);
  }
  return place;
}

/// From nearby: through the place exactly, or along the direction, or aimed at it with bits of its own.
void come_from_nearby(random_stream& random, trial& t, const frame& f) {
  const vec3 place = place_to_meet(random, t);
  const double way = scaled(f.size / largest_of(t.direction), random.between(-10, 2));
  const unsigned kind = random.below(3);
  for (unsigned a = 0; a < 3; ++a) {
    const double offset = way * t.direction[a];
    if (kind == 0) {
      t.origin[a] = exact_origin(place[a], offset);
    } else if (kind == 1) {
      t.origin[a] = place[a] - offset;
    } else {
      const double away = random_double(random, -10, 2) * f.size;
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

/// Edges of cells, one after the other.
class edges {
public:
  void add(double edge) {
    if (edge == 0) // flat
      return;
    least_ = std::min(least_, edge);
    greatest_ = std::max(greatest_, edge);
  }
  [[nodiscard]] bool are_tame() const {
    return greatest_ == 0 ||
           (1 / widest <= least_ && greatest_ <= widest && greatest_ <= steepest * least_);
  }

private:
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = 0;
};

} // namespace

bool has_tame_edges(const grid_planes& g) {
  edges all;
  for (unsigned a = 0; a < 3; ++a) {
    if (g.rule != plane_rule::given)
      all.add(g.spacing[a]);
    for (std::size_t k = 1; k < g.given[a].size(); ++k)
      all.add(g.given[a][k] - g.given[a][k - 1]);
  }
  return all.are_tame();
}

bool has_tame_edges(const std::vector<octree::box>& boxes) {
  edges all;
  for (const octree::box& b : boxes)
    for (unsigned a = 0; a < 3; ++a)
      all.add(b.hi[a] - b.lo[a]);
  return all.are_tame();
}

bool is_tame(const trial& t) {
  const frame f = frame_of(t);
  return has_tame_origin(t, f) && has_tame_direction(t, f);
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
      if (same_line && attempt == 0 && is_tame(t))
        return t;
    }
    come_from_nearby(random, t, f);
    if (is_tame(t) && judgeable(t))
      return t;
  }
  trial t = given; // along the first axis, in a face of the block
  const octree::box first = t.cell(0);
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = first.lo[a];
    t.direction[a] = a == 0 ? 1 : 0;
  }
  t.origin[0] = f.lo[0] - f.size;
  return t;
}

} // namespace graze::fuzz
