/// NanoVDB: the walks of its HDDA through a grid, in float and in cells of edge 1. Directions are
/// normalised, as its own examples do: the steps forward in HDDA.h (Delta) are lengths.
///
///   graze-adapter-nanovdb first-active|hdda
///
/// first-active: firstActive() again and again, each time without the voxels that it has found.
/// hdda: the loop of ZeroCrossing() in HDDA.h, which keeps each active voxel that it comes to.
#include "adapter.hpp"
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>
#include <string_view>

namespace {

using ray_in_cells = nanovdb::Ray<float>;
using nanovdb::Coord;

nanovdb::GridHandle<> grid_of(const std::vector<Coord>& cells) {
  nanovdb::GridBuilder<float> builder(0.0f);
  auto fill = builder.getAccessor();
  for (const Coord& cell : cells)
    fill.setValue(cell, 1.0f);
  return builder.getHandle<>();
}

std::vector<Coord> first_active(nanovdb::FloatGrid& grid, const ray_in_cells& ray) {
  std::vector<Coord> found;
  for (;;) {
    auto read = grid.getAccessor();
    ray_in_cells part = ray; // it is clipped
    Coord at;
    float t = 0;
    if (!nanovdb::firstActive(part, read, at, t))
      return found;
    found.push_back(at);
    auto* leaf = const_cast<nanovdb::NanoLeaf<float>*>(read.probeLeaf(at));
    leaf->data()->mValueMask.setOff(leaf->CoordToOffset(at));
  }
}

std::vector<Coord> hdda(const nanovdb::FloatGrid& grid, ray_in_cells ray) {
  std::vector<Coord> found;
  auto read = grid.getAccessor();
  if (!ray.clip(read.root().bbox()) || ray.t1() > 1e20f)
    return found;
  const auto keep = [&](const Coord& at) {
    if (read.isActive(at) && (found.empty() || found.back() != at))
      found.push_back(at);
  };
  constexpr float forward = 1.0001f; // ZeroCrossing's Delta
  Coord at = nanovdb::RoundDown<Coord>(ray.start());
  keep(at);
  nanovdb::HDDA<ray_in_cells> walk(ray, static_cast<int>(read.getDim(at, ray)));
  while (walk.step()) {
    at = nanovdb::RoundDown<Coord>(ray(walk.time() + forward));
    walk.update(ray, static_cast<int>(read.getDim(at, ray)));
    if (walk.dim() > 1 || !read.isActive(at))
      continue;
    keep(at);
    while (walk.step() && read.isActive(walk.voxel()))
      keep(walk.voxel());
  }
  return found;
}

void traverse(bool again_and_again, const adapter::request& r, adapter::answer& a) {
  std::array<int, 3> first{};
  if (!r.in_cells(first))
    return a.skip();
  const adapter::vec3 d = adapter::scaled(r.direction);
  const double length = std::hypot(d[0], d[1], d[2]);
  adapter::vec3 eye{}, from{}, unit{};
  for (unsigned k = 0; k < 3; ++k) {
    eye[k] = adapter::to_float(r.origin[k] / r.voxel_size());
    from[k] = eye[k] * r.voxel_size();
    unit[k] = adapter::to_float(d[k] / length);
  }
  if (!adapter::is_finite(eye))
    return a.skip();
  a.received(from, unit);

  std::vector<Coord> cells;
  for (const adapter::index3& v : r.voxels())
    cells.emplace_back(static_cast<int>(v[0]) + first[0], static_cast<int>(v[1]) + first[1],
                       static_cast<int>(v[2]) + first[2]);
  auto handle = grid_of(cells);
  nanovdb::FloatGrid& grid = *handle.grid<float>();
  const auto single = [](const adapter::vec3& v) {
    return nanovdb::Vec3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                          static_cast<float>(v[2]));
  };
  const ray_in_cells ray(single(eye), single(unit), 0.0f);
  for (const Coord& at : again_and_again ? first_active(grid, ray) : hdda(grid, ray)) {
    adapter::index3 voxel{};
    for (unsigned k = 0; k < 3; ++k)
      voxel[k] = static_cast<std::uint64_t>(at[static_cast<int>(k)] - first[k]);
    a.visit(voxel);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view variant = argc > 1 ? argv[1] : "";
  if (variant != "first-active" && variant != "hdda") {
    std::fprintf(stderr, "usage: graze-adapter-nanovdb first-active|hdda\n");
    return 2;
  }
  return adapter::serve("crossed", [&](const adapter::request& r, adapter::answer& a) {
    traverse(variant == "first-active", r, a);
  });
}
