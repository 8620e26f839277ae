#pragma once
/// First hits as each library's users ask for them: one call a ray, the nearest occupied octant or
/// none.
#include <functional>
#include <graze/octree/ray.hpp>
#include <memory>
#include <peers/occupied_octants.hpp>
#include <span>
#include <string>
#include <vector>

namespace graze::bench {

using peers::occupied_octants;
using peers::octant_key;

inline constexpr octant_key no_octant = ~octant_key{0};

struct first_hit_contestant {
  std::string name, kind; ///< kind: graze, library
  /// The octant that each ray hits first, or no_octant.
  std::function<void(std::span<const octree::ray>, octant_key*)> trace;
};

/// One ray after the other.
template <class Trace> auto one_by_one(Trace trace) {
  return [trace = std::move(trace)](std::span<const octree::ray> rays, octant_key* hits) {
    for (const octree::ray& r : rays)
      *hits++ = trace(r);
  };
}

// Each library's, where it was found; `octants` outlive them.
std::vector<first_hit_contestant> embree_first_hits(const occupied_octants& octants);
std::vector<first_hit_contestant> nanovdb_first_hits(const occupied_octants& octants);
std::vector<first_hit_contestant> octomap_first_hits(const occupied_octants& octants);
std::vector<first_hit_contestant> pcl_first_hits(const occupied_octants& octants);

} // namespace graze::bench
