#include "exact_number.hpp"
#include <algorithm>
#include <limits>

namespace graze::detail {

namespace {
/// log2(5), rounded down, with more of the digits than an estimate to a few bits needs.
constexpr long double log2_of_five = 2.3219280948873623L;

std::int64_t length_of(const natural& n) { return static_cast<std::int64_t>(n.bit_length()); }
} // namespace

double exact_number::rounded(rounding::exact::direction d) const {
  using namespace rounding::exact;
  if (numerator.is_zero())
    return 0;
  const bool away = (d == direction::up) != negative;
  // log2 of the magnitude to within 2, and far better than 1 part in 2^40 of the exponents: nothing
  // large is built for a number far out of a double's range.
  const long double log2 = static_cast<long double>(length_of(numerator) - length_of(denominator)) +
                           static_cast<long double>(twos) +
                           static_cast<long double>(fives) * log2_of_five;
  if (log2 > 1100)
    return round(negative, 1, 2000, false, d);
  if (log2 < -1200)
    return away ? round(negative, 1, -2000, false, d) : zero(negative);
  natural a = numerator, b = denominator;
  if (fives > 0)
    a = a * natural::power_of_five(static_cast<std::uint64_t>(fives));
  else if (fives < 0)
    b = b * natural::power_of_five(static_cast<std::uint64_t>(-fives));
  // a quotient of 66 or 67 bits
  const std::int64_t shift = 66 + length_of(b) - length_of(a);
  if (shift > 0)
    a <<= static_cast<std::uint64_t>(shift);
  else
    b <<= static_cast<std::uint64_t>(-shift);
  const natural::quotient q = a.divided_by(b);
  return round(negative, q.value, static_cast<int>(twos - shift), q.remainder, d);
}

bool operator==(const exact_number& x, const exact_number& y) {
  if (x.numerator.is_zero() || y.numerator.is_zero())
    return x.numerator.is_zero() && y.numerator.is_zero();
  if (x.negative != y.negative)
    return false;
  // x.numerator y.denominator 2^twos 5^fives = y.numerator x.denominator, with exponents of either
  // sign brought to the side where they are positive. A side that is divisible by 2^n or 5^n has
  // more than n bits, so that excessive powers need not be built.
  natural a = x.numerator * y.denominator, b = y.numerator * x.denominator;
  const std::int64_t twos = x.twos - y.twos, fives = x.fives - y.fives;
  if (twos > length_of(b) || -twos > length_of(a) || fives > length_of(b) || -fives > length_of(a))
    return false;
  if (twos >= 0)
    a <<= static_cast<std::uint64_t>(twos);
  else
    b <<= static_cast<std::uint64_t>(-twos);
  if (fives >= 0)
    a = a * natural::power_of_five(static_cast<std::uint64_t>(fives));
  else
    b = b * natural::power_of_five(static_cast<std::uint64_t>(-fives));
  return a == b;
}

} // namespace graze::detail
