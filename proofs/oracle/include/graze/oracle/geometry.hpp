#pragma once
/// Exact geometry of a ray in a grid of axis-parallel planes, for every finite input. Written apart
/// from graze::octree, which it judges: it shares no code with it and takes plain arrays.
///
/// Every answer is exact in every rounding mode, and where the caller flushes subnormals (FTZ,
/// DAZ). Non-finite numbers and the direction 0 are programming errors (asserted).
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::oracle {

using point = std::array<double, 3>;

/// Where a ray is on one axis among the sorted planes p[0] < p[1] < ... of that axis:
/// 2k on plane k, 2k + 1 strictly between planes k and k + 1, -1 below the first plane,
/// 2n - 1 above the last of n planes.
using place = std::int8_t;

/// A maximal part of the ray whose place on all three axes is constant: either a single point of
/// the ray (some axis with motion is on a plane, or t = 0) or an open segment of positive length.
struct step {
  std::array<place, 3> at;
  bool segment; ///< an open segment of positive length; otherwise a single point

  friend bool operator==(const step&, const step&) = default;
};

/// The steps of {origin + t direction : t >= 0} from t = 0, in order of t, that lie within the
/// closed hull of the grid; empty when the ray misses the hull. Exact for all finite doubles;
/// direction != 0; planes strictly increasing, 1 (a flat grid) to 60 on each axis. Points and segments
/// alternate;
/// t = 0, where it lies in the hull, is a point of its own even when no plane passes there.
std::vector<step> steps_in_grid(const point& origin, const point& direction,
                                const std::array<std::span<const double>, 3>& planes);

/// The same into `steps`, whose former content is dropped; nothing is allocated once it has grown.
void steps_in_grid(const point& origin, const point& direction,
                   const std::array<std::span<const double>, 3>& planes, std::vector<step>& steps);

/// The ray meets the closed box [lo, hi]. lo[a] <= hi[a] (here and below).
bool touches(const point& origin, const point& direction, const point& lo, const point& hi);
/// The ray meets the open interior of the box.
bool crosses(const point& origin, const point& direction, const point& lo, const point& hi);
/// The ray has a point in the half-open box [lo, hi); an axis in `closed_far` (bit a) is closed at
/// hi (there the box ends at the root's far face).
bool owns(const point& origin, const point& direction, const point& lo, const point& hi,
          unsigned closed_far = 0);

} // namespace graze::oracle
