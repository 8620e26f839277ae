// Literals: what they mean is built here from their parts as a rational, never from the text; the
// bounds must be the greatest double <= it and the least >= it.
#include "exact_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/boolean.hpp>
#include <graze/oracle/hard_boxes.hpp>
#include <graze/text.hpp>
#include <sstream>

using graze::bounds;
using graze::decoration;
using graze::exception;
using graze::interval_to_text;
using graze::text_style;
using graze::text_to_decorated;
using graze::text_to_interval;
using graze::oracle::hard_operands;
using graze::test::inputs;
using graze::test::rational;
using graze::test::same;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

/// Without operator+ on temporaries, of which GCC 12 warns wrongly (-Wrestrict).
std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts)
    text.append(part);
  return text;
}

mpq_class power(unsigned base, long exponent) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), base, static_cast<unsigned long>(std::labs(exponent)));
  return exponent < 0 ? mpq_class(1) / mpq_class(p) : mpq_class(p);
}

/// A number as text, in any form that the grammar has, and its value.
struct literal {
  std::string text;
  mpq_class value;
};

class literals {
public:
  explicit literals(std::uint64_t seed) : numbers(seed) {}

  literal number() {
    switch (numbers.below(4)) {
    case 0:
      return hexadecimal();
    case 1:
      return quotient();
    case 2:
      return of_double();
    default:
      return decimal();
    }
  }

  std::string digits(std::size_t count, std::uint64_t base = 10) {
    static const char set[] = "0123456789abcdefABCDEF";
    std::string s;
    const std::uint64_t choice = base == 16 ? 22 : 10;
    while (s.size() < count)
      s += set[numbers.below(8) == 0 ? 0 : numbers.below(choice)];
    return s;
  }
  /// Digits with a point somewhere, and how many follow it.
  std::pair<std::string, long> pointed(const std::string& all) {
    const std::size_t after = numbers.below(all.size() + 1);
    if (after == 0 && numbers.coin())
      return {all, 0};
    return {all.substr(0, all.size() - after) + "." + all.substr(all.size() - after),
            static_cast<long>(after)};
  }
  std::string sign(bool negative) { return negative ? "-" : numbers.below(4) == 0 ? "+" : ""; }
  std::string exponent_of(long e) {
    return joined(
        {numbers.coin() ? "e" : "E", e >= 0 && numbers.coin() ? "+" : "", std::to_string(e)});
  }
  std::size_t length() { return 1 + numbers.below(numbers.below(50) == 0 ? 900 : 30); }
  long exponent() {
    return numbers.coin() ? static_cast<long>(numbers.below(40)) - 20
                          : static_cast<long>(numbers.below(760)) - 380;
  }
  static mpz_class integer(const std::string& all, int base) { return mpz_class(all, base); }

  hard_operands numbers;

private:
  literal decimal() {
    const std::string all = digits(length());
    const auto [text, places] = pointed(all);
    const bool negative = numbers.coin();
    const bool scaled = numbers.below(3) != 0;
    const long e = scaled ? exponent() : 0;
    mpq_class value = mpq_class(integer(all, 10)) * power(10, e - places);
    return {sign(negative) + text + (scaled ? exponent_of(e) : ""),
            negative ? mpq_class(-value) : value};
  }
  literal hexadecimal() {
    const std::string all = digits(length(), 16);
    const auto [text, places] = pointed(all);
    const bool negative = numbers.coin();
    const long e = static_cast<long>(numbers.below(2400)) - 1200;
    mpq_class value = mpq_class(integer(all, 16)) * power(2, e - 4 * places);
    return {joined({sign(negative), numbers.coin() ? "0x" : "0X", text, numbers.coin() ? "p" : "P",
                    std::to_string(e)}),
            negative ? mpq_class(-value) : value};
  }
  literal quotient() {
    const std::string p = digits(length()), q = digits(length()) + "1";
    const bool negative = numbers.coin();
    mpq_class value(integer(p, 10), integer(q, 10));
    value.canonicalize();
    return {sign(negative) + p + "/" + q, negative ? mpq_class(-value) : value};
  }
  /// The exact decimal of a double, or that with one digit more: on and beside the rounding's edge.
  literal of_double() {
    double x = numbers
                   .next(static_cast<graze::oracle::hardness>(
                       numbers.below(static_cast<int>(graze::oracle::hardness::count))))
                   .x;
    if (!std::isfinite(x))
      x = largest;
    char text[1200];
    std::snprintf(text, sizeof text, "%.1100e", x);
    std::string all(text);
    const std::size_t e = all.find('e');
    const bool beyond = numbers.coin();
    mpq_class value = rational(x);
    if (beyond) {
      const int scale = std::atoi(all.c_str() + e + 1);
      all.insert(e, 1, '1');
      value += (x < 0 || (x == 0 && std::signbit(x)) ? -1 : 1) * power(10, scale - 1101);
    }
    return {all, value};
  }
};

std::string blanks(hard_operands& numbers) {
  static const char* const some[] = {"", " ", "\t", "  "};
  return some[numbers.below(4)];
}

} // namespace

TEST_CASE("interval.text: literals of every form are enclosed tightest", "[mpfr][hardcase]") {
  literals source(8);
  auto& numbers = source.numbers;
  for (int i = 0; i < inputs() / 4; ++i) {
    literal a = source.number(), b = source.number();
    if (numbers.below(4) == 0)
      b = a;
    if (a.value > b.value)
      std::swap(a, b);
    const std::string text = joined({"[", blanks(numbers), a.text, blanks(numbers), ",",
                                     blanks(numbers), b.text, blanks(numbers), "]"});
    CAPTURE(text);
    const bounds expected = graze::test::enclosure(a.value, b.value);
    const auto got = text_to_interval(text);
    REQUIRE(same(got.value, expected));
    REQUIRE(same(text_to_interval(joined({"[", a.text, "]"})).value,
                 graze::test::enclosure(a.value, a.value)));
    REQUIRE(same(text_to_interval(joined({"[", a.text, ",]"})).value, {expected.lo, infinity}));
    REQUIRE(
        same(text_to_interval(joined({"[-INF,", b.text, "]"})).value, {-infinity, expected.hi}));
    // told apart from equal ends, however they are written
    const bounds lower = graze::test::enclosure(a.value, a.value);
    const bool one_gap = a.value != b.value && lower.lo != lower.hi &&
                         same(lower, graze::test::enclosure(b.value, b.value));
    REQUIRE((got.signal == exception::possibly_undefined_operation) == one_gap);
    const auto exchanged = text_to_interval(joined({"[", b.text, ",", a.text, "]"}));
    if (a.value == b.value || one_gap) {
      REQUIRE(same(exchanged.value, expected));
      REQUIRE(exchanged.signal == got.signal);
    } else {
      REQUIRE(exchanged.value.is_empty());
      REQUIRE(exchanged.signal == exception::undefined_operation);
    }
  }
}

TEST_CASE("interval.text: uncertain literals", "[mpfr][hardcase]") {
  literals source(9);
  auto& numbers = source.numbers;
  for (int i = 0; i < inputs() / 4; ++i) {
    const std::string all = source.digits(source.length());
    const auto [significand, places] = source.pointed(all);
    const bool negative = numbers.coin(), scaled = numbers.coin();
    const long e = scaled ? source.exponent() : 0;
    const std::string radius = numbers.coin() ? "" : source.digits(source.length());
    static const char* const directions[] = {"", "u", "d", "U"};
    const std::string direction = directions[numbers.below(4)];
    const std::string text = source.sign(negative) + significand + "?" + radius + direction +
                             (scaled ? source.exponent_of(e) : "");
    const mpq_class unit = power(10, e - places);
    mpq_class middle = mpq_class(mpz_class(all, 10)) * unit;
    if (negative)
      middle = -middle;
    const mpq_class r =
        radius.empty() ? mpq_class(unit / 2) : mpq_class(mpq_class(mpz_class(radius, 10)) * unit);
    const bool up = direction == "u" || direction == "U", down = direction == "d";
    const bounds expected = graze::test::enclosure(up ? middle : mpq_class(middle - r),
                                                   down ? middle : mpq_class(middle + r));
    CAPTURE(text);
    REQUIRE(same(text_to_interval(text).value, expected));
    REQUIRE(text_to_decorated(text + "_com").value.label ==
            (expected.is_common() ? decoration::com : decoration::dac));
    const std::string unlimited = source.sign(negative) + significand + "??" + direction +
                                  (scaled ? source.exponent_of(e) : "");
    const bounds middle_only = graze::test::enclosure(middle, middle);
    REQUIRE(same(text_to_interval(unlimited).value,
                 {up ? middle_only.lo : -infinity, down ? middle_only.hi : infinity}));
  }
}

TEST_CASE("interval.text: words, decorations, and what is no literal", "[unit]") {
  for (const char* text : {"[]", "[ ]", "[empty]", "[ Empty\t]", "[EMPTY]"})
    CHECK((text_to_interval(text).value.is_empty() &&
           text_to_interval(text).signal == exception::none));
  for (const char* text :
       {"[,]", "[entire]", "[ ENTIRE ]", "[-inf,]", "[,+Infinity]", "[ -inf , INF ]", "7\?\?"})
    CHECK(graze::is_entire(text_to_interval(text).value));
  for (const char* text :
       {"",        " ",       "[",         "]",           "[1",          "1]",
        "1",       "[1,2",    "[1,2]]",    "[1,2] ",      " [1,2]",      "[1 2]",
        "[1,,2]",  "[1,2,3]", "[a]",       "[1e]",        "[1e+]",       "[.]",
        "[+]",     "[0x]",    "[0x1]",     "[0xp1]",      "[0x1p]",      "[0x1.8q1]",
        "[1/0]",   "[1/-2]",  "[1./2]",    "[1.5/2]",     "[1/2.5]",     "[1/2e3]",
        "[1/]",    "[/2]",    "[--1]",     "[+-1]",       "[- 1]",       "[1 e5]",
        "[inf]",   "[-inf]",  "[inf,inf]", "[-inf,-inf]", "[inf,-inf]",  "[1,-inf]",
        "[inf,1]", "[2,1]",   "[nan]",     "[nai]",       "[e mpty]",    "[empty,]",
        "[entire", "?",       "1?1?",      "1?1uu",       "1?ud",        "1?-1",
        "1?1e",    "0x1?",    "inf?",      "[1?]",        "1\?\?1",      "?1",
        ".?",      "1,2",     "(1,2)",     "[1,2]_com",   "[empty]_trv", "3?_com",
        "[1;2]",   "[1,2\n]", "[infinit]", "[in]"}) {
    CAPTURE(text);
    CHECK(text_to_interval(text).value.is_empty());
    CHECK(text_to_interval(text).signal == exception::undefined_operation);
  }
  CHECK(text_to_interval(std::string_view("[1,2]\0", 6)).signal == exception::undefined_operation);
  CHECK(text_to_interval(std::string_view("[1\0,2]", 6)).signal == exception::undefined_operation);
  CHECK(text_to_interval("[1.,.5e1]").value.hi == 5);
  CHECK(text_to_interval("[007/014]").value.lo == 0.5);

  using enum decoration;
  struct row {
    const char* text;
    decoration label;
  };
  for (const row& r : {row{"[1,2]", com},
                       {"[1,2]_com", com},
                       {"[1,2]_DAC", dac},
                       {"[1,2]_Def", def},
                       {"[1,2]_trv", trv},
                       {"[1,]", dac},
                       {"[1,]_def", def},
                       {"[entire]_dac", dac},
                       {"[empty]", trv},
                       {"[]_trv", trv},
                       {"[1e400]_com", dac},
                       {"[1e400]_def", def},
                       {"3.5?1_dac", dac},
                       {"3\?\?u", dac},
                       {"1/3", ill},
                       {"[nai]", ill},
                       {"[ NaI ]", ill}}) {
    CAPTURE(r.text);
    CHECK(text_to_decorated(r.text).value.label == r.label);
  }
  CHECK(text_to_decorated("[nai]").signal == exception::none);
  for (const char* text : {"[1,]_com", "[entire]_com", "[empty]_def", "[]_com", "3\?\?_com",
                           "[1,2]_ill", "[nai]_ill", "[nai]_trv", "[1,2]_", "[1,2]com",
                           "[1,2]_comx", "[1,2] _com", "[1,2]_ com", "[2,1]_trv", "[2,1]"}) {
    CAPTURE(text);
    CHECK(text_to_decorated(text).value.is_nai());
    CHECK(text_to_decorated(text).signal == exception::undefined_operation);
  }
}

TEST_CASE("interval.text: numbers of any size and length", "[hardcase]") {
  const double least = 0x1p-1074;
  struct row {
    std::string number;
    bounds value;
  };
  const std::string zeros(100000, '0'), nines(20000, '9'),
      long_exponent = joined({"1", std::string(5000, '0')});
  const row rows[] = {
      {"1e999999999999999999999", {largest, infinity}},
      {"-1e999999999999999999999", {-infinity, -largest}},
      {"1e-999999999999999999999", {0, least}},
      {"-1e-99999999999", {-least, 0}},
      {"0e99999999999999999999", {0, 0}},
      {"0x1p9223372036854775808", {largest, infinity}},
      {"0x1p-99999999999999999999999", {0, least}},
      {"1e" + long_exponent, {largest, infinity}},
      {"0." + zeros + "1e100001", {1, 1}},
      {"1" + zeros + "e-100000", {1, 1}},
      {"1" + zeros + ".e-100001", {0x1.9999999999999p-4, 0x1.999999999999ap-4}},
      {"0x1" + zeros + "p-400000", {1, 1}},
      {"0x." + zeros + "1p400004", {1, 1}},
      {"0." + nines, {0x1.fffffffffffffp-1, 1}},
      {"1" + zeros + "/1" + zeros, {1, 1}},
      {joined({nines, "/1", std::string(20000, '0')}), {0x1.fffffffffffffp-1, 1}},
      {joined({"1/", std::string(400, '9')}), {0, least}},
  };
  for (const row& r : rows) {
    CAPTURE(r.number.substr(0, 60));
    CHECK(same(text_to_interval(joined({"[", r.number, "]"})).value, r.value));
  }
  // in one gap beyond the largest double: the order stays open unless they are one number
  CHECK(text_to_interval("[1e999999999, 10e999999998]").signal == exception::none);
  CHECK(text_to_interval("[1e999999999, 2e999999999]").signal ==
        exception::possibly_undefined_operation);
  CHECK(text_to_interval("[0x1p99999999, 1e99999999]").signal ==
        exception::possibly_undefined_operation);
  CHECK(text_to_interval("[0x1p1100, 0x10p1096]").signal == exception::none);
  CHECK(text_to_interval("[1e-999999999, 0.1e-999999998]").signal == exception::none);
  CHECK(text_to_interval("[1e400, 1e300]").signal == exception::undefined_operation);
  CHECK(same(text_to_interval("1?99999999999999999999e99999999999999").value, bounds::entire()));
  CHECK(same(text_to_interval("1?e-99999999999999").value, {0, least}));
  CHECK(same(text_to_interval("1?2e-99999999999999").value, {-least, least}));
}

TEST_CASE("interval.text: written text holds the interval and reads back", "[mpfr][hardcase]") {
  graze::oracle::hard_boxes boxes(10);
  for (int i = 0; i < inputs() / 4; ++i) {
    const bounds x = boxes.next();
    CAPTURE(x.lo, x.hi);
    for (const text_style style : {text_style::hexadecimal, text_style::exact_decimal}) {
      const auto back = text_to_interval(interval_to_text(x, style));
      REQUIRE(back.signal == exception::none);
      REQUIRE(same(back.value, x));
    }
    const std::string text = interval_to_text(x);
    const auto back = text_to_interval(text);
    CAPTURE(text);
    REQUIRE(back.signal == exception::none);
    REQUIRE(x.within(back.value));
    if (!x.is_empty()) {
      REQUIRE(back.value.lo >= std::nextafter(x.lo, -infinity));
      REQUIRE((back.value.hi <= std::nextafter(x.hi, infinity) &&
               (back.value.hi < infinity) == (x.hi < infinity)));
      REQUIRE((back.value.lo > -infinity) == (x.lo > -infinity));
    }
    const auto decorated =
        text_to_decorated(interval_to_text(graze::new_dec(x), text_style::hexadecimal));
    REQUIRE(same(decorated.value.part, x));
    REQUIRE(decorated.value.label == graze::new_dec(x).label);
  }
}

TEST_CASE("interval.text: no shorter decimal lies between the bound and the next double",
          "[mpfr]") {
  literals source(11);
  for (int i = 0; i < inputs() / 10; ++i) {
    const double x = std::fabs(source.numbers
                                   .next(static_cast<graze::oracle::hardness>(source.numbers.below(
                                       static_cast<int>(graze::oracle::hardness::count))))
                                   .x);
    if (!(x > 0 && x < largest))
      continue;
    const std::string text = interval_to_text(bounds{x, largest});
    std::string number = text.substr(1, text.find(',') - 1);
    CAPTURE(text);
    // its digits, and the place of the last that is not 0
    const std::size_t e = number.find('e');
    long scale = e == std::string::npos ? 0 : std::atol(number.c_str() + e + 1);
    number = number.substr(0, e);
    if (const std::size_t point = number.find('.'); point != std::string::npos) {
      scale -= static_cast<long>(number.size() - point - 1);
      number.erase(point, 1);
    }
    mpq_class value = mpq_class(mpz_class(number, 10)) * power(10, scale);
    const mpq_class lower = rational(std::nextafter(x, 0));
    REQUIRE((value <= rational(x) && value > lower));
    number.erase(0, number.find_first_not_of('0'));
    for (; number.back() == '0'; number.pop_back())
      ++scale;
    if (number.size() > 17) // never more than 17, unless x is that number
      REQUIRE(value == rational(x));
    // one digit less, from below: too far
    const mpz_class cut = [&] {
      const mpq_class scaled = rational(x) / power(10, scale + 1);
      return mpz_class(scaled.get_num() / scaled.get_den());
    }();
    REQUIRE(mpq_class(cut) * power(10, scale + 1) <= lower);
  }
}

TEST_CASE("interval.text: as people write it", "[unit]") {
  CHECK(interval_to_text(bounds{1, 2}) == "[1, 2]");
  CHECK(interval_to_text(bounds{3, 3}) == "[3]");
  CHECK(interval_to_text(bounds{-0.0, 0.5}) == "[0, 0.5]");
  CHECK(interval_to_text(bounds{0.1, 0.1}) == "[0.1, 0.10000000000000001]");
  CHECK(interval_to_text(bounds{1, 0x1.fffffffffffffp+0}) == "[1, 1.9999999999999998]"); // not 2
  CHECK(interval_to_text(bounds{-1e300, 1e-7}) == "[-1.0000000000000001e300, 1e-7]");
  CHECK(interval_to_text(bounds{-infinity, 123456}) == "[-inf, 123456]");
  CHECK(interval_to_text(bounds::entire()) == "[entire]");
  CHECK(interval_to_text(bounds::empty()) == "[empty]");
  CHECK(interval_to_text(bounds{0x1p-1074, largest}, text_style::hexadecimal) ==
        "[0x1p-1074, 0x1.fffffffffffffp+1023]");
  CHECK(interval_to_text(graze::decorated_bounds::nai()) == "[nai]");
  CHECK(interval_to_text(graze::new_dec({1, infinity})) == "[1, inf]_dac");
  CHECK(interval_to_text(graze::interval<>(1.0, 2.0)) == "[1, 2]");
  std::ostringstream out;
  out << bounds{1, 2} << ' ' << graze::new_dec({1, 2}) << ' ' << std::hexfloat << bounds{1, 1.5};
  CHECK(out.str() == "[1, 2] [1, 2]_com [0x1p+0, 0x1.8p+0]");
}
