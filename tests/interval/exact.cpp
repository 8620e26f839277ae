// The integer operations behind `nearest`, over all inputs and not only those that reach them.
#include <catch2/catch.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/oracle/rounding.hpp>
#include <graze/rounding/nearest.hpp>

namespace exact = graze::rounding::exact;
using graze::oracle::mpfr;

TEST_CASE("interval.exact: integer operations equal MPFR bit for bit", "[property][mpfr]") {
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
  };
  using enum exact::direction;
  graze::oracle::hard_operands make(128);
  constexpr auto kinds = static_cast<std::uint64_t>(graze::oracle::hardness::count);
  long wrong = 0;
  for (int i = 0; i < 200'000; ++i) {
    const auto [x, y] = make.next(static_cast<graze::oracle::hardness>(make.below(kinds)));
    wrong += !same(exact::add(x, y, up), mpfr::add_up(x, y)) +
             !same(exact::add(x, y, down), mpfr::add_down(x, y)) +
             !same(exact::mul(x, y, up), mpfr::mul_up(x, y)) +
             !same(exact::mul(x, y, down), mpfr::mul_down(x, y)) +
             !same(exact::div(x, y, up), mpfr::div_up(x, y)) +
             !same(exact::div(x, y, down), mpfr::div_down(x, y));
    if (x > 0 && exact::finite(x))
      wrong += !same(exact::sqrt_of_positive(x, up), mpfr::sqrt_up(x)) +
               !same(exact::sqrt_of_positive(x, down), mpfr::sqrt_down(x));
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.nearest: constant expressions", "[unit]") {
  using graze::rounding::nearest;
  static_assert(nearest::div_down(1, 3) == 0x1.5555555555555p-2);
  static_assert(nearest::div_up(1, 3) == 0x1.5555555555556p-2);
  static_assert(nearest::mul_up(0x1p-1074, 0x1p-1074) == 0x1p-1074);
  static_assert(nearest::mul_down(0x1p1023, 2) == std::numeric_limits<double>::max());
  static_assert(std::bit_cast<std::uint64_t>(nearest::sub_down(1, 1)) == exact::sign_bit);
  SUCCEED();
}
