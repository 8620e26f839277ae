#include <catch2/catch.hpp>
#include <cmath>
#include <graze/oracle/rational.hpp>
#include <graze/oracle/roots.hpp>
#include <limits>
#include <random>

using namespace graze::oracle;

namespace {

const polynomial t = polynomial::along(0, 1);

/// The product of (t - r)^m over the roots and multiplicities.
polynomial with_roots(const std::vector<std::pair<mpq_class, int>>& roots) {
  polynomial p = 1;
  for (const auto& [r, m] : roots)
    for (int i = 0; i < m; ++i)
      p *= t - r;
  return p;
}

mpq_class power_of_two(int exponent) {
  mpq_class r = 1;
  if (exponent >= 0)
    mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return r;
}

template <class Number> Number tanglecube(const Number& x, const Number& y, const Number& z) {
  const auto part = [](const Number& a) { return sqr(sqr(a)) - 5 * sqr(a); };
  return part(x) + part(y) + part(z) + 11.8;
}
template <class Number> Number holesrot(const Number& x, const Number& y, const Number& z) {
  const auto part = [](const Number& a) { return a * sqr(a) - a; };
  return part(x) + part(y) + part(z);
}

} // namespace

TEST_CASE("oracle.polynomial: arithmetic is exact and agrees with evaluation in rationals",
          "[property]") {
  std::mt19937_64 random(1);
  const auto number = [&random] {
    const int exponent = random() % 16 == 0 ? static_cast<int>(random() % 2098) - 1074
                                            : static_cast<int>(random() % 40) - 20;
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random()) >> 11),
                      exponent - 52);
  };
  for (int i = 0; i < 300; ++i) {
    const double a = number(), b = number(), c = number();
    if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c))
      continue;
    const mpq_class third(1, 3), at = mpq_class(number()) / 7;
    const polynomial x = polynomial::along(a, b), y = polynomial::along(c, -a);
    const polynomial p = 3 * sqr(x) - y * x * 0.5 + third - (x - 7) / 5 + 1e-3 * y;
    const mpq_class X = a + at * b, Y = c - at * a;
    REQUIRE(p(at) == mpq_class(3 * X * X - Y * X / 2 + third - (X - 7) / 5 + mpq_class(1e-3) * Y));
    REQUIRE(p.derivative()(at) ==
            mpq_class(6 * X * b - (Y * b - X * a) / 2 - mpq_class(b) / 5 - mpq_class(1e-3) * a));
    REQUIRE(p - p == polynomial());
    REQUIRE((p * p - sqr(p)).degree() == -1);
  }
  CHECK(polynomial(0.0).degree() == -1);
  CHECK(polynomial(5e-324).coefficient(0) == power_of_two(-1074));
  CHECK(polynomial::along(1, 0).degree() == 0);
  CHECK(tanglecube(t, t, t).coefficient(4) == 3);
  CHECK(tanglecube(t, t, t).coefficient(0) == mpq_class(11.8));
}

TEST_CASE("oracle.roots: counts the known roots, whatever their multiplicities", "[unit]") {
  const mpq_class third(1, 3), half(1, 2);
  struct example {
    polynomial p;
    int all, positive;
  };
  const std::vector<example> examples{{1, 0, 0},
                                      {t, 1, 0},
                                      {t - 2, 1, 1},
                                      {sqr(t) - 2, 2, 1},
                                      {sqr(t) + 1, 0, 0},
                                      {sqr(t), 1, 0},
                                      {with_roots({{1, 1}, {2, 2}, {3, 3}, {-4, 4}}), 4, 3},
                                      {with_roots({{third, 2}}), 1, 1},
                                      {with_roots({{third, 2}, {half, 2}}) * (sqr(t) + 1), 2, 2},
                                      {-with_roots({{third, 1}, {-half, 1}}) * 1e300, 2, 1},
                                      {with_roots({{0, 3}, {1, 1}}) * 0x1p-1000, 2, 1},
                                      {sqr(sqr(t) - 2), 2, 1}};
  for (std::size_t i = 0; i < examples.size(); ++i) {
    CAPTURE(i);
    const root_counter counter(examples[i].p);
    CHECK(counter.roots() == examples[i].all);
    CHECK(counter.positive_roots() == examples[i].positive);
  }
  // Half-open: ]from, to]
  const root_counter counter(with_roots({{1, 1}, {2, 2}, {3, 1}}));
  CHECK(counter.roots_between(1, 3) == 2);
  CHECK(counter.roots_between(0, 1) == 1);
  CHECK(counter.roots_between(1, 2) == 1);
  CHECK(counter.roots_between(mpq_class(5, 2), mpq_class(29, 10)) == 0);
  CHECK(counter.roots_between(3, 1) == 0);
}

TEST_CASE("oracle.roots: finds the first of random known roots, with its multiplicity",
          "[property]") {
  std::mt19937_64 random(2);
  const auto integer = [&random](int from, int to) {
    return std::uniform_int_distribution<>(from, to)(random);
  };
  int exact = 0, found_in_range = 0, even = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::vector<std::pair<mpq_class, int>> roots;
    const int n = integer(1, 5);
    for (int k = 0; k < n; ++k) {
      mpq_class r{integer(-30, 60), integer(1, 12)};
      r.canonicalize();
      if (k > 0 && integer(0, 4) == 0) { // a close neighbour of another root
        const mpq_class gap = power_of_two(-integer(20, 90));
        r = roots.back().first + gap * integer(-1, 1);
      }
      bool known = false;
      for (auto& [other, m] : roots)
        known |= other == r;
      if (!known)
        roots.emplace_back(r, integer(0, 3) == 0 ? integer(2, 3) : 1);
    }
    polynomial p = with_roots(roots) * (integer(0, 1) != 0 ? -3.75 : 0x1p-700);
    if (integer(0, 2) == 0)
      p *= sqr(t - 1) + 1; // no more real roots

    mpq_class from = 0, to = 1'000'000;
    const bool ranged = integer(0, 1) == 0;
    if (ranged) {
      from = mpq_class{integer(-40, 40), integer(1, 7)};
      from.canonicalize();
      to = from + mpq_class{integer(0, 40), 9};
      to.canonicalize();
      if (integer(0, 4) == 0)
        to = roots.front().first;
    }
    const std::pair<mpq_class, int>* first = nullptr;
    for (const auto& r : roots)
      if (r.first >= from && r.first <= to && (first == nullptr || r.first < first->first))
        first = &r;

    CAPTURE(i, ranged, from.get_d(), to.get_d());
    const std::optional<root> found = ranged ? first_root(p, from, to) : first_root(p);
    REQUIRE(found.has_value() == (first != nullptr));
    if (!found)
      continue;
    REQUIRE(found->lo <= first->first);
    REQUIRE(first->first <= found->hi);
    REQUIRE(found->hi - found->lo <= power_of_two(-200));
    REQUIRE(found->lo >= from);
    REQUIRE(found->hi <= to);
    REQUIRE(found->multiplicity == first->second);
    exact += found->lo == found->hi ? 1 : 0;
    found_in_range += ranged ? 1 : 0;
    even += found->multiplicity % 2 == 0 ? 1 : 0;
  }
  CHECK(exact > 200);
  CHECK(found_in_range > 500);
  CHECK(even > 200);
}

TEST_CASE("oracle.roots: irrational roots to 200 bits", "[unit]") {
  const std::optional<root> found = first_root(sqr(t) - 2);
  REQUIRE(found);
  CHECK(found->lo * found->lo < 2);
  CHECK(found->hi * found->hi > 2);
  CHECK(found->hi - found->lo <= power_of_two(-200));
  CHECK(found->multiplicity == 1);
  CHECK(first_root(sqr(sqr(t) - 2))->multiplicity == 2);
  CHECK(first_root(sqr(t) - 2, 1, mpq_class(14, 10)) == std::nullopt);
  CHECK(first_root(sqr(t) - 2, -3, 3)->hi < 0);
  CHECK(first_root(sqr(t) - 2, 20)->hi - first_root(sqr(t) - 2, 20)->lo <= power_of_two(-20));
  // Close to one another: 2^-300 apart, less than the width asked for
  const mpq_class gap = power_of_two(-300);
  const std::optional<root> close = first_root((sqr(t) - 2) * (sqr(t) - mpq_class(2 + gap)));
  REQUIRE(close);
  CHECK(close->hi * close->hi < 2 + gap);
  CHECK(close->multiplicity == 1);
}

TEST_CASE("oracle.roots: a dyadic root is met exactly, bounds stay within a narrow range",
          "[unit]") {
  for (const double r : {5.0, 0.375, 0x1.8p-40, 1000.0}) {
    const std::optional<root> found = first_root((t - r) * (sqr(t) - 3e6));
    REQUIRE(found);
    CHECK(found->lo == mpq_class(r));
    CHECK(found->hi == mpq_class(r));
  }
  const std::optional<root> fine = first_root(sqr(t) - 2, 600);
  REQUIRE(fine);
  const std::optional<root> clipped = first_root(sqr(t) - 2, fine->lo, fine->hi, 50);
  REQUIRE(clipped);
  CHECK(clipped->lo >= fine->lo);
  CHECK(clipped->hi <= fine->hi);
  CHECK_FALSE(first_root(sqr(t) - 2, fine->hi, fine->hi + 100));
  CHECK_FALSE(first_root(sqr(t) - 2, 0, fine->lo));
}

TEST_CASE("oracle.roots: the roots that are none, at 0, at the ends, and everywhere", "[unit]") {
  CHECK_FALSE(first_root(polynomial(3)));
  CHECK_FALSE(first_root(t + 1));
  CHECK_FALSE(first_root(sqr(t) + 1e-300));
  const std::optional<root> everywhere = first_root(polynomial(), 2, 3);
  REQUIRE(everywhere);
  CHECK(everywhere->lo == 2);
  CHECK(everywhere->multiplicity == 0);
  const std::optional<root> at_zero = first_root(t * sqr(t) * (t - 1));
  REQUIRE(at_zero);
  CHECK(at_zero->hi == 0);
  CHECK(at_zero->multiplicity == 3);
  CHECK(first_root(t - 5, 1, 5)->hi == 5);
  CHECK(first_root(t - 5, 5, 6)->lo == 5);
  CHECK(first_root(t - 5, 5, 5)->lo == 5);
  CHECK_FALSE(first_root(t - 5, 6, 5));
  // Far, and near 0
  CHECK(first_root(t * 5e-324 - 1e308)->hi * power_of_two(-1074) >= mpq_class(1e308));
  CHECK(first_root(t * 1e308 - 5e-324)->lo * mpq_class(1e308) <= power_of_two(-1074));
}

TEST_CASE(
    "oracle.roots: along rays through tanglecube and holesrot, g changes sign within the bounds",
    "[property]") {
  std::mt19937_64 random(3);
  const auto number = [&random] {
    return std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
  };
  int hits = 0;
  for (int i = 0; i < 1'000; ++i) {
    const point o{6 + number(), 4, 12}, d{-3 + number(), -2 + number(), -6 + number()};
    const point lo{-2.5, -2.5, -2.5}, hi{2.5, 2.5, 2.5};
    const auto [x, y, z] = along(o, d);
    const polynomial g = i % 2 == 0 ? tanglecube(x, y, z) : holesrot(x, y, z);
    const auto range = rational::range_in(o, d, lo, hi);
    if (!range)
      continue;
    const std::optional<root> found = first_root(g, range->first, range->second);
    const int sign_at_entry = sgn(g(range->first));
    REQUIRE(sign_at_entry != 0);
    if (!found) { // then there is no change of sign at a thousand places
      for (int k = 0; k <= 1'000; k += 50)
        REQUIRE(sgn(g(range->first + (range->second - range->first) * mpq_class(k, 1'000))) ==
                sign_at_entry);
      continue;
    }
    ++hits;
    REQUIRE(found->hi - found->lo <= power_of_two(-200));
    REQUIRE(found->multiplicity == 1);
    REQUIRE(sgn(g(found->lo)) == sign_at_entry);
    REQUIRE(sgn(g(found->hi)) == -sign_at_entry);
    REQUIRE(root_counter(g).roots_between(range->first, found->hi) == 1);
  }
  CHECK(hits > 300);
}

TEST_CASE("oracle.roots: doubles below and above a rational", "[unit]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max();
  const mpq_class third(1, 3), huge = power_of_two(1024);
  CHECK(double_below(third) == 0x1.5555555555555p-2);
  CHECK(double_above(third) == 0x1.5555555555556p-2);
  CHECK(double_below(-third) == -0x1.5555555555556p-2);
  CHECK(double_above(-third) == -0x1.5555555555555p-2);
  for (const double x : {0.0, 1.5, -0x1p-1074, 0x1.8p-1023, most, -most}) {
    CHECK(double_below(mpq_class(x)) == x);
    CHECK(double_above(mpq_class(x)) == x);
  }
  CHECK(double_below(power_of_two(-1080)) == 0);
  CHECK(double_above(power_of_two(-1080)) == 0x1p-1074);
  CHECK(double_below(-power_of_two(-1080)) == -0x1p-1074);
  CHECK(double_above(-power_of_two(-1080)) == 0);
  CHECK(double_below(third * power_of_two(-1072)) == 0x1p-1074);
  CHECK(double_above(third * power_of_two(-1072)) == 0x1p-1073);
  CHECK(double_below(huge) == most);
  CHECK(double_above(huge) == infinity);
  CHECK(double_below(-huge) == -infinity);
  CHECK(double_above(-huge) == -most);
}
