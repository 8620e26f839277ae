// The traversals of bench/peers (PCL, CGAL, OctoMap, OpenVDB, Revelles) in
// shell_bench's scene.
#include "../peers/peers.hpp"
#include "peer.hpp"

namespace graze::bench::shell {

std::vector<peer> library_peers(const scene& s) {
  voxel_grid grid{s.root, {}};
  const auto collect = [&](auto&& self, std::uint32_t node, const octree::cube& c,
                           int level) -> void {
    if (level == s.tree.level()) {
      grid.voxels.push_back(index_of(packed(s.root, c)));
      return;
    }
    for (unsigned i = 0; i < 8; ++i)
      if ((s.tree.child_mask(node, c, 0xff) >> i & 1) != 0)
        self(self, s.tree.child(node, i), c.child(i), level + 1);
  };
  collect(collect, s.tree.root(), s.tree.box(), 0);
  std::vector<peer> all;
  for_each_peer([&]<class Library>() {
    const auto library = std::make_shared<bench::peer<Library>>(grid);
    all.push_back({std::string(bench::peer<Library>::name) + " (bench/peers)",
                   [library, &s](std::size_t first, std::size_t last, findings& out) {
                     for (std::size_t i = first; i < last; ++i) {
                       const std::size_t before = out.voxels.size();
                       library->occupied(s.rays[i], out.voxels);
                       out.counts.push_back(static_cast<std::uint32_t>(out.voxels.size() - before));
                     }
                   }});
  });
  return all;
}

} // namespace graze::bench::shell
