#pragma once
/// Which of two planes a ray reaches first: the one decision that all exact geometry here is made
/// of.
#include <array>
#include <cstdint>

namespace graze::oracle {

/// The ray's arrival at a plane of one axis, at t = |plane - origin| / speed > 0.
struct arrival {
  arrival() = default;
  /// plane != origin, speed = |direction| > 0; all finite. Needs gradual underflow (no FTZ, no
  /// DAZ).
  arrival(double plane_, double origin_, double speed_)
      : plane(plane_), origin(origin_), speed(speed_),
        distance(plane_ < origin_ ? origin_ - plane_ : plane_ - origin_) {}

  double plane, origin, speed;
  double distance; ///< |plane - origin| after one rounding, in whatever mode
};

/// How many decisions each method took in this thread: the filter in doubles, the 192-bit integers,
/// GMP. For tests, which must see that no method stays unused.
struct decision_counts {
  std::uint64_t filter = 0, wide = 0, gmp = 0;
};
inline thread_local constinit decision_counts decisions;

/// The sign of t_a - t_b, exactly, for all finite doubles: the sign of the determinant
/// |p_a - o_a| speed_b - |p_b - o_b| speed_a.
int compare_exactly(const arrival& a, const arrival& b);

/// The same; most often decided in doubles.
///
/// The filter. Let e = 2^-52, which bounds the relative error of one operation in every rounding
/// mode, D = |p_a - o_a|, s = speed_b, A = fl(fl(D) s), and likewise B. If fl(D) <= 2^1023, the
/// difference did not overflow (an overflow gives at least the largest double in every mode), and a
/// sum of doubles is never inexact below the normal range, so fl(D) = D (1 + d), |d| <= e. If
/// 2^-1000 <= A <= 2^1000, the product neither under- nor overflowed, so
///     D s (1 - e)^2 <= A <= D s (1 + e)^2,
/// and the exact products are at least A (1 - 2e) and at most B / (1 - e)^2 <= B (1 + 3e).
/// Let k = 1 + 8e. fl(B k) < A implies B (1 + 8e) (1 - e) < A, hence B (1 + 6e) < A, and the exact
/// product behind B is at most B (1 + 3e) < A (1 + 3e) / (1 + 6e) <= A (1 - 2e), since
/// (1 + 6e)(1 - 2e) = 1 + 4e - 12 e^2 >= 1 + 3e. So B's product is below A's.
inline int compare(const arrival& a, const arrival& b) {
  constexpr double margin = 0x1.0000000000008p+0; // k = 1 + 8 * 2^-52
  constexpr double least = 0x1p-1000, most = 0x1p+1000, far = 0x1p+1023;
  const double at_a = a.distance * b.speed;
  const double at_b = b.distance * a.speed;
  if (at_a >= least && at_b >= least && at_a <= most && at_b <= most && a.distance <= far &&
      b.distance <= far) {
    if (at_b * margin < at_a)
      return ++decisions.filter, 1;
    if (at_a * margin < at_b)
      return ++decisions.filter, -1;
  }
  return compare_exactly(a, b);
}

} // namespace graze::oracle
