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
/// here, or the other way round. The mode in force must be to-nearest and FTZ/DAZ off:
/// graze::rounding::refusal_for_nearest (environment.hpp) checks it.
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
    // One rounding: the error's sign is right unless it is rounded to 0, which can only be where
    // |product| < 2^-969 (the error is a multiple of 2^-105 times the product's binade). An
    // overflow to -inf has the error +inf, whose step leads to the least double; one to +inf has
    // -inf; NaN, from infinite operands, steps nowhere.
    const double error = __builtin_fma(x, y, -product);
    if (error == 0 && magnitude_of(product) < 0x1p-968) [[unlikely]]
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
    if (remainder == 0 && magnitude_of(x) < 0x1p-968) [[unlikely]]
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
    double root;
    const int error = sqrt_error(x, root);
    root = up_if(error > 0, root);
    hardware::pin(root);
    return root;
  }
  static double sqrt_down(double x) {
    double root;
    const int error = sqrt_error(x, root);
    // a root with an error is positive and normal: its predecessor is one less as an integer
    if (error < 0)
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
  static constexpr double magnitude_of(double x) { return __builtin_fabs(x); }

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

  /// root = RN(sqrt x); returns the sign of sqrt x - root.
  static int sqrt_error(double x, double& root) {
    hardware::pin(x);
    root = hardware::sqrt(x);
    if (!(x >= 0x1p-968 && x < std::numeric_limits<double>::infinity())) [[unlikely]]
      return sqrt_error_slow(x, root);
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
  [[gnu::cold, gnu::noinline]] static int sqrt_error_slow(double x, double root) {
    if (!(x > 0) || !exact::finite(x))
      return 0; // zeros, infinity and NaN are their own roots
    const double up = exact::sqrt_of_positive(x, exact::direction::up);
    const double down = exact::sqrt_of_positive(x, exact::direction::down);
    return (up > root) - (down < root);
  }
};

#if __cplusplus > 201703L
static_assert(Backend<nearest>);
#endif
static_assert(nearest::add_up(0.1, 0.2) == 0x1.3333333333334p-2 &&
              nearest::add_down(0.1, 0.2) == 0x1.3333333333333p-2);

} // namespace graze::rounding
