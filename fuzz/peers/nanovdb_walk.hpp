#pragma once
/// NanoVDB's walk through a grid by its HDDA.
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>

namespace graze::peers {

/// The loop of ZeroCrossing() in HDDA.h: keep(at) of each active voxel that it comes to. `ray` in cells of
/// edge 1, of a unit direction: the steps forward (Delta) are lengths.
template <class Grid, class Ray, class Keep>
void walk_by_hdda(const Grid& grid, Ray ray, const Keep& keep) {
  using Coord = ::nanovdb::Coord;
  auto read = grid.getAccessor();
  if (!ray.clip(read.root().bbox()) || ray.t1() > 1e20f)
    return;
  const auto keep_active = [&](const Coord& at) {
    if (read.isActive(at))
      keep(at);
  };
  constexpr float forward = 1.0001f; // ZeroCrossing's Delta
  Coord at = ::nanovdb::RoundDown<Coord>(ray.start());
  keep_active(at);
  ::nanovdb::HDDA<Ray> walk(ray, static_cast<int>(read.getDim(at, ray)));
  while (walk.step()) {
    at = ::nanovdb::RoundDown<Coord>(ray(walk.time() + forward));
    walk.update(ray, static_cast<int>(read.getDim(at, ray)));
    if (walk.dim() > 1 || !read.isActive(at))
      continue;
    keep(at);
    while (walk.step() && read.isActive(walk.voxel()))
      keep(walk.voxel());
  }
}

} // namespace graze::peers
