/// Grids of NanoVDB, written to the folder named.
#include "written_map.hpp"
#include <cmath>
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

namespace {

void write(const std::string& path, double size, const nanovdb::Vec3d& origin, bool centred) {
  nanovdb::GridBuilder<float> builder(0.0f);
  written_map map;
  map.path = path;
  map.options = centred ? "--cell-centred" : "";
  auto fill = builder.getAccessor();
  const auto occupy = [&](int x, int y, int z) {
    fill.setValue(nanovdb::Coord(x, y, z), 1.0f);
    map.voxels.insert({x, y, z});
  };
  for (int k = -60; k <= 60; ++k)
    occupy(k, -k, 3);
  for (int x = 64; x < 80; ++x) // two nodes of 8 an axis, all of one value: tiles
    for (int y = -64; y < -48; ++y)
      for (int z = 128; z < 144; ++z)
        occupy(x, y, z);
  builder.sdfToLevelSet();
  auto handle = builder.getHandle<>(size, origin, "density");
  nanovdb::io::writeGrid(path, handle);
  const nanovdb::Map transform = handle.grid<float>()->map();
  const auto on = [](unsigned axis, double x) {
    nanovdb::Vec3d v(0);
    v[static_cast<int>(axis)] = x;
    return v;
  };
  const double shift = centred ? 0.5 : 0;
  map.plane = [=](unsigned a, long i) {
    return transform.applyMap(on(a, static_cast<double>(i) - shift))[static_cast<int>(a)];
  };
  map.index = [=](unsigned a, double x) {
    return static_cast<long>(
        std::floor(transform.applyInverseMap(on(a, x))[static_cast<int>(a)] + shift));
  };
  map.write();
}

} // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  for (const double size : {0.1, 0.3, 0.7}) {
    const std::string name = folder + "/nanovdb-" + std::to_string(size).substr(0, 3);
    write(name + "-node.nvdb", size, nanovdb::Vec3d(0), false);
    write(name + "-cell.nvdb", size, nanovdb::Vec3d(0), true);
  }
  write(folder + "/nanovdb-moved.nvdb", 0.3, nanovdb::Vec3d(0.1, -7.7, 1.0 / 3), false);
}
