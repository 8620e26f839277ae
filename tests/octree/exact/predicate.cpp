// The exact predicate against exact geometry, in all rounding modes.
#include "all_modes.hpp"
#include <catch2/catch.hpp>
#include <cfloat>
#include <generate/generators.hpp>
#include <graze/octree/exact_touch.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/oracle/rational.hpp>
#include <judge/judge.hpp>
#include <trial/number.hpp>

using namespace graze;
using namespace graze::octree;
using graze::fuzz::random_stream;
using test::in_all_modes;

namespace {

struct answers {
  fuzz::octant_set touched = 0, owned = 0;
};

/// What the predicate says of every octant of a trial's block. `Predicate` is exact_touch, or what
/// a test puts in its place.
template <class Predicate> answers ask(const fuzz::trial& t) {
  const ray r = *ray::make(t.origin, t.direction);
  answers all;
  const auto collect = [&](auto verdict) {
    return in_all_modes([&] {
      const Predicate predicate(r);
      fuzz::octant_set set = 0;
      for (fuzz::octant_set left = t.all(); left != 0; left &= left - 1) {
        const auto v = static_cast<fuzz::octant_number>(std::countr_zero(left));
        set |= fuzz::octant_set{verdict(predicate, v)} << v;
      }
      return set;
    });
  };
  all.touched =
      collect([&](const Predicate& p, fuzz::octant_number v) { return p.touches(t.octant(v)); });
  all.owned = collect([&](const Predicate& p, fuzz::octant_number v) {
    const unsigned last = t.at_far_face();
    const std::array<unsigned, 3> k{v & 3u, unsigned{v} >> 2 & 3u, unsigned{v} >> 4};
    unsigned closed_far = 0;
    for (unsigned a = 0; a < 3; ++a)
      closed_far |= (last >> a & 1) != 0 && k[a] + 1 == t.extent[a] ? 1u << a : 0;
    return p.owns(t.octant(v), closed_far);
  });
  return all;
}

struct tally {
  std::uint64_t octants = 0, touched = 0, owned = 0, wrong = 0;
};

template <class Predicate> tally judge_generators(std::uint64_t rays_each) {
  tally sum;
  for (const fuzz::generator& g : fuzz::generators())
    for (const int level : {1, 10, 30, 50, 53})
      for (std::uint64_t k = 0; k < rays_each; ++k) {
        const fuzz::trial t = fuzz::make_trial(g, 41, k, level);
        const fuzz::truth is = fuzz::truth_of(t);
        const answers answer = ask<Predicate>(t);
        const auto size = [](fuzz::octant_set s) {
          return static_cast<unsigned>(std::popcount(s));
        };
        sum.octants += size(t.all());
        sum.touched += size(is.touched);
        sum.owned += size(is.owned);
        sum.wrong += size(is.touched ^ answer.touched) + size(is.owned ^ answer.owned);
      }
  return sum;
}

/// A predicate with one rounding too many: the comparison in plain doubles.
class rounded_touch {
public:
  explicit rounded_touch(const ray& r) : ray_(r) {}
  [[nodiscard]] bool touches(const cube& c) const { return meets(c, 7); }
  [[nodiscard]] bool owns(const cube& c, unsigned closed_far) const { return meets(c, closed_far); }

private:
  [[nodiscard]] bool meets(const cube& c, unsigned closed_far) const {
    double enter = 0, leave = HUGE_VAL;
    for (unsigned a = 0; a < 3; ++a) {
      const double o = ray_.origin()[a], d = ray_.direction()[a], lo = c.lo[a],
                   hi = c.hi(static_cast<int>(a));
      if (d == 0) {
        if (o < lo || ((closed_far >> a & 1) != 0 ? hi < o : hi <= o))
          return false;
        continue;
      }
      enter = std::max(enter, ((d > 0 ? lo : hi) - o) / d);
      leave = std::min(leave, ((d > 0 ? hi : lo) - o) / d);
    }
    return enter <= leave;
  }
  ray ray_;
};

/// Closed and half-open faces confused: the shape of mistake that ties alone can show.
class open_is_closed : public exact_touch {
public:
  using exact_touch::exact_touch;
  [[nodiscard]] bool owns(const cube& c, unsigned) const { return touches(c); }
};

// Values for components: zeros, subnormals, the largest, and neighbours of what boxes have.
constexpr std::array<double, 30> hard_numbers{0.0,
                                              0x1p-1074,
                                              0x1.8p-1073,
                                              0x1.fffffffffffffp-1022,
                                              0x1p-1022,
                                              0x1.0000000000001p-1022,
                                              0x1p-1000,
                                              0x1.5555555555555p-1000,
                                              0x1p-540,
                                              0x1.8p-540,
                                              0x1p-422,
                                              0x1p-400,
                                              0x1.fffffffffffffp-401,
                                              0x1p-53,
                                              0x1p-1,
                                              0x1.fffffffffffffp-2,
                                              1,
                                              0x1.0000000000001p+0,
                                              0x1.fffffffffffffp-1,
                                              3,
                                              0x1.5555555555555p+0,
                                              0x1p53,
                                              0x1p400,
                                              0x1.0000000000001p400,
                                              0x1p600,
                                              0x1.8p600,
                                              0x1p1000,
                                              0x1.1ccf385ebc8a0p+1023,
                                              0x1p1023,
                                              DBL_MAX};

double hard_number(random_stream& random) {
  return random.sign() * hard_numbers[random.below(hard_numbers.size())];
}

/// Boxes of ordinary, of the smallest and of the largest size.
constexpr std::array<cube, 12> hard_boxes{
    {{{0, 0, 0}, 1},
     {{-1, -1, -1}, 2},
     {{-1, 0, -1}, 1},
     {{0.5, 0, 0.75}, 0.25},
     {{0, 0, 0}, 0x1p-50},
     {{0x1.1fd52bb47c850p-2, 0x1.165b57bbd0b40p-4, 0x1.5a1181eb0c588p-1}, 0x1p-50},
     {{0, 0, 0}, 0x1p-1074},
     {{-0x1p-1074, 0x1p-1074, 0}, 0x1p-1074},
     {{-0x1p-1000, 0, -0x1p-1000}, 0x1p-1000},
     {{-0x1p1022, -0x1p1022, 0}, 0x1p1022},
     {{0, 0, 0}, 0x1p1023},
     {{-0x1p1023, 0, 0x1p1022}, 0x1p1022}}};

vec3 upper(const cube& c) { return {c.hi(0), c.hi(1), c.hi(2)}; }

/// A ray with hard components that often goes exactly through a corner of the box, or an ulp
/// beside. Where a corner's coordinate is 0, o = -d 2^k does so whatever the exponents.
void hard_ray(random_stream& random, const cube& c, vec3& o, vec3& d) {
  const int k = random.between(-2, 2);
  for (unsigned a = 0; a < 3; ++a) {
    const double lo = c.lo[a], hi = c.hi(static_cast<int>(a));
    d[a] = random.one_in(6) ? 0.0 : hard_number(random);
    const double plane = random.coin() ? lo : hi;
    switch (random.below(6)) {
    case 0:
      o[a] = plane;
      break;
    case 1:
      o[a] = hard_number(random);
      break;
    case 2:
      o[a] = lo / 2 + hi / 2;
      break;
    default:
      o[a] = plane - std::ldexp(d[a], k);
      break;
    }
    if (random.one_in(6))
      o[a] = fuzz::step_ulps(o[a], random.between(-1, 1));
    if (random.one_in(8))
      d[a] = fuzz::step_ulps(d[a], random.between(-1, 1));
    if (!std::isfinite(o[a]))
      o[a] = hard_number(random);
  }
  if (d == vec3{})
    d[random.below(3)] = 0x1p-1074;
}

template <class Predicate> tally judge_hard(std::uint64_t rays, std::uint64_t rational_every) {
  random_stream random(2026, 4);
  tally sum;
  for (std::uint64_t i = 0; i < rays; ++i) {
    const cube& c = hard_boxes[random.below(hard_boxes.size())];
    vec3 o, d;
    hard_ray(random, c, o, d);
    const ray r = *ray::make(o, d);
    const auto closed_far = static_cast<unsigned>(random.below(8));
    const bool touched = oracle::touches(o, d, c.lo, upper(c));
    const bool owned = oracle::owns(o, d, c.lo, upper(c), closed_far);
    if (rational_every != 0 && i % rational_every == 0) {
      CHECK(oracle::rational::touches(o, d, c.lo, upper(c)) == touched);
      CHECK(oracle::rational::owns(o, d, c.lo, upper(c), closed_far) == owned);
    }
    const int is = touched + 2 * owned;
    const int answer = in_all_modes([&] {
      const Predicate p(r);
      return p.touches(c) + 2 * p.owns(c, closed_far);
    });
    ++sum.octants;
    sum.touched += touched;
    sum.owned += owned;
    sum.wrong += is != answer;
    if (is != answer && sum.wrong == 1)
      UNSCOPED_INFO(std::hexfloat << "o " << o[0] << ' ' << o[1] << ' ' << o[2] << " d " << d[0]
                                  << ' ' << d[1] << ' ' << d[2] << " lo " << c.lo[0] << ' '
                                  << c.lo[1] << ' ' << c.lo[2] << " size " << c.size << " far "
                                  << closed_far << " is " << is << " said " << answer);
  }
  return sum;
}

} // namespace

TEST_CASE("octree.exact_touch: equals exact geometry on the adversarial generators' rays",
          "[mpfr][hardcase]") {
  const tally sum = judge_generators<exact_touch>(3000);
  CHECK(sum.octants > 2'000'000);
  CHECK(sum.touched > 500'000);
  CHECK(sum.owned > 100'000);
  CHECK(sum.wrong == 0);
}

TEST_CASE("octree.exact_touch: equals exact geometry on subnormal, huge and far operands",
          "[mpfr][hardcase]") {
  const tally sum = judge_hard<exact_touch>(1'000'000, 50);
  CHECK(sum.touched > 100'000);
  CHECK(sum.owned > 10'000);
  CHECK(sum.wrong == 0);
}

TEST_CASE("octree.exact_touch: the judge finds predicates that round or confuse faces", "[unit]") {
  CHECK(judge_generators<rounded_touch>(50).wrong > 100);
  CHECK(judge_hard<rounded_touch>(10'000, 0).wrong > 100);
  CHECK(judge_generators<open_is_closed>(50).wrong > 100);
  CHECK(judge_hard<open_is_closed>(10'000, 0).wrong > 100);
}

TEST_CASE("octree.exact_touch: a ray through a vertex, and one ulp beside it", "[unit]") {
  const cube c{{0x1.8p-1, 0x1.8p-1, 0x1.8p-1}, 0x1p-50};
  // x = 1/4 + t/2, y = 5/4 - t/2, z = 1/2 + t/4: at t = 1 the ray is at the cube's lower corner
  const auto through = [](double y) {
    return *ray::make({0x1p-2, y, 0x1p-1}, {0x1p-1, -0x1p-1, 0x1p-2});
  };
  CHECK(touches(through(1.25), c));
  CHECK(owns(through(1.25), c));
  CHECK_FALSE(touches(through(std::nextafter(1.25, 0)), c));
  CHECK(touches(through(std::nextafter(1.25, 2)), c));
  const cube below{{0x1.8p-1 - 0x1p-50, 0x1.8p-1 - 0x1p-50, 0x1.8p-1 - 0x1p-50}, 0x1p-50};
  CHECK(touches(through(1.25), below));
  CHECK_FALSE(owns(through(1.25), below));
  CHECK(owns(through(1.25), below, 7)); // the same box at the root's far faces
}

TEST_CASE("octree.determinant_sign: terms whose exponents lie thousands apart", "[hardcase]") {
  const double tiny = 0x1p-1074, top = 0x1p1023;
  // (top - -tiny) tiny against (top - 0) tiny: they differ by tiny^2
  CHECK(determinant_sign({top, -tiny}, tiny, {top, 0}, tiny) == 1);
  CHECK(determinant_sign({top, 0}, tiny, {top, -tiny}, tiny) == -1);
  CHECK(determinant_sign({top, tiny}, tiny, {top, tiny}, tiny) == 0);
  CHECK(determinant_sign({top, -top}, top, {top, -top}, top) == 0);
  CHECK(determinant_sign({DBL_MAX, -DBL_MAX}, DBL_MAX, {tiny, 0}, tiny) == 1);
  CHECK(determinant_sign({1, 1}, 1, {tiny, 0}, tiny) == -1);
  CHECK(determinant_sign({1, 1}, 1, {5, 5}, tiny) == 0);
  CHECK(determinant_sign({0, 0}, 1, {0, 0}, 1) == 0);
}

TEST_CASE("octree.determinant_sign: equals rationals at every gap of exponents",
          "[mpfr][hardcase]") {
  random_stream random(2026, 5);
  const auto number = [&](int exponent) {
    const std::uint64_t kind = random.below(4);
    double m = kind == 0 ? 1 : 1 + static_cast<double>(random.bits(52)) * 0x1p-52;
    if (kind == 1)
      m = 0x1.fffffffffffffp+0;
    return std::ldexp(m, exponent);
  };
  std::uint64_t wrong = 0, ties = 0;
  for (int i = 0; i < 300'000; ++i) {
    const int base = random.between(-300, 300);
    exact_distance x{number(base), random.sign() * number(base + random.between(-70, 70))};
    if (random.one_in(8))
      x.less = 0;
    if (x.greater < x.less)
      std::swap(x.greater, x.less);
    const double x_factor = number(random.between(-200, 200));
    // y's product is x's, its factors rescaled, perhaps an ulp off; or any product of about its
    // size
    const int k = random.between(-100, 100);
    exact_distance y{std::ldexp(x.greater, k), std::ldexp(x.less, k)};
    double y_factor = std::ldexp(x_factor, -k);
    if (random.coin()) {
      const int other = base + k + random.between(-130, 130);
      y = {number(other), -number(other + random.between(-70, 70))};
    }
    if (random.coin())
      y_factor = fuzz::step_ulps(y_factor, random.between(-1, 1));
    if (random.coin())
      y.greater = fuzz::step_ulps(y.greater, random.between(0, 1));
    const mpq_class difference = (mpq_class(x.greater) - mpq_class(x.less)) * mpq_class(x_factor) -
                                 (mpq_class(y.greater) - mpq_class(y.less)) * mpq_class(y_factor);
    wrong += in_all_modes([&] { return 4 + determinant_sign(x, x_factor, y, y_factor); }) !=
             4 + sgn(difference);
    ties += sgn(difference) == 0;
  }
  CHECK(wrong == 0);
  CHECK(ties > 10'000);
}
