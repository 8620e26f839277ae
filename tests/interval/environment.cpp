// What entry points look at before they trust the processor.
#include <catch2/catch.hpp>
#include <cfenv>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/split.hpp>

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
