// sin_rev cos_rev tan_rev: tightest for arguments of any size, judged by the formula
// (graze/oracle/reverse.hpp).
#include "../support/test_inputs.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <graze/functions/reverse.hpp>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/reverse.hpp>
#include <limits>
#include <numbers>
#include <string>

namespace functions = graze::functions;
namespace oracle = graze::oracle;
using graze::bounds;
using graze::oracle::hard_operands;
using graze::test::input_count;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string text(const bounds& x) {
  char line[80];
  std::snprintf(line, sizeof line, "[%a, %a]", x.lo, x.hi);
  return line;
}

enum class wave { sin, cos, tan };

bounds expected(wave f, const bounds& c, const bounds& x) {
  return f == wave::sin   ? oracle::reverse::sin_rev(c, x)
         : f == wave::cos ? oracle::reverse::cos_rev(c, x)
                          : oracle::reverse::tan_rev(c, x);
}

double direct(wave f, double t, mpfr_rnd_t to) {
  return f == wave::sin   ? oracle::rounded(mpfr_sin, to, t)
         : f == wave::cos ? oracle::rounded(mpfr_cos, to, t)
                          : oracle::rounded(mpfr_tan, to, t);
}
bounds reverse(wave f, const bounds& c, const bounds& x) {
  return f == wave::sin   ? functions::sin_rev::value(c, x)
         : f == wave::cos ? functions::cos_rev::value(c, x)
                          : functions::tan_rev::value(c, x);
}

class inputs : public hard_operands {
public:
  using hard_operands::hard_operands;

  double argument() {
    for (;;) {
      const double x = any_argument();
      if (std::isfinite(x))
        return x;
    }
  }
  /// May be infinite.
  double any_argument() {
    const double sign = coin() ? 1 : -1;
    switch (below(10)) {
    case 0: // tiny to huge
      return sign * any_normal();
    case 1: // where the doubles begin to lie further apart than slack, a crest, a period
      return sign * with_exponent(static_cast<int>(below(50)) + 8);
    case 2: { // the doubles nearest to a multiple of pi/2 among all, and their surroundings
      static const double list[] = {0x1.6ac5b262ca1ffp+849,  0x1.921fb54442d18p+0,
                                    0x1.921fb54442d18p+1,    0x1.6c6cbc45dc8dep+5,
                                    0x1.951a0c8a8ae14p+2,    0x1.d9ba50f60e54dp+118,
                                    0x1.7be4cd5b4f5d0p+1000, 0x1.fffffffffffffp+1023};
      return sign * step(list[below(std::size(list))], static_cast<int>(below(5)) - 2);
    }
    case 3: // small
      return sign * (below(8) == 0 ? 0 : special_finite());
    case 4:
    case 5: { // near a multiple of pi/2
      const double k = static_cast<double>(below(coin() ? 20 : 1 << 20));
      return sign * step(k * (std::numbers::pi / 2), static_cast<int>(below(7)) - 3);
    }
    default:
      return sign * std::ldexp(static_cast<double>(below(std::uint64_t{1} << 53)),
                               -53 + static_cast<int>(below(8)));
    }
  }

  /// A range about y, a value of f.
  bounds range(wave f, double y) {
    switch (below(12)) {
    case 0:
      return {-infinity, y};
    case 1:
      return {y, infinity};
    case 2: { // beside the crests, or the poles
      const double crest = f == wave::tan ? 0x1p+60 : 1;
      const double lo = step(crest, -static_cast<int>(below(5)));
      const double hi = coin() ? lo : step(crest, static_cast<int>(below(3)));
      return coin() ? bounds{std::min(lo, hi), std::max(lo, hi)}
                    : bounds{-std::max(lo, hi), -std::min(lo, hi)};
    }
    case 3: // about 0
      return {coin() ? 0.0 : -std::fabs(special_finite()), coin() ? 0.0 : special_finite()};
    case 4: {
      const double other = std::ldexp(static_cast<double>(below(1 << 20)), -19) - 1;
      return {std::min(y, other), std::max(y, other)};
    }
    case 5: // just out of reach of y
      return coin() ? bounds{above(y), infinity} : bounds{-infinity, below_(y)};
    case 6: {
      const double shifted = coin() ? above(y) : below_(y);
      return {shifted, shifted};
    }
    case 7:
      return {y, y};
    default: {
      double lo = y, hi = y;
      for (auto steps = below(4); steps-- > 0;)
        lo = below_(lo);
      for (auto steps = below(4); steps-- > 0;)
        hi = above(hi);
      return {lo, hi};
    }
    }
  }

  bounds box(double t) {
    double lo = t, hi = t;
    switch (below(10)) {
    case 0:
      break;
    case 1:
      lo = -infinity;
      break;
    case 2:
      hi = infinity;
      break;
    case 3:
    case 4: // a few ulps
      for (auto steps = below(6); steps-- > 0;)
        lo = below_(lo);
      for (auto steps = below(6); steps-- > 0;)
        hi = above(hi);
      break;
    case 5: { // one side, to any length
      const double length = std::ldexp(1 + static_cast<double>(below(1 << 20)), -20);
      hi = t + std::ldexp(length, static_cast<int>(below(60)) - 50);
      break;
    }
    default: {
      lo = t - std::ldexp(static_cast<double>(below(1 << 20)), -18);
      hi = t + std::ldexp(static_cast<double>(below(1 << 20)), -18);
    }
    }
    constexpr double largest = std::numeric_limits<double>::max();
    if (lo == infinity || hi == -infinity || (std::isinf(lo) && std::isinf(hi)))
      return {-largest, largest};
    return {lo, hi};
  }

private:
  static double below_(double x) { return std::nextafter(x, -infinity); }
  static double above(double x) { return std::nextafter(x, infinity); }
  double special_finite() {
    double x = special();
    while (!std::isfinite(x))
      x = special();
    return std::fabs(x);
  }
};

void judge(wave f, const char* name, std::uint64_t seed) {
  inputs in(seed);
  long wrong = 0, empty = 0, large = 0, members = 0, lost = 0;
  std::string failures;
  for (long i = 0; i < input_count(); ++i) {
    const double t = in.argument();
    bounds c = in.range(f, direct(f, t, in.coin() ? MPFR_RNDD : MPFR_RNDU));
    if (in.below(8) == 0) // a range of other values than f's at x
      c = in.range(f, std::ldexp(static_cast<double>(in.below(1 << 21)), -20) - 1);
    const bounds x = in.box(t);
    const bounds result = reverse(f, c, x), right = expected(f, c, x);
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
