// What the wide kernels rest on: their constants, and how near doubles come to multiples of pi/2.
#include "../../interval/src/wide_constants.hpp"
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
