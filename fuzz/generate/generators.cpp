#include <algorithm>
#include <generate/generators.hpp>
#include <generate/site.hpp>

namespace graze::fuzz {

namespace {

/// The last resort of every generator, for a direction that came out as 0.
void ensure_direction(random_stream& random, trial& t) {
  if (t.direction[0] == 0 && t.direction[1] == 0 && t.direction[2] == 0)
    t.direction[random.below(3)] = random.sign();
}

/// Leads the ray through the point exactly, at t = 1, from a full-precision origin.
void lead_through(random_stream& random, trial& t, const vec3& point) {
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = exact_origin(point[a], random_offset(random, t));
    t.direction[a] = point[a] - t.origin[a];
  }
}

/// Leads the ray through the point exactly, at t = `multiple`, along an integer direction.
void lead_along(random_stream& random, trial& t, const vec3& point, const vec3& integer, int bits) {
  const double multiple = static_cast<double>(random.bits(random.between(0, 20)) + 1);
  const double unit = scaled(t.root.size, -bits - random.between(0, 20));
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = exact_origin(point[a], integer[a] * multiple * unit);
    t.direction[a] = integer[a];
  }
  // an origin that had to be coarser has lost the direction: go straight to the point instead
  for (unsigned a = 0; a < 3; ++a)
    if (point[a] - t.origin[a] != integer[a] * multiple * unit) {
      for (unsigned b = 0; b < 3; ++b)
        t.direction[b] = point[b] - t.origin[b];
      break;
    }
}

/// As lead_along, for any direction of few bits.
vec3 integer_direction(random_stream& random, int bits) {
  vec3 d;
  const unsigned zeros = random.below(8) == 0 ? random.below(7) : 0;
  for (unsigned a = 0; a < 3; ++a)
    d[a] = (zeros >> a & 1) != 0 ? 0 : small_integer(random, bits);
  return d;
}

void lead_exactly(random_stream& random, trial& t, const vec3& point) {
  if (random.coin()) {
    lead_through(random, t, point);
  } else {
    const int bits = random.between(0, 20);
    lead_along(random, t, point, integer_direction(random, bits), bits);
  }
}

/// A point near the vertex along axis a: within the octants on either side of it.
double beside(random_stream& random, const trial& t, int axis, double v) {
  const double steps = scaled(static_cast<double>(random.bits(20)), -20);
  const auto a = static_cast<unsigned>(axis);
  const double x = v + random.sign() * steps * pitch(t, a);
  return std::clamp(x, lowest(t, a), highest(t, a));
}

void finish(random_stream& random, trial& t, const site& s) {
  ensure_direction(random, t);
  occupy(random, t, s);
}

void vertex(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  lead_exactly(random, t, s.vertex);
  if (t.direction == vec3{}) // the origin is the vertex itself
    t.direction = random_direction(random);
  if (random.one_in(4))
    scale(t.direction, random.between(-40, 40));
  finish(random, t, s);
}

/// Through a point of an edge, 0, 1 or 2 ulps beside it in one component.
void edge(random_stream& random, trial& t, int ulps) {
  const site s = pick_site(random, t);
  const unsigned along = random.below(3);
  vec3 point = s.vertex;
  point[along] = beside(random, t, static_cast<int>(along), point[along]);
  lead_exactly(random, t, point);
  const unsigned across = (along + 1 + random.below(2)) % 3;
  double& component = random.coin() ? t.origin[across] : t.direction[across];
  component = step_ulps(component, random.coin() ? ulps : -ulps);
  finish(random, t, s);
}

void edge_0(random_stream& random, trial& t) { edge(random, t, 0); }
void edge_1(random_stream& random, trial& t) { edge(random, t, 1); }
void edge_2(random_stream& random, trial& t) { edge(random, t, 2); }

void face(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  const unsigned normal = random.below(3);
  vec3 point = s.vertex;
  if (random.coin())
    for (unsigned a = 0; a < 3; ++a)
      if (random.coin())
        point[a] = beside(random, t, static_cast<int>(a), point[a]);
  point[normal] = s.vertex[normal];
  lead_exactly(random, t, point);
  t.origin[normal] = s.vertex[normal];
  t.direction[normal] = random.coin() ? 0.0 : -0.0;
  if (const unsigned a = (normal + 1) % 3; t.direction[a] == 0 && t.direction[(a + 1) % 3] == 0)
    t.direction[a] = random.sign();
  finish(random, t, s);
}

void near_parallel(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  const unsigned main = random.below(3);
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = s.vertex[a];
    t.direction[a] = 0;
    if (random.coin())
      t.origin[a] = step_ulps(t.origin[a], random.between(-2, 2));
    if (a == main)
      continue;
    switch (random.below(4)) {
    case 0:
      break;
    case 1:
      t.direction[a] = random.sign() * 0x1p-1074 * static_cast<double>(1 + random.below(4));
      break;
    default:
      t.direction[a] = random_double(random, -1074, -1);
      break;
    }
    if (random.one_in(4))
      t.origin[a] -= t.direction[a] * t.root.size;
  }
  t.origin[main] = s.vertex[main] - random_offset(random, t);
  t.direction[main] = random.coin() ? random.sign() : random_double(random, -3, 3);
  finish(random, t, s);
}

void diagonal(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  vec3 d;
  const unsigned zero = random.one_in(4) ? random.below(3) : 3;
  for (unsigned a = 0; a < 3; ++a) {
    static constexpr std::array<double, 8> steps{1, 1, 1, 1, 1, 2, 4, 3};
    d[a] = a == zero ? 0 : random.sign() * steps[random.below(8)];
  }
  lead_along(random, t, s.vertex, d, 2);
  if (random.one_in(3)) { // the same tie with every bit of the significand set or random
    const double m = std::fabs(random_double(random, 0, 0));
    for (double& x : t.direction)
      x *= m;
  }
  if (random.one_in(4)) {
    double& x = random.coin() ? t.direction[random.below(3)] : t.origin[random.below(3)];
    x = step_ulps(x, random.between(-2, 2));
  }
  finish(random, t, s);
}

/// The origin has the vertex's coordinate on `fixed` axes: 3 on the vertex, 2 an edge, 1 a face.
void origin_on(random_stream& random, trial& t, unsigned fixed) {
  const site s = pick_site(random, t);
  const unsigned first = random.below(3);
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned a = (first + i) % 3;
    t.origin[a] = i < fixed ? s.vertex[a] : beside(random, t, static_cast<int>(a), s.vertex[a]);
  }
  t.direction = random_direction(random);
  if (random.one_in(3))
    t.direction[random.below(3)] = random_double(random, -1074, -30);
  if (random.one_in(3)) { // towards another vertex
    for (unsigned a = 0; a < 3; ++a)
      t.direction[a] = s.vertex[a] + random.between(-1, 1) * pitch(t, a) - t.origin[a];
  }
  finish(random, t, s);
}

void origin_vertex(random_stream& random, trial& t) { origin_on(random, t, 3); }
void origin_edge(random_stream& random, trial& t) { origin_on(random, t, 2); }
void origin_face(random_stream& random, trial& t) { origin_on(random, t, 1); }

/// The direction from a full-precision origin to the target, rounded, at times a few ulps beside.
/// An origin made from the target would often give an exact difference; one with bits of its own,
/// below the last bit of the target's, does not.
void aim(random_stream& random, trial& t, const vec3& target, int highest_exponent) {
  const bool own_bits = random.below(4) != 0;
  const int lowest = highest_exponent - (random.coin() ? 4 : 40);
  for (unsigned a = 0; a < 3; ++a) {
    const double away = random_double(random, lowest, highest_exponent) * t.root.size;
    t.origin[a] = own_bits ? away : target[a] + away;
    t.direction[a] = target[a] - t.origin[a];
  }
  if (random.coin()) {
    double& x = t.direction[random.below(3)];
    x = step_ulps(x, random.between(-2, 2));
  }
}

void aimed_vertex(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  aim(random, t, s.vertex, 1);
  if (random.one_in(3)) { // normalized, as renderers do
    const double length = std::hypot(t.direction[0], t.direction[1], t.direction[2]);
    if (length > 0)
      for (double& x : t.direction)
        x /= length;
  }
  finish(random, t, s);
}

void aimed_edge(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  vec3 target = s.vertex;
  const unsigned along = random.below(3);
  target[along] = beside(random, t, static_cast<int>(along), target[along]);
  aim(random, t, target, 1);
  finish(random, t, s);
}

void root_graze(random_stream& random, trial& t) {
  const site s = pick_root_site(random, t);
  switch (random.below(3)) {
  case 0:
    lead_exactly(random, t, s.vertex);
    break;
  case 1:
    aim(random, t, s.vertex, 1);
    break;
  default: {
    lead_exactly(random, t, s.vertex);
    const unsigned a = random.below(3);
    t.origin[a] = step_ulps(s.vertex[a], random.between(-1, 1));
    t.direction[a] = random.coin() ? 0 : random_double(random, -1074, -40);
    break;
  }
  }
  if (random.one_in(3)) {
    double& x = random.coin() ? t.direction[random.below(3)] : t.origin[random.below(3)];
    x = step_ulps(x, random.between(-2, 2));
  }
  finish(random, t, s);
}

void subnormal(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  const int bits = random.between(0, 20);
  lead_along(random, t, s.vertex, integer_direction(random, bits), bits);
  const int down = random.one_in(3) ? random.between(-600, -480) : random.between(-1074, -1000);
  scale(t.direction, down);
  for (double& x : t.direction) // where that was not exact, near is good enough
    if (std::fabs(x) > 0x1p-400)
      x = scaled(x, down);
  if (random.one_in(3)) {
    double& x = t.direction[random.below(3)];
    x = random.coin() ? step_ulps(x, random.between(-2, 2)) : random_double(random, -1074, -480);
  }
  finish(random, t, s);
}

void huge(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  if (random.coin())
    lead_exactly(random, t, s.vertex);
  else
    aim(random, t, s.vertex, 1);
  scale(t.direction, random.coin() ? random.between(300, 640) : random.between(900, 1023));
  if (random.one_in(3)) {
    double& x = t.direction[random.below(3)];
    x = random.coin() ? step_ulps(x, random.between(-2, 2)) : random_double(random, 480, 1022);
  }
  finish(random, t, s);
}

void far_origin(random_stream& random, trial& t) {
  const site s = pick_site(random, t);
  const int most = 1022 - std::max(0, std::ilogb(t.root.size));
  const int exponent = random.one_in(8) ? random.between(60, most) : random.between(1, 60);
  if (random.one_in(3)) {
    const int bits = random.between(0, 3);
    const vec3 d = integer_direction(random, bits);
    for (unsigned a = 0; a < 3; ++a) {
      const double away = d[a] * scaled(t.root.size, std::min(exponent, most - 3));
      t.origin[a] = exact_origin(s.vertex[a], away);
      if (t.origin[a] == s.vertex[a])
        t.origin[a] = s.vertex[a] - away; // then rounded
      t.direction[a] = d[a];
    }
  } else {
    aim(random, t, s.vertex, exponent);
  }
  finish(random, t, s);
}

/// Exponents of the direction up to 2,000 apart. Where the vertex's coordinate is 0 the origin is
/// at times -d 2^k, so that the ray goes through the vertex, or an ulp beside, whatever the
/// exponents.
void exponent_gap(random_stream& random, trial& t) {
  site s = pick_site(random, t);
  const unsigned at_zero = random.below(8);
  for (unsigned a = 0; a < 3; ++a)
    if ((at_zero >> a & 1) != 0 && lowest(t, a) == 0)
      s.index[a] = 0;
  s = site_at(t, s.index);
  const int spread = random.coin() ? 1000 : random.between(30, 1000);
  const int k = random.between(-60, 60);
  for (unsigned a = 0; a < 3; ++a) {
    // the ends of the spread more often than what is between them
    const int exponent =
        random.coin() ? (random.coin() ? spread : -spread) : random.between(-spread, spread);
    t.direction[a] = random.one_in(8) ? 0 : random_double(random, exponent, exponent);
    const double back = s.vertex[a] - scaled(t.direction[a], k);
    switch (random.below(5)) {
    case 0:
      t.origin[a] = s.vertex[a];
      break;
    case 1:
      t.origin[a] = random.sign() * 0x1p-1074 * static_cast<double>(random.below(4));
      break;
    case 2:
      t.origin[a] = beside(random, t, static_cast<int>(a), s.vertex[a]);
      break;
    default:
      t.origin[a] = std::isfinite(back) ? back : s.vertex[a];
      break;
    }
    if (random.one_in(6))
      t.origin[a] = step_ulps(t.origin[a], random.between(-1, 1));
    if (random.one_in(8))
      t.direction[a] = step_ulps(t.direction[a], random.between(-1, 1));
  }
  finish(random, t, s);
}

/// In a mid-plane of a coarse level, through vertices and edges (contract 5 of the design).
void mid_plane(random_stream& random, trial& t) {
  const site s = pick_coarse_site(random, t);
  const unsigned normal = random.below(3);
  if (random.coin()) {
    lead_exactly(random, t, s.vertex);
  } else { // in two mid-planes at once: along an edge
    t.origin = s.vertex;
    t.direction = {0, 0, 0};
    const unsigned a = (normal + 1) % 3;
    t.origin[a] -= random_offset(random, t);
    t.direction[a] = random.sign();
  }
  t.origin[normal] = s.vertex[normal];
  t.direction[normal] = random.coin() ? 0.0 : -0.0;
  if (const unsigned a = (normal + 1) % 3; t.direction[a] == 0 && t.direction[(a + 1) % 3] == 0)
    t.direction[a] = random.sign();
  finish(random, t, s);
}

/// The control: nothing special, and a block where the ray passes.
void random_ray(random_stream& random, trial& t) {
  for (unsigned a = 0; a < 3; ++a) {
    const double lo = lowest(t, a), size = t.grid ? highest(t, a) - lo : t.root.size;
    const auto uniform = [&] { return static_cast<double>(random.bits(53)) * 0x1p-53 * size; };
    t.origin[a] = lo + uniform() * 3 - size;
    t.direction[a] = lo + uniform() - t.origin[a];
  }
  const double at = static_cast<double>(random.bits(53)) * 0x1p-52;
  std::array<std::uint64_t, 3> index;
  for (unsigned a = 0; a < 3; ++a) {
    const double place = (t.origin[a] + at * t.direction[a] - lowest(t, a)) / pitch(t, a);
    index[a] =
        place > 0 ? std::min(static_cast<std::uint64_t>(std::min(place, 0x1p60)), t.count(a)) : 0;
  }
  finish(random, t, site_at(t, index));
}

} // namespace

const std::vector<generator>& generators() {
  static const std::vector<generator> all{
      {"vertex", "through a vertex, exactly", vertex},
      {"edge-0", "through a point of an edge, exactly", edge_0},
      {"edge-1", "one ulp beside an edge", edge_1},
      {"edge-2", "two ulps beside an edge", edge_2},
      {"face", "in a face's plane", face},
      {"near-parallel", "nearly parallel to an axis, components down to 5e-324", near_parallel},
      {"diagonal", "several planes at the same t", diagonal},
      {"origin-vertex", "from a vertex", origin_vertex},
      {"origin-edge", "from a point of an edge", origin_edge},
      {"origin-face", "from a point of a face", origin_face},
      {"aimed-vertex", "at a vertex, direction rounded", aimed_vertex},
      {"aimed-edge", "at a point of an edge, direction rounded", aimed_edge},
      {"root-graze", "grazing the root's faces, edges and corners", root_graze},
      {"subnormal", "directions so small that products underflow", subnormal},
      {"huge", "directions so large that products overflow", huge},
      {"far-origin", "from 2 root sizes away to 1e308", far_origin},
      {"exponent-gap", "components whose exponents lie up to 2000 apart", exponent_gap},
      {"mid-plane", "in the mid-planes of coarse octants", mid_plane},
      {"random", "nothing special: the control", random_ray},
  };
  return all;
}

const generator* find_generator(std::string_view name) {
  for (const generator& g : generators())
    if (g.name == name)
      return &g;
  return nullptr;
}

trial make_trial(const generator& g, std::uint64_t seed, std::uint64_t index, int level,
                 const cube& root) {
  random_stream random(seed, index);
  trial t;
  t.root = root;
  t.level = level;
  g.make(random, t);
  return t;
}

} // namespace graze::fuzz
