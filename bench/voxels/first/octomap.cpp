// OctoMap: castRay, unknown cells taken for free ones.
#include "first_hits.hpp"
#include <octomap/octomap.h>

namespace graze::bench {

std::vector<first_hit_contestant> octomap_first_hits(const occupied_octants& octants) {
  const auto cells = peers::unit_cells::make(octants);
  if (!cells)
    return {};
  constexpr int centre = 32768;
  const auto tree = std::make_shared<::octomap::OcTree>(cells->edge);
  for (const peers::octant_index& at : octants.indices) {
    const std::array<int, 3> cell = cells->cell(at);
    ::octomap::OcTreeKey key;
    for (unsigned a = 0; a < 3; ++a)
      key[a] = static_cast<::octomap::key_type>(cell[a] + centre);
    tree->updateNode(key, true, true);
  }
  tree->updateInnerOccupancy();
  return {{"OctoMap castRay", "library",
           one_by_one([tree, cells = *cells, root = octants.root](const octree::ray& r) {
             const auto point = [](const octree::vec3& v) {
               return ::octomap::point3d(static_cast<float>(v[0]), static_cast<float>(v[1]),
                                         static_cast<float>(v[2]));
             };
             double range = 0;
             for (unsigned a = 0; a < 3; ++a)
               range += std::fabs(r.origin()[a]) + std::fabs(root.lo[a]) + root.size;
             ::octomap::point3d hit;
             if (!tree->castRay(point(r.origin()), point(r.direction()), hit, true, range))
               return no_octant;
             const ::octomap::OcTreeKey key = tree->coordToKey(hit);
             return cells.key(key[0] - centre, key[1] - centre, key[2] - centre);
           })}};
}

} // namespace graze::bench
