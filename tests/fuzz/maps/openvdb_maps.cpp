/// Grids of OpenVDB, written to the folder named.
#include "written_map.hpp"
#include <openvdb/openvdb.h>

namespace {

/// Active voxels along a diagonal, and a box that is tiles.
void write(const std::string& path, const openvdb::math::Transform::Ptr& transform, bool centred) {
  auto grid = openvdb::FloatGrid::create(0.0f);
  grid->setName("density");
  grid->setTransform(transform);
  written_map map;
  map.path = path;
  map.options = centred ? "--cell-centred" : "";
  auto fill = grid->getAccessor();
  for (int k = -60; k <= 60; ++k) {
    fill.setValue(openvdb::Coord(k, -k, 3), 1.0f);
    map.voxels.insert({k, -k, 3});
  }
  const openvdb::CoordBBox box(openvdb::Coord(64, -64, 128), openvdb::Coord(79, -49, 143));
  grid->sparseFill(box, 1.0f);
  for (const openvdb::Coord& at : box)
    map.voxels.insert({at[0], at[1], at[2]});
  const auto on = [](unsigned axis, double x) {
    openvdb::Vec3d v(0);
    v[static_cast<int>(axis)] = x;
    return v;
  };
  const double shift = centred ? 0.5 : 0;
  map.plane = [=](unsigned a, long i) {
    return transform->indexToWorld(on(a, static_cast<double>(i) - shift))[static_cast<int>(a)];
  };
  map.index = [=](unsigned a, double x) -> long {
    const openvdb::Coord at = centred ? transform->worldToIndexCellCentered(on(a, x))
                                      : transform->worldToIndexNodeCentered(on(a, x));
    return at[static_cast<int>(a)];
  };
  openvdb::io::File(path).write({grid});
  map.write();
}

} // namespace

int main(int, char** argv) {
  openvdb::initialize();
  const std::string folder = argv[1];
  for (const double size : {0.1, 0.3, 0.7}) {
    const std::string name = folder + "/openvdb-" + std::to_string(size).substr(0, 3);
    write(name + "-node.vdb", openvdb::math::Transform::createLinearTransform(size), false);
    write(name + "-cell.vdb", openvdb::math::Transform::createLinearTransform(size), true);
  }
  const auto moved = openvdb::math::Transform::createLinearTransform(0.3);
  moved->postTranslate(openvdb::Vec3d(0.1, -7.7, 1.0 / 3));
  write(folder + "/openvdb-moved.vdb", moved, false);
  const auto uneven = openvdb::math::Transform::createLinearTransform();
  uneven->preScale(openvdb::Vec3d(25.2165, 27.9808, 0.6051));
  write(folder + "/openvdb-uneven.vdb", uneven, false);
  const auto turned = openvdb::math::Transform::createLinearTransform(0.3);
  turned->preRotate(0.5);
  write(folder + "/refused-turned.vdb", turned, false);
}
