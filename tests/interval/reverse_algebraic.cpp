// sqr_rev abs_rev pown_rev cosh_rev mul_rev mul_rev_to_pair pow_rev1 pow_rev2: tightest, judged by
// MPFR's direct functions (reverse_judge.hpp).
#include "hard_operands.hpp"
#include "reverse_judge.hpp"
#include "../support/test_inputs.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <climits>
#include <cstdio>
#include <graze/functions/reverse.hpp>
#include <graze/oracle/elementary.hpp>
#include <string>

namespace functions = graze::functions;
namespace oracle = graze::oracle;
using graze::bounds;
using namespace graze::test;

namespace {

std::string text(const bounds& x) {
  char line[80];
  std::snprintf(line, sizeof line, "[%a, %a]", x.lo, x.hi);
  return line;
}

template <class Function, class... Doubles> rounded_value by_mpfr(Function f, Doubles... x) {
  return {oracle::rounded_down(f, x...), oracle::rounded_up(f, x...)};
}

const rounded_value plus_infinity = value_below(unbounded),
                    minus_infinity = value_above(-unbounded);

// --- f at a place -----------------------------------------------------------------------------

image abs_at(place p) {
  if (std::isinf(p.t))
    return single(plus_infinity);
  return single(p.side == 0 ? exact_value(std::fabs(p.t)) : value_above(0));
}
image sqr_at(place p) {
  return std::isinf(p.t) || p.side != 0 ? abs_at(p) : single(by_mpfr(mpfr_sqr, p.t));
}
image cosh_at(place p) {
  if (std::isinf(p.t))
    return single(plus_infinity);
  return single(p.side == 0 ? by_mpfr(mpfr_cosh, p.t) : value_above(1));
}

image pown_at(place p, int n) {
  if (n == 0)
    return single(exact_value(1));
  const bool at_0 = p.t == 0;
  if (at_0 && p.side == 0)
    return n < 0 ? undefined_image : single(exact_value(0));
  if (at_0 || std::isinf(p.t)) {
    const bool negative = n % 2 != 0 && (at_0 ? p.side : p.t) < 0;
    if (at_0 == (n < 0))
      return single(negative ? minus_infinity : plus_infinity);
    return single(negative ? value_below(0) : value_above(0));
  }
  return single(by_mpfr(
      [n](mpfr_ptr r, mpfr_ptr t, mpfr_rnd_t to) { return mpfr_pow_si(r, t, n, to); }, p.t));
}

/// u t for a bound u of b, which is not attained where it is infinite.
rounded_value times(double u, place p) {
  const double sign = p.t == 0 ? p.side : p.t;
  if (u == 0 || sign == 0)
    return exact_value(0);
  const bool negative = (u < 0) != (sign < 0);
  if (std::isinf(u) || std::isinf(p.t))
    return negative ? minus_infinity : plus_infinity;
  if (p.side != 0)
    return negative ? value_below(0) : value_above(0);
  return by_mpfr(mpfr_mul, u, p.t);
}
image multiples(const bounds& b, place p) {
  const rounded_value one = times(b.lo, p), other = times(b.hi, p);
  const bool reversed = (p.t == 0 ? p.side : p.t) < 0;
  return reversed ? image{other, one} : image{one, other};
}

/// u^y for u > 0 and real y, each of them a double or infinitely close to one: 0, 1, or unbounded.
rounded_value power(place u, place y) {
  const double exponent_sign = y.t == 0 ? y.side : y.t;
  const double base_side = u.t == 1 ? u.side : u.t - 1;
  if (exponent_sign == 0 || base_side == 0)
    return exact_value(1);
  const bool grows = (exponent_sign > 0) == (base_side > 0);
  if ((u.t == 0 && u.side > 0) || std::isinf(u.t) || std::isinf(y.t))
    return grows ? plus_infinity : value_above(0);
  if (u.side != 0 || y.side != 0)
    return grows ? value_above(1) : value_below(1);
  return by_mpfr(mpfr_pow, u.t, y.t);
}
place member(double end) { return {end, std::isinf(end) ? (end < 0 ? 1 : -1) : 0}; }

image powers_of(place t, const bounds& b) { // { t^y : y in b }
  if (t.t < 0 || (t.t == 0 && t.side < 0))
    return undefined_image;
  if (t.t == 0 && t.side == 0)
    return b.hi > 0 ? single(exact_value(0)) : undefined_image;
  const rounded_value one = power(t, member(b.lo)), other = power(t, member(b.hi));
  const bool falls = t.t < 1 || (t.t == 1 && t.side < 0);
  return falls ? image{other, one} : image{one, other};
}
image powers_to(place t, const bounds& a) { // { u^t : u in a }
  const double sign = t.t == 0 ? t.side : t.t;
  if (a.hi < 0 || (a.hi == 0 && sign <= 0))
    return undefined_image;
  if (a.hi == 0)
    return single(exact_value(0));
  const rounded_value largest_base = power(member(a.hi), t);
  if (a.lo > 0) {
    const rounded_value least_base = power(member(a.lo), t);
    return sign < 0 ? image{largest_base, least_base} : image{least_base, largest_base};
  }
  if (sign > 0)
    return {exact_value(0), largest_base};
  return sign < 0 ? image{largest_base, plus_infinity} : single(exact_value(1));
}

// --- inputs -----------------------------------------------------------------------------------

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
        end = direction < 0 ? graze::test::below(end) : graze::test::above(end);
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
    const auto f = [n](place p) { return pown_at(p, n); };
    failures += !judge(count, reverse_judge(f, {0}, c), x, functions::pown_rev::value(c, x, n),
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
    const auto f = [&b](place p) { return multiples(b, p); };
    const reverse_judge of(f, {0}, c);
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

    const auto of_base = [&](place p) { return powers_of(p, exponent); };
    failures += !judge(by_base, reverse_judge(of_base, {0, 1}, c), base,
                       functions::pow_rev1::value(exponent, c, base),
                       [&] { return "b " + text(exponent) + " c " + text(c); });
    const auto of_exponent = [&](place p) { return powers_to(p, base); };
    failures += !judge(by_exponent, reverse_judge(of_exponent, {0}, c), exponent,
                       functions::pow_rev2::value(base, c, exponent),
                       [&] { return "a " + text(base) + " c " + text(c); });
  }
  CHECK(by_base.judged == input_count());
}
