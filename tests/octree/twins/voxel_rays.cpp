// Rays through voxel sets, in the lanes of each path, against the descent `exact`, in roots of any
// size: the same voxels, those that are owned in the same order.
#include "../interface/adversarial.hpp"
#include <graze/octree/exact.hpp>
#include <graze/octree/sound.hpp>

using namespace graze;
using namespace graze::octree;
using namespace graze::interface_tests;

namespace {

/// From one whose voxels of level 20 are 2^-1074 wide, to half of all numbers; not at 0 too.
constexpr cube awkward_roots[] = {{{0, 0, 0}, 0x1p-1054},
                                  {{-0x1p-1054, 0, -0x1p-1053}, 0x1p-1053},
                                  {{-0x1p-1022, -0x1p-1022, -0x1p-1022}, 0x1p-1021},
                                  {{-0x1p1022, -0x1p1022, -0x1p1022}, 0x1p1023},
                                  {{0x1p1000, 0, -0x1p1001}, 0x1p1000},
                                  {{-3, -3, -3}, 6}};

std::optional<sparse_trial> trial_in(const cube& box, const fuzz::generator& g,
                                     std::uint64_t index) {
  fuzz::random_stream random(0x7a11, index);
  const int level = random.between(1, 20);
  fuzz::trial t = fuzz::make_trial(g, 9, index, level, box);
  switch (random.below(6)) { // components far below the others, or far above
  case 0:
    t.direction[random.below(3)] = random.coin() ? 0x1p-1074 : -0x1p-1073;
    break;
  case 1:
    t.direction[random.below(3)] = 0;
    break;
  case 2:
    for (double& d : t.direction)
      d = std::ldexp(d, -900);
    break;
  default:
    break;
  }
  if (t.direction == vec3{0, 0, 0})
    t.direction[0] = 1;
  const fuzz::octant_set occupied = random.one_in(3) ? t.all() & random.bits() : t.all();
  std::vector<std::array<std::uint32_t, 3>> voxels;
  for (unsigned v = 0; v < 64; ++v)
    if ((occupied >> v & 1) != 0)
      voxels.push_back({static_cast<std::uint32_t>(t.base[0] + (v & 3)),
                        static_cast<std::uint32_t>(t.base[1] + (v >> 2 & 3)),
                        static_cast<std::uint32_t>(t.base[2] + (v >> 4))});
  const root_cube root = *root_cube::make(box, level);
  const auto r = ray::make(t.origin, t.direction);
  if (!r) // beyond the doubles
    return std::nullopt;
  return sparse_trial{t, occupied, *r, root, *voxel_set::make(root, voxels)};
}

template <class Method> std::vector<fuzz::octant_number> descent_of(const sparse_trial& t) {
  std::vector<fuzz::octant_number> found;
  const Method method(t.the_ray);
  const fuzz::block_tree tree(t.trial);
  descend(method, t.trial.root, t.trial.level, tree,
          [&](const cube&, const fuzz::block_tree::node& n, const auto&) {
            if ((t.occupied >> tree.octant_of(n) & 1) != 0)
              found.push_back(tree.octant_of(n));
            return false;
          });
  return found;
}

std::vector<fuzz::octant_number> walk_of(const sparse_trial& t, convention c, exactness e) {
  std::vector<fuzz::octant_number> found;
  for (const voxel& v : all_of(t, c, e))
    found.push_back(t.number_of(v));
  return found;
}

void same_as_descents(batch::path p) {
  REQUIRE(!batch::force_path(p));
  using nearest = rounding::nearest;
  long rays = 0, reported = 0, differences = 0;
  for (const cube& root : awkward_roots)
    for (const fuzz::generator& g : fuzz::generators())
      for (std::uint64_t i = 0; i < 250; ++i) {
        const auto trial = trial_in(root, g, i);
        if (!trial)
          continue;
        const sparse_trial& t = *trial;
        ++rays;
        const auto compare = [&](auto by_descent, auto by_walk, bool ordered) {
          reported += static_cast<long>(by_walk.size());
          if (!ordered) {
            std::sort(by_descent.begin(), by_descent.end());
            std::sort(by_walk.begin(), by_walk.end());
          }
          differences += by_descent != by_walk;
        };
        compare(descent_of<exact<nearest, convention::owned>>(t),
                walk_of(t, convention::owned, exactness::exact), true);
        compare(descent_of<exact<nearest, convention::closed>>(t),
                walk_of(t, convention::closed, exactness::exact), false);
        compare(descent_of<sound<nearest, convention::owned>>(t),
                walk_of(t, convention::owned, exactness::conservative), false);
        compare(descent_of<sound<nearest, convention::closed>>(t),
                walk_of(t, convention::closed, exactness::conservative), false);
        if (differences != 0) {
          INFO(g.name << " " << i << ", root of size " << root.size);
          batch::unforce_path();
          FAIL();
        }
      }
  batch::unforce_path();
  CHECK(rays > 10'000);
  CHECK(reported > 50'000);
}

} // namespace

GRAZE_TEST_EACH_PATH("octree.twins", "rays through voxels of any size are the descents'",
                     "[property]", same_as_descents)
