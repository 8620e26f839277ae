#pragma once
/// Floats on which operations go wrong, if they go wrong; where an operation is that of doubles
/// rounded once more, above all where the double result is a float, or lies next to one.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <graze/oracle/binary32.hpp>
#include <graze/oracle/random_bits.hpp>
#include <limits>
#include <utility>

namespace graze::oracle {

/// A fixed sequence for a seed. To be used in round to nearest.
class hard_floats {
public:
  explicit hard_floats(std::uint64_t seed) : random_(seed) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool coin() { return (random_() & 1) != 0; }

  /// k floats further from zero (k < 0: nearer), within one sign.
  static float step(float x, int k) {
    constexpr std::int32_t infinity = 0x7f800000;
    const auto bits = std::bit_cast<std::int32_t>(std::fabs(x)) + k;
    return std::copysign(bits < 0 ? 0 : std::bit_cast<float>(std::min(bits, infinity)), x);
  }
  float nudged(float x) { return step(x, static_cast<int>(below(5)) - 2); }
  /// Any float but NaN.
  float any() {
    const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(random_()));
    return x != x ? 0 : x;
  }
  /// A significand of 1 to 24 bits.
  float with_exponent(int exponent) {
    const auto significand = static_cast<float>((random_() >> 40 >> below(24)) | 1);
    return std::ldexp(significand, exponent - std::ilogb(significand));
  }
  float power_of_two() { return std::ldexp(1.0f, static_cast<int>(below(277)) - 149); }

  std::pair<float, float> pair() {
    auto [x, y] = unsigned_pair();
    if (coin())
      std::swap(x, y);
    return {coin() ? x : -x, coin() ? y : -y};
  }

  /// A non-empty set between floats: a point, one ulp, from 0, a half-line, the line, any other.
  binary32::ends set(float p, float q) {
    constexpr float infinity = std::numeric_limits<float>::infinity(),
                    largest = std::numeric_limits<float>::max();
    switch (below(8)) {
    case 0:
      q = p;
      break;
    case 1:
      q = step(p, 1);
      break;
    case 2:
      q = 0;
      break;
    case 3:
      q = coin() ? infinity : -infinity;
      break;
    default:
      break;
    }
    if (below(64) == 0)
      return {-infinity, infinity};
    return {std::min({p, q, largest}), std::max({p, q, -largest})};
  }

private:
  std::pair<float, float> unsigned_pair() {
    switch (below(10)) {
    case 0:
      return {any(), any()};
    case 1: {
      const float x = any();
      return {x, nudged(x)};
    }
    case 2: // far apart: the double sum is a float, the exact one is not
      return {with_exponent(static_cast<int>(below(200)) - 80),
              with_exponent(static_cast<int>(below(60)) - 149)};
    case 3:
      return {nudged(power_of_two()), nudged(power_of_two())};
    case 4: // products and quotients that are floats, or next to one
      return {with_exponent(static_cast<int>(below(40)) - 20),
              with_exponent(static_cast<int>(below(40)) - 20)};
    case 5: {
      const float y = with_exponent(0), q = with_exponent(0);
      return {nudged(q * y), y};
    }
    case 6: { // results that are subnormal, or 0
      const int exponent = static_cast<int>(below(120)) - 140;
      return {with_exponent(exponent),
              with_exponent(std::max(-120 - static_cast<int>(below(40)) - exponent, -149))};
    }
    case 7: { // results about the largest float
      const int exponent = static_cast<int>(below(128));
      return {with_exponent(exponent), with_exponent((coin() ? 127 - exponent : exponent - 127) -
                                                     static_cast<int>(below(2)))};
    }
    case 8: { // squares
      const float s = with_exponent(static_cast<int>(below(60)) - 30);
      return {nudged(s * s), s};
    }
    default: { // subnormal, zero, the largest, infinite
      const float list[] = {0,
                            std::numeric_limits<float>::denorm_min(),
                            std::numeric_limits<float>::min(),
                            std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::infinity(),
                            1};
      return {nudged(list[below(5)]),
              std::bit_cast<float>(static_cast<std::uint32_t>(random_() >> 41 >> below(23)))};
    }
    }
  }

  random_bits random_;
};

} // namespace graze::oracle
