#pragma once
/// Operands on which rounded operations go wrong, if they go wrong: one-ulp neighbours, ties,
/// results that are subnormal or overflow, cancellation, exact quotients and squares and their
/// neighbours.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <graze/oracle/random_bits.hpp>
#include <limits>

namespace graze::oracle {

struct operands {
  double x, y;
};

/// What a pair was made to be hard for.
enum class hardness {
  none, ///< two random bit patterns: the control
  neighbours,
  sum_ties,
  powers_of_two,
  short_products,
  exact_quotients,
  squares,
  tiny_products,
  tiny_quotients,
  overflow,
  specials,
  cancellation,
  subnormal,
  far_apart,
  related,
  count
};

/// A fixed sequence of pairs for a seed. To be used in round to nearest.
class hard_operands {
public:
  explicit hard_operands(std::uint64_t seed) : random_(seed) {}

  operands next(hardness h) {
    operands p = unsigned_pair(h);
    if (coin())
      p = {p.y, p.x};
    return {coin() ? -p.x : p.x, coin() ? -p.y : p.y};
  }

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool coin() { return (random_() & 1) != 0; }

  /// A random significand, often with few bits set or few bits clear, with a given exponent.
  double with_exponent(int exponent) {
    std::uint64_t bits = random_() >> 12;
    switch (below(4)) {
    case 0:
      bits &= ~std::uint64_t{0} << below(53);
      break;
    case 1:
      bits |= (std::uint64_t{1} << below(53)) - 1;
      break;
    default:
      break;
    }
    bits &= (std::uint64_t{1} << 52) - 1;
    return std::ldexp(1 + std::ldexp(static_cast<double>(bits), -52), exponent);
  }
  double any_normal() { return with_exponent(static_cast<int>(below(2046)) - 1022); }
  double moderate() { return with_exponent(static_cast<int>(below(200)) - 100); }

  /// k doubles further from zero (k < 0: nearer), within one sign, and no further than infinity,
  /// beyond which bits are those of a NaN. A NaN stays one.
  static double step(double x, int k) {
    if (std::isnan(x))
      return x;
    constexpr auto last = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
    const auto bits = std::bit_cast<std::int64_t>(std::fabs(x)) + k;
    return std::copysign(bits < 0 ? 0 : std::bit_cast<double>(bits < last ? bits : last), x);
  }
  double nudged(double x) { return step(x, static_cast<int>(below(5)) - 2); }

  double special() {
    using limits = std::numeric_limits<double>;
    static const std::array<double, 20> list{0,
                                             limits::denorm_min(),
                                             0x2p-1074,
                                             0x1p-1023,
                                             limits::min(),
                                             0x1p-969,
                                             0x1p-968,
                                             0x1p-537,
                                             0x1p-512,
                                             0x1p-53,
                                             0x1p-52,
                                             0.5,
                                             1,
                                             1.5,
                                             0x1p53,
                                             0x1p512,
                                             0x1p970,
                                             limits::max(),
                                             limits::infinity(),
                                             limits::quiet_NaN()};
    const double x = list[below(list.size())];
    return std::isfinite(x) && coin() ? nudged(x) : x;
  }

private:
  operands unsigned_pair(hardness h) {
    switch (h) {
    case hardness::none:
      return {std::bit_cast<double>(random_() >> 1), std::bit_cast<double>(random_() >> 1)};
    case hardness::neighbours: {
      const double x = any_normal();
      return {x, step(x, static_cast<int>(below(9)) - 4)};
    }
    case hardness::sum_ties: { // y is half an ulp of x, or an odd multiple, or just beside
      const double x = any_normal();
      const double half = std::ldexp(step(x, 1) - x, -1);
      return {x, nudged(half * static_cast<double>(1 + 2 * below(8)))};
    }
    case hardness::powers_of_two: {
      const auto power = [&] { return std::ldexp(1.0, static_cast<int>(below(2098)) - 1074); };
      return {nudged(power()), nudged(power())};
    }
    case hardness::short_products: { // 53, 54 and 55 bits: exact, ties, and near ties
      const unsigned bits = 1 + static_cast<unsigned>(below(53));
      const double x = static_cast<double>((random_() >> (64 - bits)) | 1);
      const double y = static_cast<double>((random_() >> (10 + bits - below(2))) | 1);
      return {coin() ? x : nudged(x), scaled(y)};
    }
    case hardness::exact_quotients: {
      const double y = static_cast<double>((random_() >> 38) | 1);
      const double q = static_cast<double>((random_() >> 37) | 1);
      return {nudged(q * y), scaled(y)};
    }
    case hardness::squares: { // x = s^2, exact or rounded; also far into the subnormal numbers
      const double s = coin() ? static_cast<double>(random_() >> 38) : moderate();
      const double x = nudged(std::ldexp(s * s, 2 * (static_cast<int>(below(1030)) - 560)));
      return {x, s};
    }
    case hardness::tiny_products: { // from where the error is no double to below the least double
      const int sum = -960 - static_cast<int>(below(125));
      const int exponent = static_cast<int>(below(1000)) - 980;
      return {with_exponent(exponent), with_exponent(sum - exponent)};
    }
    case hardness::tiny_quotients: {
      const int difference = -960 - static_cast<int>(below(125));
      const int exponent = -1020 + static_cast<int>(below(1000));
      const double x = with_exponent(exponent);
      return {x, with_exponent(exponent - difference > 1023 ? 1023 : exponent - difference)};
    }
    case hardness::overflow: {
      const int exponent = static_cast<int>(below(1024));
      switch (below(3)) {
      case 0:
        return {with_exponent(1023), with_exponent(1023 - static_cast<int>(below(60)))};
      case 1:
        return {with_exponent(exponent), with_exponent(1023 - exponent)};
      default:
        return {with_exponent(exponent), with_exponent(exponent - 1024)};
      }
    }
    case hardness::specials:
      return {special(), special()};
    case hardness::cancellation: {
      const double x = any_normal();
      const int bits = static_cast<int>(below(60));
      return {x, x + std::ldexp(x, -bits) * (coin() ? 1.0 : 0.75)};
    }
    case hardness::subnormal: {
      const double x = std::bit_cast<double>(random_() >> (12 + below(50)));
      return {x, coin() ? std::bit_cast<double>(random_() >> (11 + below(50))) : moderate()};
    }
    case hardness::far_apart: { // about the 53, 54, 64 and 106 bits at which codes change their way
      const std::array<int, 6> gaps{52, 53, 54, 64, 106, 1100};
      const int gap = gaps[below(gaps.size())] + static_cast<int>(below(5)) - 2;
      const int exponent = static_cast<int>(below(2046)) - 1022;
      return {with_exponent(exponent), std::ldexp(with_exponent(0), exponent - gap)};
    }
    case hardness::related: {
      const double x = any_normal();
      switch (below(4)) {
      case 0:
        return {x, x};
      case 1:
        return {x, nudged(1 / x)};
      case 2:
        return {x, scaled(x)};
      default:
        return {x, nudged(std::sqrt(x))};
      }
    }
    case hardness::count:
      break;
    }
    return {0, 0};
  }

  double scaled(double x) { return std::ldexp(x, static_cast<int>(below(120)) - 60); }

  random_bits random_;
};

} // namespace graze::oracle
