// The parser: what it takes, what it refuses and where, and that nothing makes it fall over.
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree_formula.hpp>
#include <random>
#include <string>

using namespace graze;
using namespace graze::octree;

namespace {

/// At (3, 5, 7), in doubles.
double value(const std::string& text) {
  const auto f = formula::parse(text);
  INFO(text << ": " << f.reason());
  REQUIRE(f);
  return f->surface()(3.0, 5.0, 7.0);
}

interval<> enclosure(const std::string& text) {
  const auto f = formula::parse(text);
  REQUIRE(f);
  using I = interval<>;
  return f->surface()(I(3), I(5), I(7));
}

void refused(const std::string& text, std::size_t column, const std::string& why) {
  std::size_t at = 0;
  const auto f = formula::parse(text, &at);
  INFO(text.substr(0, 80) << ": " << f.reason());
  REQUIRE_FALSE(f);
  CHECK(at == column);
  CHECK(f.reason().rfind("column " + std::to_string(column) + ": ", 0) == 0);
  CHECK(f.reason().find(why) != std::string::npos);
}

} // namespace

TEST_CASE("octree.formula: means what is written", "[unit]") {
  const std::pair<const char*, double> table[] = {
      {"x", 3},
      {" x\t+\ny ", 8},
      {"x-y-z", -9},
      {"x-(y-z)", 5},
      {"2*x+3*y", 21},
      {"z/2/7", 0.5},
      {"z/(2*7)", 0.5},
      {"-x^2", -9},
      {"(-x)^2", 9},
      {"2^x^2", 512},
      {"(2^x)^2", 64},
      {"2^-1", 0.5},
      {"x^-2*9", 1},
      {"--x", 3},
      {"x - -y", 8},
      {"x*-y", -15},
      {"+x", 3},
      {"5x^2", 45},
      {"2x y", NAN},
      {"2(x+1)(y-1)", 32},
      {"(x)(y)", 15},
      {"2 pi - 2pi + x", 3},
      {"2e3x", 6000},
      {"2exp(0)x", 6},
      {"0x1.8p1x", 9},
      {"0X10", 16},
      {"0x^2 + x", 3},
      {".5x", 1.5},
      {"5.x", 15},
      {"1E2", 100},
      {"x^0", 1},
      {"x^1", 3},
      {"x^3-x", 24},
      {"x*x*x-x", 24},
      {"x*(x-1)*(x+1)", 24},
      {"x^2-4x+4", 1},
      {"x^5-3x^2+y^4-y", 836},
      {"(x+y)^3", 512},
      {"sqr(y)", 25},
      {"sqrt(x+6)", 3},
      {"(x+6)^0.5", 3},
      {"cbrt(x^3)", 3},
      {"rootn(x^3, 3)", 3},
      {"rootn(x^4, 2)", 9},
      {"pown(x, 3)", 27},
      {"pown(x, -1)*3", 1},
      {"pow(x+1, 1.5)", 8},
      {"abs(x-y)", 2},
      {"min(x,y)", 3},
      {"max(x,y,z)", 7},
      {"union(z,y,x)", 3},
      {"intersection(x,y)", 5},
      {"difference(x,y)", 3},
      {"difference(x,-y)", 5},
      {"hypot(x, 4)", 5},
      {"atan2(0, x)", 0},
      {"exp(0*x)", 1},
      {"log(e^x)", 3},
      {"ln(e)", 1},
      {"log2(2^x)", 3},
      {"log10(10^x)", 3},
      {"log1p(x-3)", 0},
      {"sin(0)", 0},
      {"cos(x-3)", 1},
      {"acos(x-2)", 0},
      {"tanh(0x)", 0},
      {"floor(y/2)", 2},
      {"ceil(y/2)", 3},
      {"trunc(-y/2)", -2},
      {"sign(-y)", -1},
      {"x/x", 1},
      {"x-x", 0},
      {"0*x+y", 5},
  };
  for (const auto& [text, expected] : table) {
    INFO(text);
    if (std::isnan(expected)) {
      CHECK_FALSE(formula::parse(text));
      continue;
    }
    CHECK(value(text) == Approx(expected).margin(1e-12));
    const auto v = enclosure(text);
    CHECK(v.lower() <= expected + 1e-12);
    CHECK(v.upper() >= expected - 1e-12);
    CHECK(v.upper() - v.lower() < 1e-11 * (1 + std::fabs(expected)));
  }
}

TEST_CASE("octree.formula: a number that is no double is enclosed by its neighbours", "[unit]") {
  for (const char* text : {"0.1", "11.8", "1e-400", "0.3333333333333333333333333333333333333333",
                           "123456789012345678901234567890", "0x1.00000000000001p0", "pi", "e"}) {
    INFO(text);
    const auto v = enclosure(text);
    CHECK(std::nextafter(v.lower(), INFINITY) == v.upper());
  }
  for (const char* text : {"0.5", "1e22", "0x1.fffffffffffffp1023", "0x0.0000000000001p-1022", "1",
                           "9007199254740992"}) {
    INFO(text);
    const auto v = enclosure(text);
    CHECK(v.lower() == v.upper());
  }
  // decimals are the numbers that are written, in sums, products, quotients and powers as well
  for (const char* text :
       {"0.1+0.2-0.3", "0.1*3-0.3", "1/3*3-1", "0.1^20*1e20-1", "1e-300*1e300-1"}) {
    INFO(text);
    CHECK(enclosure(text).lower() == 0);
    CHECK(enclosure(text).upper() == 0);
  }
  CHECK(enclosure("0.1+0.2-0.3+1e-300").lower() > 0);
  // the real number 59/5 less 3 * 25/4
  CHECK(enclosure("11.8-3*6.25").lower() <= -6.95);
}

TEST_CASE("octree.formula: refuses with the column", "[unit]") {
  refused("", 1, "empty");
  refused("  ", 3, "empty");
  refused("x+", 3, "found the end");
  refused("x+*y", 3, "'*'");
  refused("x y", 3, "operator");
  refused("x(y)", 2, "operator");
  refused("2 3", 3, "operator");
  refused("(x)3", 4, "operator");
  refused("1..2", 3, "second '.'");
  refused(".", 1, "'.'");
  refused("x+(y*2", 7, "column 3");
  refused("x)", 2, "')'");
  refused("()", 2, "')'");
  refused("1/2x", 4, "a/(b*c)");
  refused("x/(y)(z)", 6, "a/(b*c)");
  refused("x^2y", 4, "exponent");
  refused("2^3(x)", 4, "exponent");
  refused("x^-2 y", 6, "exponent");
  refused("xy+1", 1, "*");
  refused("1+foo(x)", 3, "'foo'");
  refused("sin x", 5, "'('");
  refused("sin", 4, "'('");
  refused("sin(x,y)", 1, "one operand");
  refused("1+atan2(x)", 3, "two operands");
  refused("min(x)", 1, "two or more");
  refused("hypot(x,y,z)", 1, "two operands");
  refused("difference(x)", 1, "two operands");
  refused("min(x,,y)", 7, "','");
  refused("min(x;y)", 6, "','");
  refused("pown(x,y)", 8, "integer");
  refused("pown(x,0.5)", 8, "integer");
  refused("rootn(x,0)", 1, "order 0");
  refused("x+1/0", 4, "division by zero");
  refused("x/(1-1)", 2, "division by zero");
  refused("2+sqrt(-1)", 3, "not defined");
  refused("log(0)", 1, "not defined");
  refused("0^-1", 2, "negative powers");
  refused("1e400", 1, "too large");
  refused("x+1e308*10", 8, "overflows");
  refused("1e308+1e308", 6, "overflows");
  refused("exp(1000)", 1, "overflows");
  refused("x^1e30", 2, "too large");
  refused("x^2147483648", 2, "too large");
  refused("(x^1000000)^1000000", 12, "too large");
  refused("x^1000000000*x^1000000000", 13, "too large");
  refused("2^1073741824", 2, "overflows");
  refused("x?1", 2, "'?'");
  refused("x\x01", 2, "U+0001");
  refused("x\xc3\xa9", 2, "'\xc3\xa9' (U+00E9)");
  refused(std::string("x\0y", 3), 2, "U+0000");
}

TEST_CASE("octree.formula: hostile texts are refused or compiled, in bounded time", "[hardcase]") {
  const auto repeated = [](const std::string& s, std::size_t n) {
    std::string r;
    for (std::size_t i = 0; i < n; ++i)
      r += s;
    return r;
  };
  constexpr std::size_t most = formula::longest_text;
  refused(repeated("x+", 500'000) + "x", most + 1, "longer than");
  refused(repeated("(", 60'000), formula::most_nested + 2, "nested");
  refused(repeated("2^", 30'000) + "2", 2 * formula::most_nested + 3, "nested");
  refused(repeated("sin(", 15'000), 4 * formula::most_nested + 5, "nested");
  refused(repeated("min(x,", 10'000), 6 * formula::most_nested + 5, "nested");
  refused(repeated("9", 60'000), 1, "longer than 1000");
  refused("0." + repeated("1", 60'000), 1, "longer than 1000");
  CHECK(formula::parse(repeated("-", 60'000) + "x"));
  CHECK(formula::parse(repeated("(", 199) + "x" + repeated(")", 199)));
  CHECK(formula::parse(repeated("x+", 30'000) + "x"));
  CHECK(formula::parse(repeated("x*", 30'000) + "x"));
  CHECK_FALSE(formula::parse("1e99999999999999999999999999"));
  CHECK(formula::parse("1e-99999999999999999999999999"));
  CHECK_FALSE(formula::parse("x^99999999999999999999999999"));
  std::string waves, powers, nested = "x";
  for (int i = 1; waves.size() < 60'000; ++i)
    waves += "sin(" + std::to_string(i) + "*x+y)^3-y*z^" + std::to_string(i) + "+";
  for (int i = 1; powers.size() < 60'000; ++i)
    powers += "(x+" + std::to_string(i) + ")^32-3*(x+" + std::to_string(i) + ")^7+";
  for (int i = 0; i < 190; ++i)
    nested = "(" + nested + "*(x-" + std::to_string(i) + "))";
  CHECK(formula::parse(waves + "x").reason() == "");
  CHECK(formula::parse(powers + "x").reason() == "");
  CHECK(formula::parse(nested).reason() == "");
  // so that all operands must be kept: left sides that wait for their right sides
  std::string wide = "x";
  for (int i = 0; i < 190; ++i)
    wide = "sin(y+" + std::to_string(i) + ")/(z+" + wide + ")";
  if (const auto f = formula::parse(wide); !f)
    CHECK(f.reason().find("intermediate") != std::string::npos);
}

TEST_CASE("octree.formula: no text of pieces of formulas makes it fall over", "[property]") {
  const char* const pieces[] = {"x",    "y",    "z",  "pi",    "e",    "+",    "-",    "*",
                                "/",    "^",    "(",  ")",     ",",    " ",    "2",    "0.1",
                                "3",    "0x1p", "1e", ".",     "sin(", "min(", "log(", "sqrt(",
                                "abs(", "\xff", "^2", "pown(", "^3",   "0",    "1e308"};
  std::mt19937_64 random(5);
  int compiled = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    for (std::size_t n = random() % 12; n > 0; --n)
      text += pieces[random() % std::size(pieces)];
    std::size_t column = 0;
    if (const auto f = formula::parse(text, &column)) {
      ++compiled;
      using I = interval<>;
      f->surface()(I(-1, 2), I(0, 1), I(-3, -2));
    } else if (column < 1 || column > text.size() + 1) {
      FAIL(text << ": column " << column);
    }
  }
  CHECK(compiled > 5000);
}
