// Operands for each branch and each threshold of determinant_sign and its filter: what an error of
// one in a constant would decide wrongly. Judged by rationals, in all rounding modes.
#include "all_modes.hpp"
#include <catch2/catch.hpp>
#include <cmath>
#include <generate/random.hpp>
#include <gmpxx.h>
#include <graze/octree/exact_touch.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/rounding/hardware.hpp>
#include <trial/number.hpp>
#include <vector>

using namespace graze;
using namespace graze::octree;
using graze::fuzz::random_stream;
using test::in_all_modes;

namespace {

mpq_class exact(const exact_distance& x) { return mpq_class(x.greater) - mpq_class(x.less); }

int exact_sign(const exact_distance& x, double by_x, const exact_distance& y, double by_y) {
  return sgn(exact(x) * mpq_class(by_x) - exact(y) * mpq_class(by_y));
}

/// Distances that two roundings move to either side of a number of units of 2^-1074 and a half.
exact_distance near_half(random_stream& random, double factor_in_units) {
  const double half = static_cast<double>(random.below(6)) + 0.5;
  const double about = fuzz::step_ulps(half / factor_in_units, random.between(-2, 2));
  const double ulp = std::nextafter(about, INFINITY) - about;
  // not a double: between `about` and its neighbours
  const double part = std::array<double, 6>{
      0, 0x1p-3, 0x1.f5c28f5c28f5cp-2, 0.5, 0x1.051eb851eb852p-1, 0x1.ep-1}[random.below(6)];
  return {about, random.sign() * part * ulp};
}

/// Not inlined: what is known here of the number of terms, gcc 12's sort does not know.
[[gnu::noinline]] int sign_of(octree::detail::dyadic_term* terms, int count) {
  return octree::detail::sign_of_sum(terms, count);
}

/// The distance times a factor, two roundings in the mode that is set where this is called.
[[gnu::noinline]] double rounded_product(const volatile exact_distance& distance, double factor) {
  volatile double difference = distance.greater - distance.less;
  return difference * factor;
}

} // namespace

TEST_CASE("octree.exact_touch: the filter proves nothing that is not so where products underflow",
          "[regression][hardcase]") {
  namespace hardware = graze::rounding::hardware;
  random_stream random(2027, 2);
  std::uint64_t wrong = 0, close = 0;
  for (int i = 0; i < 400'000; ++i) {
    const double a = static_cast<double>(1 + random.below(9)),
                 b = static_cast<double>(1 + random.below(9));
    const exact_distance x = near_half(random, a), y = near_half(random, b);
    const int sign = exact_sign(x, a, y, b);
    for (const hardware::mode mode :
         {hardware::mode::nearest, hardware::mode::down, hardware::mode::up}) {
      const hardware::mode_scope scope(mode);
      const double p = rounded_product(x, a * 0x1p-1074), q = rounded_product(y, b * 0x1p-1074);
      wrong += certainly_greater(p, q) && sign <= 0;
      wrong += certainly_greater(q, p) && sign >= 0;
      close += p != q && (sign == 0 || (sign > 0) != (p > q)); // the products say otherwise
    }
  }
  CHECK(wrong == 0);
  CHECK(close > 100);
}

#if defined(__x86_64__)
TEST_CASE("octree.exact_touch: the filter proves nothing that is not so where products are flushed",
          "[regression][hardcase]") {
  // both products about 2^-1022: one is rounded up to it, the other flushed to zero
  namespace hardware = graze::rounding::hardware;
  random_stream random(2027, 8);
  const unsigned before = hardware::mxcsr();
  constexpr unsigned flush = 0x8000;
  std::uint64_t wrong = 0, flushed = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double a = static_cast<double>(1 + random.below(9)),
                 b = static_cast<double>(1 + random.below(9));
    const auto near_one = [&](double factor) {
      exact_distance d = near_half(random, factor);
      d.greater = fuzz::step_ulps(1 / factor, random.between(-2, 2));
      return d;
    };
    const exact_distance x = near_one(a), y = near_one(b);
    const int sign = exact_sign(x, a, y, b);
    for (const unsigned rounding : {0x0000u, 0x2000u, 0x4000u, 0x6000u}) {
      hardware::set_mxcsr((before & ~0x6000u) | rounding | flush);
      const double p = rounded_product(x, a * 0x1p-1022), q = rounded_product(y, b * 0x1p-1022);
      const bool x_greater = certainly_greater(p, q), y_greater = certainly_greater(q, p);
      hardware::set_mxcsr(before);
      wrong += (x_greater && sign <= 0) || (y_greater && sign >= 0);
      flushed += (p == 0) != (q == 0);
    }
  }
  CHECK(wrong == 0);
  CHECK(flushed > 1000);
}
#endif

TEST_CASE("octree.exact_touch: products that underflow after an inexact difference",
          "[regression][hardcase]") {
  // A ray that enters the cube on axis 0 and leaves it on axis 1 at nearly the same time: each
  // distance times the other axis's speed is a few units of 2^-1074, and the distance on axis 1 is
  // rounded. The speeds are some 2^-1003, not a power of two, and 2^-400.
  random_stream random(2027, 3);
  std::uint64_t wrong = 0, touched = 0, apart = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double slow = static_cast<double>(3 + 2 * random.below(20)) * 0x1p-1003;
    const double units = static_cast<double>(1 + random.below(5));
    const double fast = std::ldexp(1, -400 + random.between(0, 3));
    const double near = std::ldexp(units, -1074) / fast; // the plane of entry, exact
    const double turn = fuzz::step_ulps(std::ldexp(units, -1074) / slow, random.between(-2, 2));
    const int size = -640 + random.between(0, 4);
    // leaves axis 1 at `edge`, a little before or after 0: turn + edge is no double
    const double edge = random.coin() ? -std::ldexp(1, size) : std::ldexp(1, size);
    vec3 o{0, -turn, 0}, d{slow, fast, 0};
    const cube c{{near, edge - std::ldexp(1, size), 0}, std::ldexp(1, size)};
    if (c.hi(0) - c.size != near || c.hi(1) != edge)
      continue;
    const unsigned flip = random.below(8); // of what goes backward
    cube flipped = c;
    for (unsigned a = 0; a < 3; ++a)
      if ((flip >> a & 1) != 0) {
        o[a] = -o[a];
        d[a] = -d[a];
        flipped.lo[a] = -c.hi(static_cast<int>(a));
      }
    const vec3 hi{flipped.hi(0), flipped.hi(1), flipped.hi(2)};
    const bool is = oracle::touches(o, d, flipped.lo, hi),
               own = oracle::owns(o, d, flipped.lo, hi, 0);
    const ray r = *ray::make(o, d);
    wrong +=
        in_all_modes([&] { return touches(r, flipped) + 2 * owns(r, flipped); }) != is + 2 * own;
    touched += is;
    apart += !is;
  }
  CHECK(wrong == 0);
  CHECK(touched > 1000);
  CHECK(apart > 1000);
}

TEST_CASE("octree.determinant_sign: products as long as they get, at every difference of exponents",
          "[regression][hardcase]") {
  random_stream random(2027, 4);
  std::uint64_t wrong = 0;
  std::array<std::uint64_t, 2> signs{};
  const double longest = 0x1.fffffffffffffp+0;
  for (int above = -140; above <= 140; ++above)
    for (int gap = 40; gap <= 70; ++gap)
      for (int i = 0; i < 12; ++i) {
        // x: operands 2^gap apart, all bits set, the difference's bits as many as they can be
        const auto magnitude = [&](bool all) {
          return all ? longest : 1 + static_cast<double>(random.bits(52)) * 0x1p-52;
        };
        const bool all = i < 6;
        const exact_distance x{std::ldexp(magnitude(all), gap), -magnitude(all)};
        const double by_x = magnitude(all);
        const int close = i % 6; // y's product: 2^above times smaller in its unit, or about x's
        const exact_distance y = close < 3
                                     ? exact_distance{std::ldexp(magnitude(true), gap - above), 0}
                                     : exact_distance{std::ldexp(magnitude(all), gap - above),
                                                      -std::ldexp(magnitude(all), -above)};
        const double by_y = close == 0  ? 1
                            : close < 5 ? magnitude(all)
                                        : std::ldexp(magnitude(all), above);
        const int is = exact_sign(x, by_x, y, by_y);
        wrong += in_all_modes([&] { return 4 + determinant_sign(x, by_x, y, by_y); }) != 4 + is;
        wrong += in_all_modes([&] { return 4 + determinant_sign(y, by_y, x, by_x); }) != 4 - is;
        ++signs[is > 0];
      }
  CHECK(wrong == 0);
  CHECK(signs[0] > 1000);
  CHECK(signs[1] > 1000);
}

TEST_CASE(
    "octree.determinant_sign: a product whose highest bit is alone, shifted to the last place",
    "[regression][hardcase]") {
  // (g 2^63 + l) f = 2^168 + r, r < 2^53: as long as a product gets, and nothing below its highest
  // bit that would be greater than the other product, shifted by so much that the bit is lost
  random_stream random(2027, 7);
  std::uint64_t wrong = 0;
  int products = 0;
  const double most = 0x1p53 - 1;
  for (int i = 0; i < 400'000 && products < 40; ++i) {
    const std::uint64_t f = random.bits(52) | std::uint64_t{1} << 52;
    const mpz_class whole = ((mpz_class(1) << 168) + (f - 1)) / mpz_class(f);
    const mpz_class g = whole >> 63, l = whole - (g << 63);
    if (l < (mpz_class(1) << 52) || l >= (mpz_class(1) << 53) || g >= (mpz_class(1) << 53))
      continue;
    ++products;
    const exact_distance x{std::ldexp(g.get_d(), 63), -l.get_d()};
    for (int above = 80; above <= 95; ++above) {
      const exact_distance y{std::ldexp(most, 63 - above), -std::ldexp(most, -above)};
      const auto by_x = static_cast<double>(f);
      const int is = exact_sign(x, by_x, y, most);
      wrong += in_all_modes([&] { return 4 + determinant_sign(x, by_x, y, most); }) != 4 + is;
      wrong += in_all_modes([&] { return 4 + determinant_sign(y, most, x, by_x); }) != 4 - is;
    }
  }
  CHECK(products == 40);
  CHECK(wrong == 0);
}

TEST_CASE("octree.determinant_sign: a unit that is left of long products, and terms far below it",
          "[regression][hardcase]") {
  // n n - (n - 1) (n + 1) = 1: what is left of the greater terms is one unit, and the lesser ones,
  // 2^gap below and all of one sign, are more than it up to a gap of 106
  std::uint64_t wrong = 0;
  int outweighed = 0;
  for (int gap = 60; gap <= 130; ++gap)
    for (int k = 1; k <= 40; ++k)
      for (const int opposite : {1, -1}) {
        const double n = 0x1p53 - k;
        for (const double tail : {0x1.fffffffffffffp+52, 0x1p+52, 0x1.8p+52}) {
          const exact_distance x{n, opposite * std::ldexp(tail, -gap)},
              y{n - 1, -opposite * std::ldexp(tail, -gap)};
          const int is = exact_sign(x, n, y, n + 1);
          outweighed += is < 0;
          wrong += in_all_modes([&] { return 4 + determinant_sign(x, n, y, n + 1); }) != 4 + is;
          wrong += in_all_modes([&] { return 4 + determinant_sign(y, n + 1, x, n); }) != 4 - is;
        }
      }
  CHECK(wrong == 0);
  CHECK(outweighed > 1000);
}

TEST_CASE("octree.determinant_sign: sums of terms at every gap, in every order",
          "[regression][hardcase]") {
  using octree::detail::dyadic_term;
  random_stream random(2027, 5);
  std::uint64_t wrong = 0, zero = 0;
  const auto value = [](const dyadic_term& t) {
    mpz_class m = static_cast<unsigned long>(t.magnitude >> 64);
    m <<= 64;
    m += static_cast<unsigned long>(t.magnitude);
    m <<= static_cast<unsigned>(t.exponent + 500);
    return t.negative ? mpz_class(-m) : m;
  };
  for (int i = 0; i < 200'000; ++i) {
    std::vector<dyadic_term> terms(4);
    const int count = 1 + static_cast<int>(random.below(4));
    int exponent = random.between(-20, 20);
    mpz_class sum = 0;
    for (int k = 0; k < count; ++k) {
      using octree::detail::uint128;
      const uint128 all = (uint128{1} << 106) - 1;
      const uint128 magnitudes[4] = {1, all, uint128{1} << random.below(106),
                                     (uint128{random.bits(53)} << 53 | random.bits(53)) | 1};
      terms[static_cast<unsigned>(k)] = {magnitudes[random.below(4)], exponent, random.coin()};
      if (k > 0 && random.one_in(4)) { // takes the one before it away, but for a little
        terms[static_cast<unsigned>(k)] = terms[static_cast<unsigned>(k) - 1];
        terms[static_cast<unsigned>(k)].negative = !terms[static_cast<unsigned>(k)].negative;
        if (terms[static_cast<unsigned>(k)].magnitude > 1 && random.coin())
          --terms[static_cast<unsigned>(k)].magnitude;
      }
      sum += value(terms[static_cast<unsigned>(k)]);
      exponent -= random.coin() ? random.between(0, 110) : random.between(100, 112);
    }
    for (int k = count - 1; k > 0; --k)
      std::swap(terms[static_cast<unsigned>(k)], terms[random.below(static_cast<unsigned>(k) + 1)]);
    wrong += sign_of(terms.data(), count) != sgn(sum);
    zero += sum == 0;
  }
  CHECK(wrong == 0);
  CHECK(zero > 1000);
}

TEST_CASE("octree.determinant_sign: subnormal operands, and zero beside any",
          "[regression][hardcase]") {
  random_stream random(2027, 6);
  std::uint64_t wrong = 0, ties = 0;
  const auto number = [&] {
    const double unit = static_cast<double>(random.bits(random.between(0, 6)));
    switch (random.below(4)) {
    case 0:
      return unit * 0x1p-1074;
    case 1:
      return std::ldexp(unit, random.between(-1080, -1010));
    case 2:
      return std::ldexp(unit, random.between(-40, 40));
    default:
      return static_cast<double>(random.bits(52)) * 0x1p-1074; // of all lengths
    }
  };
  for (int i = 0; i < 100'000; ++i) {
    exact_distance x{number(), random.sign() * number()}, y{number(), random.sign() * number()};
    double by_x = number(), by_y = number();
    if (random.one_in(4)) // the same product, or nearly
      y = {x.greater * 2, x.less * 2}, by_y = by_x / 2;
    if (x.greater < x.less)
      std::swap(x.greater, x.less);
    if (y.greater < y.less)
      std::swap(y.greater, y.less);
    const int is = exact_sign(x, by_x, y, by_y);
    wrong += in_all_modes([&] { return 4 + determinant_sign(x, by_x, y, by_y); }) != 4 + is;
    ties += is == 0;
  }
  CHECK(wrong == 0);
  CHECK(ties > 1000);
}

TEST_CASE("octree.exact_touch: a distance that overflows proves nothing",
          "[regression][hardcase]") {
  // the exit on axis 1 is 1.125 * 2^1024 away: the largest double, where rounding is not upwards
  const cube c{{0, -0x1p1023, -0x1p1022}, 0x1.cp1023};
  const vec3 hi{c.hi(0), c.hi(1), c.hi(2)}, o{-0x1p1023, -0x1.8p1023, 0};
  std::array<int, 2> seen{};
  for (int k = 1; k < 128; ++k) {
    const vec3 d{0x1p-100, (2 + k * 0x1p-8) * 0x1p-100, 0};
    const bool is = oracle::touches(o, d, c.lo, hi);
    const ray r = *ray::make(o, d);
    CHECK(in_all_modes([&] { return 4 + touches(r, c); }) == 4 + is);
    ++seen[is];
  }
  CHECK(seen[0] > 10);
  CHECK(seen[1] > 10);
}
