#pragma once
/// Arguments on which elementary functions go wrong, if they go wrong, and intervals of them.
#include <graze/bounds.hpp>
#include <graze/oracle/hard_operands.hpp>
#include <mpfr.h>
#include <utility>

namespace graze::oracle {

/// Where a function is neither trivial nor constant: for the random half of the inputs.
struct active_range {
  double lo, hi;
};

/// A fixed sequence for a seed. To be used in round to nearest.
class hard_arguments {
public:
  explicit hard_arguments(std::uint64_t seed) : operands_(seed) {}

  std::uint64_t below(std::uint64_t n) { return operands_.below(n); }
  bool coin() { return operands_.coin(); }
  double uniform(double lo, double hi) {
    const double part = static_cast<double>(operands_.below(std::uint64_t{1} << 53)) * 0x1p-53;
    if (std::isinf(hi - lo)) // infinity times 0 would be a NaN
      return 2 * (lo / 2 + (hi / 2 - lo / 2) * part);
    return lo + (hi - lo) * part;
  }
  /// x in half of the cases, else up to 3 doubles beside it.
  double nudged(double x) {
    return coin() ? x : hard_operands::step(x, static_cast<int>(below(7)) - 3);
  }

  /// Half of them from the active range, half hard.
  double point(active_range active) {
    if (coin())
      return uniform(active.lo, active.hi);
    switch (below(10)) {
    case 0: // ends of the range, where results overflow, vanish, or the domain ends
      return nudged(coin() ? active.lo : active.hi);
    case 1: // any bit pattern, hence any size
      return signed_(operands_.any_normal());
    case 2: // values near 0: f(x) close to x, 1 + x, ...
      return signed_(operands_.with_exponent(-static_cast<int>(below(60))));
    case 3:
      return signed_(hard_operands::step(0, static_cast<int>(below(20))));
    case 4: // subnormal
      return signed_(std::bit_cast<double>(below(std::uint64_t{1} << 52) >> below(52)));
    case 5: // values near 1 and near small integers
      return signed_(nudged(static_cast<double>(below(40))));
    case 6: // short fractions: where exact cases would be
      return signed_(std::ldexp(static_cast<double>(below(64)), -static_cast<int>(below(12))));
    case 7: // powers of two and of ten
      return nudged(coin() ? std::ldexp(1, static_cast<int>(below(2098)) - 1074)
                           : power_of_ten(static_cast<int>(below(23))));
    case 8: // any integer of the range
      return nudged(std::floor(uniform(active.lo, active.hi)));
    default:
      return near_multiple_of_half_pi();
    }
  }

  /// Near k pi/2: for small k the doubles on either side, for huge ones those that continued
  /// fractions find to be nearest.
  double near_multiple_of_half_pi() {
    if (coin()) // 2^8 and 2^25: for k beyond, the product's error exceeds the step to the neighbour
      return signed_(nudged(0x1.921fb54442d18p+0 *
                            static_cast<double>(below(std::uint64_t{1} << (coin() ? 8 : 25)))));
    return signed_(nudged(nearest_multiple(static_cast<int>(below(1024)) - 52)));
  }

  /// A double q 2^exponent, q < 2^53, nearer to a multiple of pi/2 than any with a lesser q: q is
  /// the denominator of a convergent of the continued fraction of 2^exponent / (pi/2).
  static double nearest_multiple(int exponent);

  static double power_of_ten(int k) {
    double power = 1;
    for (int i = 0; i < k; ++i)
      power *= 10; // exact up to 10^22
    return power;
  }

  /// Intervals: points, one ulp, narrow, wide, unbounded.
  bounds interval(active_range active) {
    const double infinity = std::numeric_limits<double>::infinity();
    double a = point(active), b = a;
    switch (below(8)) {
    case 0:
      break;
    case 1:
      b = hard_operands::step(a, 1);
      break;
    case 2:
      b = hard_operands::step(a, static_cast<int>(below(100)));
      break;
    case 3: // of about the size of a period
      b = a + uniform(0, 8);
      break;
    case 4:
      if (std::isfinite(a)) // -inf + inf would be a NaN
        b = a + uniform(0, 1) * std::fabs(a);
      break;
    case 5:
      (coin() ? a : b) = coin() ? infinity : -infinity;
      break;
    default:
      b = point(active);
    }
    if (!(a <= b))
      std::swap(a, b);
    constexpr double largest = std::numeric_limits<double>::max();
    if (b == -infinity) // a point beyond the last double: no set
      b = -largest;
    if (a == infinity)
      a = largest;
    return {a, b};
  }

private:
  double signed_(double x) { return coin() ? -x : x; }

  hard_operands operands_;
};

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Beside x, on a step of doubles where f is nearly linear, the argument whose value is nearest to
/// a double but not equal: 2^-14 of an ulp off, or less. There the first, fast evaluation of a
/// correctly rounded function cannot decide.
double nearly_a_double(mpfr_function f, double x);

} // namespace graze::oracle
