/// Interval literals: whatever the text, the result is an interval; of decimal literals it is the
/// tightest enclosure, by rationals; and what is written reads back.
#include "target.hpp"
#include <gmpxx.h>
#include <graze/oracle/elementary.hpp>
#include <graze/text.hpp>
#include <optional>

using namespace graze;

namespace {

bool is_interval(const bounds& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return x.is_empty() || (x.lo <= x.hi && x.lo < infinity && -infinity < x.hi);
}
bool same(const bounds& x, const bounds& y) {
  return x.is_empty() ? y.is_empty() : x.lo == y.lo && x.hi == y.hi;
}

/// [-+]digits[.digits][e[-+]digits] at the front of the text, which is taken off; exponents to
/// three digits. Read here anew: the judge shares nothing with the parser.
std::optional<mpq_class> decimal(std::string_view& text) {
  const auto digit = [&] { return !text.empty() && '0' <= text[0] && text[0] <= '9'; };
  const auto take = [&](std::string_view any) {
    if (text.empty() || any.find(text[0]) == std::string_view::npos)
      return '\0';
    const char c = text[0];
    text.remove_prefix(1);
    return c;
  };
  const bool negative = take("+-") == '-';
  std::string digits;
  long exponent = 0;
  for (; digit(); text.remove_prefix(1))
    digits += text[0];
  if (take(".") != '\0')
    for (; digit(); text.remove_prefix(1), --exponent)
      digits += text[0];
  if (digits.empty())
    return std::nullopt;
  if (take("eE") != '\0') {
    const bool down = take("+-") == '-';
    long power = 0;
    int count = 0;
    for (; digit() && count < 4; text.remove_prefix(1), ++count)
      power = power * 10 + (text[0] - '0');
    if (count < 1 || count > 3)
      return std::nullopt;
    exponent += down ? -power : power;
  }
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10,
                static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  mpq_class value(mpz_class(digits, 10));
  if (exponent < 0)
    value /= power;
  else
    value *= power;
  return negative ? mpq_class(-value) : value;
}

/// What "[a]" and "[a,b]" mean, for decimals without blanks; nothing for other text.
std::optional<std::array<mpq_class, 2>> meaning(std::string_view text) {
  if (text.size() < 3 || text.size() > 300 || text.front() != '[' || text.back() != ']')
    return std::nullopt;
  text = text.substr(1, text.size() - 2);
  const auto lower = decimal(text);
  if (!lower)
    return std::nullopt;
  if (text.empty())
    return {{*lower, *lower}};
  if (text.front() != ',')
    return std::nullopt;
  text.remove_prefix(1);
  const auto upper = decimal(text);
  if (!upper || !text.empty())
    return std::nullopt;
  return {{*lower, *upper}};
}

double rounded(const mpq_class& q, mpfr_rnd_t to) {
  return oracle::rounded(
      [&](mpfr_ptr result, mpfr_rnd_t mode) { return mpfr_set_q(result, q.get_mpq_t(), mode); },
      to);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using fuzz::target::require;
  const std::string text = fuzz::target::text_of({data, size});
  const auto read = text_to_interval(text);
  const bounds& x = read.value;
  require(is_interval(x), "no interval");
  if (read.signal == exception::undefined_operation)
    require(x.is_empty(), "undefined, but not empty");
  if (const auto means = meaning(text)) {
    const auto& [lower, upper] = *means;
    if (lower <= upper) {
      require(read.signal != exception::undefined_operation, "a decimal literal was refused");
      require(same(x, {rounded(lower, MPFR_RNDD), rounded(upper, MPFR_RNDU)}),
              "not the tightest enclosure");
    } else if (read.signal == exception::possibly_undefined_operation) {
      require(mpq_class(x.lo) <= upper && lower <= mpq_class(x.hi), "does not hold both ends");
    } else {
      require(read.signal == exception::undefined_operation, "ends in the wrong order were taken");
    }
  }
  require(same(text_to_interval(interval_to_text(x, text_style::hexadecimal)).value, x),
          "hexadecimal text does not read back");
  require(same(text_to_interval(interval_to_text(x, text_style::exact_decimal)).value, x),
          "exact decimal text does not read back");
  const bounds shown = text_to_interval(interval_to_text(x)).value;
  require(is_interval(shown) && (x.is_empty() || (shown.lo <= x.lo && x.hi <= shown.hi)),
          "decimal text does not enclose");
  const auto decorated = text_to_decorated(text);
  const bounds part = interval_part(decorated.value).value;
  require(is_interval(part), "no decorated interval");
  if (read.signal == exception::none) // without a decoration the same text means the same
    require(same(part, x), "the decorated interval is another");
  return 0;
}

std::vector<std::string> fuzz::target::seeds() {
  return {"[1.5]",
          "[1, 2]",
          "[-0x1.8p-3, 1/3]",
          "[,3]",
          "[-inf, 3]",
          "[entire]",
          "[ ]",
          "[empty]",
          "3.56?",
          "3.56?12",
          "3.56??",
          "3.56?1ue-2",
          "[1,2]_com",
          "[nai]",
          "[1e400]",
          "[0.1,0.1]",
          "[-1e-324]",
          "[0x.8p-1074]",
          "[0.1,0.09]",
          "[2,1]",
          "[1e-999999999999999999999]",
          "[10/20]_dac",
          "-10?3d_trv",
          "[0.1,0.3e-1]",
          "[-.5e2,+1.]",
          "[1.0000000000000000000000000001,1.0000000000000000000000000000]"};
}
