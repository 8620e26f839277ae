#pragma once
/// What the lanes of a path say, for the test to compare. Implemented by a file for each path.
#include <array>
#include <cstdint>
#include <graze/batch/per_path.hpp>
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

struct path_under_test {
  trail (*closed)(const octree::ray&, const way&);
  trail (*owned)(const octree::ray&, const way&);
};
GRAZE_DECLARE_ON_PATHS(path_under_test, walks);

} // namespace graze::test
