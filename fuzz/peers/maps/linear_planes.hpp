#pragma once
/// Planes and indices of a grid whose library has an affine map between indices and coordinates.
#include <algorithm>
#include <cmath>
#include <peers/maps/voxel_map.hpp>

namespace graze::peers {

/// to_world and to_index are the library's own, of points as vec3. Refuses what is not a positive
/// scaling and a translation on each axis. With `cell_centred`, voxel i is from i - 1/2 to i + 1/2.
template <class ToWorld, class ToIndex>
void set_linear_planes(voxel_map& map, const index_bounds& bounds, bool cell_centred,
                       const vec3& spacing, const ToWorld& to_world, const ToIndex& to_index) {
  const vec3 zero = to_world(vec3{0, 0, 0});
  for (unsigned a = 0; a < 3; ++a) {
    vec3 unit{};
    unit[a] = 1;
    const vec3 there = to_world(unit);
    for (unsigned b = 0; b < 3; ++b)
      if (a != b && there[b] != zero[b])
        throw map_refused("its transform is rotated or sheared: resample it along the axes");
    map.spacing[a] = spacing[a];
    if (!(there[a] > zero[a]))
      throw map_refused("its transform mirrors an axis or is singular: resample it");
  }
  const double centre = cell_centred ? 0.5 : 0;
  for (unsigned a = 0; a < 3; ++a) {
    const index_range range = range_of(bounds.lo[a], bounds.hi[a]);
    map.first[a] = range.first;
    for (std::uint32_t k = 0; k <= range.count; ++k) {
      vec3 at{};
      at[a] = static_cast<double>(range.first + k) - centre;
      map.planes[a].push_back(to_world(at)[a]);
    }
  }
  map.index = [first = map.first, centre, to_index](unsigned axis, double x) {
    vec3 at{};
    at[axis] = x;
    const double i = std::floor(to_index(at)[axis] + centre) - static_cast<double>(first[axis]);
    return static_cast<std::int64_t>(std::clamp(i, -0x1p40, 0x1p40));
  };
  map.names = "Coord";
}

/// The box of library indices, both ends included, as voxels of the map.
inline void add_box(voxel_map& map, const std::array<std::int64_t, 3>& lo,
                    const std::array<std::int64_t, 3>& hi) {
  octant_index from{}, to{};
  for (unsigned a = 0; a < 3; ++a) {
    from[a] = static_cast<std::uint32_t>(lo[a] - map.first[a]);
    to[a] = static_cast<std::uint32_t>(hi[a] - map.first[a] + 1);
  }
  map.add(from, to);
}

} // namespace graze::peers
