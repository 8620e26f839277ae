// The seam of graze::interval: construction, sets, comparisons, and use in Boost.Interval code.
#include <boost/numeric/interval/io.hpp>
#include <catch2/catch.hpp>
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>

namespace rounding = graze::rounding;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEMPLATE_TEST_CASE("interval.construction: what holds no real number is empty", "[unit]",
                   rounding::nearest, rounding::upward) {
  using I = graze::interval<TestType>;
  CHECK(empty(I(not_a_number)));
  CHECK(empty(I(1.0, not_a_number)));
  CHECK(empty(I(2.0, 1.0)));
  CHECK(empty(I(infinity)));
  CHECK(empty(I(-infinity, -infinity)));
  CHECK(empty(I(2.0, 1.0) + I(1.0)));
  CHECK(empty(I(1.0) * infinity));
  CHECK(empty(infinity * I(-1.0, 1.0)));
  CHECK(empty(not_a_number - I(1.0)));
  CHECK(empty(I(1.0, 2.0) / 0.0));
  CHECK(!empty(I(1.0, infinity)));
  CHECK(I() == I(0.0));
}

TEST_CASE("interval.construction: other number types are rounded outward", "[unit]") {
  using I = graze::interval<>;
  const I integer((1LL << 62) + 1), top(std::numeric_limits<std::int64_t>::max()),
      bottom(std::numeric_limits<std::int64_t>::min()),
      unsigned_top(std::numeric_limits<std::uint64_t>::max());
  CHECK(integer.lower() == 0x1p62);
  CHECK(integer.upper() == 0x1.0000000000001p+62);
  CHECK(top.lower() == 0x1.fffffffffffffp+62);
  CHECK(top.upper() == 0x1p63);
  CHECK(bottom == I(-0x1p63));
  CHECK(unsigned_top.lower() == 0x1.fffffffffffffp+63);
  CHECK(unsigned_top.upper() == 0x1p64);
  const I tenth(0.1L), huge(std::numeric_limits<long double>::max()),
      tiny(std::numeric_limits<long double>::denorm_min());
  CHECK(tenth.lower() == 0x1.9999999999999p-4);
  CHECK(tenth.upper() == 0x1.999999999999ap-4);
  CHECK(huge.lower() == std::numeric_limits<double>::max());
  CHECK(huge.upper() == infinity);
  CHECK(tiny.lower() == 0);
  CHECK(tiny.upper() == std::numeric_limits<double>::denorm_min());
  CHECK(I(0.1f).lower() == I(0.1f).upper());
  CHECK(I(3) == I(3.0));
}

TEST_CASE("interval.division: what Boost's operator leaves loose", "[regression]") {
  using I = graze::interval<>;
  CHECK(I(-1.0, 0.0) / I(0.0, 1.0) == I(-infinity, 0.0));
  CHECK(I(-1.0, 0.0) / I(-1.0, 0.0) == I(0.0, infinity));
  CHECK(I(0.0, 1.0) / I(0.0, 1.0) == I(0.0, infinity));
  CHECK(I(0.0) / I(-1.0, 1.0) == I(0.0));
  CHECK(empty(I(1.0) / I(0.0)));
  CHECK(I(1.0) / I(-1.0, 1.0) == I::whole());
  CHECK(I(1.0, infinity) / I(1.0, infinity) == I(0.0, infinity));
}

TEST_CASE("interval.overflow: a lower bound is the largest double, not infinity", "[regression]") {
  using I = graze::interval<>;
  constexpr double largest = std::numeric_limits<double>::max();
  CHECK(I(largest) + I(largest) == I(largest, infinity));
  CHECK(I(largest) * -2.0 == I(-infinity, -largest));
  CHECK(I::whole() * 0.0 == I(0.0));
}

TEST_CASE("interval.comparison: certain, and nothing throws", "[unit]") {
  using I = graze::interval<>;
  const I low(1.0, 2.0), high(2.0, 3.0), above(4.0, 5.0);
  CHECK(low < above);
  CHECK(above > low);
  CHECK(!(low < high));
  CHECK(low <= high);
  CHECK(high >= low);
  CHECK(!(low >= high));
  CHECK(low < 3);
  CHECK(!(low < 1.5));
  CHECK(low != high);
  CHECK(low == I(1.0, 2.0));
  CHECK(I(1.0) == 1.0);
  CHECK(I::empty() == I(2.0, 1.0));
  CHECK(I::empty() != low);
  CHECK(low < I::empty());
}

TEST_CASE("interval.functions: abs, min, max, hull, width, mag, mid", "[unit]") {
  using I = graze::interval<>;
  const I x(-3.0, 2.0), y(-1.0, 4.0);
  CHECK(abs(x) == I(0.0, 3.0));
  CHECK(abs(I(-3.0, -1.0)) == I(1.0, 3.0));
  CHECK(abs(I::whole()) == I(0.0, infinity));
  CHECK(min(x, y) == I(-3.0, 2.0));
  CHECK(max(x, y) == I(-1.0, 4.0));
  CHECK(empty(max(x, I::empty())));
  CHECK(hull(I(1.0), I(3.0)) == I(1.0, 3.0));
  CHECK(hull(I(1.0), I::empty()) == I(1.0));
  CHECK(intersect(x, y) == I(-1.0, 2.0));
  CHECK(width(I(-0x1p-60, 1.0)) == 0x1.0000000000001p+0);
  CHECK(std::isnan(width(I::empty())));
  CHECK(mag(x) == 3);
  CHECK(mid(I(1.0, 3.0)) == 2);
  CHECK(mid(I::whole()) == 0);
  CHECK(mid(I(0x1p1023, infinity)) == std::numeric_limits<double>::max());
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(mid(I(least, least)) == least);
  CHECK(graze::sqr(3.0) == 9);
}

TEST_CASE("interval.boost: 0.1 + 0.2 and 0.1 + 0.7 with our policy", "[regression]") {
  using I = boost::numeric::interval<double, graze::policies<rounding::upward>>;
  const I sum = I(0.1) + I(0.2), other = I(0.1) + I(0.7);
  CHECK(sum.lower() == 0x1.3333333333333p-2);
  CHECK(sum.upper() == 0x1.3333333333334p-2);
  CHECK(other.lower() == 0x1.9999999999999p-1);
  CHECK(other.upper() == 0x1.999999999999ap-1);
}

TEMPLATE_TEST_CASE("interval.boost: unprotected types within one scope", "[unit]",
                   rounding::nearest, rounding::upward, rounding::split) {
  using I = graze::interval<TestType>;
  using U = graze::unprotected<TestType>;
  using BoostU = typename boost::numeric::interval_lib::unprotect<I>::type;
  const I a(0.1, 0.3), b(-1.0, 0.7);
  const I expected = graze::sqr(a) * b - 1.0 / a;
  double lower = 0, upper = 0, boost_lower = 0, boost_upper = 0;
  {
    [[maybe_unused]] const typename TestType::scope scope;
    const U u(a), v(b);
    const U r = graze::sqr(u) * v - 1.0 / u;
    lower = r.lower(), upper = r.upper();
    const BoostU bu(a), bv(b);
    const BoostU br = graze::sqr(bu) * bv - 1.0 / bu;
    boost_lower = br.lower(), boost_upper = br.upper();
  }
  CHECK(lower == expected.lower());
  CHECK(upper == expected.upper());
  CHECK(boost_lower == expected.lower());
  CHECK(boost_upper == expected.upper());
}
