// The decorated type: decorations travel, NaI stays, and every function of the list takes it.
#include <catch2/catch.hpp>
#include <graze/decorated.hpp>
#include <graze/overlap.hpp>
#include <graze/rounding/upward.hpp>
#include <limits>

using graze::bounds;
using graze::decorated;
using graze::decoration;
using graze::exception;
using graze::interval;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST_CASE("interval.constructors: what is signalled where there is no interval", "[unit]") {
  struct row {
    double lower, upper;
    bool valid;
  };
  const row rows[] = {{1, 2, true},
                      {-infinity, 2, true},
                      {1, infinity, true},
                      {1, 1, true},
                      {-infinity, infinity, true},
                      {2, 1, false},
                      {not_a_number, 1, false},
                      {1, not_a_number, false},
                      {infinity, infinity, false},
                      {-infinity, -infinity, false},
                      {infinity, -infinity, false}};
  for (const row& r : rows) {
    CAPTURE(r.lower, r.upper);
    const auto bare = graze::nums_to_interval(r.lower, r.upper);
    const auto made = graze::nums_to_decorated(r.lower, r.upper);
    CHECK(bare.value.is_empty() != r.valid);
    CHECK(made.value.is_nai() != r.valid);
    CHECK((bare.signal == exception::none) == r.valid);
    CHECK((made.signal == exception::none) == r.valid);
    if (!r.valid)
      CHECK(std::string(name_of(made.signal)) == "UndefinedOperation");
  }
}

TEST_CASE("interval.decorations: set_dec gives what the set can have", "[unit]") {
  using enum decoration;
  const bounds bounded{1, 2}, unbounded{1, infinity}, empty = bounds::empty();
  for (const decoration d : {com, dac, def, trv}) {
    CHECK(graze::set_dec(bounded, d).value.label == d);
    CHECK(graze::set_dec(unbounded, d).value.label == std::min(d, dac));
    CHECK(graze::set_dec(empty, d).value.label == trv);
  }
  CHECK(graze::set_dec(bounded, ill).value.is_nai());
  CHECK(graze::set_dec(bounded, ill).signal == exception::undefined_operation);
  CHECK(graze::interval_part(graze::decorated_bounds::nai()).signal ==
        exception::interval_part_of_nai);
  CHECK(graze::interval_part(graze::new_dec(bounded)).signal == exception::none);
}

TEMPLATE_TEST_CASE("interval.decorated: arithmetic joins decorations", "[unit]",
                   graze::rounding::nearest, graze::rounding::upward) {
  using D = decorated<TestType>;
  using I = interval<TestType>;
  using enum decoration;
  const D x(1.0, 2.0), y = graze::set_dec({3, 4}, def).value;
  CHECK((x + x).label == com);
  CHECK((x + y).label == def);
  CHECK(equal((x + y).interval_part(), I(4.0, 6.0)));
  CHECK((x / D(0.0, 1.0)).label == trv);
  CHECK((x * 2.0).label == com);
  CHECK(equal(2.0 - x, D(0.0, 1.0)));
  CHECK(equal(1 / x, D(0.5, 1.0)));
  CHECK((x + I(1.0, infinity)).label == dac);
  CHECK((x * 0x1p1023).label == dac); // the upper bound overflows
  CHECK((I(1.0) - x).label == com);
  D z = x;
  z *= x;
  z -= 1.0;
  CHECK(equal(z, D(0.0, 3.0)));
  CHECK(equal(-x, D(-2.0, -1.0)));
  CHECK(equal(+x, x));
  CHECK((x + not_a_number).is_nai());
  CHECK(D(2.0, 1.0).is_nai());
  CHECK(sqrt(x - 1.5).label == trv);
  CHECK(sqrt(sqrt(x)).label == com);
  CHECK(intersection(x, x).label == trv);
  CHECK(convex_hull(x, 3.0).label == trv);
  CHECK(cancel_minus(x, x).label == trv);
  CHECK(fma(x, 2.0, y).label == def);
  CHECK(equal(fma(x, 2.0, y), D(5.0, 8.0)));
  CHECK(floor(D(1.0, 1.5)).label == dac);
  CHECK(floor(D(1.25, 1.5)).label == com);
  CHECK(floor(D(1.25, 2.5)).label == def);
  CHECK(sign(D(0.0)).label == dac);
  CHECK(trunc(D(-0.5, 0.5)).label == com);
}

TEST_CASE("interval.decorated: NaI stays NaI and compares false", "[unit]") {
  const decorated<> nai = decorated<>::nai(), x(1.0, 2.0);
  for (const auto& r : {nai + x, x / nai, -nai, fma(x, x, nai), intersection(nai, x), floor(nai),
                        nai * 0.0, min(nai, x), sqr(nai)})
    CHECK(is_nai(r));
  CHECK(!is_empty(nai));
  CHECK(!equal(nai, nai));
  CHECK(!subset(nai, x));
  CHECK(!disjoint(nai, x));
  CHECK(!is_member(1.0, nai));
  CHECK(overlap(nai, x) == graze::overlap_state::undefined);
  CHECK(nai.decoration_part() == decoration::ill);
  CHECK(empty(nai.interval_part()));
}

namespace {

/// As many operands as the function takes, or one and an exponent.
template <class Decorated, class Bare>
void check_function(const char* name, Decorated on_decorated, Bare on_bounds) {
  const decorated<> x(0.5, 0.75);
  const auto check = [&](const auto&... operands) {
    const decorated<> got = on_decorated(x, operands...);
    const bounds expected = on_bounds(x.part, graze::detail::as_bounds(operands)...);
    INFO(name);
    CHECK(graze::equal(got.part, expected));
    CHECK(!got.is_nai());
    CHECK(got.label <= graze::new_dec(expected).label);
  };
  if constexpr (std::invocable<Decorated, decorated<>, decorated<>, decorated<>>)
    check(x, x);
  else if constexpr (std::invocable<Decorated, decorated<>, decorated<>>)
    check(x);
  else if constexpr (std::invocable<Decorated, decorated<>>)
    check();
  else
    check(3);
}

} // namespace

TEST_CASE("interval.decorated: every function of the list takes decorated intervals", "[unit]") {
#define GRAZE_CHECK(name)                                                                          \
  check_function(                                                                                  \
      #name, [](const auto&... x) -> decltype(name(x...)) { return name(x...); },                  \
      [](const auto&... x) { return graze::functions::name::value(x...); });
  GRAZE_FOR_EACH_FUNCTION(GRAZE_CHECK)
#undef GRAZE_CHECK
}
