/// NanoVDB's files: the first grid of an .nvdb, its active voxels, those of tiles one by one. Planes are where
/// the grid's own map puts indices, indices its Coord by its own inverse, which is not OpenVDB's.
///
/// In version 32.4 the iterators' getOrigin() of the root has no return, and that of inner nodes does not
/// compile: tiles are asked for their places through the nodes.
#include <iostream> // for GridValidator.h
#include <nanovdb/util/GridValidator.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/IO.h>
#include <nanovdb/util/Ray.h>
#include <peers/maps/linear_planes.hpp>
#include <peers/nanovdb_walk.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

using ::nanovdb::Coord;
using corner = std::array<std::int64_t, 3>;

/// A box of `side` voxels an axis from `at` on.
template <class Box> void call(const Box& box, const Coord& at, std::int64_t side) {
  const corner lo{at[0], at[1], at[2]};
  box(lo, corner{lo[0] + side - 1, lo[1] + side - 1, lo[2] + side - 1});
}

/// Calls box(lo, hi), both ends included, for the active tiles of a node and the active voxels below.
template <class Node, class Box> void each_active(const Node& node, const Box& box) {
  if constexpr (Node::LEVEL == 0) {
    for (auto value = node.beginValueOn(); value; ++value)
      call(box, value.getCoord(), 1);
  } else {
    constexpr std::int64_t side = Node::ChildNodeType::DIM;
    for (auto value = node.beginValueOn(); value; ++value)
      if (!node.data()->mChildMask.isOn(value.pos()))
        call(box, node.offsetToGlobalCoord(value.pos()), side);
    for (auto child = node.beginChild(); child; ++child)
      each_active(*child, box);
  }
}
template <class Value, class Box>
void each_active_voxel(const ::nanovdb::NanoGrid<Value>& grid, const Box& box) {
  const auto& root = grid.tree().root();
  for (auto value = root.beginValueOn(); value; ++value)
    call(box, root.data()->tile(value.pos())->origin(), std::int64_t{1} << 12);
  for (auto child = root.beginChild(); child; ++child)
    each_active(*child, box);
}

template <class Value>
void read_grid(voxel_map& map, const ::nanovdb::NanoGrid<Value>* grid, const map_options& options) {
  if (grid == nullptr || !::nanovdb::isValid(*grid, true))
    throw map_refused("NanoVDB's own test finds the grid invalid");
  index_bounds bounds;
  each_active_voxel<Value>(*grid, [&](const corner& lo, const corner& hi) { bounds.add(lo, hi); });
  if (bounds.empty())
    throw map_refused("no voxel is active");
  const ::nanovdb::Map transform = grid->map();
  const auto plain = [](const ::nanovdb::Vec3d& v) { return vec3{v[0], v[1], v[2]}; };
  set_linear_planes(
      map, bounds, options.cell_centred, plain(grid->voxelSize()),
      [&](const vec3& i) { return plain(transform.applyMap(::nanovdb::Vec3d(i[0], i[1], i[2]))); },
      [=](const vec3& x) {
        return plain(transform.applyInverseMap(::nanovdb::Vec3d(x[0], x[1], x[2])));
      });
  each_active_voxel<Value>(*grid,
                           [&](const corner& lo, const corner& hi) { add_box(map, lo, hi); });
}

using index_ray = ::nanovdb::Ray<float>;

/// The grid of a file, of floats. Rays are in float, normalised as its own examples do, and come to its indices by
/// the grid's own transform.
class grid_of_map : public structure {
public:
  grid_of_map(const std::string& path, const map_options& options, const voxel_map& map)
      : handle_(::nanovdb::io::readGrid(path, 0)), grid_(handle_.grid<float>()), first_(map.first) {
    if (grid_ == nullptr)
      throw map_refused("rays are asked through grids of float only");
    if (options.cell_centred)
      throw map_refused("its rays take an index for a voxel's lowest corner: without "
                        "--cell-centred");
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    const vec3& d = r.direction();
    const double length = std::hypot(d[0], d[1], d[2]);
    return ray_if_any(to_float(r.origin()),
                      to_float(vec3{d[0] / length, d[1] / length, d[2] / length}));
  }

protected:
  [[nodiscard]] index_ray ray_of(const octree::ray& given) const {
    const auto r = received(given);
    const auto vector = [](const vec3& v) {
      return ::nanovdb::Vec3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                              static_cast<float>(v[2]));
    };
    return index_ray(vector(r->origin()), vector(r->direction()), 0.0f).worldToIndexF(*grid_);
  }
  [[nodiscard]] octant_key key(const Coord& at) const {
    octant_index v{};
    for (unsigned a = 0; a < 3; ++a)
      v[a] = static_cast<std::uint32_t>(at[static_cast<int>(a)] - first_[a]);
    return key_of(v);
  }

  ::nanovdb::GridHandle<> handle_;
  const ::nanovdb::FloatGrid* grid_;
  std::array<std::int64_t, 3> first_;
};

class first_active_of_map final : public grid_of_map {
public:
  using grid_of_map::grid_of_map;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    index_ray ray = ray_of(r); // it is clipped
    auto read = grid_->getAccessor();
    Coord at;
    float t = 0;
    if (::nanovdb::firstActive(ray, read, at, t))
      found.push_back(key(at));
  }
};

class hdda_of_map final : public grid_of_map {
public:
  using grid_of_map::grid_of_map;

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    walk_by_hdda(*grid_, ray_of(r), [&](const Coord& at) {
      if (found.empty() || found.back() != key(at))
        found.push_back(key(at));
    });
  }
};

template <class Structure>
std::unique_ptr<structure> built_from(const std::string& path, const map_options& options,
                                      const voxel_map& map) {
  return std::make_unique<Structure>(path, options, map);
}

voxel_map read(const std::string& path, const map_options& options) {
  const auto handle = ::nanovdb::io::readGrid(path, 0);
  const ::nanovdb::GridMetaData* about = handle.gridMetaData();
  if (about == nullptr || !about->isValid())
    throw map_refused("it holds no grid that NanoVDB reads");
  voxel_map map;
  map.library = "NanoVDB " + std::to_string(NANOVDB_MAJOR_VERSION_NUMBER) + "." +
                std::to_string(NANOVDB_MINOR_VERSION_NUMBER) + "." +
                std::to_string(NANOVDB_PATCH_VERSION_NUMBER);
  map.rule = std::string("the first grid; active voxels, tiles expanded; ") +
             (options.cell_centred
                  ? "planes: applyMap(i - 1/2); indices: floor(applyInverseMap(x) + 1/2)"
                  : "planes: applyMap(i); indices: floor(applyInverseMap(x)) (as its rays walk; "
                    "--cell-centred takes i for a voxel's centre)") +
             ", in double";
  using type = ::nanovdb::GridType;
  switch (about->gridType()) {
  case type::Float:
    read_grid<float>(map, handle.grid<float>(), options);
    break;
  case type::Double:
    read_grid<double>(map, handle.grid<double>(), options);
    break;
  case type::Int16:
    read_grid<std::int16_t>(map, handle.grid<std::int16_t>(), options);
    break;
  case type::Int32:
    read_grid<std::int32_t>(map, handle.grid<std::int32_t>(), options);
    break;
  case type::Int64:
    read_grid<std::int64_t>(map, handle.grid<std::int64_t>(), options);
    break;
  case type::UInt32:
    read_grid<std::uint32_t>(map, handle.grid<std::uint32_t>(), options);
    break;
  case type::Vec3f:
    read_grid<::nanovdb::Vec3f>(map, handle.grid<::nanovdb::Vec3f>(), options);
    break;
  case type::Vec3d:
    read_grid<::nanovdb::Vec3d>(map, handle.grid<::nanovdb::Vec3d>(), options);
    break;
  case type::Mask:
    read_grid<::nanovdb::ValueMask>(map, handle.grid<::nanovdb::ValueMask>(), options);
    break;
  case type::Boolean:
    read_grid<bool>(map, handle.grid<bool>(), options);
    break;
  case type::Fp4:
    read_grid<::nanovdb::Fp4>(map, handle.grid<::nanovdb::Fp4>(), options);
    break;
  case type::Fp8:
    read_grid<::nanovdb::Fp8>(map, handle.grid<::nanovdb::Fp8>(), options);
    break;
  case type::Fp16:
    read_grid<::nanovdb::Fp16>(map, handle.grid<::nanovdb::Fp16>(), options);
    break;
  case type::FpN:
    read_grid<::nanovdb::FpN>(map, handle.grid<::nanovdb::FpN>(), options);
    break;
  default:
    throw map_refused(std::string("a grid of type ") + ::nanovdb::toStr(about->gridType()) +
                      " is not read");
  }
  return map;
}

} // namespace

map_library nanovdb_map() {
  return {read,
          {{"nanovdb-first-active", "first", "NanoVDB, firstActive through the map (float)",
            built_from<first_active_of_map>},
           {"nanovdb-hdda", "crossed", "NanoVDB, HDDA as in ZeroCrossing through the map (float)",
            built_from<hdda_of_map>}}};
}

} // namespace graze::peers
