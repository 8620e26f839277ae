// The paths and the scalar method agree on which children a ray passes, and in which order.
#include "../../support/paths.hpp"
#include "../../support/test_inputs.hpp"
#include "walk_by.hpp"
#include <generate/generators.hpp>
#include <graze/octree/sound.hpp>

using namespace graze;
using namespace graze::test;
using namespace graze::octree;

namespace {

template <convention C> trail scalar_walk(const ray& r, const way& w) {
  return walk<sound<rounding::upward, C>>(r, w);
}

/// Roots of any size, from one whose octants of level 50 are 2^-1074 wide.
constexpr cube roots[] = {{{0, 0, 0}, 1},
                          {{-4, -4, -4}, 8},
                          {{0x1p900, 0, -0x1p900}, 0x1p900},
                          {{0, 0, 0}, 0x1p-1024},
                          {{-0x1p-1024, 0, -0x1p-1023}, 0x1p-1023},
                          {{-0x1p1022, -0x1p1022, -0x1p1022}, 0x1p1023}};

void children(batch::path p) {
  const auto rays_a_level = static_cast<std::uint64_t>(std::max(1l, test::input_count() / 500));
  const path_under_test& by_lanes = GRAZE_ALL_PATHS(path_under_test, walks).on(p);
  for (const fuzz::generator& g : fuzz::generators()) {
    long wrong = 0, steps = 0;
    for (int level = 1; level <= 50; ++level)
      for (std::uint64_t i = 0; i < rays_a_level; ++i) {
        const fuzz::trial t = fuzz::make_trial(g, 4, i, level, roots[i % std::size(roots)]);
        const way w{t.root, level, t.base, 0x9e3779b97f4a7c15u * (i + 1)};
        const auto made = ray::make(t.origin, t.direction);
        if (!made) // beyond the doubles
          continue;
        const ray& r = *made;
        const trail closed = scalar_walk<convention::closed>(r, w);
        wrong += !(by_lanes.closed(r, w) == closed);
        wrong += !(by_lanes.owned(r, w) == scalar_walk<convention::owned>(r, w));
        steps += closed.steps;
      }
    INFO("rays of " << g.name << ", " << steps << " octants");
    CHECK(steps > 0);
    CHECK(wrong == 0);
  }
}

} // namespace

GRAZE_TEST_EACH_PATH("octree.lanes", "children passed and their order are the scalar method's",
                     "[property]", children)
