// Our baseline `gargantini` through the sparse octree.
#include "peer.hpp"
#include <graze/octree/gargantini.hpp>

namespace graze::bench::shell {

peer gargantini_peer(const scene& s) {
  return {"gargantini", [&s](std::size_t first, std::size_t last, findings& out) {
            for (std::size_t i = first; i < last; ++i) {
              const std::size_t before = out.voxels.size();
              const octree::gargantini method(s.rays[i]);
              octree::descend(method, s.tree.box(), s.tree.level(), s.tree,
                              [&](const octree::cube& c, std::uint32_t, const auto&) {
                                out.voxels.push_back(packed(s.root, c));
                                return false;
                              });
              out.counts.push_back(static_cast<std::uint32_t>(out.voxels.size() - before));
            }
          }};
}

} // namespace graze::bench::shell
