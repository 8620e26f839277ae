#pragma once
/// Rays of the campaign's generators with a block of voxels around what they graze, and what exact
/// arithmetic says about them.
#include "../../support/paths.hpp"
#include <generate/generators.hpp>
#include <graze/batch.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <judge/judge.hpp>
#include <traversal/block_tree.hpp>
#include <vector>

namespace graze::interface_tests {

using namespace graze::octree;

/// A trial of which only some of the block's voxels are occupied, as a set.
struct sparse_trial {
  fuzz::trial trial;
  fuzz::octant_set occupied;
  ray the_ray;
  root_cube root;
  voxel_set set;

  /// The number of a voxel in the block; none for one outside.
  [[nodiscard]] fuzz::octant_number number_of(const voxel& v) const {
    std::array<unsigned, 3> at{};
    for (int a = 0; a < 3; ++a)
      at[a] = static_cast<unsigned>(v.index(a) - trial.base[a]);
    return fuzz::octant_at(at[0], at[1], at[2]);
  }
};

inline const std::vector<cube>& roots() {
  static const std::vector<cube> all{{{0, 0, 0}, 1},
                                     {{-2, -2, -2}, 4},
                                     {{0, 0, 0}, 3},
                                     {{0, 0, 0}, 0x1p-1000},
                                     {{-0x1p900, 0, 0}, 0x1p901}};
  return all;
}

inline sparse_trial make_sparse(const fuzz::generator& g, std::uint64_t seed, std::uint64_t index) {
  fuzz::random_stream random(seed ^ 0x5eed, index);
  const int level = random.between(1, random.one_in(3) ? 20 : 9);
  const cube box = roots()[random.one_in(4) ? random.below(5) : 0];
  fuzz::trial t = fuzz::make_trial(g, seed, index, level, box);
  const fuzz::octant_set occupied = random.one_in(3) ? t.all() & random.bits() : t.all();
  std::vector<std::array<std::uint32_t, 3>> voxels;
  for (unsigned v = 0; v < 64; ++v)
    if ((occupied >> v & 1) != 0)
      voxels.push_back({static_cast<std::uint32_t>(t.base[0] + (v & 3)),
                        static_cast<std::uint32_t>(t.base[1] + (v >> 2 & 3)),
                        static_cast<std::uint32_t>(t.base[2] + (v >> 4))});
  const root_cube root = *root_cube::make(box, level);
  return {t, occupied, *ray::make(t.origin, t.direction), root, *voxel_set::make(root, voxels)};
}

/// Runs f with each path in use that this processor has; the others are said.
template <class F> void on_each_path(F f) {
  test::for_each_path([&](batch::path p) {
    REQUIRE(!batch::force_path(p));
    f(p);
  });
  batch::unforce_path();
}

inline std::vector<voxel> all_of(const sparse_trial& t, convention c, exactness e,
                                 const ray_segment& s = {}) {
  std::vector<voxel> found;
  visit_voxels(t.set, t.the_ray, c, e, s, [&](const voxel& v) {
    found.push_back(v);
    return false;
  });
  return found;
}

inline fuzz::octant_set numbers(const sparse_trial& t, const std::vector<voxel>& found) {
  fuzz::octant_set s = 0;
  for (const voxel& v : found)
    s |= fuzz::octant_set{1} << t.number_of(v);
  return s;
}

} // namespace graze::interface_tests
