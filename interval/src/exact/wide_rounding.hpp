#pragma once
/// From a number of N limbs with a known error to the two doubles around it.
#include "wide.hpp"
#include <graze/point_rare.hpp>

namespace graze::wide {

using point::directed;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// The neighbours of a positive finite double.
constexpr double above(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1);
}
constexpr double below(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1);
}

constexpr directed mirrored(bool negative, directed d) {
  return negative ? directed{-d.up, -d.down} : d;
}

/// Bounds, and whether no tighter ones exist.
struct enclosure {
  directed bounds;
  bool tightest;
};

constexpr int clamped(std::int64_t exponent) { // beyond, nothing changes
  return static_cast<int>(exponent > 4000 ? 4000 : (exponent < -4000 ? -4000 : exponent));
}

/// Encloses a number that is no double and lies between value - under ulps and value + over ulps.
template <int N>
constexpr enclosure enclosed(const number<N>& value, std::uint64_t under, std::uint64_t over) {
  using rounding::exact::direction;
  limbs<N> lower = value.significand, upper = value.significand;
  subtract<N>(lower, under);
  const bool carry = add<N>(upper, over);
  const int exponent = clamped(value.exponent);
  if (-1021 <= exponent && exponent <= 1024) { // a normal double, or more than the largest
    const std::uint64_t kept = upper[N - 1] >> 11;
    if (!carry && lower[N - 1] >> 11 == kept) {
      const std::uint64_t bits = (static_cast<std::uint64_t>(exponent + 1021) << 52) + kept;
      return {{std::bit_cast<double>(bits), std::bit_cast<double>(bits + 1)}, true};
    }
  }
  const int bits = exponent >= -1021 ? 53 : exponent + 1074;
  const bool tightest =
      !carry && (bits <= 0 || lower[N - 1] >> (64 - bits) == upper[N - 1] >> (64 - bits));
  if (carry)
    upper = {}, upper[N - 1] = std::uint64_t{1} << 63;
  return {{rounding::exact::round(false, top_two<N>(lower), exponent - 128, true, direction::down),
           rounding::exact::round(false, top_two<N>(upper), exponent - 128 + (carry ? 1 : 0), true,
                                  direction::up)},
          tightest};
}

/// What two functions of wide_functions.hpp and a division or product or two leave: relative errors
/// below 2 * 2^8 and 20 units of 2^(-64 N), of at most an ulp each.
inline constexpr std::uint64_t error_of_quotients = 1024;

/// Tests compile the functions a second time with this macro, to see what two limbs hide: then only
/// the results with four are used.
#if defined(GRAZE_FOUR_LIMBS_ONLY)
inline constexpr bool four_limbs_only = true;
#else
inline constexpr bool four_limbs_only = false;
#endif
constexpr bool sufficient(const enclosure& e) { return e.tightest && !four_limbs_only; }

/// Bounds from f<2> and, where these do not suffice, f<4>: with an error of 2^-118 and a double
/// every 2^-53, one argument in 2^64 is expected to need the second, and none its last 128 bits;
/// should one, the bounds are still sound.
template <class Function> constexpr directed rounded(Function function) {
  const enclosure first = function.template operator()<2>();
  return sufficient(first) ? first.bounds : function.template operator()<4>().bounds;
}

/// The doubles around a t for which 1/x < t < (1 + 2^-110)/x (`farther`), or (1 - 2^-110)/x < t <
/// 1/x. x > 0. Where 1/x is no double it differs from every one by a factor of more than 1 +-
/// 2^-107, as M d, for the two significands of 53 bits, is then an integer other than a power of
/// two.
constexpr directed near_reciprocal(double x, bool farther) {
  using rounding::exact::direction;
  const double down = rounding::exact::div(1, x, direction::down);
  const double up = rounding::exact::div(1, x, direction::up);
  if (down != up)
    return {down, up};
  return farther ? directed{down, above(down)} : directed{below(down), down};
}

/// Where a decreasing or increasing residual changes its sign: `sign` is that of root - m, 0 if not
/// known; the root is then m + offset but for a relative error of the offset below 1/128.
struct residual {
  int sign;
  double offset;
  bool exact; ///< m is the root
};

constexpr bool sufficient(const residual& r) {
  return (r.sign != 0 || r.exact) && !four_limbs_only;
}

/// The neighbouring doubles around a root in (lower, upper), from a guess between. residual_at(m)
/// is sure of its sign, so that any guess is good enough, and only a poor one costs more steps.
template <class Residual>
directed neighbours_of_root(double m, double lower, double upper, Residual residual_at) {
  for (int step = 0; step < 100 && above(lower) < upper; ++step) {
    if (!(lower < m && m < upper))
      m = lower / 2 + upper / 2;
    if (!(lower < m && m < upper)) // halves of subnormal numbers
      m = above(lower);
    const residual r = residual_at(m);
    if (r.exact)
      return {m, m};
    if (r.sign == 0)
      break;
    const double next = r.sign > 0 ? above(m) : below(m);
    if ((next - m) * r.sign * 0.984375 > r.offset * r.sign)
      return r.sign > 0 ? directed{m, next} : directed{next, m};
    (r.sign > 0 ? lower : upper) = m;
    const double moved = m + r.offset;
    m = moved == m ? next : moved;
  }
  return {lower, upper};
}

} // namespace graze::wide
