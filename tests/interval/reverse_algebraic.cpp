// sqr_rev abs_rev pown_rev cosh_rev mul_rev mul_rev_to_pair pow_rev1 pow_rev2: tightest, judged by
// MPFR's direct functions (graze/oracle/reverse.hpp).
#include "../support/test_inputs.hpp"
#include <catch2/catch.hpp>
#include <cstdio>
#include <graze/functions/reverse.hpp>
#include <graze/oracle/reverse.hpp>
#include <graze/oracle/reverse_operands.hpp>
#include <string>

namespace functions = graze::functions;
using namespace graze::oracle::reverse;
using graze::bounds;
using namespace graze::test;

namespace {

std::string text(const bounds& x) {
  char line[80];
  std::snprintf(line, sizeof line, "[%a, %a]", x.lo, x.hi);
  return line;
}

struct tally {
  const char* name;
  long judged = 0, empty = 0, points = 0;
  ~tally() {
    std::printf("%s: %ld judged, %ld empty, %ld with x one number\n", name, judged, empty, points);
  }
};

/// Judges a result; on failure says what was asked.
template <class Describe>
bool judge(tally& count, const reverse_judge& equation, const bounds& x, const bounds& result,
           Describe describe) {
  ++count.judged;
  count.empty += result.is_empty();
  count.points += x.lo == x.hi;
  if (equation.tightest(x, result))
    return true;
  FAIL_CHECK(count.name << " " << describe() << " x " << text(x) << " = " << text(result));
  return false;
}

constexpr int most_failures = 10;

template <class Operation, class Direct>
void judge_even(const char* name, Operation operation, Direct f, double least, double greatest) {
  algebraic_operands in(1788);
  tally count{name};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const auto [u, c, x, n] = in.even(f, least, greatest);
    failures +=
        !judge(count, reverse_judge(f, {0}, c), x, operation(c, x), [&] { return "c " + text(c); });
  }
  CHECK(count.judged == input_count());
}

} // namespace

TEST_CASE("interval.reverse: sqr_rev is tightest", "[property][mpfr][hardcase]") {
  judge_even(
      "sqr_rev", [](bounds c, bounds x) { return functions::sqr_rev::value(c, x); }, sqr_at, 0,
      0x1p512);
}
TEST_CASE("interval.reverse: abs_rev is tightest", "[property][mpfr][hardcase]") {
  judge_even(
      "abs_rev", [](bounds c, bounds x) { return functions::abs_rev::value(c, x); }, abs_at, 0,
      std::numeric_limits<double>::max());
}
TEST_CASE("interval.reverse: cosh_rev is tightest", "[property][mpfr][hardcase]") {
  judge_even(
      "cosh_rev", [](bounds c, bounds x) { return functions::cosh_rev::value(c, x); }, cosh_at, 1,
      710);
}

TEST_CASE("interval.reverse: pown_rev is tightest", "[property][mpfr][hardcase]") {
  algebraic_operands in(1789);
  tally count{"pown_rev"};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const auto [u, c, x, n] = in.pown();
    failures += !judge(count, of_pown(c, n), x, functions::pown_rev::value(c, x, n),
                       [&] { return "c " + text(c) + " n " + std::to_string(n); });
  }
  CHECK(count.judged == input_count());
}

TEST_CASE("interval.reverse: mul_rev and mul_rev_to_pair are tightest",
          "[property][mpfr][hardcase]") {
  algebraic_operands in(1790);
  tally count{"mul_rev"}, pairs{"mul_rev_to_pair"};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const auto [b, c, x, n] = in.mul();
    const reverse_judge equation = of_mul(b, c);
    const auto describe = [&] { return "b " + text(b) + " c " + text(c); };
    failures += !judge(count, equation, x, functions::mul_rev::value(b, c, x), describe);

    const auto [first, second] = functions::mul_rev_to_pair::value(b, c);
    if (second.is_empty()) {
      failures += !judge(pairs, equation, bounds::entire(), first, describe);
      continue;
    }
    // Two pieces: the solutions on each side of 0, which is none.
    const bool sides = first.hi <= 0 && second.lo >= 0 && !equation.is_solution(0);
    CHECK(sides);
    failures += !judge(pairs, equation, {-unbounded, 0}, first, describe) + !sides;
    failures += !judge(pairs, equation, {0, unbounded}, second, describe);
  }
  CHECK(count.judged == input_count());
}

TEST_CASE("interval.reverse: pow_rev1 and pow_rev2 are tightest", "[property][mpfr][hardcase]") {
  algebraic_operands in(1791);
  tally by_base{"pow_rev1"}, by_exponent{"pow_rev2"};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const auto [base, c, exponent, n] = in.pow();
    failures +=
        !judge(by_base, of_pow1(exponent, c), base, functions::pow_rev1::value(exponent, c, base),
               [&] { return "b " + text(exponent) + " c " + text(c); });
    failures += !judge(by_exponent, of_pow2(base, c), exponent,
                       functions::pow_rev2::value(base, c, exponent),
                       [&] { return "a " + text(base) + " c " + text(c); });
  }
  CHECK(by_base.judged == input_count());
}
