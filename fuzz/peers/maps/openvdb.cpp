/// OpenVDB's files: the first grid of a .vdb, its active voxels, those of tiles one by one. Planes are
/// where the grid's own transform puts indices, and indices its Coord.
#include <openvdb/io/File.h>
#include <openvdb/math/DDA.h>
#include <openvdb/math/Ray.h>
#include <openvdb/openvdb.h>
#include <openvdb/tree/ValueAccessor.h>
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

::openvdb::GridPtrVecPtr read_grids(const std::string& path) {
  ::openvdb::initialize();
  ::openvdb::io::File file(path);
  file.open(false);
  ::openvdb::GridPtrVecPtr grids = file.getGrids();
  if (!grids || grids->empty())
    throw map_refused("it holds no grid");
  return grids;
}

using masks = ::openvdb::MaskTree;
using accessor = ::openvdb::tree::ValueAccessor<const masks>;
using index_ray = ::openvdb::math::Ray<double>;

/// The grid of a file. Rays come to its indices by the grid's own transform, as its users have it.
class grid_of_map : public structure {
public:
  grid_of_map(const std::string& path, const map_options& options, const voxel_map& map)
      : first_(map.first) {
    const ::openvdb::GridBase::ConstPtr base = read_grids(path)->front();
    base->apply<::openvdb::GridTypes>([&](const auto& grid) {
      tree_ = std::make_unique<masks>(grid.tree(), false, true, ::openvdb::TopologyCopy());
    });
    tree_->voxelizeActiveTiles(); // rays are asked for voxels
    transform_ = base->transform().copy();
    if (options.cell_centred) // its rays take index i for the lowest corner
      transform_->preTranslate(::openvdb::Vec3d(-0.5));
    read_ = std::make_unique<accessor>(*tree_);
    box_ = ::openvdb::CoordBBox::inf();
    tree_->evalActiveVoxelBoundingBox(box_);
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return r; // what rounds it to indices is the library's
  }

protected:
  /// Among indices; false where it passes by all active voxels.
  [[nodiscard]] bool clipped(const octree::ray& r, index_ray& ray) const {
    const vec3 &o = r.origin(), &d = r.direction();
    const index_ray in_world(::openvdb::Vec3d(o[0], o[1], o[2]), ::openvdb::Vec3d(d[0], d[1], d[2]),
                             0.0);
    ray = in_world.applyInverseMap(*transform_->baseMap());
    return ray.clip(::openvdb::BBoxd(box_.min().asVec3d(), (box_.max().offsetBy(1)).asVec3d()));
  }
  [[nodiscard]] octant_key key(const ::openvdb::Coord& at) const {
    octant_index v{};
    for (unsigned a = 0; a < 3; ++a)
      v[a] = static_cast<std::uint32_t>(at[static_cast<int>(a)] - first_[a]);
    return key_of(v);
  }

  std::unique_ptr<masks> tree_;
  std::unique_ptr<accessor> read_;
  std::array<std::int64_t, 3> first_;
  ::openvdb::math::Transform::Ptr transform_;
  ::openvdb::CoordBBox box_;
};

class dda_of_map final : public grid_of_map {
public:
  using grid_of_map::grid_of_map;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    index_ray ray;
    if (!clipped(r, ray))
      return;
    ::openvdb::math::DDA<index_ray> walk(ray);
    do {
      if (read_->isValueOn(walk.voxel()))
        found.push_back(key(walk.voxel()));
    } while (walk.step());
  }
};

class hdda_of_map final : public grid_of_map {
public:
  using grid_of_map::grid_of_map;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    tester t{{}, *this, found};
    if (clipped(r, t.part))
      ::openvdb::math::LevelSetHDDA<masks, static_cast<int>(
                                               masks::RootNodeType::ChildNodeType::LEVEL)>::test(t);
  }

private:
  struct tester {
    using RayT = index_ray;

    index_ray part;
    const hdda_of_map& map;
    std::vector<octant_key>& found;

    [[nodiscard]] const index_ray& ray() const { return part; }
    void setRange(double from, double to) { part.setTimes(from, to); }
    void init(double) {}
    template <class Node> [[nodiscard]] bool hasNode(const ::openvdb::Coord& at) const {
      return map.read_->probeConstNode<Node>(at) != nullptr;
    }
    bool operator()(const ::openvdb::Coord& at, double) {
      if (map.read_->isValueOn(at))
        found.push_back(map.key(at));
      return false; // on to the next
    }
  };
};

template <class Structure>
std::unique_ptr<structure> built_from(const std::string& path, const map_options& options,
                                      const voxel_map& map) {
  return std::make_unique<Structure>(path, options, map);
}

voxel_map read(const std::string& path, const map_options& options) {
  const ::openvdb::GridPtrVecPtr grids = read_grids(path);
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

} // namespace

map_library openvdb_map() {
  return {read,
          {{"openvdb-dda", "crossed", "OpenVDB, DDA through the map", built_from<dda_of_map>},
           {"openvdb-level-set-hdda", "crossed", "OpenVDB, LevelSetHDDA through the map",
            built_from<hdda_of_map>}}};
}

} // namespace graze::peers
