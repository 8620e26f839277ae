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

double nearly_a_double(mpfr_function f, double x) {
  constexpr int steps = 1 << 14;
  const double last = hard_operands::step(x, steps);
  number value(160), other(160), argument;
  const auto evaluate = [&](double at, mpfr_ptr into) {
    mpfr_set_d(argument, at, MPFR_RNDN);
    f(into, argument, MPFR_RNDN);
  };
  evaluate(x, value);
  evaluate(last, other);
  if (!mpfr_regular_p(value) || !mpfr_regular_p(other) || std::signbit(x) != std::signbit(last))
    return x;
  // In units of 2^-64 ulp, modulo the ulp.
  const auto exponent = mpfr_get_exp(value);
  if (exponent < -1000)
    return x;
  const auto fraction = [&](mpfr_ptr t) {
    number scaled(160), whole(160);
    mpfr_mul_2si(scaled, t, 53 - exponent, MPFR_RNDN);
    mpfr_floor(whole, scaled);
    mpfr_sub(scaled, scaled, whole, MPFR_RNDN);
    mpfr_mul_2ui(scaled, scaled, 64, MPFR_RNDN);
    return mpfr_get_uj(scaled, MPFR_RNDZ);
  };
  const std::uint64_t start = fraction(value);
  mpfr_sub(other, other, value, MPFR_RNDN);
  mpfr_div_ui(other, other, steps, MPFR_RNDN);
  const std::uint64_t slope = fraction(other);
  std::uint64_t product = start, least = ~std::uint64_t{0};
  int best = 0;
  for (int k = 0; k < steps; ++k, product += slope) {
    const std::uint64_t distance = product >> 63 ? ~product + 1 : product;
    if (distance < least && distance != 0) {
      least = distance;
      best = k;
    }
  }
  return hard_operands::step(x, best);
}

} // namespace graze::oracle
