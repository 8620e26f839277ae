#pragma once
/// The functions at a point, correctly rounded up and down, by CORE-MATH or CRlibm. Internal: what
/// the compiled functions on intervals and graze/point.hpp are made of.
#include "core_math.hpp"
#include <bit>
#include <cmath>
#include <cstdint>
#include <graze/rounding/exact.hpp>
#include <graze/rounding/hardware.hpp>
#include <limits>

extern "C" {
#if defined(GRAZE_ELEMENTARY_CRLIBM)
#define GRAZE_DECLARE(name) double name##_rd(double), name##_ru(double);
GRAZE_DECLARE(exp)
GRAZE_DECLARE(expm1)
GRAZE_DECLARE(log)
GRAZE_DECLARE(log1p)
GRAZE_DECLARE(log2)
GRAZE_DECLARE(log10)
GRAZE_DECLARE(sin)
GRAZE_DECLARE(cos)
GRAZE_DECLARE(tan)
GRAZE_DECLARE(atan)
GRAZE_DECLARE(sinh)
GRAZE_DECLARE(cosh)
#undef GRAZE_DECLARE
#endif
}

namespace graze::correctly_rounded {

namespace hardware = rounding::hardware;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// By the bits, as all comparisons with 0 here: a compiler may move it out of the scope, to where
/// subnormal numbers count as zero.
using rounding::exact::is_zero;

/// Another mode until a scope that lives ends.
template <hardware::mode Mode> void set_mode() {
#if defined(__x86_64__)
  static constexpr unsigned control = static_cast<unsigned>(Mode);
  asm volatile("ldmxcsr %0" : : "m"(control) : "memory");
#else
  std::fesetround(static_cast<int>(Mode));
#endif
}

/// For the life of a scope the mode that a function's points need; every exception masked, no
/// flushing of subnormals, and at the end the control and status found.
#if defined(__x86_64__)
/// As hardware::mode_scope, but with the control word in memory: an ldmxcsr that waits for a store
/// costs 2 ns more. One that lowers or raises the flag of an invalid operation or of a division by
/// zero costs 40 ns: those found raised stay so.
template <hardware::mode Mode> class scope_of {
public:
  scope_of() : found_(hardware::mxcsr()) {
    if ((found_ & slow_flags) == 0) [[likely]] {
      asm volatile("ldmxcsr %0" : : "m"(control[0]) : "memory");
    } else {
      asm volatile("ldmxcsr %0" : : "m"(control[found_ & slow_flags]) : "memory");
    }
  }
  ~scope_of() { asm volatile("ldmxcsr %0" : : "m"(found_) : "memory"); }
  scope_of(const scope_of&) = delete;
  scope_of& operator=(const scope_of&) = delete;

private:
  static constexpr unsigned slow_flags = 7; ///< invalid, denormal operand, division by zero
  static constexpr unsigned mode = static_cast<unsigned>(Mode);
  static constexpr unsigned control[] = {mode,     mode | 1, mode | 2, mode | 3,
                                         mode | 4, mode | 5, mode | 6, mode | 7};
  unsigned found_;
};
#else
template <hardware::mode Mode> struct scope_of : hardware::mode_scope {
  scope_of() : mode_scope(Mode) {}
};
#endif
using upward_scope = scope_of<hardware::mode::up>;
using nearest_scope = scope_of<hardware::mode::nearest>;

// CORE-MATH in the mode in force, compiled with fused operations where the processor has them. Read
// before its initialization, by another static object's, the flag is false: slower, not wrong.
namespace core_math {
#if defined(__x86_64__)
inline const bool fused = __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#define GRAZE_CHOOSE(name, ...)                                                                    \
  return fused ? graze_cr_##name##_fma(__VA_ARGS__) : graze_cr_##name(__VA_ARGS__)
#else
#define GRAZE_CHOOSE(name, ...) return graze_cr_##name(__VA_ARGS__)
#endif
#define GRAZE_DEFINE(name)                                                                         \
  inline double name(double x) { GRAZE_CHOOSE(name, x); }
GRAZE_FOR_EACH_POINT(GRAZE_DEFINE)
#undef GRAZE_DEFINE
#define GRAZE_DEFINE(name)                                                                         \
  inline double name(double x, double y) { GRAZE_CHOOSE(name, x, y); }
GRAZE_BINARY_FUNCTIONS(GRAZE_DEFINE)
#undef GRAZE_DEFINE
#undef GRAZE_CHOOSE
} // namespace core_math

/// The greatest double below r, for r > -inf and not NaN.
inline double below(double r) {
  if (is_zero(r))
    return -std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::int64_t>(r);
  return std::bit_cast<double>(bits + (bits < 0 ? 1 : -1));
}

/// One function from its value rounded up, r = RU(f(x)): where f(x) is no double, the greatest
/// double below r is RD(f(x)), overflow (r = inf) and underflow (r = 2^-1074 or -0) included. To be
/// called within a scope.
template <double (*Function)(double), bool (*Exact)(double x, double r)> struct from_above {
  using scope = upward_scope;
  static double up(double x) { return Function(x); }
  static double down(double x) {
    const double r = Function(x);
    return exact(x, r) ? r : below(r);
  }
  /// The least of down and the greatest of up at two points.
  static void both(double x, double y, double& least, double& greatest) {
    const double r = Function(x), s = Function(y);
    greatest = r < s ? s : r;
    const double p = exact(x, r) ? r : below(r), q = exact(y, s) ? s : below(s);
    least = p < q ? p : q;
    hardware::pin(least), hardware::pin(greatest); // compared within the scope
  }

private:
  static bool exact(double x, double r) { return Exact(x, r) || r != r; }
};

/// One function of CRlibm's, which has both directions and needs round to nearest.
template <double (*Down)(double), double (*Up)(double)> struct both_ways {
  using scope = nearest_scope;
  static double up(double x) { return Up(x); }
  static double down(double x) { return Down(x); }
  static void both(double x, double y, double& least, double& greatest) {
    const double r = up(x), s = up(y);
    greatest = r < s ? s : r;
    least = r < s ? down(x) : down(y);
    if (r == s)
      least = std::fmin(least, down(x));
  }
};

/// CRlibm's sinh(+-0x1.633ce8fb9f87ep+9), the first that overflows, is infinite in both directions.
template <class Function> struct without_infinity : Function {
  static constexpr double largest = std::numeric_limits<double>::max();
  static double up(double x) {
    const double r = Function::up(x);
    return r == -infinity && x != -infinity ? -largest : r;
  }
  static double down(double x) {
    const double r = Function::down(x);
    return r == infinity && x != infinity ? largest : r;
  }
};

// Where values are doubles. At an algebraic argument the exponential, logarithmic, trigonometric
// and hyperbolic functions and their inverses are transcendental but for the argument named here
// (Lindemann and Weierstrass); at infinite ends the limit is exact. Each test is one branch that is
// never taken in practice.

/// x is 0, infinite or NaN.
inline bool zero_or_not_finite(double x) {
  constexpr std::uint64_t twice_infinity = std::uint64_t{0x7ff} << 53;
  return (std::bit_cast<std::uint64_t>(x) << 1) - 1 >= twice_infinity - 1;
}
inline bool exact_at_zero(double x, double) { return is_zero(x); }
inline bool exact_at_one(double x, double) { return x == 1; }
inline bool exact_at_zero_and_infinity(double x, double) { return zero_or_not_finite(x); }
/// Poles at the ends of the domain, log(0) = -inf and atanh(1) = inf, are limits too; r is infinite
/// for no other argument of theirs. Where x = 0 or 1, r = 0; elsewhere r = 0 for x just below 1
/// only.
inline bool exact_at_zero_or_infinite(double x, double r) {
  return zero_or_not_finite(r) && (is_zero(x) || !is_zero(r));
}
inline bool exact_at_one_or_infinite(double x, double r) {
  return zero_or_not_finite(r) && (x == 1 || !is_zero(r));
}
/// 2^x is rational for an integer x only (Gelfond and Schneider).
inline bool exact_exp2(double x, double) {
  return (-1074 <= x && x <= 1023 && static_cast<double>(static_cast<int>(x)) == x) ||
         std::fabs(x) == infinity;
}
/// 10^k = 5^k 2^k, and 5^22 < 2^53 < 5^23; 10^-k is no dyadic number.
inline bool exact_exp10(double x, double) {
  return (0 <= x && x <= 22 && static_cast<double>(static_cast<int>(x)) == x) ||
         std::fabs(x) == infinity;
}
/// Powers of two, subnormal ones too, 0 and infinity: one bit of the significand at most.
inline bool exact_log2(double x, double) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction = bits & 0xfffffffffffff;
  return bits >> 52 == 0 ? (fraction & (fraction - 1)) == 0 : fraction == 0;
}
inline bool exact_log10(double x, double r) {
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (!(std::fabs(r) < 400))
    return true; // infinite, at 0 and inf
  const int k = static_cast<int>(r);
  return static_cast<double>(k) == r && 0 <= k && k <= 22 && powers[k] == x;
}
/// r^3 = x takes 3n - 2 bits at least, n those of r: n <= 18, so that r^2 is exact. Rounded up,
/// r^3 >= x (r >= the root); if it equals x, x >= r^3 as well. In the mode up.
inline bool exact_cbrt(double x, double r) {
  constexpr std::uint64_t beyond_18_bits = (std::uint64_t{1} << 35) - 1;
  if ((std::bit_cast<std::uint64_t>(r) & beyond_18_bits) != 0)
    return false;
  return zero_or_not_finite(r) ||
         std::bit_cast<std::uint64_t>(hardware::mul(hardware::mul(r, r), r)) ==
             std::bit_cast<std::uint64_t>(x);
}

using exp2 = from_above<core_math::exp2, exact_exp2>;
using exp10 = from_above<core_math::exp10, exact_exp10>;
using tanh = from_above<core_math::tanh, exact_at_zero_and_infinity>;
using asinh = from_above<core_math::asinh, exact_at_zero_and_infinity>;
using acosh = from_above<core_math::acosh, exact_at_one_or_infinite>;
using atanh = from_above<core_math::atanh, exact_at_zero_or_infinite>;
using cbrt = from_above<core_math::cbrt, exact_cbrt>;
// Not CRlibm's: both bounds of its asin(-0x1.e9950730c4696p-2) and the upper bound of its
// acos(0x1.1a62633145c07p-54) are an ulp too high.
using asin = from_above<core_math::asin, exact_at_zero>;
using acos = from_above<core_math::acos, exact_at_one>;
#if defined(GRAZE_ELEMENTARY_CRLIBM)
using exp = both_ways<exp_rd, exp_ru>;
using expm1 = both_ways<expm1_rd, expm1_ru>;
using log = both_ways<log_rd, log_ru>;
using log2 = both_ways<log2_rd, log2_ru>;
using log10 = both_ways<log10_rd, log10_ru>;
using logp1 = both_ways<log1p_rd, log1p_ru>;
using sin = both_ways<sin_rd, sin_ru>;
using cos = both_ways<cos_rd, cos_ru>;
using tan = both_ways<tan_rd, tan_ru>;
using atan = both_ways<atan_rd, atan_ru>;
using sinh = without_infinity<both_ways<sinh_rd, sinh_ru>>;
using cosh = both_ways<cosh_rd, cosh_ru>;
#else
using exp = from_above<core_math::exp, exact_at_zero_and_infinity>;
using expm1 = from_above<core_math::expm1, exact_at_zero_and_infinity>;
using log = from_above<core_math::log, exact_at_one_or_infinite>;
using log2 = from_above<core_math::log2, exact_log2>;
using log10 = from_above<core_math::log10, exact_log10>;
using logp1 = from_above<core_math::logp1, exact_at_zero_or_infinite>;
using sin = from_above<core_math::sin, exact_at_zero>;
using cos = from_above<core_math::cos, exact_at_zero>;
using tan = from_above<core_math::tan, exact_at_zero>;
using atan = from_above<core_math::atan, exact_at_zero>;
using sinh = from_above<core_math::sinh, exact_at_zero_and_infinity>;
using cosh = from_above<core_math::cosh, exact_at_zero_and_infinity>;
#endif

/// sqrt(x^2 + y^2).
struct hypot {
  using scope = upward_scope;
  static double up(double x, double y) { return core_math::hypot(x, y); }
  static double down(double x, double y);
};

/// The angle of (x, y).
struct atan2 {
  using scope = upward_scope;
  static double up(double y, double x) { return core_math::atan2(y, x); }
  static double down(double y, double x) {
    const double r = core_math::atan2(y, x);
    const bool exact =
        (is_zero(y) && !std::signbit(x)) || (x == infinity && std::fabs(y) < infinity);
    return exact || r != r ? r : below(r);
  }
};

/// x^y, called in both modes, which are set within one scope: its exact cases are as hard to tell
/// as its value.
struct pow {
  using scope = upward_scope;
  static double up(double x, double y) {
    set_mode<hardware::mode::up>();
    return core_math::pow(x, y);
  }
  static double down(double x, double y) {
    set_mode<hardware::mode::down>();
    return core_math::pow(x, y);
  }
};

} // namespace graze::correctly_rounded
