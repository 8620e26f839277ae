// sin_rev cos_rev tan_rev: tightest for arguments of any size, judged by the formula
// (graze/oracle/reverse.hpp).
#include "../support/test_inputs.hpp"
#include <catch2/catch.hpp>
#include <cstdio>
#include <graze/functions/reverse.hpp>
#include <graze/oracle/reverse_operands.hpp>
#include <string>

namespace functions = graze::functions;
namespace oracle = graze::oracle;
using namespace graze::oracle::reverse;
using graze::bounds;
using graze::test::input_count;

namespace {

std::string text(const bounds& x) {
  char line[80];
  std::snprintf(line, sizeof line, "[%a, %a]", x.lo, x.hi);
  return line;
}

bounds expected(wave f, const bounds& c, const bounds& x) {
  return f == wave::sin   ? oracle::reverse::sin_rev(c, x)
         : f == wave::cos ? oracle::reverse::cos_rev(c, x)
                          : oracle::reverse::tan_rev(c, x);
}

bounds computed(wave f, const bounds& c, const bounds& x) {
  return f == wave::sin   ? functions::sin_rev::value(c, x)
         : f == wave::cos ? functions::cos_rev::value(c, x)
                          : functions::tan_rev::value(c, x);
}

void judge(wave f, const char* name, std::uint64_t seed) {
  trigonometric_operands in(seed);
  long wrong = 0, empty = 0, large = 0, members = 0, lost = 0;
  std::string failures;
  for (long i = 0; i < input_count(); ++i) {
    const auto [t, c, x] = in.next(f);
    const bounds result = computed(f, c, x), right = expected(f, c, x);
    const bool same =
        right.is_empty() ? result.is_empty() : result.lo == right.lo && result.hi == right.hi;
    empty += right.is_empty();
    large += std::fabs(t) >= 0x1p50;
    if (!same && ++wrong <= 10)
      failures +=
          "\n  c " + text(c) + " x " + text(x) + " = " + text(result) + ", not " + text(right);
    // A member, by the direct function: t itself.
    if (x.contains(t) && c.lo <= direct(f, t, MPFR_RNDD) && direct(f, t, MPFR_RNDU) <= c.hi) {
      ++members;
      lost += !result.contains(t);
    }
  }
  std::printf("%s: %ld judged, %ld empty, %ld with abs(x) >= 2^50, %ld known members, %ld wrong\n",
              name, input_count(), empty, large, members, wrong);
  INFO(name << failures);
  CHECK(wrong == 0);
  CHECK(lost == 0);
}

} // namespace

TEST_CASE("interval.reverse: sin_rev is tightest", "[property][mpfr][hardcase]") {
  judge(wave::sin, "sin_rev", 17880);
}
TEST_CASE("interval.reverse: cos_rev is tightest", "[property][mpfr][hardcase]") {
  judge(wave::cos, "cos_rev", 17881);
}
TEST_CASE("interval.reverse: tan_rev is tightest", "[property][mpfr][hardcase]") {
  judge(wave::tan, "tan_rev", 17882);
}
