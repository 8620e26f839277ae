#include <generate/generators.hpp>
#include <generate/site.hpp>
#include <shrink/small_witness.hpp>

namespace graze::fuzz {

namespace {

/// Unit octants in a root of 2^3 to 8^3, and integers of `bits` bits: a ray through a vertex of the
/// block, or past it by the smallest step.
trial small_integers(random_stream& random, int bits) {
  trial t;
  t.level = random.between(1, 3);
  t.root.size = std::ldexp(1.0, t.level);
  const auto count = std::uint64_t{1} << t.level;
  const double times = std::ldexp(1.0, random.between(-3, 1));
  for (unsigned a = 0; a < 3; ++a) {
    t.base[a] = random.bits(t.level);
    t.extent[a] = t.base[a] + 1 < count && random.one_in(4) ? 2 : 1;
    t.direction[a] = random.one_in(6) ? 0 : small_integer(random, bits);
    t.origin[a] =
        t.plane(static_cast<int>(a), random.below(t.extent[a] + 1u)) - times * t.direction[a];
  }
  if (random.coin())
    t.origin[random.below(3)] += random.sign() * std::ldexp(1.0, -random.between(0, bits + 2));
  return t;
}

/// Grids of a few voxels of spacing 1 or 1/10.
scene_choice small_scene(const scene_choice& scene, unsigned k) {
  if (scene.cells != cell_kind::grid)
    return scene;
  grid_planes g;
  g.rule = scene.grid && scene.grid->rule != plane_rule::given
               ? scene.grid->rule
               : (k % 2 == 0 ? plane_rule::exact : plane_rule::rounded);
  const double spacing = k / 2 % 2 == 0 ? 1 : 0.1;
  g.spacing = {spacing, spacing, spacing};
  g.count = {2 + k % 3, 2 + k / 3 % 3, 2 + k / 9 % 3};
  return {cell_kind::grid, scene.segments, std::make_shared<const grid_planes>(std::move(g))};
}

} // namespace

std::optional<trial> small_witness(traversal& under_test, finding kind, unsigned evaluations,
                                   shrink_deadline end, const std::atomic<bool>* stop,
                                   const scene_choice& scene) {
  constexpr int most_bits = 26;
  constexpr unsigned enough = 12; // failing trials that are shrunk
  std::optional<trial> best;
  unsigned found = 0;
  const auto try_it = [&](const trial& t) {
    if (std::chrono::steady_clock::now() >= end || (stop != nullptr && stop->load()) ||
        !judgeable(t) || (judge(t, under_test).findings & bit(kind)) == 0)
      return;
    ++found;
    const trial small = shrink(t, under_test, kind, evaluations, end, stop);
    if (!best || complexity_of(small) < complexity_of(*best))
      best = small;
  };
  if (scene.segments || scene.cells != cell_kind::cube) {
    for (unsigned k = 0; k < evaluations / 2 && found < enough; ++k)
      try_it(make_trial(*(generators().data() + k % generators().size()), 2026, k, 1,
                        small_scene(scene, k)));
    return best;
  }
  for (unsigned k = 0; k < evaluations / 2 && found < enough; ++k) {
    random_stream random(2026, k);
    const unsigned bits = 1 + 2 * k * static_cast<unsigned>(most_bits - 1) / evaluations;
    try_it(small_integers(random, static_cast<int>(bits)));
  }
  found = 0;
  for (unsigned k = 0; k < evaluations / 2 && found < enough; ++k)
    try_it(make_trial(*(generators().data() + k % generators().size()), 2026, k,
                      static_cast<int>(1 + k / generators().size() % 3)));
  return best;
}

} // namespace graze::fuzz
