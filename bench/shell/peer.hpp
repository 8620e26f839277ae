#pragma once
/// The scene of shell_bench, and what each traversal in it gives.
#include <array>
#include <cstdint>
#include <functional>
#include <graze/octree/ray.hpp>
#include <graze/octree/sparse_octree.hpp>
#include <graze/octree/voxel_set.hpp>
#include <string>
#include <vector>

namespace graze::bench::shell {

struct scene {
  octree::root_cube root;
  octree::sparse_octree tree;
  octree::voxel_set set;
  std::vector<octree::ray> rays;
};

/// What a traversal found on the rays [first, first + n): x + 2^21 y + 2^42 z of each voxel, ray
/// after ray.
struct findings {
  std::vector<std::uint64_t> voxels;
  std::vector<std::uint32_t> counts;
  void clear() {
    voxels.clear();
    counts.clear();
  }
};

struct peer {
  std::string name;
  /// Traces rays [first, last), all occupied voxels on each. Single-threaded.
  std::function<void(std::size_t first, std::size_t last, findings&)> trace;
};

inline std::uint64_t packed(const octree::root_cube& root, const octree::cube& c) {
  std::uint64_t r = 0;
  for (int a = 0; a < 3; ++a)
    r |= static_cast<std::uint64_t>((c.lo[a] - root.box().lo[a]) / c.size) << (21 * a);
  return r;
}

peer gargantini_peer(const scene&);
peer embree_peer(const scene&);
/// The libraries of bench/peers that were found; some take minutes for 10^6 rays.
std::vector<peer> library_peers(const scene&);

} // namespace graze::bench::shell
