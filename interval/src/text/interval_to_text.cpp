#include "../border.hpp"
#include "../exact/natural.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <graze/text.hpp>
#include <limits>
#include <ostream>

namespace graze {

namespace {

using detail::natural;

/// 0.digits * 10^point; the first and the last digit are not 0. No digit: 0.
struct decimal {
  std::string digits;
  int point = 0;
};

bool less(const decimal& x, const decimal& y) {
  if (x.digits.empty() || y.digits.empty())
    return !y.digits.empty() && x.digits.empty();
  return x.point != y.point ? x.point < y.point : x.digits < y.digits;
}

/// |x|, every digit. For finite x.
decimal decimal_of(double x) {
  if (x == 0)
    return {};
  const rounding::exact::magnitude m = rounding::exact::take_apart(x);
  natural n = m.significand;
  int places = 0;
  if (m.exponent >= 0) {
    n <<= static_cast<std::uint64_t>(m.exponent);
  } else { // n 2^e = n 5^-e 10^e, the trailing zeros of n first
    const int zeros = std::min(static_cast<int>(n.trailing_zeros()), -m.exponent);
    n >>= static_cast<std::uint64_t>(zeros);
    places = -m.exponent - zeros;
    n = n * natural::power_of_five(static_cast<std::uint64_t>(places));
  }
  decimal d{n.decimal(), 0};
  d.point = static_cast<int>(d.digits.size()) - places;
  d.digits.erase(d.digits.find_last_not_of('0') + 1);
  return d;
}

/// The first `count` digits of d, or the next number of as many digits.
decimal shortened(const decimal& d, std::size_t count, bool away) {
  if (count >= d.digits.size())
    return d;
  decimal s{d.digits.substr(0, count), d.point};
  if (away) {
    const std::size_t last = s.digits.find_last_not_of('9');
    if (last == std::string::npos)
      return {"1", d.point + 1};
    s.digits.erase(last + 1);
    ++s.digits[last];
  } else {
    s.digits.erase(s.digits.find_last_not_of('0') + 1);
  }
  return s;
}

/// The shortest decimal from |x| to the next double in that direction, without that one. The next
/// double exists. 17 digits suffice: they are closer than doubles are (10^-16 < 2^-53), and so are
/// as many as x has if those are fewer.
decimal shortest(double x, bool away) {
  const decimal exact = decimal_of(x);
  const double towards = away ? std::numeric_limits<double>::infinity() : 0;
  const decimal limit = decimal_of(std::nextafter(std::fabs(x), towards));
  for (std::size_t count = 1; count < exact.digits.size(); ++count) {
    const decimal candidate = shortened(exact, count, away);
    if (away ? less(candidate, limit) : less(limit, candidate))
      return candidate;
  }
  return exact;
}

/// Positional from 10^-5 to 10^21, else with an exponent.
std::string written(const decimal& d) {
  if (d.digits.empty())
    return "0";
  const int size = static_cast<int>(d.digits.size());
  std::string text;
  if (d.point < -4 || d.point > 21) {
    text = d.digits;
    if (size > 1)
      text.insert(1, 1, '.');
    return text.append("e").append(std::to_string(d.point - 1));
  }
  if (d.point <= 0)
    return text.append("0.").append(static_cast<std::size_t>(-d.point), '0').append(d.digits);
  text = d.digits;
  if (d.point >= size)
    return text.append(static_cast<std::size_t>(d.point - size), '0');
  return text.insert(static_cast<std::size_t>(d.point), 1, '.');
}

/// As printf's %a writes normal numbers: 0x1.8p+1, subnormal ones too.
std::string hexadecimal(double x) {
  if (x == 0)
    return "0x0p+0";
  const rounding::exact::magnitude m = rounding::exact::take_apart(x);
  std::string text = "0x1";
  if (std::uint64_t fraction = m.significand - rounding::exact::hidden_bit; fraction != 0) {
    text += '.';
    for (; fraction != 0; fraction = (fraction << 4) & (rounding::exact::hidden_bit - 1))
      text += "0123456789abcdef"[fraction >> 48];
  }
  const int exponent = m.exponent + 52;
  return text + (exponent < 0 ? "p" : "p+") + std::to_string(exponent);
}

std::string written(double x, bool up, text_style style) {
  if (std::isinf(x))
    return x < 0 ? "-inf" : "inf";
  const std::string sign = x < 0 ? "-" : "";
  const bool away = up != (x < 0);
  // beyond the last double there is none to stay before
  const bool last = away && std::fabs(x) == std::numeric_limits<double>::max();
  if (style == text_style::hexadecimal || (style == text_style::decimal && last))
    return sign + hexadecimal(x);
  return sign + written(style == text_style::decimal ? shortest(x, away) : decimal_of(x));
}

std::ostream& print(std::ostream& out, const auto& x) {
  const auto hexfloat = std::ios_base::fixed | std::ios_base::scientific;
  const bool wanted = (out.flags() & std::ios_base::floatfield) == hexfloat;
  return out << interval_to_text(x, wanted ? text_style::hexadecimal : text_style::decimal);
}

} // namespace

namespace inside {
std::string text_of(bounds x, text_style style) {
  if (x.is_empty())
    return "[empty]";
  if (x.lo == -checking::infinity && x.hi == checking::infinity)
    return "[entire]";
  const std::string lower = written(x.lo, false, style), upper = written(x.hi, true, style);
  return lower == upper ? "[" + lower + "]" : "[" + lower + ", " + upper + "]";
}
} // namespace inside

std::string interval_to_text(const bounds& x, text_style style) {
  return at_border<inside::text_of>(x, style);
}

std::string interval_to_text(const decorated_bounds& x, text_style style) {
  if (x.is_nai())
    return "[nai]";
  return interval_to_text(x.part, style) + "_" + name_of(x.label);
}

std::ostream& operator<<(std::ostream& out, const bounds& x) { return print(out, x); }
std::ostream& operator<<(std::ostream& out, const decorated_bounds& x) { return print(out, x); }

} // namespace graze
