#pragma once
/// Arguments on which functions of doubles go wrong, if they go wrong. Fixed seeds.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <graze/bounds.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace graze::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Inputs per operation: the environment's GRAZE_TEST_INPUTS or 100,000.
inline std::size_t input_count() {
  const char* set = std::getenv("GRAZE_TEST_INPUTS");
  return set != nullptr ? std::stoull(set) : 100'000;
}

class random_doubles {
public:
  explicit random_doubles(std::uint64_t seed) : random_(seed) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool coin() { return (random_() & 1) != 0; }
  double sign() { return coin() ? 1 : -1; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  /// Any finite double.
  double bit_pattern() {
    for (;;) {
      const auto x = std::bit_cast<double>(random_());
      if (std::isfinite(x))
        return x;
    }
  }
  /// In [2^exponent, 2^(exponent + 1)), often with few bits set or few clear.
  double with_exponent(int exponent) {
    std::uint64_t bits = random_() >> 12;
    switch (below(4)) {
    case 0:
      bits &= ~std::uint64_t{0} << below(53);
      break;
    case 1:
      bits |= (std::uint64_t{1} << below(53)) - 1;
      break;
    case 2:
      bits = below(2) == 0 ? below(4) : 0xfffffffffffff - below(4);
      break;
    default:
      break;
    }
    return std::ldexp(1 + static_cast<double>(bits & 0xfffffffffffff) * 0x1p-52, exponent);
  }
  /// x or a double a few ulps from it.
  double near(double x) {
    for (std::uint64_t steps = below(3); steps > 0; --steps)
      x = std::nextafter(x, coin() ? infinity : -infinity);
    return x;
  }
  double pick(const std::vector<double>& from) { return from[below(from.size())]; }

  /// An interval with an end x: one point, one ulp, narrow, wide, unbounded.
  bounds interval_at(double x, double other) {
    double y = x;
    switch (below(8)) {
    case 0:
      break;
    case 1:
    case 2:
      y = std::nextafter(x, sign() * infinity);
      break;
    case 3:
      y = x + sign() * std::ldexp(std::fabs(x), -static_cast<int>(below(53)));
      break;
    case 4:
      y = x + between(-7, 7);
      break;
    case 5:
      y = sign() * infinity;
      break;
    case 6:
      y = below(4) == 0 ? 0 : -x;
      break;
    default:
      y = other;
    }
    if (x == y && std::isinf(x))
      y = 0;
    return x < y ? bounds{x, y} : bounds{y, x};
  }

private:
  std::mt19937_64 random_;
};

/// For each exponent the doubles next to multiples of pi/2: M 2^E of the convergents of 2^E 2/pi
/// with M < 2^53. The nearest of all is the worst case of argument reduction.
std::vector<double> near_multiples_of_half_pi();

} // namespace graze::test
