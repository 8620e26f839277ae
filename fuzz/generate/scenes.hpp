#pragma once
/// What the rays of a generator are led through, beside octants: grids with planes of any kind, boxes;
/// and segments in place of rays.
#include <generate/generators.hpp>
#include <memory>

namespace graze::fuzz {

/// Which cells a campaign's trials have.
struct scene_choice {
  cell_kind cells = cell_kind::cube;
  bool segments = false;                   ///< else rays
  std::shared_ptr<const grid_planes> grid; ///< of all trials; none: random ones
  std::shared_ptr<const voxel_map>
      map{}; ///< of all trials, with `grid` its grid; none: all occupied

  friend bool operator==(const scene_choice&, const scene_choice&) = default;
};

/// A grid as people have them, and harder: each plane rule; spacings like 0.1, 1/3, 25.2165 and 1e-7, powers
/// of two; counts from 1 to 2^20 that are no powers of two; flat axes; origins at 0, -10, 1e6, about the
/// middle. Passes judgeable().
grid_planes random_grid(random_stream& random);

/// A list of 1 to 64 boxes: stacked, so that they share faces and edges, within each other, tiny ones
/// beside huge ones, flat ones, and apart.
std::vector<octree::box> random_boxes(random_stream& random);

/// Turns the ray into a segment: to a vertex of the cells, to a plane, an ulp short of it or past it, to
/// a point about the cells, of a few ulps, far beyond them, or the other way round.
void cut(random_stream& random, trial& t);

/// Leads a ray of the generator to an occupied voxel of the trial's map: its vertices, edges and faces, and
/// the voxels around it.
void lead_through_map(const generator& g, random_stream& random, trial& t);

/// Trial `index` of `seed`, as make_trial of generators.hpp, whose octants it has where the choice is cubes.
/// Trials of 64 numbers in a row share a random grid, those of 8 a list of boxes. `tame`: as tamed()
/// (generate/tame.hpp) makes it.
trial make_trial(const generator& g, std::uint64_t seed, std::uint64_t index, int level,
                 const scene_choice& scene, bool tame = false);

} // namespace graze::fuzz
