#pragma once
/// The traversals that graze-voxel-peers times: this library's, those of papers, and libraries'.
#include "peers/voxel_grid.hpp"
#include <functional>
#include <graze/octree/ray.hpp>
#include <span>
#include <string>
#include <vector>

namespace graze::bench {

/// The occupied voxels of rays, ray after ray.
struct reported {
  std::vector<voxel_key> voxels;
  std::vector<std::uint32_t> counts; ///< one a ray
  void clear() {
    voxels.clear();
    counts.clear();
  }
};

struct contestant {
  std::string name;
  std::string kind; ///< graze, paper, published (a traversal written here from its paper), library
  std::string traversal; ///< what graze-fuzz calls it
  std::string path;      ///< of ours by lanes: GRAZE_BATCH_PATH
  double build_seconds = 0;
  /// Appends what it reports. One indirect call a block of rays. Single-threaded.
  std::function<void(std::span<const octree::ray>, reported&)> trace;
};

/// All that there are, built on these voxels, those whose name, traversal or path has `only` in it
/// (all, if empty). `grid` must outlive them.
std::vector<contestant> contestants(const voxel_grid& grid, const std::string& only);

/// Of the thread: what else runs on the machine counts little.
double cpu_seconds();

} // namespace graze::bench
