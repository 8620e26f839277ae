/// When a result counts as the one that a file states.
#include <algorithm>
#include <catch2/catch.hpp>
#include <graze/itf1788/operations.hpp>
#include <graze/itf1788/run.hpp>
#include <graze/itf1788/tighter.hpp>
#include <limits>

namespace {

using namespace graze::itf1788;
using graze::bounds, graze::decorated_bounds, graze::decoration;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool same_text(const char* stated, const char* got) {
  const auto all = parse(std::string("testcase t { f ") + stated + " = " + got + "; }", "t.itl");
  REQUIRE(all);
  REQUIRE(all->at(0).operands.size() == 1);
  REQUIRE(all->at(0).tightest.size() == 1);
  return same(all->at(0).operands[0], all->at(0).tightest[0]);
}

judgement judgement_of(const std::string& text) {
  const auto all = parse("testcase t { " + text + "; }", "t.itl");
  INFO(text << all.reason());
  REQUIRE(all);
  return judge(all->at(0));
}

} // namespace

TEST_CASE("itf1788.same: sets and decorations are equal, bare is not decorated", "[unit]") {
  CHECK(same_text("[1.0, 2.0]", "[1.0, 2.0]"));
  CHECK(same_text("[0.0, 2.0]", "[-0.0, 2.0]")); // the same set
  CHECK_FALSE(same_text("[1.0, 2.0]", "[0x1.fffffffffffffp-1, 2.0]"));
  CHECK_FALSE(same_text("[1.0, 2.0]", "[1.0, 0x1.fffffffffffffp0]"));
  CHECK(same_text("[empty]", "[empty]"));
  CHECK_FALSE(same_text("[empty]", "[1.0, 2.0]"));
  CHECK_FALSE(same_text("[1.0, 2.0]", "[empty]"));
  CHECK(same_text("[1.0, 2.0]_dac", "[1.0, 2.0]_dac"));
  CHECK_FALSE(same_text("[1.0, 2.0]_dac", "[1.0, 2.0]_def"));
  CHECK_FALSE(same_text("[1.0, 2.0]_dac", "[1.0, 2.0]"));
  CHECK_FALSE(same_text("[1.0, 2.0]", "[1.0, 2.0]_dac"));
  CHECK(same_text("[nai]", "[nai]"));
  CHECK_FALSE(same_text("[nai]", "[empty]_trv"));
  CHECK_FALSE(same_text("[empty]", "[nai]"));
}

TEST_CASE("itf1788.same: numbers with the sign of a zero, NaN, integers", "[unit]") {
  CHECK(same(1.5, 1.5));
  CHECK_FALSE(same(1.5, 0x1.8000000000001p0));
  CHECK_FALSE(same(0.0, -0.0));
  CHECK(same(not_a_number, -not_a_number));
  CHECK_FALSE(same(not_a_number, 0.0));
  CHECK_FALSE(same(0.0, not_a_number));
  CHECK(same(std::int64_t{3}, 3.0));
  CHECK_FALSE(same(std::int64_t{3}, 3.5));
  CHECK_FALSE(same(3.0, std::int64_t{3})); // no operation gives an integer
  CHECK_FALSE(same(true, false));
  CHECK_FALSE(same(overlap_name{"meets"}, overlap_name{"metBy"}));
  CHECK_FALSE(same(decoration::com, decoration::dac));
  CHECK_FALSE(same(other_format{"1.0f"}, other_format{"1.0f"}));
}

TEST_CASE("itf1788.within: sets, decorations that promise no more", "[unit]") {
  CHECK(within(bounds{1, 2}, bounds{1, 3}));
  CHECK_FALSE(within(bounds{0, 2}, bounds{1, 3}));
  CHECK(within(bounds::empty(), bounds{1, 3}));
  CHECK(
      within(decorated_bounds{{1, 2}, decoration::def}, decorated_bounds{{1, 3}, decoration::com}));
  CHECK_FALSE(
      within(decorated_bounds{{1, 2}, decoration::com}, decorated_bounds{{1, 3}, decoration::def}));
  CHECK_FALSE(within(bounds{1, 2}, decorated_bounds{{1, 3}, decoration::com}));
  CHECK_FALSE(within(decorated_bounds::nai(), decorated_bounds{{1, 3}, decoration::com}));
  CHECK_FALSE(within(1.0, bounds{1, 3}));
}

TEST_CASE("itf1788.judge: results, accuracy, signals", "[unit]") {
  CHECK(judgement_of("sub [1.0, 2.0] [3.0, 5.0] = [-4.0, -1.0]").is == verdict::passed);
  CHECK(judgement_of("sub [1.0, 2.0] [3.0, 5.0] <= [-4.5, -1.0]").is == verdict::passed);
  CHECK(judgement_of("sub [1.0, 2.0] [3.0, 5.0] <= [-3.5, -1.0]").is == verdict::failed);
  CHECK(judgement_of("sub [1.0, 2.0] [3.0, 5.0] = [-3.0, -1.5] <= [-4.0, 0.0]").is ==
        verdict::passed);
  CHECK(judgement_of("sub [1.0, 2.0] [3.0, 5.0] = [-4.5, -1.5] <= [-5.0, 0.0]").is ==
        verdict::failed);
  CHECK(judgement_of("midRad [3.0, 5.0] = 4.0 1.0").is == verdict::passed);
  CHECK(judgement_of("midRad [3.0, 5.0] = 4.0 1.5").is == verdict::failed);
  CHECK(judgement_of("midRad [3.0, 5.0] = 4.0").is == verdict::failed);
  CHECK(judgement_of("mid [3.0, 5.0] = 4.0 1.0").is == verdict::failed);
  CHECK(judgement_of("b-numsToInterval 2 1 = [empty] signal UndefinedOperation").is ==
        verdict::passed);

  const judgement wrong = judgement_of("sub [1.0, 2.0]_com [3.0, 5.0]_com = [-4.0, -1.0]_dac");
  CHECK(wrong.expected == "[-0x1p+2, -0x1p+0]_dac");
  CHECK(wrong.got == "[-0x1p+2, -0x1p+0]_com");
  const judgement unsignalled =
      judgement_of("b-numsToInterval 1.0 2.0 = [1.0, 2.0] signal InvalidOperand");
  CHECK(unsignalled.is == verdict::failed);
  CHECK(unsignalled.expected == "[0x1p+0, 0x1p+1] signal InvalidOperand");
  CHECK(unsignalled.got == "[0x1p+0, 0x1p+1]");
  const judgement signalled = judgement_of("b-numsToInterval 2.0 1.0 = [empty]");
  CHECK(signalled.is == verdict::failed);
  CHECK(signalled.got == "[empty] signal UndefinedOperation");
}

TEST_CASE("itf1788.judge: what is unsupported, and operands too many", "[unit]") {
  const judgement missing =
      judgement_of("frobnicate [1.0, 2.0]_com 7 1.5 {} \"x\" com meets true 1.0f = 1");
  CHECK(missing.is == verdict::unsupported);
  CHECK(missing.missing == "frobnicate(decorated interval, integer, number, array, string, "
                           "decoration, overlap state, boolean, literal that is not known)");
  for (const char* text :
       {"sub [1.0, 2.0] = [1.0, 2.0]", "sub [1.0, 2.0] [1.0, 2.0]_com = [1.0, 2.0]",
        "sub [1.0, 2.0] 2.0 = [1.0, 2.0]", "setDec [1.0, 2.0] = [nai]", "sum_nearest 1.0 = 1.0",
        "dot_nearest {1.0} {1.0, 2.0} = 3.0", "isMember [1.0, 2.0] 1.0 = true",
        "decorationPart [1.0, 2.0] = com", "newDec [1.0, 2.0]_com = [nai]", "pi = 3.0"})
    CHECK(judgement_of(text).is == verdict::unsupported);
  CHECK(judgement_of("neg [1.0, 2.0] [5.0, 6.0] = [-2.0, -1.0]").is == verdict::passed);
}

TEST_CASE("itf1788.call: every form of an operation is called", "[unit]") {
  const value x = bounds{0.5, 0.75}, y = decorated_bounds{{0.5, 0.75}, decoration::com};
  const auto forms = [](std::string_view name, const std::vector<value>& operands) {
    std::vector<std::string> all;
    for (const result& r : call(name, operands))
      all.push_back(r.form);
    return all;
  };
  using list = std::vector<std::string>;
  const list everywhere{"", "interval<>", "graze.h"};
  for (const char* unary : {"recip",
                            "sign",
                            "ceil",
                            "floor",
                            "trunc",
                            "roundTiesToEven",
                            "roundTiesToAway",
                            "exp",
                            "exp2",
                            "exp10",
                            "expm1",
                            "log",
                            "log2",
                            "log10",
                            "logp1",
                            "sin",
                            "cos",
                            "tan",
                            "cot",
                            "sec",
                            "csc",
                            "asin",
                            "acos",
                            "atan",
                            "acot",
                            "sinh",
                            "cosh",
                            "tanh",
                            "coth",
                            "sech",
                            "csch",
                            "asinh",
                            "acosh",
                            "atanh",
                            "acoth",
                            "cbrt",
                            "sqrRev",
                            "absRev",
                            "sinRev",
                            "cosRev",
                            "tanRev",
                            "coshRev",
                            "inf",
                            "sup",
                            "mid",
                            "rad",
                            "wid",
                            "mag",
                            "mig",
                            "isEmpty",
                            "isEntire",
                            "isSingleton",
                            "isCommonInterval"}) {
    INFO(unary);
    CHECK(forms(unary, {x}) == everywhere);
    CHECK_FALSE(forms(unary, {y}).empty());
  }
  for (const char* binary :
       {"atan2",       "hypot",     "pow",          "intersection", "convexHull",    "cancelPlus",
        "cancelMinus", "sqrRevBin", "absRevBin",    "sinRevBin",    "cosRevBin",     "tanRevBin",
        "coshRevBin",  "mulRev",    "mulRevToPair", "equal",        "subset",        "interior",
        "disjoint",    "less",      "strictLess",   "precedes",     "strictPrecedes"}) {
    INFO(binary);
    CHECK(forms(binary, {x, x}) == everywhere);
  }
  for (const char* ternary : {"fma", "mulRevTen", "powRev1", "powRev2"})
    CHECK(forms(ternary, {x, x, x}) == everywhere);
  for (const char* power : {"pown", "rootn", "pownRev"})
    CHECK(forms(power, {x, std::int64_t{3}}) == everywhere);
  CHECK(forms("pownRevBin", {x, x, std::int64_t{3}}) == everywhere);
  CHECK(forms("exp", {y}) == list{"", "decorated<>"});
  CHECK(forms("pown", {y, std::int64_t{3}}) == list{"", "decorated<>"});
  CHECK(forms("sinRevBin", {y, y}) == list{"", "decorated<>"});
  CHECK(forms("add", {y, y}) == list{"", "decorated<>", "an operator of decorated<>"});
  for (const char* name : {"add", "sub", "mul", "div", "min", "max"})
    for (const char* backend : {"nearest", "upward", "switching", "split"}) {
      const auto all = forms(name, {x, x});
      const std::string operator_of = std::string("an operator of interval<") + backend + ">";
      INFO(name << " " << backend);
      CHECK(std::count(all.begin(), all.end(), operator_of) == 1);
      CHECK(std::count(all.begin(), all.end(), "graze.h") == 1);
    }
  CHECK(forms("overlap", {x, x}) == list{"", "graze.h"});
  CHECK(forms("isMember", {0.5, x}) == list{"", "graze.h"});
  CHECK(forms("b-numsToInterval", {0.5, 1.0}) == list{"", "graze.h"});
  CHECK(forms("b-textToInterval", {"[1, 2]"}) == list{"", "graze.h"});
  CHECK(forms("sum_down", {std::vector<double>{1, 2}}) == list{"", "graze.h"});
}

TEST_CASE("itf1788.tighter: only what leaves out no solution", "[mpfr]") {
  const auto proved = [](const std::string& text, const value& got) {
    const auto all = parse("testcase t { " + text + "; }", "t.itl");
    INFO(text << all.reason());
    REQUIRE(all);
    return proved_tighter(all->at(0), all->at(0).tightest.at(0), got);
  };
  // pi lies between 0x1.921fb54442d18p1 and 0x1.921fb54442d19p1
  const std::string at_pi =
      "cosRevBin [-1.0, -1.0] [2.5, 4.5] = [0x1.921fb54442d16p1, 0x1.921fb54442d1ap1]";
  CHECK(proved(at_pi, bounds{0x1.921fb54442d18p1, 0x1.921fb54442d19p1}));
  CHECK(proved(at_pi, bounds{0x1.921fb54442d17p1, 0x1.921fb54442d1ap1}));
  CHECK_FALSE(proved(at_pi, bounds{0x1.921fb54442d19p1, 0x1.921fb54442d1ap1})); // without pi
  CHECK_FALSE(proved(at_pi, bounds{0x1.921fb54442d16p1, 0x1.921fb54442d18p1}));
  CHECK_FALSE(proved(at_pi, bounds::empty()));
  CHECK_FALSE(proved(at_pi, bounds{0x1.921fb54442d15p1, 0x1.921fb54442d19p1})); // not within
  CHECK_FALSE(
      proved(at_pi, decorated_bounds{{0x1.921fb54442d18p1, 0x1.921fb54442d19p1}, decoration::trv}));
  CHECK(proved(at_pi.substr(0, at_pi.find('=')) + "= [0x1.921fb54442d18p1, 4.5]_trv",
               decorated_bounds{{0x1.921fb54442d18p1, 0x1.921fb54442d19p1}, decoration::trv}));
  // asin(0.625) lies between 0x1.59aad71ced00ep-1 and 0x1.59aad71ced00fp-1
  const std::string arc = "sinRevBin [0.0, 0.625] [-0.5, 2.0] = [0.0, 0x1.59aad71ced011p-1]";
  CHECK(proved(arc, bounds{0, 0x1.59aad71ced00fp-1}));
  CHECK_FALSE(proved(arc, bounds{0, 0x1.59aad71ced00ep-1}));
  CHECK_FALSE(proved(arc, bounds{0x1p-1074, 0x1.59aad71ced00fp-1})); // without 0
  // 2 pi more: the piece holds a whole wave
  CHECK_FALSE(
      proved("sinRevBin [0.0, 0.625] [-0.5, 9.0] = [0.0, 7.0]", bounds{0, 0x1.59aad71ced00fp-1}));
  const std::string tangent = "tanRevBin [0.0, 2.75] [-1.5, 1.5] = [0.0, 1.5]";
  CHECK(proved(tangent, bounds{0, 0x1.38d6a6ce13353p0}));
  CHECK_FALSE(proved(tangent, bounds{0, 0x1.38d6a6ce13352p0}));
  CHECK_FALSE(proved("tanRevBin [0.0, 2.75] [-1.5, 4.5] = [0.0, 4.5]",
                     bounds{0, 0x1.38d6a6ce13353p0})); // a pole and a solution between
  const std::string root = "pownRevBin [2.0, 27.0] [0.0, 9.0] 3 = [1.25, 3.5]";
  CHECK(proved(root, bounds{1.25, 3}));
  CHECK(proved(root, bounds{0x1.428a2f98d728ap0, 3})); // below the cube root of 2
  CHECK_FALSE(proved(root, bounds{0x1.428a2f98d728bp0, 3}));
  CHECK_FALSE(proved(root, bounds{1.25, 0x1.7ffffffffffffp1}));
  CHECK_FALSE(proved("pownRevBin [4.0, 9.0] [-9.0, 9.0] 2 = [-3.0, 3.0]", bounds{2, 3}));
  CHECK_FALSE(proved("pownRev [1.0, 4.0] 2 = [-3.0, 2.5]", bounds{-3, -2.5})); // both sides of 0
  CHECK_FALSE(proved("pownRev [0.0, 9.0] 0 = [1.0, 3.0]", bounds{1, 2}));
  const std::string exponent = "powRev2 [0.0625, 1.0] [4.0, infinity] [entire] = [entire]";
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(proved(exponent, bounds{-infinity, -0.5}));
  CHECK_FALSE(proved(exponent, bounds{-infinity, -0.625}));
  CHECK_FALSE(proved(exponent, bounds{-9, -0.5}));
  CHECK_FALSE(proved("powRev2 [0.375, 1.0] [1.0, infinity] [entire] = [entire]",
                     bounds{-infinity, 0.5})); // 1^t = 1
  CHECK(proved("powRev2 [0.25, 0.75] [1.0, infinity] [entire] = [entire]", bounds{-infinity, 0}));
  CHECK_FALSE(proved("powRev2 [0.0625, 1.25] [4.0, infinity] [entire] = [entire]",
                     bounds{-infinity, -0.5}));
  // forward operations and powRev1 never
  CHECK_FALSE(proved("sqrt [4.0, 4.0] = [1.0, 3.0]", bounds{2, 2}));
  CHECK_FALSE(proved("mulRev [2.0, 2.0] [4.0, 4.0] = [1.0, 3.0]", bounds{2, 2}));

  const judgement tighter =
      judgement_of("cosRevBin [-1.0, -1.0] [2.5, 4.5] = [0x1.921fb54442d16p1, 4.5]");
  CHECK(tighter.is == verdict::tighter);
  CHECK(tighter.got == "[0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1]");
}
