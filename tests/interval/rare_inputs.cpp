#include "rare_inputs.hpp"
#include <gmpxx.h>
#include <graze/oracle/elementary.hpp>

namespace graze::test {

std::vector<double> near_multiples_of_half_pi() {
  std::vector<double> found;
  oracle::number value(mpfr_prec_t{2400}), half_pi(mpfr_prec_t{2400});
  mpfr_const_pi(half_pi, MPFR_RNDN);
  mpfr_div_2ui(half_pi, half_pi, 1, MPFR_RNDN);
  for (int exponent = -60; exponent <= 971; ++exponent) {
    mpfr_set_ui_2exp(value, 1, exponent, MPFR_RNDN);
    mpfr_div(value, value, half_pi, MPFR_RNDN); // about M value = an integer
    mpz_class previous = 1, current = 0, digit; // denominators of the convergents, from 1/0 on
    while (current < (mpz_class{1} << 53)) {
      if (current >= (mpz_class{1} << 46))
        found.push_back(std::ldexp(current.get_d(), exponent));
      mpfr_get_z(digit.get_mpz_t(), value, MPFR_RNDD);
      mpfr_sub_z(value, value, digit.get_mpz_t(), MPFR_RNDN);
      mpfr_ui_div(value, 1, value, MPFR_RNDN);
      const mpz_class next = digit * current + previous;
      previous = current, current = next;
    }
  }
  return found;
}

} // namespace graze::test
