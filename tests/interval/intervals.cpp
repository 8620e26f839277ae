// + - * / sqr sqrt on hard intervals, bounded, unbounded and empty: inclusion and tightness, judged
// by MPFR through a formula that shares nothing with the operators.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <graze/interval.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/rounding.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>
#include <optional>
#include <string>

namespace rounding = graze::rounding;
using graze::oracle::hard_operands;
using graze::oracle::hardness;
using graze::oracle::mpfr;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A non-empty closed set of reals [lower, upper]; none is the empty set.
struct ends {
  double lower, upper;
};
using set = std::optional<ends>;

set hull(const set& a, const set& b) {
  if (!a || !b)
    return a ? a : b;
  return ends{std::min(a->lower, b->lower), std::max(a->upper, b->upper)};
}

/// The hull of an operation over the four corners, each rounded outward by MPFR.
template <class Down, class Up> ends corners(const ends& x, const ends& y, Down down, Up up) {
  ends r{infinity, -infinity};
  for (const double a : {x.lower, x.upper})
    for (const double b : {y.lower, y.upper}) {
      r.lower = std::min(r.lower, down(a, b));
      r.upper = std::max(r.upper, up(a, b));
    }
  return r;
}

/// 0 times an unbounded end is 0: the end is not a member, and 0 t = 0 for every real t.
auto times(double (*operation)(double, double)) {
  return [operation](double a, double b) { return a == 0 || b == 0 ? 0 : operation(a, b); };
}
/// The limit of a / t for t towards b, from the side of `divisor_sign` where b = 0.
auto over(double (*operation)(double, double), double divisor_sign) {
  return [operation, divisor_sign](double a, double b) {
    if (a == 0 || std::isinf(b))
      return 0.0;
    if (b == 0)
      return a * divisor_sign > 0 ? infinity : -infinity;
    return operation(a, b);
  };
}

set add(const ends& x, const ends& y) {
  return ends{mpfr::add_down(x.lower, y.lower), mpfr::add_up(x.upper, y.upper)};
}
set sub(const ends& x, const ends& y) {
  return ends{mpfr::sub_down(x.lower, y.upper), mpfr::sub_up(x.upper, y.lower)};
}
set mul(const ends& x, const ends& y) {
  return corners(x, y, times(mpfr::mul_down), times(mpfr::mul_up));
}
set div(const ends& x, const ends& y) {
  set r;
  if (y.upper > 0) // the positive part of y
    r = hull(r, corners(x, {std::max(y.lower, 0.0), y.upper}, over(mpfr::div_down, 1),
                        over(mpfr::div_up, 1)));
  if (y.lower < 0)
    r = hull(r, corners(x, {y.lower, std::min(y.upper, 0.0)}, over(mpfr::div_down, -1),
                        over(mpfr::div_up, -1)));
  return r;
}
set sqr(const ends& x) {
  const double far = std::max(std::fabs(x.lower), std::fabs(x.upper));
  const double near =
      x.lower <= 0 && 0 <= x.upper ? 0 : std::min(std::fabs(x.lower), std::fabs(x.upper));
  return ends{mpfr::mul_down(near, near), mpfr::mul_up(far, far)};
}
set root(const ends& x) {
  if (x.upper < 0)
    return {};
  return ends{mpfr::sqrt_down(std::max(x.lower, 0.0)), mpfr::sqrt_up(x.upper)};
}

/// The operations of B as code calls them that holds the scope: `type` has no scope of its own.
template <class B> struct held_by_caller {
  using type = graze::unprotected<B>;
  using scope = typename B::scope;
};
template <class B> struct own_scope {
  using type = graze::interval<B>;
  struct scope {
    scope() {}
  };
};

/// Ends from hard operands; now and then unbounded, a point, or touching zero.
set make_set(hard_operands& make, double p, double q) {
  if (std::isnan(p) || std::isnan(q))
    return {};
  switch (make.below(8)) {
  case 0:
    q = p;
    break;
  case 1:
    q = hard_operands::step(p, 1);
    break;
  case 2:
    q = 0;
    break;
  case 3:
    q = make.coin() ? infinity : -infinity;
    break;
  default:
    break;
  }
  const ends e{std::min(p, q), std::max(p, q)};
  if (make.below(64) == 0)
    return ends{-infinity, infinity};
  if (e.lower == infinity || e.upper == -infinity || make.below(64) == 0)
    return {};
  return e;
}

template <class I> I to_interval(const set& s) { return s ? I(s->lower, s->upper) : I::empty(); }

/// Boost's constructor from a number takes infinities; they hold no real number.
template <class I> I no_number(hard_operands& make) { return make.coin() ? infinity : -infinity; }

long failures = 0;

template <class I>
void judge(const char* expression, const set& x, const set& y, const I& r, const set& t) {
  const bool tightest = t ? !empty(r) && r.lower() == t->lower && r.upper() == t->upper : empty(r);
  if (tightest)
    return;
  if (++failures > 10)
    return;
  const auto text = [](const set& s) {
    char buffer[80] = "empty";
    if (s)
      std::snprintf(buffer, sizeof buffer, "[%a, %a]", s->lower, s->upper);
    return std::string(buffer);
  };
  UNSCOPED_INFO(expression << " gives " << text(ends{r.lower(), r.upper()}) << ", tightest "
                           << text(t) << ", x " << text(x) << ", y " << text(y));
}

/// Members of a set: its finite ends, and what lies near them.
std::array<double, 3> members(hard_operands& make, const ends& e) {
  constexpr double largest = std::numeric_limits<double>::max();
  const double a = std::max(e.lower, -largest), b = std::min(e.upper, largest);
  return {a, b, std::clamp(hard_operands::step(make.coin() ? a : b, make.coin() ? 1 : -1), a, b)};
}

} // namespace

TEMPLATE_TEST_CASE("interval.operations: tightest, by MPFR, and hold every member's result",
                   "[property][mpfr]", own_scope<rounding::nearest>, own_scope<rounding::upward>,
                   own_scope<rounding::split>, own_scope<rounding::switching>,
                   own_scope<rounding::held<mpfr>>, held_by_caller<rounding::upward>,
                   held_by_caller<rounding::split>) {
  using I = typename TestType::type;
  // the judge and its sets are computed outside of the scope
  const auto in_scope = [](auto operation) {
    [[maybe_unused]] const typename TestType::scope scope;
    return operation();
  };
  hard_operands make(1788);
  failures = 0;
  long not_held = 0;
  for (int i = 0; i < 40'000; ++i) {
    const auto kind = [&] {
      return static_cast<hardness>(make.below(static_cast<std::uint64_t>(hardness::count)));
    };
    const auto [p, q] = make.next(kind());
    const auto [v, w] = make.next(kind());
    // correlated: the ends of x and y come from the same pair
    const set x = make_set(make, p, make.coin() ? v : q), y = make_set(make, q, w);
    const I a = x || make.coin() ? to_interval<I>(x) : no_number<I>(make), b = to_interval<I>(y);
    const bool both = x && y;
    judge("x + y", x, y, in_scope([&] { return a + b; }), both ? add(*x, *y) : set{});
    judge("x - y", x, y, in_scope([&] { return a - b; }), both ? sub(*x, *y) : set{});
    judge("x * y", x, y, in_scope([&] { return a * b; }), both ? mul(*x, *y) : set{});
    judge("x / y", x, y, in_scope([&] { return a / b; }), both ? div(*x, *y) : set{});
    judge("sqr(x)", x, x, in_scope([&] { return graze::sqr(a); }), x ? sqr(*x) : set{});
    judge("sqrt(x)", x, x, in_scope([&] { return sqrt(a); }), x ? root(*x) : set{});
    if (x && std::isfinite(p)) { // a number is the set that holds it alone
      const set point_set = ends{p, p};
      judge("p + x", point_set, x, in_scope([&] { return p + a; }), add(*point_set, *x));
      judge("x - p", x, point_set, in_scope([&] { return a - p; }), sub(*x, *point_set));
      judge("p - x", point_set, x, in_scope([&] { return p - a; }), sub(*point_set, *x));
      judge("p * x", point_set, x, in_scope([&] { return p * a; }), mul(*point_set, *x));
      judge("p / x", point_set, x, in_scope([&] { return p / a; }), div(*point_set, *x));
      judge("x / p", x, point_set, in_scope([&] { return a / p; }), div(*x, *point_set));
    }
    if (!both)
      continue;
    // inclusion apart from any formula of ends: a member's exact result lies within the bounds
    const auto [sum, difference, product, quotient] =
        in_scope([&] { return std::array<I, 4>{a + b, a - b, a * b, a / b}; });
    const auto holds = [&](const I& r, double down, double up) {
      not_held += !(r.lower() <= down && up <= r.upper());
    };
    for (const double s : members(make, *x))
      for (const double t : members(make, *y)) {
        holds(sum, mpfr::add_down(s, t), mpfr::add_up(s, t));
        holds(difference, mpfr::sub_down(s, t), mpfr::sub_up(s, t));
        holds(product, mpfr::mul_down(s, t), mpfr::mul_up(s, t));
        if (t != 0)
          holds(quotient, mpfr::div_down(s, t), mpfr::div_up(s, t));
      }
  }
  CHECK(failures == 0);
  CHECK(not_held == 0);
}
