// Reverse operations: values worked out by hand, decorations, and the functions of interval types.
#include <catch2/catch.hpp>
#include <graze/functions/reverse.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>
#include <vector>

using graze::bounds;
using graze::decoration;
namespace functions = graze::functions;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
const bounds entire = bounds::entire(), empty = bounds::empty();

bool equal(const bounds& a, const bounds& b) {
  return a.is_empty() || b.is_empty() ? a.is_empty() && b.is_empty() : a.lo == b.lo && a.hi == b.hi;
}

} // namespace

TEST_CASE("interval.reverse: nothing comes of the empty set", "[unit]") {
  for (const bounds& x : {empty, entire, bounds{1, 2}})
    for (const bounds& c : {empty, entire, bounds{-1, 1}, bounds{0.5, 0.5}}) {
      if (!c.is_empty() && !x.is_empty())
        continue;
      CHECK(functions::sqr_rev::value(c, x).is_empty());
      CHECK(functions::abs_rev::value(c, x).is_empty());
      CHECK(functions::cosh_rev::value(c, x).is_empty());
      CHECK(functions::sin_rev::value(c, x).is_empty());
      CHECK(functions::cos_rev::value(c, x).is_empty());
      CHECK(functions::tan_rev::value(c, x).is_empty());
      for (const int n : {-2, -1, 0, 1, 2, 3})
        CHECK(functions::pown_rev::value(c, x, n).is_empty());
      for (const bounds& b : {empty, entire, bounds{0, 1}}) {
        CHECK(functions::mul_rev::value(b, c, x).is_empty());
        CHECK(functions::pow_rev1::value(b, c, x).is_empty());
        CHECK(functions::pow_rev2::value(b, c, x).is_empty());
      }
    }
  CHECK(functions::mul_rev::value(empty, entire, entire).is_empty());
  CHECK(functions::pow_rev1::value(empty, entire, entire).is_empty());
  CHECK(functions::pow_rev2::value(empty, entire, entire).is_empty());
}

TEST_CASE("interval.reverse: sin_rev, cos_rev and tan_rev far out", "[unit][hardcase]") {
  using functions::cos_rev;
  using functions::sin_rev;
  using functions::tan_rev;
  // From 2^56 on, doubles are 16 apart, more than two periods: between any two lies a solution.
  const bounds far = {0x1p1000, 0x1.0000000000001p1000};
  for (const bounds& c : {bounds{0, 0}, bounds{1, 1}, bounds{-1, -1}, bounds{0.5, 0.5}}) {
    CHECK(equal(sin_rev::value(c, far), far));
    CHECK(equal(cos_rev::value(c, far), far));
    CHECK(equal(tan_rev::value(c, far), far));
    CHECK(sin_rev::value(c, {far.lo, far.lo}).is_empty());
    CHECK(cos_rev::value(c, {far.hi, far.hi}).is_empty());
    CHECK(equal(sin_rev::value(c, {-infinity, -largest}), {-infinity, -largest}));
    CHECK(equal(tan_rev::value(c, {largest, infinity}), {largest, infinity}));
  }
  // 0x1.6ac5b262ca1ffp+849 is 2^-60.9 off an odd multiple of pi/2, closer than any other double.
  const double pole = 0x1.6ac5b262ca1ffp+849;
  CHECK(equal(sin_rev::value({0x1.fffffffffffffp-1, 1}, {pole, pole}), {pole, pole}));
  CHECK(sin_rev::value({1, 1}, {pole, pole}).is_empty());
  CHECK(cos_rev::value({0, 0}, {pole, pole}).is_empty());
  CHECK(tan_rev::value({-1, 1}, {pole, pole}).is_empty());
}

TEST_CASE("interval.reverse: sin_rev, cos_rev and tan_rev near 0, crests and poles",
          "[unit][hardcase]") {
  using functions::cos_rev;
  using functions::sin_rev;
  using functions::tan_rev;
  const double pi_down = 0x1.921fb54442d18p+1, pi_up = 0x1.921fb54442d19p+1;
  const double half_down = pi_down / 2, half_up = pi_up / 2;
  // pi and pi/2 alone, and no crest within half a pi.
  CHECK(equal(cos_rev::value({-1, -1}, {3, 4}), {pi_down, pi_up}));
  CHECK(equal(cos_rev::value({-1, -1}, {-4, 3}), {-pi_up, -pi_down}));
  CHECK(equal(sin_rev::value({1, 1}, {0, 4}), {half_down, half_up}));
  CHECK(equal(sin_rev::value({0, 0}, {1, 4}), {pi_down, pi_up}));
  CHECK(equal(sin_rev::value({0, 0}, {-1, 4}), {0, pi_up}));
  CHECK(equal(tan_rev::value({0, 0}, {least, 4}), {pi_down, pi_up}));
  CHECK(cos_rev::value({1, 1}, {least, 6}).is_empty());
  CHECK(equal(cos_rev::value({1, 1}, {-1, 6}), {0, 0}));
  // sin t < t < tan t: the solutions of sin t = least and tan t = least are on either side of it.
  CHECK(equal(sin_rev::value({least, least}, {-1, 1}), {least, 2 * least}));
  CHECK(equal(tan_rev::value({least, least}, {-1, 1}), {0, least}));
  // A pole is the end of the solutions that come near it.
  CHECK(equal(tan_rev::value({0x1p60, infinity}, {0, 2}), {half_down, half_up}));
  CHECK(equal(tan_rev::value({-infinity, -0x1p60}, {0, 2}), {half_down, half_up}));
  CHECK(tan_rev::value({0x1p60, infinity}, {half_up, 3}).is_empty());
  CHECK(tan_rev::value({-infinity, -0x1p60}, {0, half_down}).is_empty());
  CHECK(equal(tan_rev::value(entire, {1, 2}), {1, 2}));
}

TEST_CASE("interval.reverse: pown_rev with the extreme exponents", "[unit][hardcase]") {
  using functions::pown_rev;
  const int greatest = std::numeric_limits<int>::max(), smallest = std::numeric_limits<int>::min();
  CHECK(equal(pown_rev::value({1, 1}, greatest), {1, 1}));
  CHECK(equal(pown_rev::value({1, 1}, smallest), {-1, 1}));
  CHECK(equal(pown_rev::value({0, infinity}, smallest), entire));
  CHECK(pown_rev::value({0, 0}, smallest).is_empty());
  CHECK(pown_rev::value(entire, {0, 0}, -1).is_empty());
  CHECK(equal(pown_rev::value({-1, 1}, {0, 5}, -1), {1, 5}));
  CHECK(equal(pown_rev::value({least, least}, -1074), {-2, 2}));
  CHECK(equal(pown_rev::value({least, 0x1p1000}, 1), {least, 0x1p1000}));
  CHECK(equal(pown_rev::value({0, least}, {0, infinity}, -1), {largest, infinity}));
}

TEST_CASE("interval.reverse: pow_rev1 and pow_rev2 at their open ends", "[unit][hardcase]") {
  using functions::pow_rev1;
  using functions::pow_rev2;
  // t^u < 1 for u < 0 and any t > 1: 1 is the end of these t and not one of them.
  CHECK(equal(pow_rev1::value({-infinity, -1}, {0, 0.5}, {0.5, 8}), {1, 8}));
  CHECK(pow_rev1::value({-infinity, -1}, {0, 0.5}, {0.5, 1}).is_empty());
  CHECK(pow_rev1::value({-1, -1}, entire, {0, 0}).is_empty());
  CHECK(equal(pow_rev1::value({0, 1}, {0, 0}, {-1, 1}), {0, 0}));
  CHECK(equal(pow_rev1::value({0x1p-1074, 0x1p-1074}, {2, 2}), {largest, infinity}));
  CHECK(equal(pow_rev1::value({-least, -least}, {2, 2}), {0, least}));
  CHECK(equal(pow_rev1::value({1e300, 1e300}, {2, 2}), {1, 0x1.0000000000001p0}));
  CHECK(equal(pow_rev2::value({0.5, 0.5}, {4, infinity}), {-infinity, -2}));
  CHECK(equal(pow_rev2::value({0.25, 0.5}, {2, infinity}), {-infinity, -0.5}));
  CHECK(equal(pow_rev2::value({2, infinity}, {4, 8}), {0, 3}));
  CHECK(pow_rev2::value({2, infinity}, {4, 8}, {-1, 0}).is_empty());
  CHECK(pow_rev2::value({0, 0}, {0, 0}, {-1, 0}).is_empty());
  CHECK(equal(pow_rev2::value({0, 0}, {0, 0}, {-1, 1}), {0, 1}));
}

TEST_CASE("interval.reverse: mul_rev_to_pair has the decoration of a division", "[unit]") {
  using pair = functions::mul_rev_to_pair;
  const auto decoration_of = [](const bounds& b, const bounds& c) {
    return graze::local_decoration<pair>(pair::value(b, c).first, b, c);
  };
  CHECK(decoration_of({1, 2}, {3, 4}) == decoration::com);
  CHECK(decoration_of({1, 2}, {3, infinity}) == decoration::dac);
  CHECK(decoration_of({1, infinity}, {3, 4}) == decoration::dac);
  CHECK(decoration_of({least, 1}, {1, 1}) == decoration::dac); // the quotient overflows
  CHECK(decoration_of({0, 2}, {3, 4}) == decoration::trv);
  CHECK(decoration_of({-1, 2}, {0, 4}) == decoration::trv);
  CHECK(decoration_of(empty, {3, 4}) == decoration::trv);
  CHECK(decoration_of({1, 2}, empty) == decoration::trv);

  const auto [negative, positive] = pair::value({-2, 4}, {1, 1});
  CHECK(equal(negative, {-infinity, -0.5}));
  CHECK(equal(positive, {0.25, infinity}));
  CHECK(graze::local_decoration<functions::sin_rev>(bounds{0, 0}, bounds{0, 0}, bounds{-1, 1}) ==
        decoration::trv);
}

TEST_CASE("interval.reverse: functions of every interval type", "[unit]") {
  using I = graze::interval<>;
  using U = graze::interval<graze::rounding::upward>;
  const auto same = [](const auto& a, const auto& b) {
    return graze::empty(a) ? graze::empty(b) : a.lower() == b.lower() && a.upper() == b.upper();
  };
  CHECK(same(sqr_rev(I(4, 9)), I(-3, 3)));
  CHECK(same(sqr_rev(I(4, 9), I(0, 5)), I(2, 3)));
  CHECK(same(abs_rev(U(1, 2), U(-5, 0)), U(-2, -1)));
  CHECK(same(abs_rev(U(-2, -1)), U::empty()));
  CHECK(same(pown_rev(I(8, 27), 3), I(2, 3)));
  CHECK(same(pown_rev(I(8, 27), I(0, 2.5), 3), I(2, 2.5)));
  CHECK(same(sin_rev(I(2, 3)), I::empty()));
  CHECK(same(sin_rev(I(0), I(-1, 1)), I(0)));
  CHECK(same(cos_rev(I(-1, 1)), I::whole()));
  CHECK(same(cos_rev(I(1), I(-1, 1)), I(0)));
  CHECK(same(tan_rev(I(0)), I::whole()));
  CHECK(same(tan_rev(U(0), U(-1, 1)), U(0)));
  CHECK(same(cosh_rev(I(0, 1)), I(0)));
  CHECK(same(cosh_rev(I(1, 2), I(1, 1.25)), I(1, 1.25)));
  CHECK(same(mul_rev(I(2), I(1, 4)), I(0.5, 2)));
  CHECK(same(mul_rev(I(-1, 1), I(1, 4), I(0, 9)), I(1, 9)));
  CHECK(same(mul_rev_to_pair(I(-1, 1), I(1, 4)).first, I(-infinity, -1, true)));
  CHECK(same(mul_rev_to_pair(I(-1, 1), I(1, 4)).second, I(1, infinity, true)));
  CHECK(same(pow_rev1(I(2), I(4, 9)), I(2, 3)));
  CHECK(same(pow_rev1(I(2), I(4, 9), I(0, 2.5)), I(2, 2.5)));
  CHECK(same(pow_rev2(I(2), I(4, 8)), I(2, 3)));
  CHECK(same(pow_rev2(I(2), I(4, 8), I(0, 2.5)), I(2, 2.5)));
}
