#pragma once
/// The traversals that graze-voxel-peers times: this library's, those of papers, and libraries'.
#include <functional>
#include <graze/octree/ray.hpp>
#include <peers/occupied_octants.hpp>
#include <span>
#include <string>
#include <vector>

namespace graze::bench {

using peers::occupied_octants;
using peers::octant_key;

/// The occupied octants of rays, ray after ray.
struct reported {
  std::vector<octant_key> octants;
  std::vector<std::uint32_t> counts; ///< one a ray
  void clear() {
    octants.clear();
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

/// All that there are, built on these octants, those whose name, traversal or path has `only` in it
/// (all, if empty). `octants` must outlive them.
std::vector<contestant> contestants(const occupied_octants& octants, const std::string& only);

/// Of the thread: what else runs on the machine counts little.
double cpu_seconds();

} // namespace graze::bench
