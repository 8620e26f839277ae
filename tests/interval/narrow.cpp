// Between float and double, in any environment.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <graze/oracle/elementary.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <graze/rounding/hardware.hpp>
#include <graze/rounding/narrow.hpp>
#include <limits>
#include <vector>

namespace rounding = graze::rounding;
namespace oracle = graze::oracle;

namespace {

std::uint32_t bits_of(float x) { return x != x ? 0x7fc00000 : std::bit_cast<std::uint32_t>(x); }
std::uint64_t bits_of(double x) {
  return x != x ? 0x7ff8000000000000 : std::bit_cast<std::uint64_t>(x);
}

struct three {
  std::uint32_t down, up, nearest;
  bool operator==(const three&) const = default;
};
three narrowed(double x) {
  return {bits_of(rounding::narrow_down(x)), bits_of(rounding::narrow_up(x)),
          bits_of(rounding::narrow_to_nearest(x))};
}
three by_mpfr(double x) {
  const auto to = [x](mpfr_rnd_t direction) {
    return bits_of(oracle::rounded_to<float>(
        [](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t d) { return mpfr_set(r, a, d); }, direction, x));
  };
  return {to(MPFR_RNDD), to(MPFR_RNDU), to(MPFR_RNDN)};
}

/// Floats, halves between two of them, and doubles beside those; results that are subnormal, 0, the
/// largest or infinite.
std::vector<double> hard_doubles() {
  oracle::hard_operands make(24);
  std::vector<double> list{0.0,
                           std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::denorm_min(),
                           std::numeric_limits<float>::max(),
                           0x1.fffffefffffffp+127,
                           0x1.ffffffp+127,
                           0x1p128,
                           0x1p-149,
                           0x1p-150,
                           0x1p-126};
  for (int i = 0; i < 200'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(make.below(std::uint64_t{1} << 31));
    double x = 0;
    switch (i % 4) {
    case 0: // any float, or half a step beyond, or beside either
      x = std::bit_cast<float>(bits);
      if (make.coin() && std::isfinite(x))
        x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + (std::uint64_t{1} << 28));
      x = make.nudged(x);
      break;
    case 1: // subnormal as floats, down to what is nothing
      x = make.nudged(std::ldexp(static_cast<double>(bits >> make.below(31)),
                                 -149 - static_cast<int>(make.below(20))));
      break;
    case 2:
      x = make.with_exponent(static_cast<int>(make.below(300)) - 160);
      break;
    default:
      x = make.any_normal();
    }
    list.push_back(x);
  }
  const std::size_t positive = list.size();
  for (std::size_t i = 0; i < positive; ++i)
    list.push_back(-list[i]);
  return list;
}

} // namespace

static_assert(rounding::narrow_down(0.1) == 0x1.999998p-4f &&
              rounding::narrow_up(0.1) == 0x1.99999ap-4f);
static_assert(rounding::narrow_up(0x1p-1074) == 0x1p-149f &&
              rounding::narrow_down(1e39) == std::numeric_limits<float>::max());

TEST_CASE("interval.narrow: a double's neighbours among floats are MPFR's", "[property][mpfr]") {
  long wrong = 0;
  for (const double x : hard_doubles())
    if (narrowed(x) != by_mpfr(x) && ++wrong <= 5)
      UNSCOPED_INFO(x);
  CHECK(wrong == 0);
}

TEST_CASE("interval.narrow: floats, widened, are themselves", "[exhaustive]") {
  long wrong = 0;
  for (std::uint64_t i = 0; i <= 0xffffffff; i += 61) {
    const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(i));
    const double wide = rounding::widened(x);
    // the compiler's own conversion, in the mode that every program starts in
    wrong += bits_of(wide) != bits_of(static_cast<double>(x));
    wrong += narrowed(wide) != three{bits_of(x), bits_of(x), bits_of(x)};
  }
  CHECK(wrong == 0);
}

#if defined(__x86_64__)
TEST_CASE("interval.narrow: FTZ, DAZ and the rounding mode change nothing", "[regression]") {
  namespace hardware = rounding::hardware;
  const std::vector<double> doubles = hard_doubles();
  std::vector<three> expected;
  for (const double x : doubles)
    expected.push_back(narrowed(x));
  const unsigned found = hardware::mxcsr();
  for (const unsigned flushing : {0u, 0x8000u, 0x0040u, 0x8040u})
    for (const unsigned mode : {0x0000u, 0x2000u, 0x4000u, 0x6000u}) {
      long wrong = 0;
      hardware::set_mxcsr(0x1f80 | mode | flushing);
      for (std::size_t i = 0; i < doubles.size(); ++i)
        wrong += narrowed(doubles[i]) != expected[i];
      for (std::uint32_t i = 0; i < 0x01000000; i += 3)
        wrong +=
            bits_of(rounding::widened(std::bit_cast<float>(i))) !=
            (i == 0 ? 0
                    : (i < 0x00800000 ? bits_of(static_cast<double>(i)) - (std::uint64_t{149} << 52)
                                      : (std::uint64_t{i} << 29) + (std::uint64_t{896} << 52)));
      hardware::set_mxcsr(found);
      INFO(mode << ' ' << flushing);
      CHECK(wrong == 0);
    }
}
#endif
