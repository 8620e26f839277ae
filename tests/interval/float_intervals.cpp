// The seam of float intervals: what goes in, what comes out, and what is beside them.
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/io.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <graze/interval.hpp>
#include <graze/oracle/hard_floats.hpp>
#include <graze/rounding/hardware.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>
#include <sstream>
#include <vector>

namespace rounding = graze::rounding;

namespace {

using F = graze::float_interval<>;
using D = graze::interval<>;
constexpr float infinity = std::numeric_limits<float>::infinity(),
                largest = std::numeric_limits<float>::max(),
                least = std::numeric_limits<float>::denorm_min();

template <class I> bool is(const I& x, float lower, float upper) {
  return !empty(x) && x.lower() == lower && x.upper() == upper;
}

} // namespace

TEMPLATE_TEST_CASE("interval.float: 1/3 is within, where it was a point beside", "[regression]",
                   rounding::nearest, rounding::upward, rounding::split, rounding::switching) {
  using I = boost::numeric::interval<float, graze::policies<TestType>>;
  STATIC_REQUIRE(std::is_same_v<I, graze::float_interval<TestType>>);
  const I third = I(1.0f) / I(3.0f);
  CHECK(is(third, 0x1.555554p-2f, 0x1.555556p-2f));
  CHECK(is(boost::numeric::operator/(I(1.0f), I(3.0f)), 0x1.555554p-2f, 0x1.555556p-2f));
  // RN to double, then to float, would step over a neighbour here: 1 + 2^-24 + 2^-60
  CHECK(is(I(1.0f) + I(0x1p-24f) + I(0x1p-60f), 1.0f, 0x1.000004p+0f));
  CHECK(is(I(1.0f) + I(0x1p-60f), 1.0f, 0x1.000002p+0f));
}

TEST_CASE("interval.float: other numbers go in outward", "[regression]") {
  CHECK(is(F(0.1), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(F(0.1f), 0.1f, 0.1f));
  CHECK(is(F(0.1L), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(F((1 << 24) + 1), 0x1p24f, 0x1.000002p+24f));
  CHECK(is(F(-(1 << 24) - 1), -0x1.000002p+24f, -0x1p24f));
  CHECK(is(F(std::numeric_limits<std::int64_t>::max()), 0x1.fffffep+62f, 0x1p63f));
  CHECK(is(F(1e300), largest, infinity));
  CHECK(is(F(-1e-300), -least, 0));
  CHECK(is(F(0.1, 0.2), 0x1.999998p-4f, 0x1.99999ap-3f));
  F x;
  x = 0.1;
  CHECK(is(x, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(empty(F(std::nan(""))));
  CHECK(empty(F(2.0f, 1.0f)));
  CHECK(empty(F(infinity)));
  CHECK(empty(F(-infinity, -infinity)));
}

TEST_CASE("interval.float: numbers beside are enclosed", "[regression]") {
  const F one(1.0f);
  CHECK(is(one * 0.1, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(0.1 * one, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(one + ((1 << 24) + 1), 0x1p24f, 0x1.000004p+24f));
  CHECK(is(((1 << 24) + 1) - one, 0x1.fffffep+23f, 0x1.000002p+24f));
  CHECK(is(one * ((std::int64_t{1} << 40) + 1), 0x1p40f, 0x1.000002p+40f));
  CHECK(is(one * 0.1L, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(one / 10, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(one * 0.5f, 0.5f, 0.5f));
  CHECK(is(one * 2, 2.0f, 2.0f));
  F x = one;
  x *= 0.1;
  CHECK(is(x, 0x1.999998p-4f, 0x1.99999ap-4f));
  x = one;
  x += (1 << 24) + 1;
  CHECK(is(x, 0x1p24f, 0x1.000004p+24f));
  x = one;
  x -= 0x1p-60;
  CHECK(is(x, 0x1.fffffep-1f, 1.0f));
  x = one;
  x /= 3.0f;
  CHECK(is(x, 0x1.555554p-2f, 0x1.555556p-2f));
  CHECK(is(hull(F(1.0f), 0.1), 0x1.999998p-4f, 1.0f));
  CHECK(is(max(F(0.0f), 0.1), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(empty(one * std::nan("")));
  CHECK(empty(one * std::numeric_limits<double>::infinity()));
}

TEST_CASE("interval.float: to doubles exactly, from doubles outward", "[unit]") {
  const F third = F(1.0f) / 3.0f;
  const D wide(third);
  CHECK(wide.lower() == third.lower());
  CHECK(wide.upper() == third.upper());
  CHECK(is(F(wide), third.lower(), third.upper()));
  CHECK(is(F(D(0.1)), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(F(D(1.0) / 3.0), 0x1.555554p-2f, 0x1.555556p-2f));
  CHECK(is(F(D(-1e300, 1e-300)), -infinity, least));
  CHECK(is(F(D(1e300, 1e301)), largest, infinity));
  CHECK(empty(F(D::empty())));
  CHECK(empty(D(F::empty())));
  CHECK(is(F(D::whole()), -infinity, infinity));
  CHECK(D(F(least)).lower() == 0x1p-149);
  F x;
  x = D(0.1);
  CHECK(is(x, 0x1.999998p-4f, 0x1.99999ap-4f));
  const boost::numeric::interval<double, graze::policies<rounding::upward>> other(F(0.1));
  CHECK(other.lower() == 0x1.999998p-4);
}

TEST_CASE("interval.float: sets, numbers and comparisons are those of doubles", "[unit]") {
  const F x(-3.0f, 2.0f), y(-1.0f, 4.0f);
  CHECK(is(abs(x), 0, 3));
  CHECK(is(min(x, y), -3, 2));
  CHECK(is(max(x, y), -1, 4));
  CHECK(is(hull(F(1.0f), F(3.0f)), 1, 3));
  CHECK(is(hull(F(1.0f), F::empty()), 1, 1));
  CHECK(is(intersect(x, y), -1, 2));
  CHECK(is(convex_hull(x, F(5.0f)), -3, 5));
  CHECK(empty(intersection(x, F(5.0f))));
  CHECK(is(-x, -2, 3));
  CHECK(is(F::whole(), -infinity, infinity));
  CHECK(lower(x) == -3);
  CHECK(upper(x) == 2);
  // each is a float, of the right rounding
  STATIC_REQUIRE(std::is_same_v<decltype(width(x)), float>);
  CHECK(width(F(-0x1p-60f, 1.0f)) == 0x1.000002p+0f);
  CHECK(wid(F(-0x1p-60f, 1.0f)) == 0x1.000002p+0f);
  CHECK(width(F(-largest, largest)) == infinity);
  CHECK(std::isnan(width(F::empty())));
  CHECK(mag(x) == 3);
  CHECK(mig(x) == 0);
  CHECK(mig(F(-3.0f, -0.5f)) == 0.5f);
  CHECK(mid(F(1.0f, 0x1.000006p+0f)) == 0x1.000004p+0f); // of two, the even one
  CHECK(mid(F(largest, infinity)) == largest);
  CHECK(mid(F(-infinity, 0.0f)) == -largest);
  CHECK(mid(F::whole()) == 0);
  CHECK(mid(F(largest)) == largest);
  CHECK(mid(F(least)) == least);
  CHECK(rad(F(0.0f, 0x1.000002p+0f)) == 0x1.000002p-1f);
  CHECK(graze::inf(x) == -3);
  CHECK(graze::sup(x) == 2);
  CHECK(median(F(1.0f, 3.0f)) == 2);
  CHECK(x <= F(2.0f));
  CHECK(!(x < F(2.0f)));
  CHECK(x < F(3.0f));
  CHECK(F(0.1f) == 0.1f);
  CHECK(F(0.1f) > 0.1); // 0.1f is greater
  CHECK(!(F(0.1f) == 0.1));
  CHECK(F(16777216.0f) < (1 << 24) + 1);
  CHECK(!(F(16777216.0f) >= (1 << 24) + 1));
  CHECK(F::empty() == F(2.0f, 1.0f));
  CHECK(graze::is_member(0.5, F(0.0f, 1.0f)));
  CHECK(in(0.5f, F(0.0f, 1.0f)));
  CHECK(graze::interior(F(0.0f), F(-1.0f, 1.0f)));
}

TEST_CASE("interval.float: written text holds the interval", "[regression]") {
  const F x = F(1.0f) / 3.0f;
  for (const auto style : {graze::text_style::decimal, graze::text_style::exact_decimal,
                           graze::text_style::hexadecimal}) {
    const auto read = graze::text_to_interval(graze::interval_to_text(x, style));
    REQUIRE(read.signal == graze::exception::none);
    CHECK(read.value.lo <= x.lower());
    CHECK(x.upper() <= read.value.hi);
    if (style != graze::text_style::decimal)
      CHECK(is(graze::to_interval<graze::policies<>, float>(read.value), x.lower(), x.upper()));
  }
  std::ostringstream out;
  out << x;
  const auto read = graze::text_to_interval(out.str());
  REQUIRE(read.signal == graze::exception::none);
  CHECK(read.value.lo <= x.lower());
  CHECK(x.upper() <= read.value.hi);
}

TEST_CASE("interval.float: Boost's functions by their qualified names", "[regression]") {
  const F x(0.5f, 0.75f);
  // tightest, 24 bits
  CHECK(is(boost::numeric::exp(x), graze::exp(x).lower(), graze::exp(x).upper()));
  CHECK(is(boost::numeric::sin(x), graze::sin(x).lower(), graze::sin(x).upper()));
  CHECK(is(boost::numeric::tan(x), graze::tan(x).lower(), graze::tan(x).upper()));
  CHECK(is(boost::numeric::atanh(x), graze::atanh(x).lower(), graze::atanh(x).upper()));
  CHECK(is(boost::numeric::pow(x, 7), pown(x, 7).lower(), pown(x, 7).upper()));
  CHECK(is(boost::numeric::pow(F(2.0f), 2.5), 0x1.6a09e6p+2f, 0x1.6a09e8p+2f));
  CHECK(is(boost::numeric::nth_root(F(2.0f), 3), 0x1.428a2ep+0f, 0x1.428a30p+0f));
  CHECK(is(boost::numeric::fmod(F(5.0f), F(-3.0f)), 2, 2));
  CHECK(is(boost::numeric::square(F(0x1.000002p+0f)), 0x1.000004p+0f, 0x1.000006p+0f));
  CHECK(boost::numeric::lower(x) == 0.5f);
  CHECK(boost::numeric::median(x) == 0.625f);
  CHECK(is(boost::numeric::interval_lib::multiplicative_inverse(F(3.0f)), 0x1.555554p-2f,
           0x1.555556p-2f));
}

TEST_CASE("interval.float: the rounding policy alone, with Boost's checking", "[regression]") {
  namespace lib = boost::numeric::interval_lib;
  using I =
      boost::numeric::interval<float,
                               lib::policies<graze::boost_rounding<>, lib::checking_base<float>>>;
  const I one(1.0f), x(0.5f, 0.75f);
  CHECK(is(one / I(3.0f), 0x1.555554p-2f, 0x1.555556p-2f));
  CHECK(is(one / 3.0f, 0x1.555554p-2f, 0x1.555556p-2f));
  CHECK(is(one * 0.1, 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(one + ((1 << 24) + 1), 0x1p24f, 0x1.000004p+24f));
  CHECK(is(I(0.1), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(I(D(0.1)), 0x1.999998p-4f, 0x1.99999ap-4f));
  CHECK(is(sqrt(I(2.0f)), 0x1.6a09e6p+0f, 0x1.6a09e8p+0f));
  const F y(0.5f, 0.75f);
  CHECK(is(boost::numeric::exp(x), exp(y).lower(), exp(y).upper()));
  CHECK(is(sin(x), sin(y).lower(), sin(y).upper()));
  CHECK(is(boost::numeric::pow(x, 7), pown(y, 7).lower(), pown(y, 7).upper()));
  CHECK(I(0.1f) > 0.1);
  CHECK(I(16777216.0f) < (1 << 24) + 1);
  CHECK(boost::numeric::width(x) == 0.25f);
  CHECK(boost::numeric::median(x) == 0.625f);
  // a scope around unprotected operations
  using U = lib::unprotect<I>::type;
  const I::traits_type::rounding scope;
  CHECK(is(U(1.0f) / U(3.0f), 0x1.555554p-2f, 0x1.555556p-2f));
}

#if defined(__x86_64__)
TEMPLATE_TEST_CASE("interval.float: FTZ and DAZ change no result", "[regression]",
                   rounding::nearest, rounding::upward, rounding::split, rounding::switching) {
  using I = graze::float_interval<TestType>;
  namespace hardware = rounding::hardware;
  graze::oracle::hard_floats make(126);
  std::vector<I> operands;
  for (int i = 0; i < 3'000; ++i) {
    const auto [p, q] = make.pair();
    const auto x = make.set(i % 2 == 0 ? p : std::ldexp(p, -100), std::ldexp(q, -120));
    operands.emplace_back(x.lo, x.hi);
  }
  // as bits: to look at a subnormal float would flush it; a zero bound is of either sign
  const auto bits = [](const float& x) {
    std::uint32_t pattern;
    std::memcpy(&pattern, &x, sizeof pattern);
    return pattern == 0x80000000 ? 0 : pattern & ~((pattern & 0x7fffffff) > 0x7f800000 ? ~0u : 0u);
  };
  const auto results = [&] {
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i + 1 < operands.size(); ++i) {
      const I &x = operands[i], &y = operands[i + 1];
      for (const I& r : {I(x + y), I(x - y), I(x * y), I(x / y), I(graze::sqr(x)), I(sqrt(x)),
                         exp(x), log(x), sin(x), recip(x), cbrt(x), hypot(x, y), pown(x, -3)})
        all.push_back(bits(r.lower())), all.push_back(bits(r.upper()));
    }
    return all;
  };
  const std::vector<std::uint32_t> expected = results();
  const unsigned found = hardware::mxcsr();
  for (const unsigned flushing : {0x8000u, 0x0040u, 0x8040u}) {
    hardware::set_mxcsr(found | flushing);
    const std::vector<std::uint32_t> flushed = results();
    const graze::interval<TestType> wide(least); // a double, hence normal
    hardware::set_mxcsr(found);
    CHECK(wide.lower() == 0x1p-149);
    CHECK(wide.upper() == 0x1p-149);
    long different = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      different += flushed[i] != expected[i];
    INFO(flushing);
    CHECK(different == 0);
  }
}
#endif
