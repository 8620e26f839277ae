#include <algorithm>
#include <bit>
#include <cmath>
#include <generate/scenes.hpp>
#include <generate/site.hpp>

namespace graze::fuzz {

namespace {

/// What generators take for the root: about where the voxels are.
void set_frame(trial& t) {
  const voxel_index &lo = t.map->lowest(), &hi = t.map->highest();
  double size = 0;
  std::uint32_t count = 1;
  for (unsigned a = 0; a < 3; ++a) {
    t.root.lo[a] = nearest_plane(*t.grid, a, lo[a]);
    size = std::max(size, nearest_plane(*t.grid, a, hi[a] + 1) - t.root.lo[a]);
    count = std::max(count, hi[a] - lo[a] + 1);
  }
  t.root.size = std::ldexp(1.0, std::clamp(std::ilogb(size) + 1, -1000, 1000));
  t.level = std::max(1, static_cast<int>(std::bit_width(count - 1)));
}

/// From a point about the occupied voxels to a point of one: for generators that come by none.
void aim_at_voxel(random_stream& random, trial& t) {
  const voxel_index v = t.map->voxel(random.bits() % t.map->size());
  const auto fraction = [&] { return static_cast<double>(random.bits(53)) * 0x1p-53; };
  for (unsigned a = 0; a < 3; ++a) {
    const double lo = nearest_plane(*t.grid, a, v[a]), hi = nearest_plane(*t.grid, a, v[a] + 1);
    t.origin[a] = t.root.lo[a] + (3 * fraction() - 1) * t.root.size;
    t.direction[a] = lo + fraction() * (hi - lo) - t.origin[a];
  }
  if (t.direction == vec3{})
    t.direction[random.below(3)] = 1;
  occupy(random, t,
         site_at(t, {v[0] + random.below(2), v[1] + random.below(2), v[2] + random.below(2)}));
}

} // namespace

void lead_through_map(const generator& g, random_stream& random, trial& t) {
  const trial empty = t;
  trial framed = t;
  set_frame(framed);
  t = framed;
  g.make(random, t);
  t.root = empty.root;
  t.level = empty.level;
  if (judgeable(t))
    return;
  // the ray stays, if it is one, and comes by no occupied voxel: such are of no use
  t = framed;
  aim_at_voxel(random, t);
  t.root = empty.root;
  t.level = empty.level;
}

} // namespace graze::fuzz
