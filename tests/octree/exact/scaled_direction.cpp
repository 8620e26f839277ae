// Directions of any size: the same half-line as by hand, no octant missed, the bounds as tight.
#include <campaign/campaign.hpp>
#include <catch2/catch.hpp>
#include <cstring>
#include <graze/octree/exact.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <traversal/method_traversal.hpp>

using namespace graze;
using namespace graze::octree;

namespace {

/// The sound method by another direction than the scaled one: Take(direction).
template <rounding::Backend B, convention C, vec3 (*Take)(const vec3&)>
class by_direction : public sound<B, C> {
public:
  explicit by_direction(const ray& r)
      : sound<B, C>(ray_bounds<B>::prepare(r.origin(), Take(r.direction()))) {}
};
vec3 by_power(const vec3& d, int k) {
  return {std::ldexp(d[0], k), std::ldexp(d[1], k), std::ldexp(d[2], k)};
}
vec3 as_given(const vec3& d) { return d; }
/// The mutant: to [1, 2) whatever the other components lose.
vec3 careless(const vec3& d) {
  const int e = std::ilogb(std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])}));
  return by_power(d, -e);
}

template <rounding::Backend B, convention C> using as_it_is = by_direction<B, C, &as_given>;

double greatest_of(const vec3& d) {
  return std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
}

/// Any finite doubles, their exponents near each other or anywhere, some 0 or subnormal.
vec3 any_direction(fuzz::random_stream& random) {
  const bool together = random.coin();
  const int about = random.between(-1074, 1023);
  vec3 d{};
  for (double& x : d) {
    if (random.one_in(5))
      continue;
    const int e = together ? std::clamp(about + random.between(-30, 30), -1074, 1023)
                           : random.between(-1074, 1023);
    x = std::ldexp(1 + static_cast<double>(random.bits(52)) * 0x1p-52, e);
    x = random.coin() ? x : -x;
  }
  if (greatest_of(d) == 0)
    d[random.below(3)] = 0x1p-1074;
  return d;
}

std::vector<fuzz::octant_number> order_of(fuzz::traversal& t, const fuzz::trial& at) {
  fuzz::visited answer;
  t.visit(at, answer);
  std::vector<fuzz::octant_number> order;
  for (unsigned i = 0; i < answer.size(); ++i)
    order.push_back(answer[i]);
  return order;
}

/// A ray through a grid vertex of the unit cube, exactly or nearly, with the block around it and a
/// direction of small integers.
fuzz::trial through_vertex(fuzz::random_stream& random, int level) {
  fuzz::trial t;
  t.level = level;
  t.extent = {4, 4, 4};
  for (unsigned a = 0; a < 3; ++a) {
    t.base[a] = random.bits(level) % ((std::uint64_t{1} << level) - 3);
    do
      t.direction[a] = random.between(-999, 999);
    while (a == 0 && t.direction[a] == 0);
    if (a != 0 && random.one_in(8))
      t.direction[a] = 0;
    t.origin[a] = t.plane(static_cast<int>(a), 2) - t.direction[a] * 0x1p-11;
    if (random.coin())
      t.origin[a] = std::nextafter(t.origin[a], random.coin() ? 9 : -9);
  }
  return t;
}

fuzz::trial with_direction(fuzz::trial t, const vec3& d) {
  t.direction = d;
  return t;
}
vec3 times(const vec3& d, double x) { return {d[0] * x, d[1] * x, d[2] * x}; }

template <class B> void judge_sizes() {
  fuzz::method_traversal<sound<B, convention::closed>> closed("", fuzz::promise::touched);
  fuzz::method_traversal<sound<B, convention::owned>> owned("", fuzz::promise::owned);
  fuzz::method_traversal<exact<B, convention::closed>> exactly("", fuzz::promise::exactly_touched);
  fuzz::method_traversal<as_it_is<B, convention::closed>> unscaled("", fuzz::promise::touched);
  // 0x1p-1074 is 4.9e-324: components are 1 to 999 of it
  for (const double size : {0x1p-1074, 0x1p-1060, 0x1p-1040, 0x1p-996, 0x1p-600, 0x1p600, 0x1p996,
                            0x1p1013, 1e-300, 1e200, 1e300})
    for (const int level : {10, 30, 50}) {
      fuzz::random_stream random(91, static_cast<std::uint64_t>(level));
      fuzz::counts of_closed, of_owned, of_exact, by_hand, as_given;
      bool same = true;
      for (int i = 0; i < 300; ++i) {
        const fuzz::trial ordinary = through_vertex(random, level);
        const fuzz::trial t = with_direction(ordinary, times(ordinary.direction, size));
        REQUIRE(fuzz::judgeable(t));
        // the same half-line as an ordinary ray
        const fuzz::trial hand = with_direction(t, by_power(t.direction, -std::ilogb(size)));
        REQUIRE(fuzz::truth_of(hand).touched == fuzz::truth_of(t).touched);
        same = same && order_of(closed, t) == order_of(unscaled, hand);
        of_closed.add(fuzz::judge(t, closed));
        of_owned.add(fuzz::judge(t, owned));
        of_exact.add(fuzz::judge(t, exactly));
        by_hand.add(fuzz::judge(hand, unscaled));
        as_given.add(fuzz::judge(t, unscaled));
      }
      INFO(B::name << ", size " << size << ", level " << level);
      CHECK(of_closed.touched > 2000);
      CHECK(of_closed.misses == 0);
      CHECK(of_closed.findings == 0);
      CHECK(of_owned.misses == 0);
      CHECK(of_owned.findings == 0);
      CHECK(of_exact.findings == 0);
      CHECK(same);
      CHECK(of_closed.spurious == by_hand.spurious);
      CHECK(as_given.misses == 0); // without scaling: as sound, but it reports nearly the block
      if (size < 0x1p-1000 || size > 0x1p990)
        CHECK(as_given.spurious > 10 * of_closed.spurious + 1000);
    }
}

} // namespace

TEST_CASE("octree.scaled_direction: exact, and from 1 to 2 where that is exact", "[property]") {
  fuzz::random_stream random(71, 1);
  int ordinary = 0, scaled = 0, limited = 0, subnormal = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const vec3 d = any_direction(random);
    const scaling factors = scaling_of(d[0], d[1], d[2]);
    const vec3 s = scaled_direction(d);
    const double before = greatest_of(d), after = greatest_of(s);
    REQUIRE(std::ldexp(1.0, std::ilogb(factors.of_direction)) == factors.of_direction);
    REQUIRE(std::isnormal(factors.of_direction));
    REQUIRE(std::isnormal(factors.of_parameter));
    REQUIRE(std::ilogb(factors.of_direction) == -std::ilogb(factors.of_parameter));
    bool could_halve = true; // and remain exact
    for (unsigned a = 0; a < 3; ++a) {
      REQUIRE(std::isfinite(s[a]));
      // scaled back: a bit lost would not return
      REQUIRE(std::ldexp(s[a], -std::ilogb(factors.of_direction)) == d[a]);
      could_halve = could_halve && (s[a] == 0 || std::fabs(s[a]) >= 0x1p-1021);
    }
    if (before >= 0x1p-64 && before < 0x1p64) {
      REQUIRE(s == d);
      ++ordinary;
    } else if (before < 0x1p-1022) {
      REQUIRE(factors.of_direction == 0x1p1022);
      ++subnormal;
    } else if (after < 1 || after >= 2) {
      REQUIRE(after >= 2);
      const bool the_most = before >= 0x1p1023 && after < 4;
      REQUIRE((the_most || !could_halve));
      ++limited;
    } else {
      ++scaled;
    }
  }
  CHECK(ordinary > 10'000);
  CHECK(scaled > 100'000);
  CHECK(limited > 10'000);
  CHECK(subnormal > 1'000);
}

TEST_CASE("octree.scaled_direction: ordinary rays have the same bounds and visits, bit for bit",
          "[property]") {
  using B = rounding::upward;
  fuzz::method_traversal<sound<B, convention::closed>> closed("", fuzz::promise::touched);
  fuzz::method_traversal<sound<B, convention::owned>> owned("", fuzz::promise::owned);
  fuzz::method_traversal<as_it_is<B, convention::closed>> closed_as_given("",
                                                                          fuzz::promise::touched);
  fuzz::method_traversal<as_it_is<B, convention::owned>> owned_as_given("", fuzz::promise::owned);
  int rays = 0;
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < 3000; ++i) {
      const int level = 1 + static_cast<int>(i % 50);
      const fuzz::trial t = fuzz::make_trial(g, 17, i, level);
      if (greatest_of(t.direction) < 0x1p-64 || greatest_of(t.direction) >= 0x1p64)
        continue;
      ++rays;
      const ray r = *ray::make(t.origin, t.direction);
      const B::scope scope;
      const sound<B, convention::owned> method(r);
      const as_it_is<B, convention::owned> before(r);
      sound<B, convention::owned>::state at{}, at_before{};
      REQUIRE(method.enter(t.root, at) == before.enter(t.root, at_before));
      REQUIRE(std::memcmp(&at, &at_before, sizeof at) == 0);
      REQUIRE(order_of(closed, t) == order_of(closed_as_given, t));
      REQUIRE(order_of(owned, t) == order_of(owned_as_given, t));
    }
  CHECK(rays > 40'000);
}

TEST_CASE("octree.scaled_direction: visits do not depend on a power of two in the direction",
          "[property]") {
  fuzz::method_traversal<sound<rounding::upward, convention::owned>> owned("",
                                                                           fuzz::promise::owned);
  fuzz::random_stream random(23, 5);
  for (int i = 0; i < 20'000; ++i) {
    const fuzz::trial t = through_vertex(random, 2 + i % 49);
    const fuzz::trial other = with_direction(t, by_power(t.direction, random.between(-1074, 1013)));
    REQUIRE(order_of(owned, other) == order_of(owned, t));
  }
}

TEST_CASE("octree.scaled_direction: tiny and huge directions, no miss and no more spurious than by "
          "hand (upward)",
          "[mpfr][hardcase]") {
  judge_sizes<rounding::upward>();
}
TEST_CASE("octree.scaled_direction: tiny and huge directions, no miss and no more spurious than by "
          "hand (nearest)",
          "[mpfr][hardcase]") {
  judge_sizes<rounding::nearest>();
}
TEST_CASE("octree.scaled_direction: tiny and huge directions, no miss and no more spurious than by "
          "hand (split)",
          "[mpfr][hardcase]") {
  judge_sizes<rounding::split>();
}

TEST_CASE("octree.scaled_direction: components far apart, no miss and no more spurious than as "
          "given",
          "[mpfr][hardcase]") {
  using B = rounding::upward;
  fuzz::method_traversal<sound<B, convention::closed>> closed("", fuzz::promise::touched);
  fuzz::method_traversal<exact<B, convention::closed>> exactly("", fuzz::promise::exactly_touched);
  fuzz::method_traversal<as_it_is<B, convention::closed>> unscaled("", fuzz::promise::touched);
  const vec3 directions[] = {{1, 1e-300, 0},         {0, 1, 4.9e-324},     {1, 4.9e-324, 1e-300},
                             {1e300, 1e-300, 0},     {1e300, 4.9e-324, 1}, {1e-300, 4.9e-324, 0},
                             {1e300, -1e300, 1e-20}, {0, 1e-300, 1e-320},  {1e308, 1, -1e-308}};
  for (const int level : {10, 30, 50}) {
    fuzz::random_stream random(37, static_cast<std::uint64_t>(level));
    fuzz::counts scaled, of_exact, as_given;
    for (int i = 0; i < 900; ++i) {
      fuzz::trial t = through_vertex(random, level);
      t.direction = directions[i % 9];
      for (unsigned a = 0; a < 3; ++a) { // through the vertex, or beside it by an ulp
        const double along = std::fabs(t.direction[a]) == greatest_of(t.direction) ? 0x1p-11 : 0;
        t.origin[a] = t.plane(static_cast<int>(a), 2) - std::copysign(along, t.direction[a]);
        if (random.one_in(3))
          t.origin[a] = std::nextafter(t.origin[a], random.coin() ? 9 : -9);
      }
      REQUIRE(fuzz::judgeable(t));
      scaled.add(fuzz::judge(t, closed));
      of_exact.add(fuzz::judge(t, exactly));
      as_given.add(fuzz::judge(t, unscaled));
    }
    INFO("level " << level);
    CHECK(scaled.touched > 5000);
    CHECK(of_exact.findings == 0);
    CHECK(scaled.misses == 0);
    CHECK(scaled.findings == 0);
    CHECK(scaled.spurious <= as_given.spurious);
  }
}

TEST_CASE("octree.scaled_direction: a scaling that loses bits of a component misses octants",
          "[mpfr][hardcase]") {
  // the ray rises to y = 0 exactly where it reaches x = 0 (or, with 3, a little later)
  struct tiny_ray {
    vec3 origin, direction;
  };
  const tiny_ray rays[] = {
      {{-0x1p1000, -0x1.4ccccccccccccp-70, 0}, {0x1p1000, 0x1.4ccccccccccccp-70, 0}},
      {{-0x1p1000, -0x1.8p-1073, 0x1p900}, {0x1p1000, 0x1.8p-1073, 0}},
      {{-0x1p1000, 0x1.4cccccccccccfp-60, 1}, {0x1p1000, -0x1.4cccccccccccfp-60, 0}}};
  const cube root{{-0x1p1000, -0x1p1000, -0x1p1000}, 0x1p1001};
  using B = rounding::upward;
  const auto missed = [&](const auto& method, const tiny_ray& r) {
    auto at = typename std::decay_t<decltype(method)>::state{};
    branches<decltype(at)> out;
    unsigned passed = 0;
    if (method.enter(root, at)) {
      method.split(root, at, out);
      passed = out.mask();
    }
    int count = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const cube c = root.child(i);
      const bool touched =
          oracle::touches(r.origin, r.direction, c.lo, {c.hi(0), c.hi(1), c.hi(2)});
      count += touched && (passed >> i & 1) == 0;
    }
    return count;
  };
  const B::scope scope;
  int by_mutant = 0;
  for (const tiny_ray& r : rays) {
    const ray a_ray = *ray::make(r.origin, r.direction);
    CHECK(missed(sound<B, convention::closed>(a_ray), r) == 0);
    by_mutant += missed(by_direction<B, convention::closed, &careless>(a_ray), r);
  }
  CHECK(by_mutant > 0);
}
