// cot, sec, csc, acot, coth, sech, csch, acoth at points against MPFR.
#include "rare_judge.hpp"
#include <catch2/catch.hpp>

#if !defined(GRAZE_PHASE) // a second program tests the accurate phase alone
#define GRAZE_PHASE ""
#endif

using namespace graze;
using namespace graze::test;

namespace {

template <class Judge, class Inputs>
std::string differences(const char* name, point::directed (*function)(double), Judge judge,
                        Inputs inputs) {
  random_doubles random(20241);
  verdicts v(name);
  for (double x : {0.0, -0.0, infinity, -infinity, std::nan(""), 1.0, -1.0, 0x1p-1074, -0x1p-1074,
                   std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()})
    v.see(x, function(x), judge(x));
  for (std::size_t i = input_count(); i > 0; --i) {
    const double x = inputs(random);
    v.see(x, function(x), judge(x));
  }
  return v.text();
}

/// MPFR gives a signed infinity at poles; here they are outside of the domain.
template <class Function> auto off_poles(Function f) {
  return
      [f](double x) { return x == 0 ? point::directed{std::nan(""), std::nan("")} : judged(f, x); };
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
    return random.sign() *
           random.near(1.5707963267948966 *
                       static_cast<double>(random.below(std::uint64_t{1} << random.below(50))));
  case 4:
    return random.sign() * random.with_exponent(static_cast<int>(random.below(160)) - 80);
  case 5:
    return random.sign() * random.near(0.75);
  default:
    return random.between(-10, 10);
  }
};

const auto hyperbolic_arguments = [](random_doubles& random) {
  switch (random.below(8)) {
  case 0:
    return random.bit_pattern();
  case 1:
    return random.sign() * random.with_exponent(static_cast<int>(random.below(80)) - 70);
  case 2:
    return random.sign() * random.between(700, 750);
  case 3:
    return random.sign() * random.between(18, 20);
  case 4:
    return random.sign() *
           random.near(0.6931471805599453 * static_cast<double>(random.below(1080)));
  case 5:
    return random.sign() *
           random.near(random.coin() ? 0.75 : std::ldexp(1, -27 - 33 * random.coin()));
  default:
    return random.between(-30, 30);
  }
};

} // namespace

TEST_CASE("interval.cot: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences("cot", point::cot, off_poles(mpfr_cot), circular_arguments) == "");
}
TEST_CASE("interval.sec: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences(
            "sec", point::sec, [](double x) { return judged(mpfr_sec, x); }, circular_arguments) ==
        "");
}
TEST_CASE("interval.csc: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences("csc", point::csc, off_poles(mpfr_csc), circular_arguments) == "");
}
TEST_CASE("interval.coth: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences("coth", point::coth, off_poles(mpfr_coth), hyperbolic_arguments) == "");
}
TEST_CASE("interval.sech: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences(
            "sech", point::sech, [](double x) { return judged(mpfr_sech, x); },
            hyperbolic_arguments) == "");
}
TEST_CASE("interval.csch: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  CHECK(differences("csch", point::csch, off_poles(mpfr_csch), hyperbolic_arguments) == "");
}

TEST_CASE("interval.acot: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  const auto judge = [](double x) { return judged(oracle::ranges::mpfr_acot, x); };
  CHECK(differences("acot", point::acot, judge, [](random_doubles& random) {
          switch (random.below(8)) {
          case 0:
            return random.bit_pattern();
          case 1:
            return random.sign() * random.near(std::ldexp(1, random.coin() ? 60 : -60));
          case 2: // near the cotangent of a double
            return 1 / std::tan(random.between(0, 3.2));
          case 3:
            return random.between(-10, 10);
          default:
            return random.sign() * random.with_exponent(static_cast<int>(random.below(140)) - 70);
          }
        }) == "");
}

TEST_CASE("interval.acoth: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  const auto judge = [](double x) { return judged(oracle::ranges::mpfr_acoth, x); };
  CHECK(differences("acoth", point::acoth, judge, [](random_doubles& random) {
          switch (random.below(8)) {
          case 0:
            return random.bit_pattern();
          case 1:
            return random.sign() * random.near(0x1p60);
          case 2: // near the hyperbolic cotangent of a double
            return random.sign() / std::tanh(random.between(0, 19));
          case 3:
            return random.sign() *
                   (1 + random.with_exponent(-1 - static_cast<int>(random.below(53))));
          case 4:
            return random.between(-10, 10);
          default:
            return random.sign() * random.with_exponent(static_cast<int>(random.below(70)));
          }
        }) == "");
}
