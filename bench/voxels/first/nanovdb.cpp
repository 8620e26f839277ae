// NanoVDB: firstActive, as its users call it: in cells of edge 1, rays in float, normalised.
#include "first_hits.hpp"
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>

namespace graze::bench {

std::vector<first_hit_contestant> nanovdb_first_hits(const occupied_octants& octants) {
  const auto cells = peers::unit_cells::make(octants);
  if (!cells)
    return {};
  struct held {
    ::nanovdb::GridHandle<> handle;
    peers::unit_cells cells;
  };
  const auto scene = std::make_shared<held>(held{{}, *cells});
  ::nanovdb::GridBuilder<float> builder(0.0f);
  auto fill = builder.getAccessor();
  for (const peers::octant_index& at : octants.indices) {
    const std::array<int, 3> cell = cells->cell(at);
    fill.setValue(::nanovdb::Coord(cell[0], cell[1], cell[2]), 1.0f);
  }
  scene->handle = builder.getHandle<>();
  return {
      {"NanoVDB firstActive", "library",
       [scene](std::span<const octree::ray> rays, octant_key* hits) {
         auto read = scene->handle.grid<float>()->getAccessor();
         for (const octree::ray& r : rays) {
           const auto &o = r.origin(), &d = r.direction();
           const double length = std::hypot(d[0], d[1], d[2]), edge = scene->cells.edge;
           const auto vector = [](const octree::vec3& v, double by) {
             return ::nanovdb::Vec3f(static_cast<float>(v[0] / by), static_cast<float>(v[1] / by),
                                     static_cast<float>(v[2] / by));
           };
           ::nanovdb::Ray<float> ray(vector(o, edge), vector(d, length), 0.0f);
           ::nanovdb::Coord at;
           float t = 0;
           *hits++ = ::nanovdb::firstActive(ray, read, at, t) ? scene->cells.key(at) : no_octant;
         }
       }}};
}

} // namespace graze::bench
