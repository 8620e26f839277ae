// sqr_rev abs_rev pown_rev cosh_rev mul_rev mul_rev_to_pair pow_rev1 pow_rev2: tightest, judged by
// MPFR's direct functions (graze/oracle/reverse.hpp).
#include "../support/test_inputs.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <climits>
#include <cstdio>
#include <graze/functions/reverse.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/reverse.hpp>
#include <string>

namespace functions = graze::functions;
using graze::oracle::hard_operands;
using graze::oracle::hardness;
using namespace graze::oracle::reverse;
using graze::bounds;
using namespace graze::test;

namespace {

std::string text(const bounds& x) {
  char line[80];
  std::snprintf(line, sizeof line, "[%a, %a]", x.lo, x.hi);
  return line;
}

class inputs : public hard_operands {
public:
  using hard_operands::hard_operands;

  /// Any double, often a hard one; finite.
  double number() {
    for (;;) {
      const auto h = static_cast<hardness>(below(static_cast<std::uint64_t>(hardness::count)));
      const double x = next(h).x;
      if (std::isfinite(x))
        return x;
    }
  }
  /// A double near 1 or of everyday size, as it suits powers.
  double near_one() {
    switch (below(6)) {
    case 0:
      return step(1, static_cast<int>(below(9)) - 4);
    case 1:
      return with_exponent(static_cast<int>(below(80)) - 40);
    case 2:
      return std::ldexp(1.0, static_cast<int>(below(40)) - 20);
    case 3:
      return 1 + std::ldexp(coin() ? 1.0 : -0.5, -static_cast<int>(below(52)));
    default:
      return with_exponent(static_cast<int>(below(6)) - 3);
    }
  }
  double exponent() {
    static const double list[] = {0,  0.5,     1,    2,         3,      4,     -1,
                                  -2, -0.5,    0.25, 0x1p-1074, 1e-300, 1e300, 0.1,
                                  -7, 1.0 / 3, 53,   -1e18,     0x1p-60};
    switch (below(4)) {
    case 0:
      return list[below(std::size(list))];
    case 1:
      return number();
    default:
      return (coin() ? -1 : 1) * with_exponent(static_cast<int>(below(10)) - 5);
    }
  }
  /// An interval about t: often t alone, or a few ulps wide, or unbounded.
  bounds about(double t) {
    double lo = t, hi = t;
    widen(lo, -1);
    widen(hi, 1);
    return lo <= hi ? bounds{lo, hi} : bounds{hi, lo};
  }

private:
  void widen(double& end, int direction) {
    switch (below(8)) {
    case 0:
    case 1:
      return;
    case 2:
      end = direction * unbounded;
      return;
    case 3:
      end = 0;
      return;
    case 4:
      end = static_cast<double>(below(3)) - 1;
      return;
    case 5: {
      const double other = number();
      end = direction < 0 ? std::min(end, other) : std::max(end, other);
      return;
    }
    default:
      for (auto steps = below(4); steps-- > 0;)
        end =
            direction < 0 ? graze::oracle::reverse::below(end) : graze::oracle::reverse::above(end);
      if (!std::isfinite(end)) // not an end of a set that holds real numbers only
        end = direction * std::numeric_limits<double>::max();
    }
  }
};

struct tally {
  const char* name;
  long judged = 0, empty = 0, points = 0;
  ~tally() {
    std::printf("%s: %ld judged, %ld empty, %ld with x one number\n", name, judged, empty, points);
  }
};

/// Judges a result; on failure says what was asked.
template <class Describe>
bool judge(tally& count, const reverse_judge& of, const bounds& x, const bounds& result,
           Describe describe) {
  ++count.judged;
  count.empty += result.is_empty();
  count.points += x.lo == x.hi;
  if (of.tightest(x, result))
    return true;
  FAIL_CHECK(count.name << " " << describe() << " x " << text(x) << " = " << text(result));
  return false;
}

constexpr int most_failures = 10;

/// c about f(t), x about t: with the solution at or near an end of x, or out of reach.
template <class Operation, class Direct>
void judge_even(const char* name, Operation operation, Direct f, double least, double greatest) {
  inputs in(1788);
  tally count{name};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    double t = in.number();
    if (std::fabs(t) > greatest)
      t = in.below(4) == 0 ? std::copysign(greatest, t) : std::ldexp(t, -std::ilogb(t));
    const double y = std::clamp(f({t, 0}).lo.down, -std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::max());
    const bounds c = in.below(16) == 0 ? in.about(least) : in.about(y);
    const bounds x = in.below(8) == 0 ? bounds::entire() : in.about(in.coin() ? t : -t);
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
  inputs in(1789);
  tally count{"pown_rev"};
  int failures = 0;
  static const int list[] = {0,  1, 2,    3,     -1,     -2,     -3,      4,       8,
                             -8, 7, 1023, -1074, 100000, -99999, INT_MAX, INT_MIN, INT_MIN + 1};
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const int n = in.coin() ? list[in.below(std::size(list))] : static_cast<int>(in.below(60)) - 30;
    // Roots of any double, and doubles whose powers are near the ends of the range.
    double t = (in.coin() ? 1 : -1) *
               (n >= -1 && n <= 1 ? std::fabs(in.number())
                                  : std::exp2((static_cast<double>(in.below(2100)) - 1074) / n));
    t = hard_operands::step(t, static_cast<int>(in.below(1000)));
    if (!std::isfinite(t) || in.below(4) == 0)
      t = t != 0 && std::isfinite(t) && in.coin() ? std::ldexp(t < 0 ? -1.0 : 1.0, std::ilogb(t))
                                                  : in.number();
    const double y =
        std::clamp(pown_at(t == 0 ? place{1, 0} : place{t, 0}, n).lo.down,
                   -std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
    const bounds c = in.about(y);
    const bounds x = in.below(8) == 0 ? bounds::entire() : in.about(in.below(4) != 0 ? t : -t);
    failures += !judge(count, of_pown(c, n), x, functions::pown_rev::value(c, x, n),
                       [&] { return "c " + text(c) + " n " + std::to_string(n); });
  }
  CHECK(count.judged == input_count());
}

TEST_CASE("interval.reverse: mul_rev and mul_rev_to_pair are tightest",
          "[property][mpfr][hardcase]") {
  inputs in(1790);
  tally count{"mul_rev"}, pairs{"mul_rev_to_pair"};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const auto h = static_cast<hardness>(in.below(static_cast<std::uint64_t>(hardness::count)));
    const auto [dividend, divisor] = in.next(h);
    if (!std::isfinite(dividend) || !std::isfinite(divisor)) {
      --i;
      continue;
    }
    const bounds b = in.about(divisor), c = in.about(dividend);
    const double quotient = divisor == 0 ? in.number() : dividend / divisor;
    const bounds x =
        in.below(8) == 0 || !std::isfinite(quotient) ? bounds::entire() : in.about(quotient);
    const reverse_judge of = of_mul(b, c);
    const auto describe = [&] { return "b " + text(b) + " c " + text(c); };
    failures += !judge(count, of, x, functions::mul_rev::value(b, c, x), describe);

    const auto [first, second] = functions::mul_rev_to_pair::value(b, c);
    if (second.is_empty()) {
      failures += !judge(pairs, of, bounds::entire(), first, describe);
      continue;
    }
    // Two pieces: the solutions on each side of 0, which is none.
    const bool sides = first.hi <= 0 && second.lo >= 0 && !of.is_solution(0);
    CHECK(sides);
    failures += !judge(pairs, of, {-unbounded, 0}, first, describe) + !sides;
    failures += !judge(pairs, of, {0, unbounded}, second, describe);
  }
  CHECK(count.judged == input_count());
}

TEST_CASE("interval.reverse: pow_rev1 and pow_rev2 are tightest", "[property][mpfr][hardcase]") {
  inputs in(1791);
  tally by_base{"pow_rev1"}, by_exponent{"pow_rev2"};
  int failures = 0;
  for (long i = 0; i < input_count() && failures < most_failures; ++i) {
    const double u = in.below(8) == 0 ? std::fabs(in.number()) : in.near_one();
    const double y = in.exponent();
    const double z =
        std::clamp(u == 0 ? 0.0 : std::pow(u, y), 0.0, std::numeric_limits<double>::max());
    const bounds base = in.about(u), exponent = in.about(y), c = in.about(z);

    failures +=
        !judge(by_base, of_pow1(exponent, c), base, functions::pow_rev1::value(exponent, c, base),
               [&] { return "b " + text(exponent) + " c " + text(c); });
    failures += !judge(by_exponent, of_pow2(base, c), exponent,
                       functions::pow_rev2::value(base, c, exponent),
                       [&] { return "a " + text(base) + " c " + text(c); });
  }
  CHECK(by_base.judged == input_count());
}
