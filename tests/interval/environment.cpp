// What the environment of a thread does to bounds: nothing, or it is refused. The matrix of all
// operations in all environments is tests/environments.
#include <catch2/catch.hpp>
#include <cfenv>
#include <graze/graze.h>
#include <graze/interval.hpp>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/fused.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace rounding = graze::rounding;
namespace hardware = graze::rounding::hardware;

namespace {

struct refusals {
  std::optional<std::string> any, nearest;
};

refusals with_mxcsr(unsigned value) {
  const unsigned found = hardware::mxcsr();
  hardware::set_mxcsr(value);
  refusals r{rounding::refusal(), rounding::refusal_for_nearest()};
  hardware::set_mxcsr(found);
  return r;
}

} // namespace

TEST_CASE("interval.environment: the start of a program is accepted", "[unit]") {
  CHECK(!rounding::refusal());
  CHECK(!rounding::refusal_for_nearest());
}

TEST_CASE("interval.environment: FTZ and DAZ are reported", "[regression]") {
  const refusals ftz = with_mxcsr(0x9f80), daz = with_mxcsr(0x1fc0);
  REQUIRE(ftz.any);
  CHECK_THAT(*ftz.any, Catch::Contains("FTZ"));
  CHECK(ftz.nearest == ftz.any);
  REQUIRE(daz.any);
  CHECK_THAT(*daz.any, Catch::Contains("DAZ"));
  CHECK(daz.nearest == daz.any);
}

TEST_CASE("interval.environment: nearest refuses every other mode", "[unit]") {
  for (const unsigned mxcsr : {0x3f80u, 0x5f80u, 0x7f80u}) {
    const refusals r = with_mxcsr(mxcsr);
    CHECK(!r.any);
    REQUIRE(r.nearest);
    CHECK_THAT(*r.nearest, Catch::Contains("to-nearest"));
  }
}

TEST_CASE("interval.split: fesetround rewrites both control words, the scope puts them back",
          "[regression]") {
  const unsigned short found = hardware::x87_control();
  unsigned short within = 0;
  {
    const rounding::split::scope scope;
    std::fesetround(FE_DOWNWARD); // what the documentation forbids: the upper bounds go down
    within = hardware::x87_control();
  }
  CHECK((within & 0x0c00) == 0x0400);
  CHECK(hardware::x87_control() == found);
  CHECK(std::fegetround() == FE_TONEAREST);
}

namespace {

constexpr double tiny = 0x1p-1074;

/// f() in an environment, and what it gives as bounds in the default one again.
template <class F> auto within(unsigned mxcsr, F f) {
  const unsigned found = hardware::mxcsr();
  hardware::set_mxcsr(mxcsr);
  auto r = f();
  hardware::set_mxcsr(found);
  return r;
}
template <class I> bool is(const I& x, double lo, double hi) {
  return x.lower() == lo && x.upper() == hi;
}
/// FTZ and DAZ, as a library linked with -Ofast leaves them.
constexpr unsigned flushing = 0x9fc0;
constexpr unsigned environments[] = {0x9f80, 0x1fc0, flushing, 0x3f80, 0x5f80, 0x7f80};

} // namespace

TEST_CASE("interval.environment: products and quotients of interval<> where numbers are flushed",
          "[regression]") {
  using I = graze::interval<>;
  const I least(tiny), one(1);
  CHECK(is(within(flushing, [=] { return least * one; }), tiny, tiny));
  CHECK(is(within(flushing, [=] { return least / one; }), tiny, tiny));
  CHECK(is(within(flushing, [=] { return one / least; }), 0x1.fffffffffffffp+1023,
           std::numeric_limits<double>::infinity()));
  CHECK(is(within(flushing, [=] { return sqrt(least); }), 0x1p-537, 0x1p-537));
  CHECK(is(within(flushing, [=] { return square(least); }), 0, tiny));
  CHECK(empty(within(flushing, [=] { return sqrt(-least); })));
}

TEMPLATE_TEST_CASE("interval.environment: sums where numbers are flushed", "[regression]",
                   graze::rounding::nearest, graze::rounding::upward) {
  using I = graze::interval<TestType>;
  const I x(0x1.8p-1022), y(0x1p-1022), least(tiny), one(1);
  for (const unsigned mxcsr : {0x9f80u, 0x1fc0u, flushing}) {
    CAPTURE(mxcsr);
    CHECK(is(within(mxcsr, [=] { return x - y; }), 0x1p-1023, 0x1p-1023));
    CHECK(is(within(mxcsr, [=] { return least + least; }), 0x1p-1073, 0x1p-1073));
    CHECK(is(within(mxcsr, [=] { return one + least; }), 1, 0x1.0000000000001p+0));
    CHECK(is(within(mxcsr, [=] { return one - least; }), 0x1.fffffffffffffp-1, 1));
  }
}

TEMPLATE_TEST_CASE("interval.environment: functions are the same in any environment",
                   "[regression]", graze::rounding::nearest, graze::rounding::upward,
                   graze::rounding::split, graze::rounding::switching) {
  using I = graze::interval<TestType>;
  const I least(tiny);
  const I right_log = log(least), right_recip = recip(least);
  CHECK(right_log.lower() == -0x1.74385446d71c4p+9);
  for (const unsigned mxcsr : environments) {
    CAPTURE(mxcsr);
    const I l = within(mxcsr, [=] { return log(least); });
    CHECK(is(l, right_log.lower(), right_log.upper()));
    const I r = within(mxcsr, [=] { return recip(least); });
    CHECK(is(r, right_recip.lower(), right_recip.upper()));
    const I f = within(mxcsr, [] { return fma(I(0x1p-532), I(1.5), I(1.5)); });
    CHECK(is(f, 1.5, 0x1.8000000000001p+0));
    CHECK(is(within(mxcsr, [=] { return pown(least, 1); }), tiny, tiny));
    CHECK(is(within(mxcsr, [=] { return log2(least); }), -1074, -1074));
  }
}

TEMPLATE_TEST_CASE("interval.environment: signs of bounds are seen where numbers are flushed",
                   "[regression]", graze::rounding::upward, graze::rounding::split,
                   graze::rounding::switching) {
  using I = graze::interval<TestType>;
  const I least(tiny), x(1.5);
  CHECK(is(within(flushing, [=] { return least / x; }), 0, tiny));
  CHECK(is(within(flushing, [=] { return x / least; }), 0x1.fffffffffffffp+1023,
           std::numeric_limits<double>::infinity()));
  CHECK(is(within(flushing, [=] { return least * x; }), tiny, 0x1p-1073));
  CHECK(is(within(flushing, [=] { return least * I(1); }), tiny, tiny));
}

TEST_CASE("interval.environment: mid and rad belong together in any mode", "[regression]") {
  // mid rounded up and rad about the mid to nearest left 2^-60 out
  const auto holds = [](const graze::centre& c) { return c.mid == 0.5 && c.rad == 0.5; };
  graze::centre held{};
  {
    const rounding::upward::scope scope;
    held = mid_rad(graze::unprotected<rounding::upward>(0x1p-60, 1.0));
  }
  CHECK(holds(held));
  for (const unsigned mxcsr : environments) {
    CAPTURE(mxcsr);
    CHECK(holds(within(mxcsr, [] { return mid_rad(graze::interval<>(0x1p-60, 1.0)); })));
    const graze::centre c = within(mxcsr, [] { return mid_rad(graze::interval<>(tiny)); });
    CHECK((c.mid == tiny && c.rad == 0));
    CHECK(within(mxcsr, [] { return mag(graze::interval<>(-tiny)); }) == tiny);
    const graze::float_interval<> least(-0x1p-149f, 0x1p-149f);
    CHECK(within(mxcsr, [=] { return wid(least); }) == 0x1p-148f);
    CHECK(within(mxcsr, [=] { return inf(least); }) == -0x1p-149f);
  }
}

TEST_CASE("interval.environment: fmod and powers where numbers are flushed", "[regression]") {
  using I = graze::interval<>;
  const I least(tiny), one(1), two(2);
  for (const unsigned mxcsr : environments) {
    CAPTURE(mxcsr);
    CHECK(is(within(mxcsr, [=] { return fmod(least, one); }), tiny, tiny));
    const graze_interval r = within(mxcsr, [] { return graze_fmod({1, 1}, {tiny, tiny}); });
    CHECK((r.inf == 0 && r.sup == 0));
    CHECK(is(within(mxcsr, [=] { return pow(two, tiny); }), 1, 0x1.0000000000001p+0));
    CHECK(is(within(mxcsr, [] { return pow(I(0), tiny); }), 0, 0));
    CHECK(is(within(mxcsr, [] { return pow(I(-2, -1), 3.0); }), -8, -1));
    CHECK(is(within(mxcsr, [] { return pow(I(-2, 1), 0x1p60); }), 0,
             std::numeric_limits<double>::infinity()));
  }
}

TEST_CASE("interval.environment: text where numbers are flushed", "[regression]") {
  const graze::bounds least{tiny, tiny};
  const std::string right = graze::interval_to_text(least);
  CHECK(right != "[0]");
  for (const unsigned mxcsr : environments)
    CHECK(within(mxcsr, [&] { return graze::interval_to_text(least); }) == right);
}

TEST_CASE("interval.environment: a mode that is stored and not obeyed is refused", "[regression]") {
  // as under valgrind, where every operation rounds to nearest
  using rounding::detail::witness;
  const witness w = witness::now();
  CHECK(w.rounds_to_nearest());
  CHECK_FALSE(w.rounds_down());
  CHECK_FALSE(w.rounds_up());
  CHECK(rounding::detail::witness_within(hardware::mode::down).rounds_down());
  CHECK(rounding::detail::witness_within(hardware::mode::up).rounds_up());
  const witness flushed = within(flushing, [] { return witness::now(); });
  CHECK_FALSE(flushed.knows_subnormal_results());
  CHECK_FALSE(flushed.knows_subnormal_operands());
}

TEST_CASE("interval.environment: a program sets its own", "[unit]") {
  const bool good = within(0xdfc0, [] {
    const bool may = rounding::program_may_start("test");
    return may && hardware::mxcsr() == 0x1f80 && hardware::x87_control() == 0x037f;
  });
  CHECK(good);
}
