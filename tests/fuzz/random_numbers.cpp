#include <catch2/catch.hpp>
#include <generate/random.hpp>
#include <limits>
#include <trial/number.hpp>

using namespace graze::fuzz;

TEST_CASE("fuzz.random: splitmix64 gives the published numbers", "[unit]") {
  // the first output of the reference implementation from state 0
  CHECK(mix(0) == 0xe220a8397b1dcdafu);
  CHECK(mix(0x9e3779b97f4a7c15u) == 0x6e789e6aa1b965f4u);
}

TEST_CASE("fuzz.random: streams of a seed are reproducible and differ", "[unit]") {
  random_stream a(1, 2), b(1, 2), c(1, 3), d(2, 2);
  const auto x = a.bits();
  CHECK(x == b.bits());
  CHECK(x != c.bits());
  CHECK(x != d.bits());
  for (int i = 0; i < 1000; ++i) {
    CHECK(a.below(7) < 7);
    const int n = a.between(-3, 3);
    CHECK((-3 <= n && n <= 3));
    CHECK(a.bits(5) < 32);
  }
}

TEST_CASE("fuzz.number: neighbours go through zero and stop at the largest double", "[unit]") {
  constexpr double least = 0x1p-1074;
  constexpr double most = std::numeric_limits<double>::max();
  CHECK(step_ulps(0.0, 1) == least);
  CHECK(step_ulps(-0.0, -1) == -least);
  CHECK(step_ulps(-least, 2) == least);
  CHECK(step_ulps(1.0, 1) == 0x1.0000000000001p0);
  CHECK(step_ulps(1.0, -1) == 0x1.fffffffffffffp-1);
  CHECK(step_ulps(most, 2) == most);
  CHECK(step_ulps(-most, -1) == -most);
}

TEST_CASE("fuzz.number: significant bits and their rounding", "[unit]") {
  CHECK(significant_bits(0) == 0);
  CHECK(significant_bits(-0x1p300) == 1);
  CHECK(significant_bits(0x1.8p-3) == 2);
  CHECK(significant_bits(0x1.0000000000001p0) == 53);
  CHECK(significant_bits(0x5p-1074) == 3);
  CHECK(keep_bits(0x1.fp0, 2) == 0x1.8p0);
  CHECK(keep_bits(-0x1.fp0, 1) == -1);
  CHECK(keep_bits(0x7p-1074, 2) == 0x6p-1074);
  CHECK(keep_bits(0.0, 1) == 0);
}

TEST_CASE("fuzz.number: hex floats are read back to the last bit", "[unit]") {
  random_stream random(3, 0);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::bit_cast<double>(random.bits());
    if (!std::isfinite(x))
      continue;
    const auto y = parse_number(hex(x));
    REQUIRE(y);
    REQUIRE(std::bit_cast<std::uint64_t>(*y) == std::bit_cast<std::uint64_t>(x));
  }
  CHECK(*parse_number("0.1") == 0.1);
  CHECK(*parse_number("-3") == -3);
  for (const char* wrong :
       {"", " 1", "1 ", "nan", "inf", "-infinity", "0x", "1e999", "0x1p5000", "1,5", "--1", "1x"})
    CHECK_FALSE(parse_number(wrong));
}
