// One line changed in a client of Boost.Interval: what it writes means what it meant, and holds.
// tests/interval/api has the whole of Boost's interface; here is what went wrong once.
#include <algorithm>
#include <boost/numeric/interval.hpp>
#include <boost/numeric/interval/compare.hpp>
#include <boost/numeric/interval/compare/tribool.hpp>
#include <boost/numeric/interval/ext/integer.hpp>
#include <boost/numeric/interval/io.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <graze/interval.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <iomanip>
#include <limits>
#include <sstream>
#include <version>

namespace rounding = graze::rounding;
namespace il = boost::numeric::interval_lib;
using boost::numeric::interval;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr long long beyond = (1LL << 53) + 1; // no double
__extension__ using int128 = __int128;

template <class Checking, class B = rounding::nearest>
using swapped = interval<double, il::policies<graze::boost_rounding<B>, Checking>>;
using quiet = swapped<il::checking_base<double>>;
/// Boost's default checking: no empty sets, which throw.
using strict = swapped<il::checking_strict<double>>;
using boost_class = interval<double, graze::policies<>>;

template <class I> std::string printed(const I& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}
template <class I> bool is(const I& x, double lower, double upper) {
  return x.lower() == lower && x.upper() == upper;
}

// A client's code, in which one of Boost's comparisons is in force.
namespace tribool_client {
using namespace il::compare::tribool;
template <class I> boost::logic::tribool less(const I& x, const I& y) { return x < y; }
template <class I> boost::logic::tribool less(const I& x, double y) { return x < y; }
} // namespace tribool_client
namespace possible_client {
using namespace il::compare::possible;
template <class I> bool less(const I& x, const I& y) { return x < y; }
template <class I> bool differ(const I& x, const I& y) { return x != y; }
} // namespace possible_client
namespace set_client {
using namespace il::compare::set;
template <class I> bool less(const I& x, const I& y) { return x < y; }
} // namespace set_client
namespace lexicographic_client {
using namespace il::compare::lexicographic;
template <class I> bool less(const I& x, const I& y) { return x < y; }
template <class I> bool equal(const I& x, const I& y) { return x == y; }
} // namespace lexicographic_client
namespace certain_client {
using namespace il::compare::certain;
template <class I> bool less(const I& x, const I& y) { return x < y; }
} // namespace certain_client

} // namespace

TEMPLATE_TEST_CASE("interval.swap: lower, upper and operator<< of Boost", "[regression]",
                   graze::interval<>, graze::interval<rounding::upward>, boost_class, quiet,
                   strict) {
  const TestType x(1, 2);
  CHECK(lower(x) == 1);
  CHECK(boost::numeric::lower(x) == 1);
  CHECK(upper(x) == 2);
  CHECK(boost::numeric::upper(x) == 2);
  CHECK(boost::numeric::checked_lower(x) == 1);
  CHECK(checked_upper(x) == 2);
  CHECK(printed(x) == "[1,2]");
  CHECK(printed(TestType(1)) == "[1,1]");
  CHECK(printed(TestType(0.1)) == "[0.1,0.10000000000000001]");
  CHECK(printed(TestType(-infinity, infinity)) == "[-inf,inf]");
  CHECK(printed(TestType(1, infinity)) == "[1,inf]");
  std::ostringstream hexadecimal;
  hexadecimal << std::hexfloat << TestType(1, 0x1.8p-3 + 1);
  CHECK(hexadecimal.str() == "[0x1p+0,0x1.3p+0]");
  std::wostringstream wide;
  wide << std::setw(8) << x;
  CHECK(wide.str() == L"   [1,2]");
}

TEST_CASE("interval.swap: the empty set is written as Boost writes it", "[regression]") {
  CHECK(printed(graze::interval<>::empty()) == "[]");
  CHECK(printed(quiet::empty()) == "[]");
}

TEST_CASE("interval.swap: std::format", "[unit]") {
#if defined(__cpp_lib_format)
  CHECK(std::format("{}", graze::interval<>(1, 2)) == "[1,2]");
  CHECK(std::format("{}", quiet(0.1)) == "[0.1,0.10000000000000001]");
  CHECK(std::format("{:x}", graze::interval<>(0.5)) == "[0x1p-1,0x1p-1]");
#else
  std::puts("graze: skipped, this C++ library has no <format>");
#endif
}

TEST_CASE("interval.swap: an unprotected rounding is its own", "[regression]") {
  using R = graze::boost_rounding<rounding::upward>;
  using U = R::unprotected_rounding;
  CHECK(std::is_same_v<U, graze::boost_rounding<rounding::held<rounding::upward>>>);
  CHECK(std::is_same_v<U::unprotected_rounding, U>);
  CHECK(std::is_same_v<graze::boost_rounding<>, graze::boost_rounding<rounding::nearest>>);
}

TEMPLATE_TEST_CASE("interval.swap: qualified calls are tightest", "[regression]", graze::interval<>,
                   boost_class, quiet, strict) {
  const TestType x(0.5, 2);
  CHECK(is(boost::numeric::exp(x), 0x1.a61298e1e069bp+0, 0x1.d8e64b8d4ddaep+2));
  CHECK(is(boost::numeric::sin(x), 0x1.eaee8744b05efp-2, 1));
  CHECK(is(sin(TestType(10)), -0x1.1689ef5f34f53p-1, -0x1.1689ef5f34f52p-1));
  CHECK(is(boost::numeric::atanh(TestType(-1, 0.5)), -infinity, 0x1.193ea7aad030bp-1));
}

TEMPLATE_TEST_CASE("interval.swap: powers take real exponents", "[regression]", graze::interval<>,
                   graze::interval<rounding::upward>, boost_class, quiet, strict) {
  const TestType two(2);
  CHECK(is(pow(two, 2.5), 0x1.6a09e667f3bccp+2, 0x1.6a09e667f3bcdp+2));
  CHECK(is(boost::numeric::pow(two, 0.5), 0x1.6a09e667f3bccp+0, 0x1.6a09e667f3bcdp+0));
  CHECK(is(pow(two, TestType(2.5)), 0x1.6a09e667f3bccp+2, 0x1.6a09e667f3bcdp+2));
  // whole numbers of any type are whole: of negative numbers too
  CHECK(is(pow(TestType(-2, 1), 3.0), -8, 1));
  CHECK(is(pow(TestType(-2, 1), 2.0f), 0, 4));
  CHECK(is(pow(TestType(-1), 1e10), 1, 1));
  CHECK(is(pow(TestType(-1), 10000000001.0), -1, -1));
  CHECK(is(pow(TestType(-1), 0x1.0000000000001p+52), -1, -1)); // odd: its last bit is 1
  CHECK(is(pow(TestType(-1), 10000000001LL), -1, -1));
  CHECK(is(pow(TestType(-1), (1LL << 62) + 1), -1, -1));
  CHECK(is(pow(TestType(-1), 0x1.0000000000000002p+63L), -1, -1));
  CHECK(is(pow(TestType(1, 4), 0.5L), 1, 2));
  // 0.1^7 is 1.0000000000000003885... times 1e-7
  const auto seventh = pow(TestType(0.1), 7);
  CHECK(is(seventh, 0x1.ad7f29abcaf4bp-24, 0x1.ad7f29abcaf4cp-24));
}

TEST_CASE("interval.swap: graze::pow and graze::fmod by name", "[regression]") {
  using I = graze::interval<>;
  CHECK(is(graze::pow(I(2), 7), 128, 128));
  CHECK(is(graze::pow(I(4), 0.5), 2, 2));
  CHECK(is(graze::pow(I(4), I(0.5)), 2, 2));
  CHECK(is(graze::fmod(I(5), I(-3)), 2, 2));
}

TEMPLATE_TEST_CASE("interval.swap: fmod is C's", "[regression]", graze::interval<>, boost_class,
                   quiet, strict) {
  using I = TestType;
  CHECK(is(fmod(I(5, 7), I(-3.5, -3)), 0, 3.5));
  CHECK(is(boost::numeric::fmod(I(5, 7), I(-3.5, -3)), 0, 3.5));
  CHECK(is(fmod(I(5), I(1.6, 2.4)), 0, 0x1.aaaaaaaaaaaabp+0)); // 5 / 3, not met
  CHECK(is(fmod(I(5), I(-3)), 2, 2));
  CHECK(is(fmod(I(-5), 3.0), -2, -2));
  CHECK(is(fmod(I(4, 5), 3), 1, 2));
  CHECK(is(fmod(-5, I(3)), -2, -2));
  CHECK(is(fmod(I(0x1p1000), I(3)), 1, 1));
}

TEST_CASE("interval.swap: fmod holds and is reached, on all boxes of a grid", "[property]") {
  using I = graze::interval<>;
  int boxes = 0;
  for (int a = -10; a <= 10; ++a)
    for (int b = a; b <= a + 9; b += 2)
      for (int c = -7; c <= 7; ++c)
        for (int d = c; d <= c + 6; ++d) {
          const I x(a / 4.0, b / 4.0), y(c / 4.0, d / 4.0), r = fmod(x, y);
          double least = infinity, greatest = -infinity;
          const auto add = [&](double s, double t) {
            if (t == 0 || !in(s, x) || !in(t, y))
              return;
            const double value = std::fmod(s, t);
            least = std::min(least, value), greatest = std::max(greatest, value);
          };
          for (int i = 4 * a; i <= 4 * b; ++i)
            for (int k = 4 * c; k <= 4 * d; ++k)
              add(i / 16.0, k / 16.0);
          // where s / t nears an integer m from below, and is one
          for (int m = 1; m <= 40; ++m)
            for (const double sign : {1.0, -1.0}) {
              for (const double s : {a / 4.0, b / 4.0})
                for (const double t : {s / m * (1 + 0x1p-40), s / m * (1 - 0x1p-40)})
                  add(s, sign * t);
              for (const double t : {c / 4.0, d / 4.0})
                for (const double s : {m * t * (1 - 0x1p-40), m * t})
                  add(sign * s, t);
            }
          const bool some = least <= greatest;
          const bool holds = some ? r.lower() <= least && greatest <= r.upper() : empty(r);
          const bool reached =
              !some || (least - r.lower() < 0x1p-30 && r.upper() - greatest < 0x1p-30);
          ++boxes;
          if (!holds || !reached) {
            CAPTURE(a, b, c, d, r.lower(), r.upper(), least, greatest);
            CHECK(holds);
            CHECK(reached);
          }
        }
  CHECK(boxes == 21 * 5 * 15 * 7);
}

TEMPLATE_TEST_CASE("interval.swap: numbers beside are enclosed", "[regression]", graze::interval<>,
                   graze::interval<rounding::upward>, boost_class, quiet, strict) {
  using I = TestType;
  const I zero(0), one(1);
  const auto around = [](const I& x) { return is(x, 0x1p53, 0x1p53 + 2); };
  CHECK(around(zero + beyond));
  CHECK(around(beyond + zero));
  CHECK(is(zero + ((1LL << 54) + 3), 0x1p54, 0x1p54 + 4));
  CHECK(around(beyond - zero));
  CHECK(around(one * beyond));
  CHECK(around(beyond * one));
  CHECK(around(beyond / one));
  CHECK(around(one * static_cast<unsigned long>(beyond)));
  CHECK(around(one * int128{beyond}));
  CHECK(around(I(int128{beyond})));
  I sum(0), product(1);
  CHECK(around(sum += beyond));
  CHECK(around(product *= int128{beyond}));
  sum = beyond;
  CHECK(around(sum));
  CHECK(is(one * 0.1L, 0x1.9999999999999p-4, 0x1.999999999999ap-4));
  CHECK(is(0.1L * one, 0x1.9999999999999p-4, 0x1.999999999999ap-4));
  CHECK(is(one * 0.1f, 0.1f, 0.1f));
  CHECK(is(one + 1, 2, 2));
  CHECK(is(1 - one, 0, 0));
  CHECK(is(one + true, 2, 2));
  CHECK(is(one / -2, -0.5, -0.5));
  CHECK(is(hull(one, beyond), 1, 0x1p53 + 2));
  CHECK(!in(beyond, one));
  CHECK(in(beyond, I(0x1p53, 0x1p53 + 2)));
  CHECK(in(1, one));
}

TEST_CASE("interval.swap: comparisons with a number that is no double", "[regression]") {
  using I = graze::interval<>;
  CHECK(I(0x1p53) < beyond);
  CHECK(I(0x1p53) <= beyond);
  CHECK(!(I(0x1p53 + 2) <= beyond));
  CHECK(I(0x1p53 + 2) > beyond);
  CHECK(beyond < I(0x1p53 + 2));
  CHECK(beyond >= I(0x1p53));
  CHECK(I(0x1p53) != beyond);
  CHECK(!(I(0x1p53) == beyond));
  CHECK(!(beyond == I(0x1p53, 0x1p53 + 2)));
  CHECK(I(3) == 3);
  CHECK(I(3) <= 3);
  CHECK(!(I(3) < 3));
  CHECK(3u == I(3));
  // Boost's, which throw where they cannot tell
  CHECK(quiet(0x1p53) < beyond);
  CHECK(!(quiet(0x1p53 + 2) < beyond));
  CHECK(quiet(0x1p53 + 2) >= beyond);
  CHECK(quiet(0x1p53) <= beyond);
  CHECK_THROWS_AS(quiet(0x1p53, 0x1p53 + 2) < beyond, il::comparison_error);
  CHECK_THROWS_AS(quiet(0x1p53, 0x1p53 + 2) == beyond, il::comparison_error);
}

TEMPLATE_TEST_CASE("interval.swap: a client's comparisons stay", "[regression]", quiet, strict,
                   boost_class, graze::interval<>) {
  const TestType x(0, 2), y(1, 3), within(0.5, 1);
  CHECK(boost::logic::indeterminate(tribool_client::less(x, y)));
  CHECK(boost::logic::indeterminate(tribool_client::less(x, 1.0)));
  CHECK(possible_client::less(x, y));
  CHECK(!possible_client::less(y + 5.0, x));
  CHECK(possible_client::differ(x, x));
  CHECK(!set_client::less(x, y));
  CHECK(set_client::less(within, x));
  CHECK(lexicographic_client::less(x, y));
  CHECK(lexicographic_client::equal(x, x));
  CHECK(!certain_client::less(x, y));
}

TEST_CASE("interval.swap: Boost's default comparison stays, and throws when unsure",
          "[regression]") {
  CHECK_THROWS_AS(quiet(0, 2) < quiet(1, 3), il::comparison_error);
  CHECK_THROWS_AS(quiet(0, 2) == 1.0, il::comparison_error);
  CHECK(quiet(0, 1) < quiet(2, 3));
  // policies<> name ours
  CHECK(!(boost_class(0, 2) < boost_class(1, 3)));
}

TEST_CASE("interval.swap: a client's checking stays", "[unit]") {
  CHECK_THROWS_AS(strict(2, 1), std::runtime_error);
  CHECK_THROWS_AS(log(strict(-2, -1)), std::runtime_error);
  CHECK(empty(log(quiet(-2, -1))));
  CHECK(empty(graze::interval<>(2, 1)));
}

TEST_CASE("interval.swap: quotients at zero", "[regression]") {
  CHECK(is(quiet(-1, 0) / quiet(0, 1), -infinity, 0));
  bool more = true;
  CHECK(is(il::division_part1(quiet(-1, 0), quiet(0, 1), more), -infinity, 0));
  CHECK(!more);
  CHECK(is(il::division_part1(quiet(1), quiet(-1, 1), more), -infinity, -1));
  CHECK(more);
}

TEST_CASE("interval.swap: Boost's own algorithms on unprotected types hold", "[unit]") {
  // as from a template that was read before boost_functions.hpp
  for (const double x : {-20.0, -4.0, -2.0, -1.0, 0.0, 1.0, 1.6, 3.1, 3.2, 4.8, 6.3, 100.0})
    for (const double width : {0.0, 0.125, 1.5, 4.0}) {
      const quiet i(x, x + width);
      const auto inner = boost::numeric::sin<double, quiet::traits_type>(i);
      CHECK(subset(sin(i), inner));
      const auto other = boost::numeric::tan<double, quiet::traits_type>(i);
      CHECK(subset(tan(i), other));
    }
}
