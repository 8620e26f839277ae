#include <graze/oracle/hard_arguments.hpp>
#include <graze/oracle/mpfr_number.hpp>
#include <map>

namespace graze::oracle {

double hard_arguments::nearest_multiple(int exponent) {
  thread_local std::map<int, double> known;
  if (const auto found = known.find(exponent); found != known.end())
    return found->second;
  // The value has 1,024 bits before the point at most, and some 110 after it are used.
  number rest(1300), digit(1300);
  mpfr_const_pi(rest, MPFR_RNDN);
  mpfr_ui_div(rest, 2, rest, MPFR_RNDN);
  mpfr_mul_2si(rest, rest, exponent, MPFR_RNDN);
  double before = 1, denominator = 0; // q_-2 and q_-1
  while (true) {
    mpfr_floor(digit, rest);
    // q_0 = 1 whatever the first digit.
    const double next = denominator == 0 ? 1 : mpfr_get_d(digit, MPFR_RNDN) * denominator + before;
    if (!(next < 0x1p53))
      break;
    before = denominator;
    denominator = next;
    mpfr_sub(rest, rest, digit, MPFR_RNDN);
    mpfr_ui_div(rest, 1, rest, MPFR_RNDN);
  }
  return known[exponent] = std::ldexp(denominator, exponent);
}

} // namespace graze::oracle
