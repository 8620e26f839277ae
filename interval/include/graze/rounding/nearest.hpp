#pragma once
/// `nearest`: round to nearest, then the sign of the exact error tells which neighbour is the
/// bound. It needs no mode but the one that every program starts in, so it may be inlined anywhere.
#include <cstdint>
#include <graze/rounding/exact.hpp>
#include <graze/rounding/hardware.hpp>
#if defined(__x86_64__)
#include <graze/rounding/packed_nearest.hpp>
#endif
#include <limits>

namespace graze::rounding {

/// Correct on every input under every flag that backend.hpp and hardware.hpp let through: operands
/// and results are pinned, so that no multiplication of the caller's is contracted into the sums
/// here, or the other way round. The mode in force must be to-nearest:
/// graze::rounding::refusal_for_nearest (environment.hpp) checks it. Where subnormal numbers may
/// occur, all is done in integers, so that flushing them (FTZ, DAZ) changes nothing.
struct nearest {
  using number = double;
  static constexpr const char* name = "nearest";

  /// Nothing: the operations need no mode but to-nearest.
  struct scope {
    scope() {}
  };

#if defined(__x86_64__)
  using pair_operations = packed::emulated_up;
#endif

  static constexpr double add_up(double x, double y) {
    GRAZE_IN_ORDER_WRITTEN
    if (__builtin_is_constant_evaluated())
      return exact::add(x, y, exact::direction::up);
    hardware::pin(x), hardware::pin(y);
    // else sums and their errors are multiples of 2^-1020
    if (tiny(x) || tiny(y)) [[unlikely]]
      return add_up_slow(x, y);
    double sum = x + y;
    // Knuth's TwoSum: sum + error = x + y exactly, as long as nothing overflows. If something does,
    // the sum or one of the steps, an infinity or NaN reaches `error`.
    const double y_part = sum - x;
    const double error = (x - (sum - y_part)) + (y - y_part);
    if (error - error != 0) [[unlikely]]
      sum = add_up_slow(x, y);
    else
      sum = up_if(error > 0, sum);
    hardware::pin(sum);
    return sum;
  }

  static constexpr double mul_up(double x, double y) {
    if (__builtin_is_constant_evaluated())
      return exact::mul(x, y, exact::direction::up);
    hardware::pin(x), hardware::pin(y);
    double product = x * y;
#if defined(__FMA__)
    // One rounding: the error's sign is right unless it is below the normal numbers, which can only
    // be where |product| < 2^-917 (the error is a multiple of 2^-105 times the product's binade).
    // An overflow to -inf has the error +inf, whose step leads to the least double; one to +inf has
    // -inf; NaN, from infinite operands, steps nowhere.
    const double error = __builtin_fma(x, y, -product);
    if (below(product, 0x1p-900) || subnormal(x) || subnormal(y)) [[unlikely]]
      product = mul_up_slow(x, y);
    else
      product = up_if(error > 0, product);
#else
    const parts a = x, b = y, p = product;
    if (!(a.normal() && b.normal() && p.normal())) [[unlikely]] {
      product = mul_up_slow(x, y);
    } else {
      // x y - product in units of the last bit of the exact 106-bit product: at most half an ulp of
      // product, 2^53 or less, so that the difference modulo 2^64 is the difference.
      const int shift = p.field - a.field - b.field + 1075;
      const auto error =
          static_cast<std::int64_t>(a.significand * b.significand - (p.significand << shift));
      product = up_if((p.is_negative ? -error : error) > 0, product);
    }
#endif
    hardware::pin(product);
    return product;
  }

  static constexpr double div_up(double x, double y) {
    if (__builtin_is_constant_evaluated())
      return exact::div(x, y, exact::direction::up);
    hardware::pin(x), hardware::pin(y);
    double quotient = x / y;
#if defined(__FMA__)
    // x - quotient y: signs and special cases as in mul_up; a multiple of 2^-105 times x's binade.
    const double remainder = __builtin_fma(-quotient, y, x);
    if (below(x, 0x1p-900) || subnormal(y) || below(quotient, 0x1p-1021)) [[unlikely]]
      quotient = div_up_slow(x, y);
    else
      quotient = up_if(__builtin_copysign(1.0, y) * remainder > 0, quotient);
#else
    const parts a = x, b = y, q = quotient;
    if (!(a.normal() && b.normal() && q.normal())) [[unlikely]] {
      quotient = div_up_slow(x, y);
    } else {
      // |x| - |quotient y| in units of the last bit of the exact product: at most |y|'s
      // significand.
      const int shift = a.field - q.field - b.field + 1075;
      const auto remainder =
          static_cast<std::int64_t>((a.significand << shift) - q.significand * b.significand);
      quotient = up_if((q.is_negative ? -remainder : remainder) > 0, quotient);
    }
#endif
    hardware::pin(quotient);
    return quotient;
  }

  static double sqrt_up(double x) {
    hardware::pin(x);
    if (!has_usual_root(x)) [[unlikely]]
      return sqrt_slow(x, exact::direction::up);
    double root;
    const bool low = sqrt_error(x, root) > 0;
    root = up_if(low, root);
    hardware::pin(root);
    return root;
  }
  static double sqrt_down(double x) {
    hardware::pin(x);
    if (!has_usual_root(x)) [[unlikely]]
      return sqrt_slow(x, exact::direction::down);
    double root;
    // a root with an error is positive and normal: its predecessor is one less as an integer
    if (sqrt_error(x, root) < 0)
      root = bit_cast<double>(bit_cast<std::int64_t>(root) - 1);
    hardware::pin(root);
    return root;
  }

  // Rounding to nearest is symmetric: RD(t) = -RU(-t) as in `upward`, signed zeros included.
  static constexpr double sub_up(double x, double y) { return add_up(x, -y); }
  static constexpr double add_down(double x, double y) { return -add_up(-x, -y); }
  static constexpr double sub_down(double x, double y) { return -add_up(-x, y); }
  static constexpr double mul_down(double x, double y) { return -mul_up(-x, y); }
  static constexpr double div_down(double x, double y) { return -div_up(-x, y); }

private:
  /// The double above x if `inexact`, else x. Not for NaN. A zero steps within its sign: -0 does
  /// not occur (rounding to zero keeps the sign, and what exceeds -0 is negative).
  /// Without a branch: the sign of an error is a coin toss.
  static constexpr double up_if(bool inexact, double x) {
    const auto bits = bit_cast<std::int64_t>(x);
    return bit_cast<double>(bits + (-std::int64_t{inexact} & (bits >> 63 | 1)));
  }
  // Magnitudes as integers: of 0 < |x| < 2^-968, of |x| < limit, of 0 < |x| < 2^-1022.
  static constexpr bool tiny(double x) {
    return (exact::bits_of(x) << 1) - 1 < (exact::bits_of(0x1p-968) << 1) - 1;
  }
  static constexpr bool below(double x, double limit) {
    return exact::bits_of(x) << 1 < exact::bits_of(limit) << 1;
  }
  static constexpr bool subnormal(double x) { return below(x, 0x1p-1022) && !exact::is_zero(x); }

  /// A double as integers; significand and field mean something for normal numbers only.
  struct parts {
    std::uint64_t significand = 0;
    int field = 0; ///< biased exponent: |x| = significand * 2^(field - 1075)
    bool is_negative = false;
    constexpr parts(double x) {
      const auto bits = bit_cast<std::uint64_t>(x);
      significand = (bits & (exact::hidden_bit - 1)) | exact::hidden_bit;
      field = static_cast<int>(bits >> 52 & 0x7ff);
      is_negative = exact::negative(x);
    }
    [[nodiscard]] constexpr bool normal() const {
      return static_cast<unsigned>(field) - 1u < 2046u;
    }
  };

  /// x >= 2^-900, and finite: the error below is a normal number or 0.
  static bool has_usual_root(double x) {
    return exact::bits_of(x) - exact::bits_of(0x1p-900) <
           exact::bits_of(std::numeric_limits<double>::infinity()) - exact::bits_of(0x1p-900);
  }
  /// root = RN(sqrt x); returns the sign of sqrt x - root.
  static int sqrt_error(double x, double& root) {
    root = hardware::sqrt(x);
#if defined(__FMA__)
    const double error = __builtin_fma(-root, root, x); // a double, since x >= 2^-968
    return (error > 0) - (error < 0);
#else
    const parts a = x, r = root;
    const int shift = a.field - 2 * r.field + 1075;
    const auto error =
        static_cast<std::int64_t>((a.significand << shift) - r.significand * r.significand);
    return (error > 0) - (error < 0);
#endif
  }

  [[gnu::cold, gnu::noinline]] static double add_up_slow(double x, double y) {
    return exact::add(x, y, exact::direction::up);
  }
  [[gnu::cold, gnu::noinline]] static double mul_up_slow(double x, double y) {
    return exact::mul(x, y, exact::direction::up);
  }
  [[gnu::cold, gnu::noinline]] static double div_up_slow(double x, double y) {
    return exact::div(x, y, exact::direction::up);
  }
  [[gnu::cold, gnu::noinline]] static double sqrt_slow(double x, exact::direction d) {
    if (exact::is_zero(x) || !exact::above_zero(x) || !exact::finite(x))
      return hardware::sqrt(exact::sign_if_number(x)); // zeros, infinity and NaN; NaN below zero
    return exact::sqrt_of_positive(x, d);
  }
};

#if __cplusplus > 201703L
static_assert(Backend<nearest>);
#endif
static_assert(nearest::add_up(0.1, 0.2) == 0x1.3333333333334p-2 &&
              nearest::add_down(0.1, 0.2) == 0x1.3333333333333p-2);

} // namespace graze::rounding
