#pragma once
/// A library that bench/peers drives already, asked by graze-fuzz: built from the block of each
/// request anew.
#include "../../bench/peers/peers.hpp"
#include "adapter.hpp"

namespace adapter {

template <class Library> void ask_peer(const request& r, answer& a) {
  std::array<int, 3> first{};
  const auto root = graze::octree::root_cube::make({r.lo, r.size}, r.level);
  const auto ray = graze::octree::ray::make(r.origin, scaled(r.direction));
  if (!r.in_cells(first) || !root || !ray)
    return a.skip();
  graze::bench::voxel_grid grid{*root, {}};
  for (const index3& v : r.voxels())
    grid.voxels.push_back({static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                           static_cast<std::uint32_t>(v[2])});
  graze::bench::peer<Library> library(grid);
  const auto received = library.received(*ray);
  if (!received)
    return a.skip();
  a.received(received->origin(), received->direction());
  std::vector<graze::bench::voxel_key> found;
  library.occupied(*ray, found);
  for (const graze::bench::voxel_key key : found) {
    const graze::bench::voxel_index v = graze::bench::index_of(key);
    a.visit({v[0], v[1], v[2]});
  }
}

} // namespace adapter
