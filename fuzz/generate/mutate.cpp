#include <algorithm>
#include <generate/mutate.hpp>
#include <generate/site.hpp>
#include <trial/number.hpp>
#include <utility>

namespace graze::fuzz {

namespace {

double& number_of_ray(random_stream& random, trial& t) {
  const unsigned i = random.below(6);
  return i < 3 ? t.origin[i] : t.direction[i - 3];
}

double plane_of_block(random_stream& random, const trial& t, unsigned axis) {
  return t.plane(static_cast<int>(axis), random.below(t.extent[axis] + 1u));
}

/// Most often one ulp, at times up to 2^30 of them, log-uniform.
void step(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  const int ulps = random.coin() ? 1 : static_cast<int>(random.bits(random.between(1, 30)));
  x = step_ulps(x, random.coin() ? ulps : -ulps);
}

void snap(random_stream& random, trial& t) {
  const unsigned a = random.below(3);
  t.origin[a] = plane_of_block(random, t, a);
}

/// At a vertex of the block, or at a point of one of its edges.
void aim(random_stream& random, trial& t) {
  vec3 target;
  for (unsigned a = 0; a < 3; ++a)
    target[a] = plane_of_block(random, t, a);
  if (random.coin()) {
    const unsigned along = random.below(3);
    target[along] += std::ldexp(static_cast<double>(random.bits(20)), -20) * t.size();
  }
  const bool exactly = random.one_in(4);
  for (unsigned a = 0; a < 3; ++a) {
    if (exactly)
      t.origin[a] = exact_origin(target[a], target[a] - t.origin[a]);
    t.direction[a] = target[a] - t.origin[a];
  }
}

void change_level(random_stream& random, trial& t) {
  if (random.coin()) {
    --t.level;
    for (auto& b : t.base)
      b >>= 1;
  } else {
    ++t.level;
    for (auto& b : t.base)
      b = 2 * b + random.below(2);
  }
}

void change_sign(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  x = -x;
}

void change_exponent(random_stream& random, trial& t) {
  const int reach = random.one_in(8) ? 1000 : 8;
  const int exponent = random.between(-reach, reach);
  if (random.coin()) {
    scale(t.direction, exponent);
  } else {
    double& x = number_of_ray(random, t);
    x = std::ldexp(x, exponent);
  }
}

void make_zero(random_stream& random, trial& t) {
  t.direction[random.below(3)] = random.coin() ? 0.0 : -0.0;
}

void drop_bits(random_stream& random, trial& t) {
  double& x = number_of_ray(random, t);
  x = keep_bits(x, random.between(1, 52));
}

void change_block(random_stream& random, trial& t) {
  const unsigned a = random.below(3);
  if (random.coin())
    t.base[a] += random.coin() ? std::uint64_t{1} : ~std::uint64_t{0};
  else
    t.extent[a] = static_cast<std::uint8_t>(random.between(1, max_extent));
}

void exchange_axes(random_stream& random, trial& t) {
  const unsigned a = random.below(3);
  const unsigned b = (a + 1) % 3;
  std::swap(t.origin[a], t.origin[b]);
  std::swap(t.direction[a], t.direction[b]);
  std::swap(t.root.lo[a], t.root.lo[b]);
  std::swap(t.base[a], t.base[b]);
  std::swap(t.extent[a], t.extent[b]);
}

void scale_scene(random_stream& random, trial& t) {
  const int exponent = random.between(-4, 4);
  for (unsigned a = 0; a < 3; ++a) {
    t.origin[a] = std::ldexp(t.origin[a], exponent);
    t.root.lo[a] = std::ldexp(t.root.lo[a], exponent);
  }
  t.root.size = std::ldexp(t.root.size, exponent);
}

/// A root whose corners are small integers.
void change_root(random_stream& random, trial& t) {
  for (double& x : t.root.lo)
    x = random.between(-4, 4);
  t.root.size = random.between(1, 8);
}

void move(random_stream& random, trial& t) {
  using change = void (*)(random_stream&, trial&);
  static constexpr std::array<change, 20> moves{step,         step,
                                                step,         step,
                                                step,         step,
                                                aim,          aim,
                                                aim,          snap,
                                                snap,         make_zero,
                                                change_sign,  change_exponent,
                                                change_block, change_level,
                                                drop_bits,    exchange_axes,
                                                scale_scene,  change_root};
  moves[random.below(moves.size())](random, t);
}

} // namespace

trial mutated(random_stream& random, const trial& t) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    trial next = t;
    move(random, next);
    if (next.level >= 0 &&
        next.level <= octree::max_level) // a block may leave the root: bring it back
      for (unsigned a = 0; a < 3; ++a) {
        const std::uint64_t count = std::uint64_t{1} << next.level;
        next.base[a] = std::min(next.base[a], count - 1);
        next.extent[a] = static_cast<std::uint8_t>(
            std::min<std::uint64_t>(next.extent[a], count - next.base[a]));
      }
    if (next != t && judgeable(next))
      return next;
  }
  return t;
}

} // namespace graze::fuzz
