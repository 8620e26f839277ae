#include <algorithm>
#include <generate/site.hpp>

namespace graze::fuzz {

namespace {

/// An index in 1..count - 1; where the axis has one voxel, either face of it.
std::uint64_t inner_index(random_stream& random, const trial& t, unsigned axis) {
  if (!t.grid)
    return t.level == 1 ? 1 : std::clamp<std::uint64_t>(random.bits(t.level), 1, t.count(axis) - 1);
  const auto count = static_cast<unsigned>(t.count(axis));
  return count == 1 ? random.below(2) : 1 + random.below(count - 1);
}

/// An odd multiple of 2^(level - coarse): on a mid-plane of level coarse - 1.
std::uint64_t coarse_index(random_stream& random, const trial& t, int coarse) {
  return (random.bits(coarse - 1) * 2 + 1) << (t.level - coarse);
}

} // namespace

double pitch(const trial& t, unsigned axis) {
  if (!t.grid)
    return t.size();
  const auto last = t.grid->last(axis);
  return last == 0 ? 0 : (highest(t, axis) - lowest(t, axis)) / last;
}

double lowest(const trial& t, unsigned axis) {
  return t.grid ? nearest_plane(*t.grid, axis, 0) : t.root.lo[axis];
}

double highest(const trial& t, unsigned axis) {
  return t.grid ? nearest_plane(*t.grid, axis, t.grid->last(axis))
                : t.root.hi(static_cast<int>(axis));
}

site site_at(const trial& t, const std::array<std::uint64_t, 3>& index) {
  site s{index, {}};
  for (unsigned a = 0; a < 3; ++a) {
    s.index[a] = std::min(index[a], t.flat(a) ? 0 : t.count(a));
    s.vertex[a] = t.grid_plane(static_cast<int>(a), s.index[a]);
  }
  return s;
}

site pick_occupied_site(random_stream& random, const trial& t) {
  const voxel_index v = t.map->voxel(random.bits() % t.map->size());
  return site_at(t, {v[0] + random.below(2), v[1] + random.below(2), v[2] + random.below(2)});
}

site pick_site(random_stream& random, const trial& t) {
  if (t.map)
    return pick_occupied_site(random, t);
  const unsigned kind = random.below(16);
  if (kind == 0)
    return pick_root_site(random, t);
  if (kind == 1)
    return pick_coarse_site(random, t);
  std::array<std::uint64_t, 3> index{};
  for (unsigned a = 0; a < 3; ++a)
    index[a] = inner_index(random, t, a);
  if (kind == 2) { // one plane of a coarse level, or the one beside it
    const unsigned a = random.below(3);
    auto& i = index[a];
    i = coarse_index(random, t, random.between(1, t.level)) + random.below(3) - 1;
    i = std::min(i, t.count(a));
  }
  return site_at(t, index);
}

site pick_root_site(random_stream& random, const trial& t) {
  if (t.map)
    return pick_occupied_site(random, t);
  std::array<std::uint64_t, 3> index{};
  const unsigned faces = random.between(1, 7);
  for (unsigned a = 0; a < 3; ++a)
    index[a] = (faces >> a & 1) == 0 ? inner_index(random, t, a) : (random.coin() ? 0 : t.count(a));
  return site_at(t, index);
}

site pick_coarse_site(random_stream& random, const trial& t) {
  if (t.map)
    return pick_occupied_site(random, t);
  std::array<std::uint64_t, 3> index{};
  const int coarse = random.between(1, t.level);
  for (auto& i : index)
    i = coarse_index(random, t, random.coin() ? coarse : random.between(1, t.level));
  if (random.one_in(3)) {
    // drawn before the axis, on all of which octants are as many
    const std::uint64_t inner = t.grid ? 0 : inner_index(random, t, 0);
    const unsigned a = random.below(3);
    index[a] = t.grid ? inner_index(random, t, a) : inner;
  }
  return site_at(t, index);
}

void occupy(random_stream& random, trial& t, const site& s) {
  const unsigned wider = random.below(8) == 0 ? random.between(1, 63) : 0;
  for (unsigned a = 0; a < 3; ++a) {
    const std::uint64_t before = 1 + (wider >> a & 1);
    const std::uint64_t after = 1 + (wider >> (a + 3) & 1);
    t.base[a] = s.index[a] - std::min(before, s.index[a]);
    const std::uint64_t end = std::min(s.index[a] + after, t.count(a));
    t.extent[a] = static_cast<std::uint8_t>(end - t.base[a]);
  }
}

double random_double(random_stream& random, int lowest_exponent, int highest_exponent) {
  const std::uint64_t bits = random.bits();
  double significand = std::bit_cast<double>(0x3ff0000000000000u | (bits & 0xfffffffffffffu));
  if (const unsigned style = bits >> 52 & 7; style < 2)
    significand = keep_bits(significand, style == 0 ? random.between(1, 8) : random.between(1, 53));
  else if (style == 2) // a few ulps from a power of two
    significand = step_ulps(1, random.between(-2, 2));
  const double value = scaled(significand, random.between(lowest_exponent, highest_exponent));
  return bits >> 63 != 0 ? -value : value;
}

double random_offset(random_stream& random, const trial& t) {
  const double steps = static_cast<double>(random.bits(random.between(0, 53)));
  return random.sign() * steps * 0x1p-53 * t.root.size;
}

double exact_origin(double v, double offset) {
  const auto exact = [v](double o) {
    const double difference = v - o; // Knuth's two_sum, whose error term is exact
    const double part = difference - v;
    return (v - (difference - part)) - (o + part) == 0;
  };
  for (int bits = 53; bits > 0; bits -= 9) {
    const double coarse = keep_bits(offset, bits);
    const double o = v - coarse;
    if (exact(o))
      return o;
  }
  return v;
}

void scale(vec3& direction, int k) {
  vec3 result;
  for (unsigned a = 0; a < 3; ++a) {
    result[a] = scaled(direction[a], k);
    if (!std::isfinite(result[a]) || scaled(result[a], -k) != direction[a])
      return;
  }
  direction = result;
}

double small_integer(random_stream& random, int bits) {
  return random.sign() * static_cast<double>(random.bits(bits) + 1);
}

vec3 random_direction(random_stream& random) {
  vec3 d;
  const unsigned zeros = random.below(8) == 0 ? random.below(7) : 0; // never all three
  for (unsigned a = 0; a < 3; ++a)
    d[a] = (zeros >> a & 1) != 0 ? 0 : random_double(random, -2, 0);
  return d;
}

} // namespace graze::fuzz
