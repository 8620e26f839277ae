// The rare functions over intervals: tightest, against ranges put together from MPFR's values at
// points and its own whereabouts of poles and extrema; and their decorations.
#include "rare_judge.hpp"
#include <catch2/catch.hpp>
#include <graze/functions/integer_power.hpp>
#include <graze/functions/reciprocal_hyperbolic.hpp>
#include <graze/functions/reciprocal_trigonometric.hpp>
#include <graze/oracle/ranges.hpp>

using namespace graze;
using namespace graze::test;
namespace ranges = graze::oracle::ranges;

namespace {

constexpr decoration trv = decoration::trv;

template <class F, class Inputs, class Judge, class... Exponent>
std::string differences(const char* name, Inputs inputs, Judge judge) {
  random_doubles random(20244);
  verdicts v(name);
  if (!F::value(bounds::empty()).is_empty() || F::local(bounds::empty()) != trv)
    return "the empty set";
  const auto see = [&](const bounds& x) {
    const ranges::decorated want = judge(x);
    v.see(x, F::value(x), want.value);
    if (F::local(x) != want.local)
      v.see(x, bounds{double(F::local(x)), 0}, bounds{double(want.local), 0});
  };
  for (const bounds& x : {bounds::entire(),      bounds{0, infinity},
                          bounds{-infinity, 0},  bounds{0, 0},
                          bounds{-0.0, 0},       bounds{-0.0, 1},
                          bounds{-1, -0.0},      bounds{-1, 0.0},
                          bounds{0.0, 3.2},      bounds{-3.2, 0.0},
                          bounds{-1, 1},         bounds{1, infinity},
                          bounds{-infinity, -1}, bounds{1, 1},
                          bounds{-1, -1},        bounds{-1, infinity},
                          bounds{-infinity, 1},  bounds{0, 0x1p-1074},
                          bounds{-0x1p-1074, 0}, bounds{0x1.fffffffffffffp+1023, infinity},
                          bounds{-4, -1},        bounds{0.5, 1},
                          bounds{0, 1}})
    see(x);
  for (std::size_t i = input_count(); i > 0; --i) {
    const double x = inputs(random), other = inputs(random);
    see(random.interval_at(x, other));
  }
  return v.text();
}

const auto circular_arguments = [](random_doubles& random) {
  static const std::vector<double> near = near_multiples_of_half_pi();
  switch (random.below(8)) {
  case 0:
  case 1:
    return random.sign() * random.near(random.pick(near));
  case 2:
    return random.bit_pattern();
  case 3:
  case 4:
    return random.sign() * random.near(1.5707963267948966 * static_cast<double>(random.below(20)));
  default:
    return random.between(-8, 8);
  }
};
const auto real_arguments = [](random_doubles& random) {
  switch (random.below(6)) {
  case 0:
    return random.bit_pattern();
  case 1:
    return random.sign() * random.near(1);
  case 2:
    return random.between(-750, 750);
  case 3:
    return random.sign() * random.with_exponent(static_cast<int>(random.below(200)) - 100);
  default:
    return random.between(-10, 10);
  }
};

} // namespace

TEST_CASE("interval.cot: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::cot>("cot", circular_arguments, ranges::cot) == "");
}
TEST_CASE("interval.sec: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::sec>("sec", circular_arguments, ranges::sec) == "");
}
TEST_CASE("interval.csc: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::csc>("csc", circular_arguments, ranges::csc) == "");
}
TEST_CASE("interval.acot: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::acot>("acot", real_arguments, ranges::acot) == "");
}
TEST_CASE("interval.coth: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::coth>("coth", real_arguments, ranges::coth) == "");
}
TEST_CASE("interval.sech: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::sech>("sech", real_arguments, ranges::sech) == "");
}
TEST_CASE("interval.csch: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  CHECK(differences<functions::csch>("csch", real_arguments, ranges::csch) == "");
}
TEST_CASE("interval.acoth: the tightest enclosure on hard intervals",
          "[property][mpfr][hardcase]") {
  CHECK(differences<functions::acoth>("acoth", real_arguments, ranges::acoth) == "");
}

namespace {
template <int N> struct power {
  static bounds value(const bounds& x) { return functions::pown::value(x, N); }
  static decoration local(const bounds& x) { return functions::pown::local(x, N); }
};
template <int N> struct root {
  static bounds value(const bounds& x) { return functions::rootn::value(x, N); }
  static decoration local(const bounds& x) { return functions::rootn::local(x, N); }
};
const auto power_arguments = [](random_doubles& random) {
  return random.below(4) == 0 ? std::round(random.between(-300, 300)) *
                                    std::ldexp(1, static_cast<int>(random.below(9)) - 4)
                              : real_arguments(random);
};
template <int N> void check_power() {
  INFO("n = " << N);
  CHECK(differences<power<N>>("pown", power_arguments,
                              [](const bounds& x) { return ranges::pown(x, N); }) == "");
}
template <int N> void check_root() {
  INFO("n = " << N);
  CHECK(differences<root<N>>("rootn", power_arguments,
                             [](const bounds& x) { return ranges::rootn(x, N); }) == "");
}
constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();
} // namespace

TEST_CASE("interval.pown: the tightest enclosure on hard intervals", "[property][mpfr][hardcase]") {
  check_power<2>();
  check_power<3>();
  check_power<4>();
  check_power<8>();
  check_power<-2>();
  check_power<-3>();
}
TEST_CASE("interval.pown: the tightest enclosure for other exponents",
          "[property][mpfr][hardcase]") {
  check_power<0>();
  check_power<1>();
  check_power<-1>();
  check_power<5>();
  check_power<6>();
  check_power<7>();
  check_power<9>();
  check_power<100>();
  check_power<least>();
  check_power<greatest>();
}
TEST_CASE("interval.rootn: the tightest enclosure on hard intervals",
          "[property][mpfr][hardcase]") {
  check_root<0>();
  check_root<1>();
  check_root<-1>();
  check_root<2>();
  check_root<3>();
  check_root<4>();
  check_root<-2>();
  check_root<-3>();
  check_root<17>();
  check_root<least>();
  check_root<greatest>();
}

TEST_CASE("interval.rare: free functions on interval types, com for bounded results", "[unit]") {
  using I = interval<>;
  CHECK(cot(I(1.0)) == I(point::cot_down(1), point::cot_up(1)));
  CHECK(sec(I(0.0)) == I(1.0));
  CHECK(empty(csc(I(0.0))));
  CHECK(acot(I(0.0)) == I(0x1.921fb54442d18p+0, 0x1.921fb54442d19p+0));
  CHECK(coth(I(1.0, infinity)).lower() == 1);
  CHECK(sech(I(-1.0, 1.0)).upper() == 1);
  CHECK(csch(I(0.0, infinity)) == I(0.0, infinity));
  CHECK(empty(acoth(I(-1.0, 1.0))));
  CHECK(pown(I(-2.0, 1.0), 4) == I(0.0, 16.0));
  CHECK(pown(I(-2.0, 1.0), 3) == I(-8.0, 1.0));
  CHECK(rootn(I(-8.0, 27.0), 3) == I(-2.0, 3.0));
  const bounds x{1, 2};
  CHECK(local_decoration<functions::cot>(functions::cot::value(x), x) == decoration::com);
  CHECK(local_decoration<functions::pown>(functions::pown::value(x, -3), x, -3) == decoration::com);
  const bounds huge{1, std::numeric_limits<double>::max()};
  CHECK(local_decoration<functions::pown>(functions::pown::value(huge, 2), huge, 2) ==
        decoration::dac);
}

TEST_CASE("interval.rare: the same bounds in every rounding mode", "[unit]") {
  random_doubles random(20245);
  for (int i = 0; i < 1000; ++i) {
    const double x = circular_arguments(random), y = random.between(-20, 20);
    const int n = static_cast<int>(random.below(40)) - 20;
    const auto all = [&] {
      return std::vector<point::directed>{
          point::cot(x),  point::sec(x),  point::csc(x),   point::acot(y),    point::coth(y),
          point::sech(y), point::csch(y), point::acoth(y), point::pown(y, n), point::rootn(y, n)};
    };
    const std::vector<point::directed> nearest = all();
    for (const auto mode : {rounding::hardware::mode::down, rounding::hardware::mode::up}) {
      const rounding::hardware::mode_scope set(mode);
      const std::vector<point::directed> directed = all();
      bool equal = true;
      for (std::size_t k = 0; k < nearest.size(); ++k)
        equal = equal && same(nearest[k], directed[k]);
      REQUIRE(equal);
    }
  }
}
