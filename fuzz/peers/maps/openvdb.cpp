/// OpenVDB's files: the first grid of a .vdb, its active voxels, those of tiles one by one. Planes are
/// where the grid's own transform puts indices, and indices its Coord.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <peers/maps/linear_planes.hpp>

namespace graze::peers {
namespace {

using corner = std::array<std::int64_t, 3>;

/// Calls box(lo, hi), both ends included, for each active voxel and tile.
template <class Grid, class Box> void each_active(const Grid& grid, const Box& box) {
  for (auto value = grid.cbeginValueOn(); value; ++value) {
    const ::openvdb::CoordBBox b = value.getBoundingBox();
    box(corner{b.min()[0], b.min()[1], b.min()[2]}, corner{b.max()[0], b.max()[1], b.max()[2]});
  }
}

} // namespace

voxel_map openvdb_map(const std::string& path, const map_options& options) {
  ::openvdb::initialize();
  ::openvdb::io::File file(path);
  file.open(false);
  const ::openvdb::GridPtrVecPtr grids = file.getGrids();
  if (!grids || grids->empty())
    throw map_refused("it holds no grid");
  const ::openvdb::GridBase::ConstPtr base = grids->front();
  const ::openvdb::math::Transform transform = base->transform();
  if (!transform.isLinear())
    throw map_refused("its transform is no affine map: resample it along the axes");
  voxel_map map;
  map.library = std::string("OpenVDB ") + OPENVDB_LIBRARY_VERSION_STRING;
  map.rule =
      "grid '" + base->getName() + "', " +
      (grids->size() > 1 ? "the first of " + std::to_string(grids->size()) : "the only one") +
      "; active voxels, tiles expanded; " +
      (options.cell_centred
           ? "planes: indexToWorld(i - 1/2); indices: worldToIndexCellCentered"
           : "planes: indexToWorld(i); indices: worldToIndexNodeCentered (as its rays walk; "
             "--cell-centred takes i for a voxel's centre)");
  index_bounds bounds;
  const bool is_read = base->apply<::openvdb::GridTypes>([&](const auto& grid) {
    each_active(grid, [&](const corner& lo, const corner& hi) { bounds.add(lo, hi); });
  });
  if (!is_read)
    throw map_refused("a grid of type " + base->type() + " is none of voxels");
  if (bounds.empty())
    throw map_refused("no voxel is active");
  const auto plain = [](const ::openvdb::Vec3d& v) { return vec3{v[0], v[1], v[2]}; };
  set_linear_planes(
      map, bounds, options.cell_centred, plain(transform.voxelSize()),
      [&](const vec3& i) {
        return plain(transform.indexToWorld(::openvdb::Vec3d(i[0], i[1], i[2])));
      },
      [=](const vec3& x) {
        return plain(transform.worldToIndex(::openvdb::Vec3d(x[0], x[1], x[2])));
      });
  base->apply<::openvdb::GridTypes>([&](const auto& grid) {
    each_active(grid, [&](const corner& lo, const corner& hi) { add_box(map, lo, hi); });
  });
  return map;
}

} // namespace graze::peers
