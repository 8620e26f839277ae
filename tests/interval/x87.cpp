// What the x87 does to a result, and what its precision does to long double.
#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/rounding.hpp>
#include <graze/rounding/split.hpp>
#include <string>

namespace hardware = graze::rounding::hardware;
using graze::oracle::mpfr;
using graze::rounding::split;

namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

std::string third() {
  volatile long double one = 1, three = 3;
  char text[64];
  std::snprintf(text, sizeof text, "%.20Lg", one / three);
  return text;
}

} // namespace

TEST_CASE("interval.split: a result kept in an x87 register would not be a double's",
          "[regression]") {
  double stored = 0;
  long double kept = 0;
  {
    const split::scope scope;
    stored = split::mul_up(split::mul_up(split::mul_up(0x1p-600, 1.5), 0x1p-500), 0x1p80);
    volatile long double a = 0x1p-600, b = 1.5, c = 0x1p-500, d = 0x1p80;
    kept = a * b * c * d;
  }
  CHECK(stored == 0x1p-994);
  CHECK(kept == 0x1.8p-1020L);
}

TEST_CASE("interval.split: rounding up twice is rounding up once", "[property][mpfr]") {
  // the x87 at 64 bits, then the store to a double: still MPFR's result, bit for bit
  graze::oracle::hard_operands make(641);
  long wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto [x, y] = make.next(static_cast<graze::oracle::hardness>(
        make.below(static_cast<std::uint64_t>(graze::oracle::hardness::count))));
    double sum = 0, product = 0, quotient = 0, root = 0;
    {
      const split::scope scope;
      hardware::set_x87_control(0x0b7f); // up, 64 bits
      sum = split::add_up(x, y);
      product = split::mul_up(x, y);
      quotient = split::div_up(x, y);
      root = split::sqrt_up(x);
    }
    wrong += !same(sum, mpfr::add_up(x, y)) + !same(product, mpfr::mul_up(x, y)) +
             !same(quotient, mpfr::div_up(x, y)) + !same(root, mpfr::sqrt_up(x));
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.split: long double and printf have their 64 bits back after the scope",
          "[regression]") {
  const std::string before = third();
  std::string within;
  {
    const split::scope scope;
    within = third();
  }
  CHECK(before == "0.33333333333333333334");
  CHECK(within != before); // 53 bits, rounded up: why the precision is scoped
  CHECK(third() == before);
}

TEST_CASE("interval.split: long double values alive across an operation survive it",
          "[regression]") {
  // eight of them fill the x87's stack, which the operations use too
  volatile long double start = 1;
  long double a = start / 3, b = start / 5, c = start / 7, d = start / 9, e = start / 11,
              f = start / 13, g = start / 15, h = start / 17;
  const long double sum = a + b + c + d + e + f + g + h;
  double bound = 0;
  {
    const split::scope scope;
    bound = split::sqrt_up(split::add_up(start, 0x1p-60));
  }
  CHECK(a + b + c + d + e + f + g + h == sum);
  CHECK(a * 3 == 1);
  CHECK(bound == 0x1.0000000000001p+0);
}
