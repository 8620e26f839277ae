#pragma once
/// How the ray passes the octant, in rationals: where it enters and leaves, and the edge that its
/// line passes nearest.
#include <gmpxx.h>
#include <optional>
#include <report/reproducer/reproducer.hpp>
#include <utility>

namespace graze::fuzz {

struct passage {
  /// The t >= 0 at which the ray is in the closed box; nothing if it misses it.
  std::optional<std::pair<mpq_class, mpq_class>> range;

  /// The nearest edge is parallel to the third axis: the corner `corner` on these two.
  unsigned along;  ///< the axis of the two on which the ray moves faster
  unsigned across; ///< the other: the distance is measured on it, where the ray is on the plane
  std::array<double, 3> corner; ///< of the edge; the third component is the box's lower one
  mpq_class distance;           ///< signed, on the axis `across`; 0 if the line meets the edge

  /// The unit in the last place of the largest of |origin|, |corner| (on `across`) and the size.
  double ulp;

  [[nodiscard]] double distance_in_ulps() const;
  /// The length of the ray in the box, on the axis of its fastest motion, in sizes of the box.
  [[nodiscard]] double chord(const trial& t) const;
};

passage passage_of(const trial& t, const cube& box);

/// "3", "0.25", or the hex float where a short decimal is not exact.
std::string spelled_short(double x);
/// The rational if it is short, else "about" and a decimal.
std::string spelled(const mpq_class& x);
std::string spelled(const vec3& v);
/// What the finding says about the octant, as a clause: "the ray crosses its interior".
std::string_view claim_of(finding kind, promise p);
/// There is no answer, and no octant is to blame.
bool is_fault(finding kind);
/// What the traversal did: "was not visited".
std::string_view fault_of(finding kind);

} // namespace graze::fuzz
