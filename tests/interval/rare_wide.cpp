// What the wide kernels rest on: their constants, and how near doubles come to multiples of pi/2.
#include "../../interval/src/exact/wide_functions.hpp"
#include "../../interval/src/exact/wide_power.hpp"
#include "rare_judge.hpp"
#include <catch2/catch.hpp>
#include <gmpxx.h>

using namespace graze;
using namespace graze::test;

namespace {
template <std::size_t N> mpz_class as_integer(const std::array<std::uint64_t, N>& a) {
  mpz_class r;
  mpz_import(r.get_mpz_t(), N, -1, sizeof(std::uint64_t), 0, 0, a.data());
  return r;
}
/// floor(x 2^shift)
mpz_class scaled(oracle::number& x, long shift) {
  mpz_class r;
  mpfr_mul_2si(x, x, shift, MPFR_RNDN);
  mpfr_get_z(r.get_mpz_t(), x, MPFR_RNDD);
  return r;
}
} // namespace

TEST_CASE("interval.wide: every bit of the constants is MPFR's", "[unit][mpfr]") {
  {
    oracle::number x(mpfr_prec_t{2000});
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_ui_div(x, 2, x, MPFR_RNDN);
    CHECK(as_integer(wide::two_over_pi) == scaled(x, 1536));
  }
  {
    oracle::number x(mpfr_prec_t{2000});
    mpfr_const_pi(x, MPFR_RNDN);
    CHECK(as_integer(wide::half_pi<4>.significand) == scaled(x, 254));
    mpfr_const_pi(x, MPFR_RNDN);
    CHECK(as_integer(wide::half_pi<2>.significand) == scaled(x, 126));
  }
  {
    oracle::number x(mpfr_prec_t{2000});
    mpfr_const_log2(x, MPFR_RNDN);
    CHECK(as_integer(wide::log_of_2<5>) == scaled(x, 320));
    mpfr_const_log2(x, MPFR_RNDN);
    CHECK(as_integer(wide::log_of_2<3>) == scaled(x, 192));
  }
  for (int k = 0; k < 29; ++k) {
    for (int odd = 0; odd < 2; ++odd) {
      mpz_class f;
      mpz_fac_ui(f.get_mpz_t(), static_cast<unsigned long>(2 * k + odd));
      const mpz_class want = (mpz_class{1} << 255) / f;
      const auto& table = wide::factorials<4, 29>;
      CHECK(as_integer(odd != 0 ? table.odd[k] : table.even[k]) == want);
    }
  }
}

TEST_CASE("interval.wide: no double is within 2^-62 of a multiple of pi/2, in units of pi/2",
          "[unit][mpfr]") {
  // The convergents of 2^E 2/pi are its best approximations: of all M < 2^53, the one that comes
  // nearest is among them.
  oracle::number x(mpfr_prec_t{2400}), two_over_pi(mpfr_prec_t{2400}), whole(mpfr_prec_t{2400});
  mpfr_const_pi(two_over_pi, MPFR_RNDN);
  mpfr_ui_div(two_over_pi, 2, two_over_pi, MPFR_RNDN);
  double nearest = 1;
  for (double m : near_multiples_of_half_pi()) {
    if (m < 0.75)
      continue;
    mpfr_mul_d(x, two_over_pi, m, MPFR_RNDN);
    mpfr_round(whole, x);
    mpfr_sub(x, x, whole, MPFR_RNDN);
    nearest = std::min(nearest, std::fabs(mpfr_get_d(x, MPFR_RNDN)));
  }
  CHECK(nearest > 0x1p-62);
  CHECK(nearest < 0x1p-61);
}

namespace {
/// Limbs that are often 0 or all ones, where carries and wrong quotient digits happen.
template <int N> wide::limbs<N> edgy(random_doubles& random, bool normal) {
  wide::limbs<N> a{};
  for (auto& limb : a) {
    switch (random.below(5)) {
    case 0:
      limb = random.below(3);
      break;
    case 1:
      limb = ~random.below(3);
      break;
    case 2:
      limb = (std::uint64_t{1} << 63) + random.below(3);
      break;
    default:
      limb = random.below(~std::uint64_t{0});
    }
  }
  if (normal)
    a[N - 1] |= std::uint64_t{1} << 63;
  return a;
}

/// q = floor(n / d), by both ways where there are two; false where one is wrong.
template <int N> bool quotient_holds(random_doubles& random) {
  const wide::limbs<N> d = edgy<N>(random, true);
  std::array<std::uint64_t, 2 * N> n = edgy<2 * N>(random, false);
  if (random.coin()) { // the same head as d
    for (int i = 1; i < N; ++i)
      n[N + i] = d[i];
    n[N] = random.below(3);
  }
  const mpz_class numerator = as_integer(n), divisor = as_integer(d);
  if ((numerator >> (64 * N)) >= divisor)
    return true;
  const mpz_class want = numerator / divisor;
  bool holds = as_integer(wide::quotient<N, N>(n, d)) == want;
  if constexpr (N == 2)
    holds = holds && as_integer(wide::quotient_of_two(n, d)) == want;
  return holds;
}

template <int N> bool product_holds(random_doubles& random) {
  const wide::limbs<N> a = edgy<N>(random, false), b = edgy<N>(random, false);
  const mpz_class exact = as_integer(a) * as_integer(b);
  const mpz_class low = exact - (as_integer(wide::high_product<N>(a, b)) << (64 * N));
  const mpz_class by_one = as_integer(a) * as_integer(std::array{b[0]}) -
                           (as_integer(wide::high_product<N>(a, b[0])) << 64);
  return low >= 0 && low < (mpz_class{N + 1} << (64 * N)) && by_one >= 0 &&
         by_one < (mpz_class{1} << 64);
}

/// How many units of 2^(-64 N) the relative error has; `want` is changed.
template <int N> double error(const wide::number<N>& got, mpfr_ptr want) {
  oracle::number value(mpfr_prec_t{400});
  const mpz_class m = as_integer(got.significand);
  mpfr_set_z_2exp(value, m.get_mpz_t(), got.exponent - 64 * N, MPFR_RNDN);
  mpfr_abs(want, want, MPFR_RNDN);
  mpfr_reldiff(value, want, value, MPFR_RNDN);
  mpfr_mul_2si(value, value, 64 * N, MPFR_RNDN);
  return std::fabs(mpfr_get_d(value, MPFR_RNDN));
}

template <int N> double greatest_error_of_functions() {
  random_doubles random(20246);
  const std::vector<double> near = near_multiples_of_half_pi();
  double greatest = 0;
  oracle::number sine(mpfr_prec_t{400}), cosine(mpfr_prec_t{400});
  for (std::size_t i = input_count() / 10; i > 0; --i) {
    double x = random.coin() ? random.pick(near) : random.between(-4, 4);
    if (random.below(3) == 0)
      x = random.sign() * random.with_exponent(static_cast<int>(random.below(1084)) - 60);
    if (std::fabs(x) < 0x1p-61)
      continue;
    oracle::number exact(x);
    const wide::circular<N> f = wide::circular_of<N>(x);
    mpfr_sin_cos(sine, cosine, exact, MPFR_RNDN);
    if (f.sine_negative != (mpfr_sgn(static_cast<mpfr_ptr>(sine)) < 0) ||
        f.cosine_negative != (mpfr_sgn(static_cast<mpfr_ptr>(cosine)) < 0))
      return infinity;
    greatest = std::max({greatest, error<N>(f.sine, sine), error<N>(f.cosine, cosine)});

    const double y = random.coin() ? random.between(-750, 750)
                                   : random.with_exponent(static_cast<int>(random.below(62)) - 60);
    oracle::number exact_y(y);
    const wide::hyperbolic<N> h = wide::hyperbolic_of<N>(y);
    mpfr_sinh_cosh(sine, cosine, exact_y, MPFR_RNDN);
    greatest = std::max({greatest, error<N>(h.sine, sine), error<N>(h.cosine, cosine)});
  }
  return greatest;
}
} // namespace

TEST_CASE("interval.wide: products and quotients keep their error bounds", "[property]") {
  random_doubles random(20247);
  std::size_t wrong = 0;
  for (std::size_t i = input_count(); i > 0; --i) {
    const bool holds = quotient_holds<2>(random) && quotient_holds<4>(random) &&
                       product_holds<2>(random) && product_holds<4>(random);
    wrong += holds ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.wide: sin, cos, sinh, cosh within 2^8 units of 2^(-64 N)",
          "[property][mpfr][hardcase]") {
  CHECK(greatest_error_of_functions<2>() < 256);
  CHECK(greatest_error_of_functions<4>() < 256);
}

TEST_CASE("interval.wide: powers keep their error bounds, also with four limbs", "[property]") {
  random_doubles random(20248);
  bool holds = true;
  int exact_ones = 0;
  for (std::size_t i = input_count() / 10; i > 0; --i) {
    const double x = random.with_exponent(0);
    const auto n = static_cast<std::uint32_t>(
        2 + random.below(std::uint64_t{1} << random.below(random.coin() ? 4 : 32)));
    oracle::number base(x), want(mpfr_prec_t{400});
    mpfr_pow_ui(want, base, n, MPFR_RNDN);
    const rounding::exact::magnitude a = rounding::exact::take_apart(x);
    const wide::two_limbs two = wide::power(a.significand << 11, a.exponent + 53, n);
    const double error_of_two = error<2>(wide::as_number(two), want);
    const bool exact = wide::is_exact(wide::bits_of(a.significand), n);
    exact_ones += exact ? 1 : 0;
    holds = holds && (exact ? error_of_two == 0 : error_of_two < 8.0 * n) &&
            error<4>(wide::power_of_four_limbs(x, n), want) < 20.0 * n;
  }
  CHECK(exact_ones > 100);
  CHECK(holds);
}
