// Spellings that mean the same have the same tape; definitions, parameters, choices; what is refused,
// where, and what it says.
#include "../../support/formulas.hpp"
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <graze/octree_formula.hpp>
#include <random>
#include <string>

using namespace graze;
using namespace graze::octree;
using support::parsed;

namespace {

void refused(const std::string& text, std::size_t column, const std::string& why,
             std::size_t shown_column = 0) {
  std::size_t at = 0;
  const auto f = formula::parse(text, &at);
  INFO(text << ": " << f.reason());
  REQUIRE_FALSE(f);
  CHECK(at == column);
  const std::size_t shown = shown_column == 0 ? column : shown_column;
  CHECK(f.reason().rfind("column " + std::to_string(shown) + ": ", 0) == 0);
  CHECK(f.reason().find(why) != std::string::npos);
}

/// All that the value over any number type depends on.
std::string tape_of(const formula& f) {
  const tape::program& p = f.surface().program();
  std::string r;
  const auto put = [&r](const auto&... number) {
    char word[64];
    ((std::snprintf(word, sizeof word, "%a ", static_cast<double>(number)), r += word), ...);
  };
  for (const auto& i : p.code)
    put(static_cast<int>(i.op), i.target, i.a, i.b, i.n);
  for (const auto& c : p.constants)
    put(c.lo, c.hi, c.nearest);
  for (const auto& q : p.polynomials)
    put(q.first_coefficient, q.degree, q.first_turn, q.turns, q.derivative);
  for (const auto& t : p.turns)
    put(t.lo, t.hi, t.least, t.greatest);
  put(p.registers, p.result, p.continuous, p.tight);
  return r;
}

parameter given(const char* name, const char* value) {
  const auto p = parameter::make(name, value);
  INFO(p.reason());
  REQUIRE(p);
  return *p;
}

/// In doubles.
double value(const std::string& text, const vec3& p = {3, 5, 7}) {
  return parsed(text).surface()(p[0], p[1], p[2]);
}

} // namespace

TEST_CASE("octree.formula: each spelling has the tape of the plain one", "[unit]") {
  const std::pair<const char*, const char*> table[] = {
      // equations
      {"x^2 + y^2 = 1", "x^2 + y^2 - (1)"},
      {"z = x*y", "z - x*y"},
      {"x^2 = y = ", nullptr},
      {"x^2 + y^2 - 1;", "x^2 + y^2 - 1"},
      {"x^2 + y^2 = 1 ;; ", "x^2 + y^2 - 1"},
      {"r = 2", "hypot(x,y) - 2"},
      // powers
      {"x**2 + y**-1", "x^2 + y^-1"},
      {"2**x**2", "2^x^2"},
      {"x²+y³-z⁻¹", "x^2+y^3-z^(-1)"},
      {"x¹²+y⁺⁰+z⁴⁵⁶⁷⁸⁹", "x^12+y^0+z^456789"},
      {"-x²", "-(x^2)"},
      {"2x²y³z", "2*x^2*y^3*z"},
      {"e²", "exp(2)"},
      {"e⁻²x", "exp(-2)*x"},
      {"(x+y)²(x-z)", "(x+y)^2*(x-z)"},
      {"sin(x)²", "sin(x)^2"},
      // bars
      {"|x|", "abs(x)"},
      {"||x|-1|", "abs(abs(x)-1)"},
      {"|x*|y|-z|", "abs(x*abs(y)-z)"},
      {"|x|*|y|", "abs(x)*abs(y)"},
      {"2|x|+(y+1)|z|", "2*abs(x)+(y+1)*abs(z)"},
      {"|x|^2+|y|²", "abs(x)^2+abs(y)^2"},
      {"|(|x|-|y|)|", "abs(abs(x)-abs(y))"},
      {"min(|x|,|y|)", "min(abs(x),abs(y))"},
      {"-|x|/|y|", "-abs(x)/abs(y)"},
      {"|-x|", "abs(-x)"},
      {"||x||", "abs(abs(x))"},
      // upper case
      {"X^2+Y-Z", "x^2+y-z"},
      {"Sin(x)+SQRT(y)+Atan2(Y,X)", "sin(x)+sqrt(y)+atan2(y,x)"},
      {"PI*x+e^y", "pi*x+e^y"},
      {"R=2;E=3;x^2-R*E", "x^2-6"},
      // pasted signs
      {"2×x·y⋅z − π", "2*x*y*z - pi"},
      {"2\u00a0x\u00a0+\u00a01", "2 x + 1"},
      {"θ+φ+ϕ+ρ+r", "theta+phi+phi+rho+r"},
      // functions
      {"clamp(x,-1,1)", "min(max(x,-1),1)"},
      {"mod(x,2)", "x-2*floor(x/2)"},
      {"x % 2", "x-2*floor(x/2)"},
      {"mod(x,y)", "x-y*floor(x/y)"},
      {"-x%2", "(-x)-2*floor((-x)/2)"},
      {"3*x%2", "3*x-2*floor(3*x/2)"},
      {"min(x,y,z,1)", "min(min(min(x,y),z),1)"},
      {"r", "hypot(x,y)"},
      {"rho", "hypot(hypot(x,y),z)"},
      {"theta", "atan2(y,x)"},
      {"phi", "atan2(hypot(x,y),z)"},
      // definitions
      {"w=sqrt(5);x^2-w", "x^2-sqrt(5)"},
      {"let w = sqrt(5); x^2-w", "x^2-sqrt(5)"},
      {"a=x+y;b=a^2;b*a-b;", "(x+y)^2*(x+y)-(x+y)^2"},
      {"a=x+y; sin(a)+cos(a) = a", "sin(x+y)+cos(x+y)-(x+y)"},
      {"r=2;x^2+y^2=r^2", "x^2+y^2-4"},
      {"R=2;r=1;(hypot(x,y)-R)^2+z^2=r^2", "(hypot(x,y)-2)^2+z^2-1"},
      {"phi=(1+sqrt(5))/2;x-phi", "x-(1+sqrt(5))/2"},
      {"a=1;A=2;a*x+A*y", "x+2y"},
      {"(w=sqrt(5);x^2-w;)+y", "(x^2-sqrt(5))+y"},
      {"union((w=1;x-w),(w=2;y=w))", "union(x-1,y-2)"},
      {"inside=x<1 and y<2; if(inside,x,y)", "if(x<1 and y<2,x,y)"},
      // choices
      {"if(x<y,z,1)", "if(y>x,z,1)"},
      {"if(x<=y,z,1)", "if(y>=x,z,1)"},
      {"if(not x<y,z,1)", "if(x>=y,z,1)"},
      {"if(!(x<y or x>z),z,1)", "if(x>=y && x<=z,z,1)"},
      {"if(x≤y||y≥z,z,1)", "if(x<=y or y>=z,z,1)"},
      {"if(!!(x≠y),z,1)", "if(x!=y,z,1)"},
      {"if(x!=y,z,1)", "if(x==y,1,z)"},
      {"if(|x|<1||y<2,z,1)", "if(abs(x)<1 or y<2,z,1)"},
      {"IF(x<y AND NOT y<z, z, 1)", "if(x<y and y>=z,z,1)"},
      {"if(1<2,x,y)", "x"},
      {"if(1>2,x,y)", "y"},
      {"if(x<y,z,z)", "z"},
      // continuous choices
      {"if(x<y,x,y)", "min(x,y)"},
      {"if(x>=y,x,y)", "max(x,y)"},
      {"if(x<0,-x,x)", "max(-x,x)"},
      {"if(x>y^2,y^2,x)", "min(y^2,x)"},
      // solids
      {"x^2+y^2<1", "x^2+y^2-1"},
      {"x^2+y^2>=1", "1-x^2-y^2"},
      {"x^2==y", "x^2-y"},
      {"x<1 and y<2 and z>3", "max(x-1,y-2,3-z)"},
      {"x<1 or not y<2", "min(x-1,-(y-2))"},
      {"union(x<1,y)", "union(x-1,y)"},
      {"difference(x<1,y<2)", "difference(x-1,y-2)"},
  };
  for (const auto& [spelling, plain] : table) {
    INFO(spelling);
    if (plain == nullptr) {
      CHECK_FALSE(formula::parse(spelling));
      continue;
    }
    CHECK(tape_of(parsed(spelling)) == tape_of(parsed(plain)));
  }
  // so that the comparison tells tapes apart
  CHECK(tape_of(parsed("x^2-0.1")) != tape_of(parsed("x^2-0.2")));
  CHECK(tape_of(parsed("if(x<y,z,1)")) != tape_of(parsed("if(x<=y,z,1)")));
}

TEST_CASE("octree.formula: mod has the sign of its second operand, at multiples too", "[unit]") {
  for (const double m : {2.0, 3.0, -3.0, 0.1, 7.5})
    for (double x = -9; x <= 9; x += 0.375) {
      const double expected = x - m * std::floor(x / m);
      const std::string text = std::string("mod(x,").append(std::to_string(m)).append(")");
      CHECK(value(text, {x, 0, 0}) == Approx(expected).margin(1e-9));
      CHECK(value(std::string("x%(").append(std::to_string(m)).append(")"), {x, 0, 0}) ==
            Approx(expected).margin(1e-9));
    }
  // from a multiple on it is continuous, and known
  using I = interval<>;
  for (const char* text : {"mod(x,3)", "x%3", "mod(x,5)", "mod(3x,9)"}) {
    INFO(text);
    const formula f = parsed(text);
    const double m = std::string(text) == "mod(x,5)" ? 5 : 3;
    const I v = f.surface()(I(m, m + 1), I(0), I(0));
    CHECK(v.lower() >= -1e-12);
    CHECK(v.upper() <= 3 + 1e-12);
  }
}

TEST_CASE("octree.formula: a choice is known where its comparison is decided", "[unit]") {
  using I = interval<>;
  const auto on = [](const char* text, const I& x) {
    return parsed(text).surface()(x, I(0), I(0));
  };
  const auto is = [](const I& v, double lo, double hi) {
    INFO(v.lower() << " to " << v.upper());
    CHECK(v.lower() == lo);
    CHECK(v.upper() == hi);
  };
  is(on("if(x>0,5,7)", I(1, 2)), 5, 5);
  is(on("if(x>0,5,7)", I(-1, 0)), 7, 7);
  is(on("if(x>0,5,7)", I(0, 1)), 5, 7);
  is(on("if(x>=0,5,7)", I(0, 1)), 5, 5);
  is(on("if(x>=0,5,7)", I(-1, -0x1p-1074)), 7, 7);
  is(on("if(x==0,5,7)", I(0, 0)), 5, 5);
  is(on("if(x==0,5,7)", I(1, 2)), 7, 7);
  is(on("if(x==0,5,7)", I(0, 2)), 5, 7);
  is(on("if(x!=0,5,7)", I(0, 0)), 7, 7);
  is(on("if(x>0,sqrt(x),5)", I(-2, -1)), 5, 5);
  is(on("if(x>0,sqrt(x),5)", I(1, 4)), 1, 2);
  is(on("if(x>0,sqrt(x),5)", I(-1, 4)), 0, 5);
  is(on("if(sqrt(x)>2,3,5)", I(-2, -1)), 1, 1); // not defined
  is(on("if(sqrt(x)>2,3,3)", I(-2, -1)), 1, 1);
  is(on("if(x>0,5,sqrt(x-9))", I(-1, 1)), 5, 5);
  is(on("if(x>0,sqrt(x-9),5)", I(-1, 1)), 5, 5);
  is(on("if(0.1+0.2-0.3>0,5,7)", I(0)), 7, 7); // decimals are known
  is(on("if(sin(pi)>0,5,7)", I(0)), 5, 7);
  is(on("if(x>1 and x<3,5,7)", I(1.5, 2)), 5, 5);
  is(on("if(x>1 and x<3,5,7)", I(1.5, 4)), 5, 7);
  is(on("if(x>1 and x<3,5,7)", I(3, 4)), 7, 7);
  is(on("if(x<1 or x>3 or x==2,5,7)", I(2, 2)), 5, 5);
  is(on("if(x<1 or x>3 or x==2,5,7)", I(2.5, 3)), 7, 7);
  is(on("if(x>1 and sqrt(x-1)>1,3,5)", I(0, 0.5)), 5, 5);
  is(on("if(x>1 or sqrt(x-1)>1,3,5)", I(2, 3)), 3, 3);
  is(on("if(x>0,sqrt(x),5)+if(x>0,5,sqrt(-x))", I(-4, -1)), 6, 7);

  using up = rounding::upward;
  const up::scope scope;
  const auto continuous = [](const char* text, double lo, double hi) {
    const formula f = parsed(text);
    return f.surface().continuous_on<up>({bound<up>(lo, hi), bound<up>(0), bound<up>(1)});
  };
  for (const char* text : {"if(x>0,sqrt(x),-x)", "if(x>0,1/x,2)", "if(x>0 and sqrt(x)>1/8,x,3)"}) {
    INFO(text);
    CHECK(continuous(text, 1, 2));
    CHECK(continuous(text, -2, -1));
    CHECK(continuous(text, -2, 0));
    CHECK_FALSE(continuous(text, 0, 1));
    CHECK_FALSE(continuous(text, -1, 1));
  }
  CHECK(continuous("if(x>=0,3,x)", 0, 1));
  CHECK_FALSE(continuous("if(x>=0,3,x)", -1, 0));
  CHECK_FALSE(continuous("if(sqrt(x)>1,3,x)", -1, 0.5));
  CHECK_FALSE(continuous("if(x>0,sqrt(x-2),3)", 1, 2));
  CHECK(continuous("if(x>0,sqrt(x-2),3)", -1, 0));
  CHECK_FALSE(continuous("if(x>0,5,7)+floor(x)", 0.5, 1.5));
  CHECK_FALSE(continuous("floor(x)*y+z*sin(x)", 0.5, 1.5));
  CHECK_FALSE(continuous("y*z+min(x,floor(x))", 0.5, 1.5));
  CHECK_FALSE(continuous("max(floor(x),x)", 0.5, 1.5));
}

TEST_CASE("octree.formula: a choice is of few operations, however it is nested", "[hardcase]") {
  std::string any = "x>1", nested = "x";
  for (int i = 2; i < 60; ++i)
    any += (i % 2 == 0 ? " or y>" : " and z>") + std::to_string(i);
  const formula f = parsed("if(" + any + ",x^2+y^2+z,x*y*z-sin(x))");
  CHECK(f.surface().program().code.size() < 300);
  for (int i = 0; i < 180; ++i)
    nested =
        std::string("if(x>").append(std::to_string(i)).append(",").append(nested).append(",y)");
  CHECK(parsed(nested).surface().program().code.size() < 600);
}

TEST_CASE("octree.formula: spellings are refused with a way out", "[unit]") {
  refused("x=y=z", 4, "second '='");
  refused("=x", 1, "'='");
  refused("x=", 3, "the end");
  refused("x;y", 3, "'y'");
  refused("x^2;y^2;z", 5, "'y'");
  refused(";", 1, "';'");
  refused("w=2", 1, "needs a ';' and a formula");
  refused("w=2;", 1, "needs a ';' and a formula");
  refused("f = x^2+y^2", 1, "needs a ';'");
  refused("z=2;x", 1, "'z' has a meaning");
  refused("sin=2;x", 1, "'sin' has a meaning");
  refused("Pi=3;x", 1, "'Pi' has a meaning");
  refused("w=1;w=2;x-w", 5, "'w' has a meaning");
  refused("let x=1;y", 5, "'x' has a meaning");
  refused("let 2=1;y", 1, "'let'");
  refused("let w;y", 1, "let name");
  refused("(w=1;w)+w", 9, "unknown name 'w'");
  refused("a=r;r=2;x-r*a", 5, "used before it is defined");
  refused("r=r+1;x-r", 1, "used before it is defined");
  refused("w=w+1;x-w", 3, "unknown name 'w'");
  refused("x+t", 3, "unknown name 't': define it before the formula, as in t = 1; ..., or set it");
  refused("x+f(y)", 3, "unknown function 'f'");
  refused("x+sine(y)", 3, "; sin?");
  refused("arctan(y)", 1, "; atan?");
  refused("sgn(y)", 1, "; sign?");
  refused("radius=2;x-raduis", 12, "; radius?");
  refused("XY", 1, "products need a *");
  for (const char* own :
       {"R", "E", "Rho", "THETA", "PHI"}) // a forgotten parameter is no coordinate
    refused(std::string("x^2+").append(own).c_str(), 5, "unknown name");
  // a surface joined to a condition would be the solid f <= g
  refused("x^2==1 and y<2", 1, "no solid");
  refused("y<2 or not x!=1", 1, "no solid");
  refused("union(x==1,y<2)", 7, "no solid");
  refused("|x|y|z|", 4, "*");
  refused("x|y|", 2, "*");
  refused("|x||y|", 4, "*");
  refused("|x", 3, "'|' for the '|' in column 1");
  refused("|x+|y|", 7, "column 1");
  refused("(|x)|", 4, "'|'");
  refused("min(|x,y|)", 7, "column 5");
  refused("x|", 2, "*");
  refused("2||x|-1|", 2, "write * before");
  refused("sin²(x)", 4, "write sin(x)^2");
  refused("sin^2(x)", 4, "write sin(x)^2");
  refused("x²^3", 4, "write", 3);
  refused("x⁻", 2, "exponent such as");
  refused("x²⁻", 2, "exponent such as");
  refused("x²³⁺¹", 2, "exponent such as");
  refused("²", 1, "'²' (U+00B2)");
  refused("x²2", 4, "an operator", 3);
  refused("1%2x", 4, "a%(b*c)");
  refused("x%0", 2, "division by zero");
  refused("x**2y", 5, "exponent");
  refused("if(x,1,2)", 4, "comparison, such as");
  refused("if(x=1,1,2)", 5, "==");
  refused("if(x<1,1)", 1, "three operands");
  refused("if(x<1<2,1,2)", 7, "a < b and b < c");
  refused("if(x<1 and y,1,2)", 12, "comparison");
  refused("if(not x,1,2)", 8, "comparison");
  refused("(x<1)+2", 6, "no number");
  refused("sin(x<1)", 5, "no number");
  refused("-(x<1)", 1, "no number");
  refused("|x<1|", 1, "no number");
  refused("x<1=y", 4, "no number");
  refused("x!=1", 1, "no surface");
  refused("clamp(x,1)", 1, "three operands");
  refused("mod(x)", 1, "two operands");
  refused("and", 1, "'and'");
  refused("x and", 1, "comparison");
  refused("x<1 and", 8, "the end");
  refused("and=2;x", 1, "has a meaning");
  // columns of the reason count characters, positions bytes
  refused("x²+é", 5, "found 'é' (U+00E9)", 4);
  refused("θ+ж", 4, "found 'ж' (U+0436)", 3);
  refused("x+√2", 3, "found '√' (U+221A)");
  refused("x+\xff", 3, "the byte 0xFF");
  refused("x\x01", 2, "U+0001");
  refused("x+\xe2\x80\x8f", 3, "found U+200F");
  refused("x+\xed\xa0\x80", 3, "the byte 0xED");
  refused("x+\xc0\xaf", 3, "the byte 0xC0");
  refused("x+\xc3(", 3, "the byte 0xC3");
  refused("x\xb2", 2, "the byte 0xB2");
  refused("x²\xb2", 4, "the byte 0xB2", 3);
  refused("x²+(y", 7, "'(' in column 4", 6);
}

TEST_CASE("octree.formula: parameters are exact, and known by name", "[unit]") {
  const parameter set[] = {given("a", "0.3"), given("t", "-1/4"), given("R", "sqrt(5)"),
                           given("r", "2")};
  CHECK(tape_of(parsed("x^2-a", set)) == tape_of(parsed("x^2-0.3")));
  CHECK(tape_of(parsed("x^2-a*t", set)) == tape_of(parsed("x^2-0.3*(-1/4)")));
  CHECK(tape_of(parsed("x^2-R^2", set)) == tape_of(parsed("x^2-sqrt(5)^2")));
  CHECK(tape_of(parsed("x^2-r", set)) == tape_of(parsed("x^2-2")));
  CHECK(tape_of(parsed("(w=a;x-w)", set)) == tape_of(parsed("x-0.3")));
  CHECK(parsed("x^2-a", set).uses("a"));
  CHECK_FALSE(parsed("x^2-a", set).uses("t"));
  CHECK_FALSE(parsed("x^2-a", set).uses("x"));
  CHECK_FALSE(formula::parse("a=1;x-a", nullptr, set));
  CHECK_FALSE(formula::parse("A*x", nullptr, set));
  CHECK(formula::parse("x+aa", nullptr, std::vector{given("ab", "1")}).reason().find("; ab?") !=
        std::string::npos);

  const auto no = [](const char* name, const char* text, const std::string& why,
                     std::size_t column = 0) {
    std::size_t at = 99;
    const auto p = parameter::make(name, text, &at);
    INFO(name << "=" << text << ": " << p.reason());
    REQUIRE_FALSE(p);
    CHECK(p.reason().find(why) != std::string::npos);
    CHECK(at == column);
  };
  no("", "1", "is no name");
  no("2a", "1", "is no name");
  no("a b", "1", "is no name");
  no(" a", "1", "is no name");
  no("é", "1", "is no name");
  no("x", "1", "has a meaning");
  no("Sin", "1", "has a meaning");
  no("pi", "3", "has a meaning");
  no("or", "3", "has a meaning");
  no("a", "x", "no constant");
  no("a", "", "column 1: the formula is empty", 1);
  no("a", "1+", "column 3", 3);
  no("a", "b", "unknown name 'b'", 1);
  no("a", std::string(2000, '1').c_str(), "longer than 1000");
}

TEST_CASE("octree.formula: a root that is not defined for x < 0 is noted, where there is such x",
          "[unit]") {
  const box across{{-1, -1, -1}, {1, 1, 1}}, right{{0, -1, -1}, {1, 1, 1}};
  const auto notes = [](const char* text, const box& b) {
    std::string all;
    for (const std::string& n : parsed(text).notes(b))
      all += n + "\n";
    return all;
  };
  CHECK(notes("x^(1/3)+y", across) == "x^(1/3) is defined for x >= 0; cbrt(x)?\n");
  CHECK(notes("x^(1/3)+y", right).empty());
  CHECK(notes("x^(1/3)+(y-1)^(2/5)", across) ==
        "x^(1/3) is defined for x >= 0; cbrt(x)?\n"
        "(y-1)^(2/5) is defined for y-1 >= 0; rootn(y-1, 5)^2?\n");
  CHECK(notes("x^(1/3)+y^(1/3)", right) == "y^(1/3) is defined for y >= 0; cbrt(y)?\n");
  CHECK(notes("pow(x*y, 1/3)", across) == "pow(x*y, 1/3) is defined for x*y >= 0; cbrt(x*y)?\n");
  CHECK(notes("a=1/3; x^a", across) == "x^a is defined for x >= 0; cbrt(x)?\n");
  for (const char* text : {"|x|^(1/3)", "(x^2+y^2)^(1/3)", "cbrt(x)", "x^0.5", "x^1.5", "x^(1/4)",
                           "x^3", "rootn(x,3)", "exp(x)^(1/3)", "2^(1/3)*x", "e^(1/3)*x"}) {
    INFO(text);
    CHECK(notes(text, across).empty());
  }
}

TEST_CASE("octree.formula: definitions do not multiply work or memory", "[hardcase]") {
  const auto seconds = [](const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    const auto f = formula::parse(text);
    INFO(text.substr(0, 60) << ": " << f.reason());
    if (!f)
      CHECK((f.reason().find("terms in all") != std::string::npos ||
             f.reason().find("intermediate") != std::string::npos ||
             f.reason().find("too large") != std::string::npos));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const auto numbered = [](const char* letter, int i) {
    return std::string(letter).append(std::to_string(i));
  };
  std::string products = "a0=x+y;", sums = "a0=x+sin(y);", conditions = "a0=x<1;", wide = "s=x";
  for (int i = 1; i < 2000; ++i) {
    const std::string before = numbered("a", i - 1), name = numbered("a", i);
    products += name + "=" + before + "*" + before + "+" + before + "*y;";
    sums += name + "=" + before + "+" + before + "*z;";
    conditions += name + "=" + before + " and " + before + ";";
  }
  for (int i = 0; wide.size() < 30'000; ++i)
    wide.append("+y^").append(std::to_string(i));
  wide += ";";
  for (int i = 0; wide.size() < 62'000; ++i)
    wide += numbered("b", i) + "=s+" + std::to_string(i) + ";";
  std::string functions = wide.substr(0, wide.find(';') + 1), factors = "m=x";
  for (int i = 0; functions.size() < 64'000; ++i)
    functions.append("sin(s+").append(std::to_string(i)).append("*x)+");
  for (int i = 1; factors.size() < 30'000; ++i)
    factors.append("*sin(").append(std::to_string(i)).append("x)");
  factors += ";";
  for (int i = 0; factors.size() < 64'000; ++i)
    factors.append("m*").append(std::to_string(i)).append("+");
  CHECK(seconds(products + "a1999") < 20);
  CHECK(seconds(sums + "a1999") < 20);
  CHECK(seconds(conditions + "if(a1999,x,y)") < 20);
  CHECK(seconds(wide + "b0") < 20);
  CHECK(seconds(functions + "x") < 20);
  CHECK(seconds(factors + "x") < 20);
  CHECK_FALSE(formula::parse(conditions + "if(a1999,x,y)"));
  const auto often = [](int uses) {
    std::string text = "s=x";
    for (int i = 2; i < 1000; ++i)
      text.append("+y^").append(std::to_string(i)).append("*z");
    text += ";y";
    for (int i = 0; i < uses; ++i)
      text += "+s";
    return formula::parse(text);
  };
  CHECK(often(80).reason() == "");
  CHECK(often(160).reason().find("more than 262144 terms in all") != std::string::npos);
  // and what people write is taken
  CHECK(formula::parse(conditions.substr(0, conditions.find("a9=")) + "if(a8,x,y)"));
  std::string bars(60'000, '|');
  CHECK_FALSE(formula::parse(bars));
  CHECK_FALSE(formula::parse(std::string(60'000, '!') + "x<1;").has_value() == false);
}

TEST_CASE("octree.formula: no text of pieces of spellings makes it fall over", "[property]") {
  const char* const pieces[] = {
      "x",    "y",  "a",     "r",      "=",    ";",       "+",   "-",    "*",        "**",
      "%",    "|",  "||",    "²",      "⁻¹",   "(",       ")",   ",",    "<",        "<=",
      "==",   "!=", " and ", " or ",   "not ", "!",       "&&",  "if(",  "mod(",     "clamp(",
      "let ", "a=", "b=",    "2",      "0.1",  "×",       "π",   "\xc3", "\xe2\x88", "sin",
      "θ",    "^",  "1/3",   "union(", "≥",    "if(x<y,", "phi="};
  std::mt19937_64 random(17);
  int compiled = 0;
  const parameter set[] = {given("b", "2")};
  for (int i = 0; i < 300'000; ++i) {
    std::string text;
    for (std::size_t n = random() % 14; n > 0; --n)
      text += pieces[random() % std::size(pieces)];
    std::size_t column = 0;
    const auto f = formula::parse(text, &column, i % 2 == 0 ? std::span(set) : std::span(set, 0));
    if (f) {
      ++compiled;
      using I = interval<>;
      f->surface()(I(-1, 2), I(0, 1), I(-3, -2));
      (void)f->notes({{-1, -1, -1}, {1, 1, 1}});
    } else if (column < 1 || column > text.size() + 1 || f.reason().empty()) {
      FAIL(text << ": column " << column);
    }
  }
  CHECK(compiled > 4000);
}
