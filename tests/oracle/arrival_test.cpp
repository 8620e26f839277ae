#include <catch2/catch.hpp>
#include <cmath>
#include <gmpxx.h>
#include <graze/oracle/arrival.hpp>
#include <random>
#include <xmmintrin.h>

using namespace graze::oracle;

namespace {

int order_in_rationals(const arrival& a, const arrival& b) {
  const mpq_class left = abs(mpq_class(a.plane) - a.origin) * b.speed;
  const mpq_class right = abs(mpq_class(b.plane) - b.origin) * a.speed;
  return (left > right ? 1 : 0) - (left < right ? 1 : 0);
}

/// Pairs of which most are equal or differ in the last bits.
class close_pairs {
public:
  explicit close_pairs(std::uint64_t seed) : random_(seed) {}

  std::pair<arrival, arrival> next(int gap) {
    small_ = integer(0, 2) == 0;
    const double scale = std::ldexp(1.0, integer(-gap, gap));
    const double other_scale = std::ldexp(1.0, integer(-gap, gap));
    const double origin_a = scaled(integer(-gap, gap));
    const double origin_b = scaled(integer(-gap, gap));
    const double speed_a = std::fabs(number()) * scale, speed_b = std::fabs(number()) * other_scale;
    const double t = small_ ? integer(1, 15) : std::fabs(number());
    // braces: the draws come in this order with every compiler
    return {arrival{nudged(origin_a + t * speed_a), origin_a, speed_a},
            arrival{nudged(origin_b + t * speed_b), origin_b, speed_b}};
  }

private:
  int integer(int from, int to) { return std::uniform_int_distribution<>(from, to)(random_); }
  double scaled(int exponent) { return std::ldexp(number(), exponent); }
  double number() {
    if (small_ || integer(0, 2) == 0)
      return integer(0, 1) != 0 ? integer(1, 15) : -integer(1, 15);
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_() | 1)), -63);
  }
  double nudged(double x) {
    return integer(0, 2) != 0 ? x : std::nextafter(x, integer(0, 1) != 0 ? 1e308 : -1e308);
  }
  std::mt19937_64 random_;
  bool small_ = false; // all numbers of the pair are small integers times powers of two
};

/// compare() of arrivals that are made, too, in the rounding mode given by MXCSR bits.
[[gnu::noinline]] int compare_in_mode(unsigned mode, const arrival& a, const arrival& b) {
  const unsigned found = _mm_getcsr();
  _mm_setcsr((found & ~0x6000u) | mode);
  const volatile double planes[2] = {a.plane, b.plane};
  const int sign = compare({planes[0], a.origin, a.speed}, {planes[1], b.origin, b.speed});
  _mm_setcsr(found);
  return sign;
}

bool legal(const arrival& a) {
  return std::isfinite(a.plane) && a.plane != a.origin && std::isfinite(a.speed) && a.speed > 0;
}

} // namespace

TEST_CASE("oracle.arrival: equals the rational order, by every one of its three methods",
          "[property][hardcase]") {
  close_pairs random(1);
  decisions = {};
  std::array<int, 3> seen{};
  int compared = 0;
  for (int i = 0; i < 250'000; ++i) {
    const auto [a, b] = random.next(i % 4 == 0 ? 1000 : (i % 4 == 1 ? 60 : 4));
    if (!legal(a) || !legal(b))
      continue;
    ++compared;
    const int expected = order_in_rationals(a, b);
    ++seen[static_cast<unsigned>(expected + 1)];
    if (compare(a, b) != expected || compare(b, a) != -expected ||
        compare_exactly(a, b) != expected) {
      CAPTURE(i, a.plane, a.origin, a.speed, b.plane, b.origin, b.speed);
      REQUIRE(compare(a, b) == expected);
      REQUIRE(compare(b, a) == -expected);
      REQUIRE(compare_exactly(a, b) == expected);
    }
  }
  for (const int n : seen)
    CHECK(n > 10'000); // ties as well as both orders
  INFO("filter " << decisions.filter << ", wide " << decisions.wide << ", gmp " << decisions.gmp);
  CHECK(compared > 150'000);
  CHECK(decisions.filter > 30'000);
  CHECK(decisions.wide > 30'000);
  CHECK(decisions.gmp > 30'000);
}

TEST_CASE("oracle.arrival: the filter leaves to exact arithmetic what doubles get wrong",
          "[hardcase]") {
  // 1 + 2^-53 is no double: fl(plane - origin) = 1 for both, but a's is greater.
  const arrival a{1, -0x1p-53, 1}, b{1, 0x0p+0, 1};
  REQUIRE(a.time() == b.time());
  CHECK(compare(a, b) == 1);
  CHECK(compare(b, a) == -1);
  // A product that rounds the wrong way round: 3 * (1/3 rounded) is below 1 and rounds to 1.
  const arrival c{0x1.5555555555555p-2, 0, 1}, d{1, 0, 3};
  CHECK(compare(c, d) == -1);
  // The largest and the least doubles: products of 2^2048 and 2^-2148.
  const double least = 0x1p-1074, most = 0x1.fffffffffffffp+1023;
  CHECK(compare({most, -most, most}, {least, 0, least}) == 1);   // 2 against 1
  CHECK(compare({most, -most, least}, {least, 0, most}) == 1);   // 2^2099 against 2^-2098
  CHECK(compare({least, 0, most}, {least, -least, most}) == -1); // 1 against 2, of 2^-2098
  CHECK(compare({most, -most, most}, {most, -most, most}) == 0);
  CHECK(compare({most, least, most}, {most, -least, most}) == -1); // differ 2098 bits below
  CHECK(compare({most, least, most}, {most, 0, most}) == -1);
  CHECK(compare({most, least, 1}, {most, least, 1}) == 0);
}

TEST_CASE("oracle.arrival: times that underflow and differences that overflow are not filtered",
          "[hardcase]") {
  // In units of 2^-1074, a's time is 2.5 + 2^-52 + 2^-105 and b's 2.5 + 1.25 * 2^-52.
  const arrival a{0x1.4000000000001p-73, 0x1p-126 - 0x1p-179, 0x1p+1000};
  const arrival b{0x1p-75, -0x1p-128, 0x1p+999 * 0.2};
  CHECK(std::isnan(a.time()));
  CHECK(std::isnan(b.time()));
  CHECK(compare(a, b) == order_in_rationals(a, b));
  CHECK(compare(b, a) == order_in_rationals(b, a));
  const arrival never{0x1p+100, 0, 0x1p-1000};
  CHECK(std::isnan(never.time()));
  CHECK(compare(never, a) == 1);
  // Rounding down or to zero, 2^1025 becomes the largest double, not infinity: half of what it is.
  const double most = 0x1.fffffffffffffp+1023;
  for (const unsigned mode : {0x0000u, 0x2000u, 0x4000u, 0x6000u}) {
    CAPTURE(mode);
    CHECK(compare_in_mode(mode, {most, -most, 1}, {1.5, 0, 0x1p-1024}) == 1); // 2 against 1.5
  }
}

TEST_CASE("oracle.arrival: errors of up to two ulps between the filter's products, in every mode",
          "[hardcase]") {
  // Significands just above 1, where an ulp weighs most; the parts below the last bit make the
  // differences inexact, and k near 2^26 the products. (All errors of a directed mode have one
  // sign, so that two ulps are the most, where the filter's proof allows for four.)
  constexpr double ulp = 0x1p-52;
  std::mt19937_64 random(2);
  int computed_wrong = 0;
  for (int i = 0; i < 40'000; ++i) {
    const auto k = [&random] { return static_cast<double>((1u << 26) + random() % (1u << 26)); };
    const auto part = [&random] {
      static constexpr std::array<double, 6> parts{.01, .49, .51, .99, -.01, -.49};
      return parts[random() % parts.size()] * ulp;
    };
    const double k1 = k(), k2 = k(), k3 = k();
    const double k4 = k1 + k2 - k3 + static_cast<double>(static_cast<int>(random() % 9) - 4);
    const double part_a = part(), part_b = part();
    const arrival a{1 + k1 * ulp, part_a, 1 + k3 * ulp}, b{1 + k4 * ulp, part_b, 1 + k2 * ulp};
    const int expected = order_in_rationals(a, b);
    computed_wrong += (a.time() > b.time() ? 1 : -1) != expected ? 1 : 0;
    for (const unsigned mode : {0x0000u, 0x2000u, 0x4000u, 0x6000u})
      if (compare_in_mode(mode, a, b) != expected) {
        CAPTURE(i, mode, a.plane, a.origin, a.speed, b.plane, b.origin, b.speed);
        REQUIRE(compare_in_mode(mode, a, b) == expected);
      }
  }
  CHECK(computed_wrong > 1'000);
}
