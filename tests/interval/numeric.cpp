// Numbers of an interval: GMP's rationals tell what is nearest and what is least.
#include "exact_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/construct.hpp>
#include <graze/numeric.hpp>
#include <graze/oracle/hard_boxes.hpp>

using graze::bounds;
using graze::test::rational;

TEST_CASE("interval.numeric: mid, rad and wid are correctly rounded", "[mpfr][hardcase]") {
  graze::oracle::hard_boxes boxes(6);
  for (int i = 0; i < graze::test::inputs(); ++i) {
    const bounds x = boxes.next();
    CAPTURE(x.lo, x.hi);
    if (!x.is_common())
      continue;
    const mpq_class lo = rational(x.lo), hi = rational(x.hi);
    const double m = graze::mid(x), r = graze::rad(x);
    REQUIRE(m == graze::test::rounded((lo + hi) / 2, MPFR_RNDN));
    REQUIRE(!(m == 0 && std::signbit(m)));
    REQUIRE(x.contains(m));
    REQUIRE(r == graze::test::rounded(std::max<mpq_class>(rational(m) - lo, hi - rational(m)),
                                      MPFR_RNDU));
    REQUIRE(graze::wid(x) == graze::test::rounded(hi - lo, MPFR_RNDU));
    REQUIRE(graze::mag(x) == std::fmax(std::fabs(x.lo), std::fabs(x.hi)));
    REQUIRE(graze::mig(x) == (x.contains(0) ? 0 : std::fmin(std::fabs(x.lo), std::fabs(x.hi))));
    REQUIRE(graze::mid(graze::interval<>(x.lo, x.hi)) == m);
  }
}

TEST_CASE("interval.numeric: empty, unbounded, NaI, signed zeros", "[unit]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  const bounds empty = bounds::empty();
  CHECK(graze::inf(empty) == infinity);
  CHECK(graze::sup(empty) == -infinity);
  using function = double (*)(const bounds&);
  for (const auto number : {function(graze::mid), function(graze::rad), function(graze::wid),
                            function(graze::mag), function(graze::mig)})
    CHECK(std::isnan(number(empty)));
  CHECK(std::signbit(graze::inf(bounds{0.0, 1.0})));
  CHECK(!std::signbit(graze::sup(bounds{-1.0, -0.0})));
  CHECK(graze::mid(bounds::entire()) == 0);
  CHECK(graze::mid(bounds{1, infinity}) == largest);
  CHECK(graze::mid(bounds{-infinity, 1}) == -largest);
  CHECK(graze::rad(bounds::entire()) == infinity);
  CHECK(graze::rad(bounds{1, infinity}) == infinity);
  CHECK(graze::wid(bounds{-largest, largest}) == infinity);
  CHECK(graze::mid_rad(bounds{-largest, largest}).rad == largest);
  CHECK(graze::mag(bounds{-infinity, 1}) == infinity);
  CHECK(graze::mig(bounds{-infinity, -1}) == 1);
  CHECK(!std::signbit(graze::mig(bounds{-0.0, -0.0})));
  CHECK(!std::signbit(graze::mag(bounds{-0.0, -0.0})));
  const auto nai = graze::decorated_bounds::nai();
  CHECK(std::isnan(graze::inf(nai)));
  CHECK(std::isnan(graze::sup(nai)));
  CHECK(std::isnan(graze::mid_rad(nai).mid));
  CHECK(graze::inf(graze::new_dec(empty)) == infinity);
}
