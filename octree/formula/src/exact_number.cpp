// Rational numbers: from texts and doubles, and to the doubles beside them.
#include "exact_number.hpp"

#include <cmath>
#include <cstdint>
#include <graze/octree_formula/operations.hpp>
#include <limits>

namespace graze::octree::tape {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// floor(n / d) * 2^exponent, or the next one up if `up` and the quotient is not exact; n >= 0, d > 0.
double rounded(const integer& n, const integer& d, bool up) {
  if (n.is_zero())
    return 0;
  constexpr int precision = 53, least_exponent = -1074, greatest_exponent = 1024 - precision;
  // n / d is in (2^(size - 1), 2^(size + 1))
  const int size = static_cast<int>(bits_of(n)) - static_cast<int>(bits_of(d));
  for (int exponent = std::max(size - precision, least_exponent);; ++exponent) {
    const integer above = exponent < 0 ? integer(n << -exponent) : n,
                  below = exponent > 0 ? integer(d << exponent) : d;
    integer quotient, rest;
    divide_qr(above, below, quotient, rest);
    if (quotient >> precision != 0)
      continue;
    if (up && !rest.is_zero())
      ++quotient;
    const auto significand = quotient.convert_to<std::uint64_t>();
    const bool next_binade = significand >> precision != 0;
    if (exponent + (next_binade ? 1 : 0) > greatest_exponent)
      return up ? infinity : std::numeric_limits<double>::max();
    return std::ldexp(static_cast<double>(significand), exponent);
  }
}

bool is_small(const rational& x) {
  return bits_of(numerator_of(x)) <= number::most_bits &&
         bits_of(denominator_of(x)) <= number::most_bits;
}

/// The result of an operation on two numbers: enclosed by intervals, and exact if both are and it is
/// not too large.
template <class Function>
number result_of(const number& x, const number& y, const number::interval& enclosure, Function f) {
  if (enclosure.lower() == enclosure.upper()) // by outward rounding no other number is there
    return number(enclosure);
  const auto a = x.exact(), b = y.exact();
  if (!a || !b)
    return number(enclosure);
  const rational exact = f(*a, *b);
  return is_small(exact) ? number(exact) : number(enclosure);
}

} // namespace

rational exactly(double x) {
  int exponent = 0;
  const double significand = std::ldexp(std::frexp(x, &exponent), 53);
  exponent -= 53;
  const integer n(static_cast<std::int64_t>(significand));
  return exponent >= 0 ? rational(n << exponent) : rational(n, integer(1) << -exponent);
}

graze::interval<> enclosure_of(const rational& x) {
  const integer n = numerator_of(x), d = denominator_of(x);
  if (n.sign() >= 0)
    return {rounded(n, d, false), rounded(n, d, true)};
  return {-rounded(-n, d, true), -rounded(-n, d, false)};
}

std::optional<rational> exact_literal(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    const auto magnitude = exact_literal(text.substr(1));
    return magnitude && text[0] == '-' ? std::optional(rational(-*magnitude)) : magnitude;
  }
  const bool hexadecimal = text.size() > 1 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  const char mark = hexadecimal ? 'p' : 'e';
  integer n(0);
  int after_point = 0, exponent = 0;
  bool point = false;
  std::size_t i = hexadecimal ? 2 : 0;
  for (; i < text.size() && (text[i] | 0x20) != mark; ++i) {
    const char c = static_cast<char>(text[i] | 0x20);
    if (text[i] == '.') {
      point = true;
      continue;
    }
    n = n * (hexadecimal ? 16 : 10) + (c >= 'a' ? c - 'a' + 10 : text[i] - '0');
    after_point += point ? 1 : 0;
  }
  if (i < text.size()) {
    const bool negative = text[++i] == '-';
    i += negative || text[i] == '+' ? 1 : 0;
    for (; i < text.size() && exponent < 10000; ++i)
      exponent = 10 * exponent + (text[i] - '0');
    exponent = negative ? -exponent : exponent;
  }
  if (n.is_zero())
    return rational(0);
  exponent -= after_point * (hexadecimal ? 4 : 1);
  constexpr int most = static_cast<int>(number::most_bits);
  if (std::abs(exponent) > (hexadecimal ? most : most / 3) || bits_of(n) > 2 * number::most_bits)
    return std::nullopt;
  const auto size = static_cast<unsigned>(std::abs(exponent));
  const integer scale = hexadecimal ? integer(1) << size : pow(integer(10), size);
  const rational x = exponent >= 0 ? rational(n * scale) : rational(n, scale);
  return is_small(x) ? std::optional(x) : std::nullopt;
}

number::number(const rational& x) : enclosure_(enclosure_of(x)) {
  if (!is_double())
    exact_ = std::make_shared<const rational>(x);
}

std::optional<rational> number::exact() const {
  if (exact_)
    return *exact_;
  return is_double() ? std::optional(exactly(lower())) : std::nullopt;
}

number number::operator-() const {
  number r(-enclosure_);
  if (exact_)
    r.exact_ = std::make_shared<const rational>(-*exact_);
  return r;
}

number operator+(const number& x, const number& y) {
  return result_of(x, y, x.enclosure_ + y.enclosure_,
                   [](const rational& a, const rational& b) { return rational(a + b); });
}
number operator-(const number& x, const number& y) { return x + -y; }
number operator*(const number& x, const number& y) {
  return result_of(x, y, x.enclosure_ * y.enclosure_,
                   [](const rational& a, const rational& b) { return rational(a * b); });
}
number operator/(const number& x, const number& y) {
  const number::interval quotient = operations<number::interval>::div(x.enclosure_, y.enclosure_);
  if (!(y.lower() > 0 || y.upper() < 0))
    return number(quotient);
  return result_of(x, y, quotient,
                   [](const rational& a, const rational& b) { return rational(a / b); });
}

bool operator==(const number& x, const number& y) {
  return x.lower() == y.lower() && x.upper() == y.upper() && !x.exact_ == !y.exact_ &&
         (!x.exact_ || *x.exact_ == *y.exact_);
}

} // namespace graze::octree::tape
