/// When a result counts as the one that a file states.
#include <catch2/catch.hpp>
#include <graze/itf1788/run.hpp>
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
                           "decoration, overlap state, boolean, number that is not binary64)");
  for (const char* text :
       {"sub [1.0, 2.0] = [1.0, 2.0]", "sub [1.0, 2.0] [1.0, 2.0]_com = [1.0, 2.0]",
        "sub [1.0, 2.0] 2.0 = [1.0, 2.0]", "setDec [1.0, 2.0] = [nai]", "sum_nearest 1.0 = 1.0",
        "dot_nearest {1.0} {1.0, 2.0} = 3.0", "isMember [1.0, 2.0] 1.0 = true",
        "decorationPart [1.0, 2.0] = com", "newDec [1.0, 2.0]_com = [nai]", "pi = 3.0"})
    CHECK(judgement_of(text).is == verdict::unsupported);
  CHECK(judgement_of("neg [1.0, 2.0] [5.0, 6.0] = [-2.0, -1.0]").is == verdict::passed);
}
