// pown and rootn at points against MPFR.
#include "rare_judge.hpp"
#include <catch2/catch.hpp>

#if !defined(GRAZE_PHASE) // a second program tests the accurate phase alone
#define GRAZE_PHASE ""
#endif

using namespace graze;
using namespace graze::test;

namespace {

constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();

int exponent(random_doubles& random) {
  static const int special[] = {least, least + 1, greatest, greatest - 1, 0, 1, -1, 2, -2};
  switch (random.below(8)) {
  case 0:
    return special[random.below(std::size(special))];
  case 1:
    return static_cast<int>(random.below(2000)) - 1000;
  case 2:
    return static_cast<int>(static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32))) >>
           random.below(31);
  case 3:
  case 4:
    return static_cast<int>(random.below(9));
  default:
    return static_cast<int>(random.below(80)) - 16;
  }
}

/// A significand of few bits, so that powers may be exact.
double short_number(random_doubles& random, int exponent_of_two) {
  const auto bits = static_cast<int>(random.below(20)) + 1;
  return std::ldexp(static_cast<double>(random.below(std::uint64_t{1} << bits) | 1),
                    exponent_of_two);
}

double base(random_doubles& random, int n) {
  const double size = std::fabs(static_cast<double>(n)) + (n == 0 ? 1 : 0);
  switch (random.below(8)) {
  case 0:
    return random.bit_pattern();
  case 1: // a result near the limits of doubles
    return random.sign() *
           random.near(std::exp2(random.sign() * random.between(1020, 1078) / size));
  case 2:
  case 3: // any finite result
    return random.sign() * std::exp2(random.between(-1080, 1030) / size);
  case 4:
    return random.sign() * short_number(random, static_cast<int>(random.below(60)) - 40);
  case 5:
    return random.sign() * random.near(1);
  case 6:
    return random.sign() * random.with_exponent(static_cast<int>(random.below(4)) - 2);
  default:
    return random.between(-4, 4);
  }
}

/// At 0 < |n| odd MPFR has a signed infinity at the pole, which is outside of the domain here.
point::directed power(double x, int n) {
  return x == 0 && n < 0 ? point::directed{std::nan(""), std::nan("")} : judged_power(x, n);
}
point::directed root(double x, int n) {
  return (x == 0 && n < 0) || n == 0 ? point::directed{std::nan(""), std::nan("")}
                                     : judged_root(x == 0 ? 0.0 : x, n);
}

} // namespace

TEST_CASE("interval.pown: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  random_doubles random(20242);
  verdicts v("pown");
  for (int n : {least, least + 1, -3, -2, -1, 0, 1, 2, 3, 4, greatest - 1, greatest})
    for (double x : {0.0, -0.0, 1.0, -1.0, infinity, -infinity, 0x1p-1074, -0x1p-1074, 0x1p-1022,
                     std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                     0x1.0000000000001p0, 0x1.fffffffffffffp-1})
      v.see(x, point::pown(x, n), power(x, n), n);
  for (std::size_t i = input_count(); i > 0; --i) {
    const int n = exponent(random);
    const double x = base(random, n);
    v.see(x, point::pown(x, n), power(x, n), n);
  }
  CHECK(v.text() == "");
}

TEST_CASE("interval.rootn: equals MPFR at hard points" GRAZE_PHASE, "[property][mpfr][hardcase]") {
  random_doubles random(20243);
  verdicts v("rootn");
  for (int n : {least, least + 1, -3, -2, -1, 0, 1, 2, 3, 4, greatest - 1, greatest})
    for (double x : {0.0, -0.0, 1.0, -1.0, infinity, -infinity, 0x1p-1074, -0x1p-1074, 0x1p-1022,
                     std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                     0x1.0000000000001p0, 0x1.fffffffffffffp-1})
      v.see(x, point::rootn(x, n), root(x, n), n);
  for (std::size_t i = input_count(); i > 0; --i) {
    const int n = exponent(random);
    double x = 0;
    switch (random.below(6)) {
    case 0:
      x = random.bit_pattern();
      break;
    case 1: // perfect powers and their neighbours
      x = std::pow(short_number(random, static_cast<int>(random.below(40)) - 20), n);
      break;
    case 2: // powers of doubles, rounded: close to perfect
      x = point::pown(base(random, n), n).down;
      break;
    case 3:
      x = std::ldexp(1, static_cast<int>(random.below(2098)) - 1074);
      break;
    default:
      x = random.sign() * random.with_exponent(static_cast<int>(random.below(2098)) - 1074);
    }
    x = random.near(x);
    v.see(x, point::rootn(x, n), root(x, n), n);
  }
  CHECK(v.text() == "");
}
