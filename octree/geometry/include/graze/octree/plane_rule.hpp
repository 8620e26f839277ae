#pragma once
/// How the planes of a grid come about. Vocabulary only.
#include <graze/needs_cxx20.hpp>

namespace graze::octree {

/// Plane k of an axis, k = 0 .. count, from an origin o, a spacing s > 0 and a count. RN rounds to
/// the nearest double, ties to even; RN32 to the nearest float.
enum class plane_rule {
  exact,      ///< the real number o + k s, in general no double
  rounded,    ///< RN(o + k s), one rounding
  multiplied, ///< RN(o + RN(k s))
  added,      ///< o, and RN(plane k - 1 + s)
  binary32,   ///< RN32(RN32(o) + RN32(RN32(k) RN32(s)))
  given,      ///< doubles from an array
};

} // namespace graze::octree
