#pragma once
/// Planes that need not be doubles, and what lies between them on each axis: a voxel of any grid, a
/// box, an octant.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <cstdint>
#include <graze/octree/box.hpp>
#include <graze/rounding/exact.hpp>

namespace graze::octree {

/// The real number origin + multiple * spacing, not rounded; spacing >= 0, multiple <= 2^20.
struct plane_value {
  double origin;
  double spacing = 0;
  std::uint32_t multiple = 0;
};

/// On each axis what lies between two planes, lower <= upper. Flat where they are equal.
struct slabs {
  std::array<plane_value, 3> lower, upper;
  /// Bit a: in the half-open convention axis a is closed at its upper plane too, as at a grid's far
  /// face. Set for every axis that is flat.
  unsigned closed_far = 0;

  /// A box of finite doubles, lo <= hi. (An octant: closed_box.)
  slabs(const box& b, unsigned closed_far_ = 0) : closed_far(closed_far_) {
    for (unsigned a = 0; a < 3; ++a) {
      lower[a] = {b.lo[a]};
      upper[a] = {b.hi[a]};
      if (rounding::exact::equal(b.lo[a], b.hi[a]))
        closed_far |= 1u << a;
    }
  }
  slabs() = default;
};

} // namespace graze::octree
