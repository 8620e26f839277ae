#include <chrono>
#include <cstdlib>
#include <generate/tame.hpp>
#include <shrink/candidates.hpp>
#include <shrink/scenes.hpp>
#include <shrink/shrink.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

/// The numbers of the ray, 0..2 the origin, 3..5 the direction.
double& number(trial& t, unsigned i) { return i < 3 ? t.origin[i] : t.direction[i - 3]; }
double number(const trial& t, unsigned i) { return i < 3 ? t.origin[i] : t.direction[i - 3]; }

/// The ancestors of the block's first octant, which the ray may miss already.
void offer_ancestors(const trial& t, candidates& out) {
  if (t.extent != std::array<std::uint8_t, 3>{1, 1, 1})
    return;
  for (int level = 0; level < t.level; ++level) {
    trial up = t;
    up.level = level;
    for (auto& b : up.base)
      b >>= t.level - level;
    out.offer(up);
  }
}

/// The same block in a descent that starts `levels` deeper: the part of the scene in the root's
/// descendant that holds the block, blown up to the root's size.
void offer_zoom(const trial& t, candidates& out) {
  for (int levels = t.level - 1; levels >= 1; --levels) {
    trial in = t;
    in.level = t.level - levels;
    bool held = true;
    for (unsigned a = 0; a < 3; ++a) {
      const std::uint64_t corner = t.base[a] >> in.level; // of the descendant, in its own sizes
      held = held && (t.base[a] + t.extent[a] - 1u) >> in.level == corner;
      in.base[a] = t.base[a] - (corner << in.level);
      const double lo =
          t.root.lo[a] + static_cast<double>(corner) * std::ldexp(t.root.size, -levels);
      in.origin[a] = t.root.lo[a] + std::ldexp(t.origin[a] - lo, levels);
    }
    if (held)
      out.offer(in);
  }
  // the block moved towards the root's corner, and the ray with it
  for (unsigned a = 0; a < 3; ++a)
    for (int high = t.level; high >= 0; --high) {
      trial moved = t;
      moved.base[a] &= (std::uint64_t{1} << high) - 1;
      if (moved.base[a] == t.base[a])
        continue;
      moved.origin[a] -= static_cast<double>(t.base[a] - moved.base[a]) * t.size();
      out.offer(moved);
    }
  for (unsigned a = 0; a < 3; ++a) // and the block alone, low bits first
    for (int low = t.level; low >= 1; --low) {
      trial moved = t;
      moved.base[a] = moved.base[a] >> low << low;
      if (moved.base[a] != t.base[a])
        out.offer(moved);
    }
}

/// x with n significant bits: towards 0, and away from it.
std::array<double, 2> rounded(double x, int n) {
  const double down = keep_bits(x, n);
  const double up = down + (down - keep_bits(step_ulps(down, down > 0 ? -1 : 1), n));
  return {down, std::isfinite(up) ? up : down};
}

constexpr std::array<int, 16> widths{1, 2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 25, 31, 38, 45, 51};

void offer_fewer_bits(const trial& t, candidates& out) {
  // all six at once, by the same width
  for (const int n : widths) {
    trial all = t;
    for (unsigned i = 0; i < 6; ++i)
      number(all, i) = keep_bits(number(t, i), n);
    out.offer(all);
  }
  // the origin rounded and the ray led again through a corner that it passes near
  for (const int n : widths)
    for (unsigned corner = 0; corner < 8; ++corner) {
      trial again = t;
      for (unsigned a = 0; a < 3; ++a) {
        again.origin[a] = keep_bits(t.origin[a], n);
        again.direction[a] =
            t.plane(static_cast<int>(a), (corner >> a & 1) != 0 ? t.extent[a] : 0u) -
            again.origin[a];
      }
      out.offer(again);
    }
  for (unsigned i = 0; i < 6; ++i) {
    const double x = number(t, i);
    if (x == 0)
      continue;
    trial candidate = t;
    const auto offer_number = [&](double y) {
      number(candidate, i) = y;
      out.offer(candidate);
    };
    offer_number(0);
    offer_number(std::copysign(1.0, x));
    offer_number(std::fabs(x));
    const int bits = significant_bits(x);
    for (int n = 1; n < bits; ++n)
      for (const double y : rounded(x, n))
        offer_number(y);
    int exponent = 0;
    const double significand = std::frexp(x, &exponent);
    offer_number(significand);
    for (int closer = exponent / 2; closer != 0; closer /= 2)
      offer_number(std::ldexp(x, -closer));
    offer_number(std::ldexp(x, exponent > 0 ? -1 : 1));
  }
  // origin and direction of an axis together
  for (unsigned a = 0; a < 3; ++a) {
    trial both = t;
    both.origin[a] = t.plane(static_cast<int>(a), 0);
    both.direction[a] = 0;
    out.offer(both);
    both.origin[a] = t.plane(static_cast<int>(a), t.extent[a]);
    out.offer(both);
    for (const int n : widths)
      for (unsigned far = 0; far < 2; ++far) {
        both.origin[a] = keep_bits(t.origin[a], n);
        both.direction[a] =
            t.plane(static_cast<int>(a), far != 0 ? t.extent[a] : 0u) - both.origin[a];
        out.offer(both);
      }
  }
}

/// The exponent of the lowest bit that is set in any of the numbers; 0 if all are 0.
template <class Numbers> int lowest_bit(const Numbers& numbers) {
  int lowest = INT32_MAX;
  for (const double x : numbers)
    if (x != 0)
      lowest = std::min(lowest, octree::detail::lowest_bit_exponent(x));
  return lowest == INT32_MAX ? 0 : lowest;
}

/// The direction's common power of two taken out, its components made integers.
void offer_scale(const trial& t, candidates& out) {
  const auto offer = [&](int power) {
    trial scaled = t;
    for (unsigned a = 0; a < 3; ++a)
      scaled.direction[a] = std::ldexp(t.direction[a], -power);
    out.offer(scaled);
  };
  offer(lowest_bit(t.direction));
  int largest = INT32_MIN;
  for (const double d : t.direction)
    if (d != 0)
      largest = std::max(largest, std::ilogb(d));
  for (int power = largest; power != 0; power /= 2)
    offer(power);
}

/// The whole scene times a power of two: octants of size 1, or all coordinates integers.
void offer_scene_scale(const trial& t, candidates& out) {
  const std::array<double, 7> coordinates{t.origin[0],  t.origin[1],  t.origin[2], t.root.lo[0],
                                          t.root.lo[1], t.root.lo[2], t.size()};
  for (const int power :
       {-std::ilogb(t.size()), -lowest_bit(coordinates), -std::ilogb(t.root.size), 1, -1}) {
    trial scaled = t;
    for (unsigned a = 0; a < 3; ++a) {
      scaled.origin[a] = std::ldexp(t.origin[a], power);
      scaled.root.lo[a] = std::ldexp(t.root.lo[a], power);
    }
    scaled.root.size = std::ldexp(t.root.size, power);
    out.offer(scaled);
  }
}

/// The scene moved so that a point of it is 0: the root's corner, the octant's, the ray's origin.
void offer_moved(const trial& t, candidates& out) {
  const std::array<vec3, 3> points{t.root.lo, vec3{t.plane(0, 0), t.plane(1, 0), t.plane(2, 0)},
                                   t.origin};
  for (const vec3& zero : points)
    for (unsigned axes = 7; axes >= 1; --axes) {
      trial moved = t;
      for (unsigned a = 0; a < 3; ++a)
        if ((axes >> a & 1) != 0) {
          moved.origin[a] -= zero[a];
          moved.root.lo[a] -= zero[a];
        }
      out.offer(moved);
    }
  trial at_zero = t; // the root alone
  at_zero.root.lo = {0, 0, 0};
  out.offer(at_zero);
}

/// Directions of small integers, as they are and led through a corner of the block again from a few
/// integer times before it.
void offer_small_integers(const trial& t, candidates& out) {
  double largest = 0;
  for (const double d : t.direction)
    largest = std::max(largest, std::fabs(d));
  if (largest > 0x1p1000 || largest < 0x1p-1000)
    return;
  for (const double most : {1.0, 2.0, 3.0, 5.0, 7.0, 11.0, 15.0}) {
    trial small = t;
    for (unsigned a = 0; a < 3; ++a)
      small.direction[a] = std::round(t.direction[a] / largest * most) + 0.0; // no -0
    out.offer(small);
    for (unsigned corner = 0; corner < 8; ++corner)
      for (const double times : {0.0, 1.0, 2.0, 3.0}) {
        trial again = small;
        for (unsigned a = 0; a < 3; ++a)
          again.origin[a] =
              t.plane(static_cast<int>(a), (corner >> a & 1) != 0 ? t.extent[a] : 0u) -
              times * t.size() * small.direction[a];
        out.offer(again);
      }
  }
}

} // namespace

complexity complexity_of(const trial& t) {
  if (t.end || t.cells() != cell_kind::cube)
    return complexity_of_scene(t);
  complexity c{t.extent[0] * t.extent[1] * t.extent[2], t.level, 0, 0};
  constexpr int not_finite = 1 << 20; // a candidate that is not judgeable()
  const auto digits = [&c](double x) {
    if (x != 0 && std::isfinite(x))
      c.places +=
          std::max(0, std::ilogb(x) + 1) + 3 * std::max(0, -octree::detail::lowest_bit_exponent(x));
  };
  const auto bits = [&c](double x) {
    if (!std::isfinite(x)) {
      c.bits += not_finite;
      return;
    }
    c.bits += 2 * significant_bits(x) + (std::signbit(x) ? 1 : 0);
    if (x != 0) // nobody's scene has 1e-300 in it: a number of 53 bits is the better witness
      c.bits += std::max(0, std::abs(std::ilogb(x)) - 64) / 2;
  };
  for (const std::uint64_t b : t.base)
    if (b != 0)
      c.bits += 64 - std::countl_zero(b) - std::countr_zero(b);
  for (unsigned i = 0; i < 6; ++i) {
    bits(number(t, i));
    digits(number(t, i));
  }
  for (unsigned a = 0; a < 3; ++a) {
    bits(t.root.lo[a]); // twice: rather a ray from anywhere than a root
    bits(t.root.lo[a]);
    digits(t.root.lo[a]);
    digits(t.plane(static_cast<int>(a), 0));
  }
  digits(t.size());
  if (t.size() > 0 && std::isfinite(t.size())) { // integers, but not octants of 2^53
    const int exponent = std::ilogb(t.size());
    c.places += exponent * exponent;
  }
  return c;
}

std::vector<trial> simpler(const trial& t) {
  if (t.end || t.cells() != cell_kind::cube)
    return simpler_scenes(t);
  candidates out(t);
  offer_smaller_block(t, out);
  offer_ancestors(t, out);
  offer_zoom(t, out);
  offer_small_integers(t, out);
  offer_fewer_bits(t, out);
  offer_scale(t, out);
  offer_scene_scale(t, out);
  offer_moved(t, out);
  return out.take();
}

trial shrink(const trial& failing, const std::function<bool(const trial&)>& still_fails,
             unsigned evaluations) {
  trial best = failing;
  for (bool again = true; again;) {
    again = false;
    for (const trial& t : simpler(best)) {
      if (evaluations-- == 0)
        return best;
      if (still_fails(t)) {
        best = t;
        again = true;
        break;
      }
    }
  }
  return best;
}

trial shrink(const trial& failing, traversal& under_test, finding kind, unsigned evaluations,
             shrink_deadline end, const std::atomic<bool>* stop, bool keeps_grid) {
  const bool tame = is_tame(failing); // an owner takes it, and is to take what it becomes
  return shrink(
      failing,
      [&](const trial& t) {
        return (!keeps_grid || t.grid == failing.grid || *t.grid == *failing.grid) &&
               (!tame || is_tame(t)) && std::chrono::steady_clock::now() < end &&
               (stop == nullptr || !stop->load()) &&
               (judge(t, under_test).findings & bit(kind)) != 0;
      },
      evaluations);
}

} // namespace graze::fuzz
