#pragma once
/// What the lanes of a path say, for the test to compare. Implemented by a file for each path.
#include <array>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <graze/octree/ray.hpp>

namespace graze::test {

/// The children of each octant on a way down, in their order.
struct trail {
  bool entered = false;
  int steps = 0;
  /// For each octant opened: the indices of its children passed, in order, three bits each from
  /// the lowest up, and their number above.
  std::array<std::uint32_t, octree::max_level> children{};
  friend bool operator==(const trail&, const trail&) = default;
};

/// A way down: towards the octant `target` of `level` as long as the ray passes its ancestors, then
/// by the bits of `choices`.
struct way {
  octree::cube root;
  int level;
  std::array<std::uint64_t, 3> target;
  std::uint64_t choices;
};

/// Which children of an octant the surface is proven to have no zero in: bit i of `none`.
enum { surface_count = 5 };
struct inclusions {
  std::array<std::uint8_t, surface_count> none{}, positive{}, negative{};
  friend bool operator==(const inclusions&, const inclusions&) = default;
};

/// A surface whose natural extension is loose, so that the mean value form decides.
struct loose_surface {
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return x * x * y - y * z + z * z * z - x * y * z;
  }
};

struct path_under_test {
  trail (*closed)(const octree::ray&, const way&);
  trail (*owned)(const octree::ray&, const way&);
  inclusions (*inclusion)(const octree::cube&);
};
extern const path_under_test baseline_walks, avx2_walks, avx512_walks;

} // namespace graze::test
