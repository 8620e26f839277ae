#pragma once
/// When a ray is in a cell, through which faces, and on what length.
#include <graze/needs_cxx20.hpp>

#include <graze/bounds.hpp>

namespace graze::octree {

/// A face of a cell as a bit: its axis, and whether it is the upper one.
[[nodiscard]] constexpr unsigned face_bit(unsigned axis, bool upper) {
  return 1u << (2 * axis + (upper ? 1 : 0));
}

/// What a ray or segment and a closed cell have in common. The exact values are real numbers, in
/// general no doubles: each is enclosed, to an ulp or two.
struct passage {
  /// The first and the last t, in units of the ray's own parameter; of a segment between points, 0
  /// at the one and 1 at the other.
  bounds enter, leave;
  /// face_bit of the faces that the ray reaches at the very first t, from outside: two or three at
  /// an edge or a corner, none if it begins inside. One on which it begins and from which it moves
  /// inwards counts. Exact.
  unsigned entered;
  /// Likewise of the faces that it reaches at the very last t; none if it ends before them.
  unsigned left;
  /// From the first point to the last: scene length.
  bounds length;
};

} // namespace graze::octree
