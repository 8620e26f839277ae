// Float intervals: operations and functions, judged by MPFR.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/interval.hpp>
#include <graze/oracle/binary32.hpp>
#include <graze/oracle/hard_floats.hpp>
#include <graze/oracle/ranges.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>
#include <string>

namespace rounding = graze::rounding;
namespace oracle = graze::oracle;
namespace ranges = graze::oracle::ranges;
using graze::bounds;
using oracle::hard_floats;
using oracle::binary32::ends;
using oracle::binary32::set;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

using mpfr_operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
float down(mpfr_operation f, float x, float y) {
  return oracle::rounded_to<float>(f, MPFR_RNDD, x, y);
}
float up(mpfr_operation f, float x, float y) {
  return oracle::rounded_to<float>(f, MPFR_RNDU, x, y);
}

ends hull(const ends& a, const ends& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

/// The hull of an operation over the four corners; `at` gives {down, up} at one.
template <class At> ends corners(const ends& x, const ends& y, At at) {
  ends r{infinity, -infinity};
  for (const float a : {x.lo, x.hi})
    for (const float b : {y.lo, y.hi})
      r = hull(r, at(a, b));
  return r;
}

set add(const ends& x, const ends& y) {
  return ends{down(mpfr_add, x.lo, y.lo), up(mpfr_add, x.hi, y.hi)};
}
set sub(const ends& x, const ends& y) {
  return ends{down(mpfr_sub, x.lo, y.hi), up(mpfr_sub, x.hi, y.lo)};
}
/// 0 times an unbounded end is 0: the end is no member.
set mul(const ends& x, const ends& y) {
  return corners(x, y, [](float a, float b) {
    return a == 0 || b == 0 ? ends{0, 0} : ends{down(mpfr_mul, a, b), up(mpfr_mul, a, b)};
  });
}
/// a / t for t towards b, from the side of `sign` where b = 0.
auto over(float sign) {
  return [sign](float a, float b) {
    if (a == 0 || std::isinf(b))
      return ends{0, 0};
    if (b == 0)
      return a * sign > 0 ? ends{infinity, infinity} : ends{-infinity, -infinity};
    return ends{down(mpfr_div, a, b), up(mpfr_div, a, b)};
  };
}
set div(const ends& x, const ends& y) {
  set r;
  if (y.hi > 0)
    r = corners(x, {std::max(y.lo, 0.0f), y.hi}, over(1));
  if (y.lo < 0) {
    const ends left = corners(x, {y.lo, std::min(y.hi, 0.0f)}, over(-1));
    r = r ? hull(*r, left) : left;
  }
  return r;
}
set sqr(const ends& x) {
  const float far = std::max(std::fabs(x.lo), std::fabs(x.hi));
  const float near = x.lo <= 0 && 0 <= x.hi ? 0 : std::min(std::fabs(x.lo), std::fabs(x.hi));
  return ends{down(mpfr_mul, near, near), up(mpfr_mul, far, far)};
}
set root(const ends& x) {
  if (x.hi < 0)
    return {};
  return ends{oracle::rounded_to<float>(mpfr_sqrt, MPFR_RNDD, std::max(x.lo, 0.0f)),
              oracle::rounded_to<float>(mpfr_sqrt, MPFR_RNDU, x.hi)};
}

/// A set of doubles' bounds, by MPFR to 24 bits.
set narrowed(const bounds& x) {
  if (x.is_empty())
    return {};
  const auto keep = [](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t to) { return mpfr_set(r, a, to); };
  return ends{oracle::rounded_to<float>(keep, MPFR_RNDD, x.lo),
              oracle::rounded_to<float>(keep, MPFR_RNDU, x.hi)};
}
bounds widened(const set& x) { return x ? bounds{x->lo, x->hi} : bounds::empty(); }

std::string text(const set& x) {
  char buffer[80] = "empty";
  if (x)
    std::snprintf(buffer, sizeof buffer, "[%a, %a]", static_cast<double>(x->lo),
                  static_cast<double>(x->hi));
  return buffer;
}

class verdict {
public:
  template <class I>
  void judge(const char* expression, const I& result, const set& expected, const set& x,
             const set& y = {}) {
    ++judged_;
    const set got = empty(result) ? set{} : set{ends{result.lower(), result.upper()}};
    if (got != expected && ++failures_ <= 10)
      first_ += std::string(expression) + " gives " + text(got) + ", tightest " + text(expected) +
                ", x " + text(x) + ", y " + text(y) + '\n';
  }
  void check() const {
    INFO(first_);
    CHECK(failures_ == 0);
    CHECK(judged_ > 0);
  }

private:
  long judged_ = 0, failures_ = 0;
  std::string first_;
};

template <class I> I to_interval(const set& x) { return x ? I(x->lo, x->hi) : I::empty(); }
set hard_set(hard_floats& make) {
  const auto [p, q] = make.pair();
  return make.below(64) == 0 ? set{} : make.set(p, q);
}

/// As code calls operations that holds the scope, and as code that does not.
template <class B> struct held_by_caller {
  using type = graze::float_interval<rounding::held<B>>;
  using scope = typename B::scope;
};
template <class B> struct own_scope {
  using type = graze::float_interval<B>;
  struct scope {
    scope() {}
  };
};

} // namespace

TEMPLATE_TEST_CASE("interval.float: operations are tightest, by MPFR with 24 bits",
                   "[property][mpfr]", own_scope<rounding::nearest>, own_scope<rounding::upward>,
                   own_scope<rounding::split>, own_scope<rounding::switching>,
                   held_by_caller<rounding::upward>, held_by_caller<rounding::split>) {
  using I = typename TestType::type;
  const auto in_scope = [](auto operation) {
    [[maybe_unused]] const typename TestType::scope scope;
    return operation();
  };
  hard_floats make(1788);
  verdict result;
  for (int i = 0; i < 40'000; ++i) {
    const auto [p, q] = make.pair();
    const auto [v, w] = make.pair();
    // correlated: the ends of x and y come from the same pair
    const set x = make.below(64) == 0 ? set{} : make.set(p, make.coin() ? v : q),
              y = make.below(64) == 0 ? set{} : make.set(q, w);
    const I a = to_interval<I>(x), b = to_interval<I>(y);
    const bool both = x && y;
    result.judge("x + y", in_scope([&] { return a + b; }), both ? add(*x, *y) : set{}, x, y);
    result.judge("x - y", in_scope([&] { return a - b; }), both ? sub(*x, *y) : set{}, x, y);
    result.judge("x * y", in_scope([&] { return a * b; }), both ? mul(*x, *y) : set{}, x, y);
    result.judge("x / y", in_scope([&] { return a / b; }), both ? div(*x, *y) : set{}, x, y);
    result.judge("sqr(x)", in_scope([&] { return graze::sqr(a); }), x ? sqr(*x) : set{}, x);
    result.judge("sqrt(x)", in_scope([&] { return sqrt(a); }), x ? root(*x) : set{}, x);
    // by Boost's own operators, as code calls them that names them
    result.judge("Boost's x * y", in_scope([&] { return boost::numeric::operator*(a, b); }),
                 both ? mul(*x, *y) : set{}, x, y);
    result.judge("Boost's sqrt(x)", in_scope([&] { return boost::numeric::sqrt(a); }),
                 x ? root(*x) : set{}, x);
    if (x && std::isfinite(p)) {
      const set point_set = ends{p, p};
      result.judge("p + x", in_scope([&] { return p + a; }), add(*point_set, *x), point_set, x);
      result.judge("x - p", in_scope([&] { return a - p; }), sub(*x, *point_set), x, point_set);
      result.judge("p * x", in_scope([&] { return p * a; }), mul(*point_set, *x), point_set, x);
      result.judge("x / p", in_scope([&] { return a / p; }), div(*x, *point_set), x, point_set);
    }
    if (x) { // numbers that describe it
      CHECK(in_scope([&] { return width(a); }) == up(mpfr_sub, x->hi, x->lo));
      const float m = in_scope([&] { return mid(a); });
      CHECK((x->lo <= m && m <= x->hi && std::isfinite(m)));
      CHECK(mag(a) == std::max(std::fabs(x->lo), std::fabs(x->hi)));
    }
  }
  result.check();
}

TEST_CASE("interval.float: functions of two and three numbers are tightest, by MPFR with 24 bits",
          "[property][mpfr]") {
  using I = graze::float_interval<>;
  hard_floats make(754);
  verdict result;
  const auto uniform = [&make] {
    return static_cast<float>(std::ldexp(static_cast<double>(make.below(1 << 24)), -20) - 8);
  };
  for (int i = 0; i < 20'000; ++i) {
    const auto hard = make.pair();
    const float x = i % 2 == 0 ? uniform() : hard.first, y = i % 3 == 0 ? uniform() : hard.second,
                z = i % 4 == 0 ? uniform() : make.any();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      continue;
    const set a = ends{x, x}, b = ends{y, y};
    using oracle::binary32::enclosed;
    result.judge("hypot", hypot(I(x), I(y)), enclosed(mpfr_hypot, x, y), a, b);
    result.judge("fma", fma(I(x), I(y), I(z)), enclosed(mpfr_fma, x, y, z), a, b);
    if (x != 0 || y != 0)
      result.judge("atan2", atan2(I(x), I(y)),
                   // a zero has no sign
                   enclosed(mpfr_atan2, x == 0 ? 0 : x, y == 0 ? 0 : y), a, b);
    if (x > 0)
      result.judge("pow", graze::pow(I(x), I(y)), enclosed(mpfr_pow, x, y), a, b);
    for (const int n : {-7, -2, 3, 10}) {
      const auto power = [n](auto r, auto t, auto to) { return mpfr_pow_si(r, t, n, to); };
      const auto root_of = [n](auto r, auto t, auto to) { return mpfr_rootn_si(r, t, n, to); };
      result.judge("pown", pown(I(x), n), x == 0 && n < 0 ? set{} : enclosed(power, x), a);
      result.judge("rootn", rootn(I(x), n), x == 0 && n < 0 ? set{} : enclosed(root_of, x), a);
    }
  }
  result.check();
}

TEST_CASE("interval.float: functions over boxes are tightest", "[property][mpfr]") {
  using I = graze::float_interval<>;
  hard_floats make(2017);
  verdict result;
  for (int i = 0; i < 4'000; ++i) {
    const auto moderate = [&make]() -> set {
      const float a = static_cast<float>(static_cast<double>(make.below(1 << 24)) * 0x1p-20 - 8),
                  b = make.coin()
                          ? hard_floats::step(a, 3)
                          : a + 0x1p-24f * static_cast<float>(make.below(std::uint64_t{1} << 26));
      return ends{std::min(a, b), std::max(a, b)};
    };
    const set x = i % 2 == 0 ? moderate() : hard_set(make),
              y = i % 3 == 0 ? moderate() : hard_set(make), z = hard_set(make);
    const I a = to_interval<I>(x), b = to_interval<I>(y), c = to_interval<I>(z);
    const bounds s = widened(x), t = widened(y);
#define GRAZE_ONE(f) result.judge(#f, graze::f(a), narrowed(ranges::f(s)), x)
#define GRAZE_ONE_DECORATED(f) result.judge(#f, graze::f(a), narrowed(ranges::f(s).value), x)
#define GRAZE_TWO(f) result.judge(#f, graze::f(a, b), narrowed(ranges::f(s, t)), x, y)
    GRAZE_ONE(recip), GRAZE_ONE(abs), GRAZE_ONE(sign), GRAZE_ONE(ceil), GRAZE_ONE(floor),
        GRAZE_ONE(trunc), GRAZE_ONE(round_ties_to_even), GRAZE_ONE(round_ties_to_away),
        GRAZE_ONE(exp), GRAZE_ONE(exp2), GRAZE_ONE(exp10), GRAZE_ONE(expm1), GRAZE_ONE(log),
        GRAZE_ONE(log2), GRAZE_ONE(log10), GRAZE_ONE(logp1), GRAZE_ONE(sin), GRAZE_ONE(cos),
        GRAZE_ONE(tan), GRAZE_ONE(asin), GRAZE_ONE(acos), GRAZE_ONE(atan), GRAZE_ONE(sinh),
        GRAZE_ONE(cosh), GRAZE_ONE(tanh), GRAZE_ONE(asinh), GRAZE_ONE(acosh), GRAZE_ONE(atanh),
        GRAZE_ONE(cbrt), GRAZE_ONE_DECORATED(cot), GRAZE_ONE_DECORATED(sec),
        GRAZE_ONE_DECORATED(csc), GRAZE_ONE_DECORATED(acot), GRAZE_ONE_DECORATED(coth),
        GRAZE_ONE_DECORATED(sech), GRAZE_ONE_DECORATED(csch), GRAZE_ONE_DECORATED(acoth),
        GRAZE_TWO(atan2), GRAZE_TWO(hypot), GRAZE_TWO(pow), GRAZE_TWO(min), GRAZE_TWO(max),
        GRAZE_TWO(intersection), GRAZE_TWO(convex_hull);
#undef GRAZE_ONE
#undef GRAZE_ONE_DECORATED
#undef GRAZE_TWO
    result.judge("fma", fma(a, b, c), narrowed(ranges::fma(s, t, widened(z))), x, y);
    for (const int n : {-3, 2, 5}) {
      result.judge("pown", pown(a, n), narrowed(ranges::pown(s, n).value), x);
      result.judge("rootn", rootn(a, n), narrowed(ranges::rootn(s, n).value), x);
    }
  }
  result.check();
}
