/// The grammar of .itl files: what each literal means, and what is refused where.
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/itf1788/syntax.hpp>
#include <limits>

namespace {

using namespace graze::itf1788;
using graze::bounds, graze::decorated_bounds, graze::decoration;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<statement> parsed(const std::string& text) {
  const auto all = parse(text, "t.itl");
  INFO(text << "\n" << all.reason());
  REQUIRE(all);
  return *all;
}

/// The operands of `f <literals> = true;`.
std::vector<value> literals(const std::string& text) {
  return parsed("testcase t { f " + text + " = true; }").at(0).operands;
}
template <class T> T literal(const std::string& text) {
  const auto all = literals(text);
  INFO(text);
  REQUIRE(all.size() == 1);
  REQUIRE(std::holds_alternative<T>(all[0]));
  return std::get<T>(all[0]);
}

bool is(const bounds& x, double lo, double hi) { return x.lo == lo && x.hi == hi; }

std::string why_not(const std::string& text) {
  const auto all = parse(text, "t.itl");
  INFO(text);
  REQUIRE_FALSE(all);
  return all.reason();
}
/// The reason for refusing `f <literal> = true;` in line 2.
std::string why_not_literal(const std::string& text) {
  return why_not("testcase t {\n f " + text + " = true; }");
}

} // namespace

TEST_CASE("itf1788.parse: numbers are the nearest doubles", "[unit]") {
  CHECK(literal<double>("0.1") == 0.1);
  CHECK(literal<double>("-2.5e3") == -2500);
  CHECK(literal<double>("1.e-3") == 1e-3);
  CHECK(literal<double>("1e3") == 1000);
  CHECK(literal<double>(".5") == 0.5);
  CHECK(literal<double>("+0X1.8P+1") == 3);
  CHECK(literal<double>("0x10p0") == 16);
  CHECK(literal<double>("-0x0.0000000000001p-1022") == -std::numeric_limits<double>::denorm_min());
  CHECK(literal<double>("1e999") == infinity);
  CHECK(literal<double>("infinity") == infinity);
  CHECK(literal<double>("+infinity") == infinity);
  CHECK(literal<double>("-infinity") == -infinity);
  CHECK(std::isnan(literal<double>("NaN")));
  CHECK(std::signbit(literal<double>("-0.0")));
  CHECK_FALSE(std::signbit(literal<double>("0.0")));
  CHECK(literal<std::int64_t>("-7") == -7);
  CHECK(literal<std::int64_t>("0x1F") == 31);
  CHECK(literal<std::int64_t>("3UL") == 3);
}

TEST_CASE("itf1788.parse: bare and decorated intervals", "[unit]") {
  CHECK(is(literal<bounds>("[1.5, 2.0]"), 1.5, 2));
  CHECK(is(literal<bounds>("[ 1,2 ]"), 1, 2));
  CHECK(is(literal<bounds>("[-infinity,+infinity]"), -infinity, infinity));
  CHECK(is(literal<bounds>("[entire]"), -infinity, infinity));
  CHECK(literal<bounds>("[empty]").is_empty());
  const auto x = literal<decorated_bounds>("[1.5, 2.0]_com");
  CHECK(is(x.part, 1.5, 2));
  CHECK(x.label == decoration::com);
  CHECK(literal<decorated_bounds>("[entire]_dac").label == decoration::dac);
  CHECK(literal<decorated_bounds>("[-1.0, 1.0] _ def").label == decoration::def);
  CHECK(literal<decorated_bounds>("[empty]_trv").part.is_empty());
  CHECK(literal<decorated_bounds>("[nai]").is_nai());
}

TEST_CASE("itf1788.parse: the other literals", "[unit]") {
  CHECK(literal<bool>("true"));
  CHECK_FALSE(literal<bool>("false"));
  CHECK(literal<decoration>("dac") == decoration::dac);
  CHECK(literal<decoration>("ill") == decoration::ill);
  CHECK(literal<overlap_name>("containedBy").name == "containedBy");
  CHECK(literal<std::string>(R"("[1, 2]_com // \"no\" comment")") ==
        "[1, 2]_com // \"no\" comment");
  const auto numbers = literal<std::vector<double>>("{1.0, -2.5, NaN, infinity, 3}");
  REQUIRE(numbers.size() == 5);
  CHECK(numbers[1] == -2.5);
  CHECK(std::isnan(numbers[2]));
  CHECK(numbers[4] == 3);
  CHECK(literal<std::vector<double>>("{}").empty());
  CHECK(literal<other_format>("1.5f").written == "1.5f");
  CHECK(literal<other_format>("infinityL").written == "infinityL");
  CHECK(literal<other_format>("[1.5f, 2.0f]_com").written == "[1.5f, 2.0f]_com");
  CHECK(literal<other_format>("[entiref]").written == "[entiref]");
  CHECK(literal<other_format>("{1.0l, 2.0l}").written.front() != '\0');
}

TEST_CASE("itf1788.parse: statements, their lines and what they state", "[unit]") {
  const auto all = parsed("/* two\nlines */\n"
                          "testcase a.b-c { // to the end }\n"
                          "\tf [1.0,2.0]   7 =\n  true\tNaN; # also a comment;\n"
                          "#* and\n this *#\n"
                          "  d-op \"x\" <= [1.0, 2.0] signal IntvlOverflow;\r\n"
                          "  g 1.0 = [1.0, 1.5] <= [1.0, 2.0]; }\n"
                          "testcase c { h = 1.0 signal InvalidOperand; /* } */ }");
  REQUIRE(all.size() == 4);
  CHECK(all[0].line == 4);
  CHECK(all[0].written == "f [1.0,2.0] 7 = true NaN");
  CHECK(all[0].operation == "f");
  CHECK(all[0].operands.size() == 2);
  CHECK(all[0].tightest.size() == 2);
  CHECK(all[0].accurate.empty());
  CHECK(all[0].signal.empty());
  CHECK(all[1].line == 8);
  CHECK(all[1].operation == "d-op");
  CHECK(all[1].tightest.empty());
  CHECK(all[1].accurate.size() == 1);
  CHECK(all[1].signal == "IntvlOverflow");
  CHECK(all[2].tightest.size() == 1);
  CHECK(all[2].accurate.size() == 1);
  CHECK(all[3].line == 10);
  CHECK(all[3].operands.empty());
  CHECK(all[3].signal == "InvalidOperand");
}

TEST_CASE("itf1788.parse: errors name the line and what was expected", "[unit]") {
  CHECK(why_not("") == "t.itl:1: expected 'testcase', found the end of the file");
  CHECK(why_not("\n\nadd") == "t.itl:3: expected 'testcase', found 'add'");
  CHECK(why_not("testcase { }") == "t.itl:1: expected the name of the testcase, found '{'");
  CHECK(why_not("testcase a ;") ==
        "t.itl:1: expected '{' after the name of the testcase, found ';'");
  CHECK(why_not("testcase a {\n}") == "t.itl:2: expected an operation, found '}'");
  CHECK(why_not("testcase a {\n f 1.0 = 2.0;\n") ==
        "t.itl:3: expected an operation, found the end of the file");
  CHECK(why_not("testcase a {\n f 1.0 ;}") == "t.itl:2: expected '=' and a result, found ';'");
  CHECK(why_not("testcase a {\n f 1.0 = ;}") == "t.itl:2: expected a result, found ';'");
  CHECK(why_not("testcase a {\n f 1.0 = 2.0 }") == "t.itl:2: expected a literal, found '}'");
  CHECK(why_not("testcase a {\n f = 2.0 signal Nothing; }") ==
        "t.itl:2: expected the name of an exception, found 'Nothing'");
  CHECK(why_not("testcase a {\n f = 2.0 <= 3.0; }") ==
        "t.itl:2: only intervals can stand after '<='");
  CHECK(why_not("testcase a {\n f = 2.0 <= [1.0, 3.0] [1.0, 3.0]; }") ==
        "t.itl:2: not as many results after '<=' as after '='");
  CHECK(why_not("testcase a { f = 1.0; }\n /* ") == "t.itl:2: a comment without end");
  CHECK(why_not("testcase a { f\n\"x = 1.0;\n }") == "t.itl:2: a string without end");
  CHECK(why_not("testcase a { f = 1.0; } $") ==
        "t.itl:1: a character that has no meaning here ('$')");
}

TEST_CASE("itf1788.parse: literals that are none", "[unit]") {
  CHECK(why_not_literal("[2.0, 1.0]") ==
        "t.itl:2: an interval without members: [0x1p+1, 0x1p+0] (write [empty])");
  CHECK(why_not_literal("[infinity, infinity]").find("without members") != std::string::npos);
  CHECK(why_not_literal("[NaN, 1.0]").find("without members") != std::string::npos);
  CHECK(why_not_literal("[1.0]") ==
        "t.itl:2: expected ',' between the bounds of an interval, found ']'");
  CHECK(why_not_literal("[1.0, 2.0") ==
        "t.itl:2: expected ']' at the end of an interval, found '='");
  CHECK(why_not_literal("[1.0, true]") == "t.itl:2: expected a number, found true");
  CHECK(why_not_literal("[1.0, 2.0]_ill") ==
        "t.itl:2: expected a decoration (com, dac, def, trv), found 'ill'");
  CHECK(why_not_literal("[1.0, 2.0]_[") ==
        "t.itl:2: expected a decoration (com, dac, def, trv), found '['");
  CHECK(why_not_literal("[empty]_com") == "t.itl:2: [empty] cannot be decorated com");
  CHECK(why_not_literal("[entire]_com") ==
        "t.itl:2: [-infinity, infinity] cannot be decorated com");
  CHECK(why_not_literal("{1.0 2.0}") == "t.itl:2: expected '}' after the numbers, found '2.0'");
  CHECK(why_not_literal("{1.0, [1.0, 2.0]}") == "t.itl:2: expected a number, found '['");
  CHECK(why_not_literal("{{{1.0}}}") == "t.itl:2: expected a number, found '{'");
}

TEST_CASE("itf1788.parse: a literal that is not known is of its statement alone", "[regression]") {
  for (const char* const unknown :
       {"nothing", "inf", "-inf", "0x1.8", "1.5x", "$", "99999999999999999999"}) {
    CAPTURE(unknown);
    CHECK(literal<other_format>(unknown).written == unknown);
  }
  CHECK(literal<other_format>("[inf, 1.0]").written == "[inf, 1.0]");
  const auto both = parse("testcase a {\n f inf = 1.0;\n g 1.0 = inf;\n h 1.0 = 2.0; }", "t.itl");
  REQUIRE(both);
  CHECK(both->size() == 3);
}

TEST_CASE("itf1788.parse: a bound that is no double is not rounded", "[regression]") {
  // to nearest, neither interval would hold its number
  for (const char* const text :
       {"[0x1.99999999999999999999p-4, 1.0]", "[0.0, 0x1.00000000000000001p0]",
        "[0.1000000000000000055511151231257828, 1.0]", "[0.0, 9007199254740993]"}) {
    CAPTURE(text);
    CHECK(literal<other_format>(text).written == text);
  }
  CHECK(same(literal<bounds>("[0x1.99999999999a0000p-4, 1.0]"), bounds{0x1.99999999999ap-4, 1}));
  CHECK(same(literal<bounds>("[0.1000000000000000055511151231257827021181583404541015625, 1.0]"),
             bounds{0.1, 1}));
  CHECK(same(literal<bounds>("[0.1, 1.0]"), bounds{0.1, 1}));
}
