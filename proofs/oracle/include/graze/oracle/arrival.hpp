#pragma once
/// Which of two planes a ray reaches first: the one decision that all exact geometry here is made
/// of.
#include <array>
#include <cstdint>
#include <limits>

namespace graze::oracle {

/// The ray's arrival at a plane of one axis, at t = |plane - origin| / speed > 0.
/// plane != origin, speed = |direction| > 0; all finite.
struct arrival {
  double plane, origin, speed;

  /// t after two roundings, in whatever mode; NaN where the bound of certainly_before does not
  /// hold. Needs gradual underflow (no FTZ, no DAZ).
  [[nodiscard]] double time() const {
    constexpr double least = 0x1p-1000, most = 0x1p+1000, far = 0x1p+1023;
    const double distance = plane < origin ? origin - plane : plane - origin;
    const double t = distance / speed;
    const bool in_range = (t >= least) & (t <= most) & (distance <= far);
    return in_range ? t : std::numeric_limits<double>::quiet_NaN();
  }
};

/// x lies before y for certain: for two arrivals' times, and infinity for one that never comes.
///
/// Let e = 2^-52, which bounds the relative error of one operation in every rounding mode, D =
/// |plane - origin|, T = D / speed. If fl(D) <= 2^1023, the difference did not overflow (an
/// overflow gives at least the largest double in every mode), and a sum of doubles is never inexact
/// below the normal range, so fl(D) = D (1 + d), |d| <= e. If 2^-1000 <= x <= 2^1000 for x =
/// fl(fl(D) / speed), the quotient neither under- nor overflowed, so
///     T (1 - e)^2 <= x <= T (1 + e)^2,
/// and T lies between x (1 - 2e) and x / (1 - e)^2 <= x (1 + 3e). Let k = 1 + 8e. fl(x k) < y
/// implies x (1 + 8e) (1 - e) < y, hence x (1 + 6e) < y, and the exact time behind x is at most
/// x (1 + 3e) < y (1 + 3e) / (1 + 6e) <= y (1 - 2e), since (1 + 6e)(1 - 2e) = 1 + 4e - 12 e^2 >=
/// 1 + 3e. So it is below that behind y.
inline bool certainly_before(double x, double y) {
  constexpr double k = 0x1.0000000000008p+0; // 1 + 8 * 2^-52
  return x * k < y;
}

/// How many decisions each method took in this thread: the filter in doubles, the 192-bit integers,
/// GMP. For tests, which must see that no method stays unused.
struct decision_counts {
  std::uint64_t filter = 0, wide = 0, gmp = 0;
};
inline thread_local constinit decision_counts decisions;

/// The sign of t_a - t_b, exactly, for all finite doubles: the sign of the determinant
/// |p_a - o_a| speed_b - |p_b - o_b| speed_a.
int compare_exactly(const arrival& a, const arrival& b);

/// The same; most often decided in doubles, by certainly_before.
inline int compare(const arrival& a, const arrival& b) {
  const double at_a = a.time(), at_b = b.time();
  if (certainly_before(at_b, at_a))
    return ++decisions.filter, 1;
  if (certainly_before(at_a, at_b))
    return ++decisions.filter, -1;
  return compare_exactly(a, b);
}

} // namespace graze::oracle
