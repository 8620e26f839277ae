// First hits by scalar code and by lanes: the same verdicts and intervals of t, certified along the
// ray and by descent, after as many steps; the descent's octants too.
#include "../../support/paths.hpp"
#include "inputs.hpp"
#include "surfaces.hpp"
#include <generate/generators.hpp>
#include <graze/octree_formula/lane_kernels.hpp>

using namespace graze;
using namespace graze::octree;
using namespace graze::twins;

namespace {

struct tally {
  long rays = 0, hits = 0, misses = 0, undecided = 0, differences = 0;
  void add(verdict v) {
    ++rays;
    ++(v == verdict::hit ? hits : v == verdict::miss ? misses : undecided);
  }
};

bool same(const surface_hit& a, const surface_hit& b) {
  return a.outcome == b.outcome && a.t_near == b.t_near && a.t_far == b.t_far && a.leaf == b.leaf &&
         a.certified_leaf == b.certified_leaf;
}

template <class F>
void compare_certified(const F& f, const box& domain, const std::vector<ray>& rays, batch::path p,
                       tally& t) {
  const auto scalar = certified_traversal<F>::make(f, domain);
  const auto by_lanes = lane_certified_traversal<F>::make(f, domain, p);
  REQUIRE(static_cast<bool>(scalar) == static_cast<bool>(by_lanes));
  if (!scalar)
    return;
  std::vector<certified_hit> wanted, hits(rays.size());
  std::uint64_t steps_wanted = 0, steps = 0;
  for (const ray& r : rays)
    wanted.push_back(scalar->first_hit(r, &steps_wanted));
  by_lanes->first_hits(rays, hits, &steps);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    t.add(wanted[i].outcome);
    t.differences += !(wanted[i] == hits[i]);
  }
  CHECK(steps == steps_wanted);
  // whatever rays are beside it, and however many
  for (std::size_t count = 0; count < std::min<std::size_t>(20, rays.size()); ++count) {
    const std::size_t from = (count * 577) % (rays.size() - count);
    std::vector<certified_hit> some(count);
    by_lanes->first_hits(std::span(rays).subspan(from, count), some);
    t.differences +=
        !std::equal(some.begin(), some.end(), wanted.begin() + static_cast<std::ptrdiff_t>(from));
  }
}

template <class F>
void compare_descents(const F& f, const box& domain, const std::vector<ray>& rays, int stored,
                      int level, batch::path p, tally& t) {
  const auto octree = voxelize(f, domain, stored);
  if (!octree)
    return;
  const auto scalar = surface_traversal<F>::make(f, domain, *octree, level);
  const auto by_lanes = lane_traversal<F>::make(f, domain, *octree, level, p);
  REQUIRE(static_cast<bool>(scalar) == static_cast<bool>(by_lanes));
  if (!scalar)
    return;
  std::vector<surface_hit> hits(rays.size());
  traversal_counts wanted, single, batch;
  by_lanes->first_hits(rays, hits, &batch);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const surface_hit h = scalar->first_hit(rays[i], &wanted);
    t.add(h.outcome);
    t.differences += !same(h, hits[i]) + !same(h, by_lanes->first_hit(rays[i], &single));
  }
  for (const traversal_counts& c : {single, batch}) {
    CHECK(c.cells_opened == wanted.cells_opened);
    CHECK(c.leaves_kept == wanted.leaves_kept);
  }
}

/// Those of the campaign, of a camera, and through each awkward domain.
template <class F> void of_scene(const built_in_surface<F>& row, batch::path p) {
  INFO(row.name);
  const F f;
  tally certified, descents;
  random_source random(27);
  for (const box& domain : some_domains()) {
    const std::vector<ray> rays = some_rays(random, domain, 150);
    compare_certified(f, domain, rays, p, certified);
    for (const int level : {5, 20})
      compare_descents(f, domain, std::vector<ray>(rays.begin(), rays.begin() + 40), 5, level, p,
                       descents);
  }
  const scenes::scene<F> scene{f, 2, 2.5};
  std::vector<ray> rays;
  for (int j = 1; j < 512; j += 19)
    for (int i = 2; i < 512; i += 19)
      rays.push_back(scene.pixel(i, j));
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < 40; ++i) {
      const fuzz::trial trial =
          fuzz::make_trial(g, 7, i, 1 + static_cast<int>(i), {{-4, -4, -4}, 8});
      rays.push_back(*ray::make(trial.origin, trial.direction));
    }
  const box domain = row.domain();
  compare_certified(f, domain, rays, p, certified);
  for (const int level : {5, 6, 7, 20, 30, 50})
    compare_descents(f, domain, rays, std::min(level, 6), level, p, descents);
  CHECK(certified.differences == 0);
  CHECK(descents.differences == 0);
  for (const tally& t : {certified, descents}) {
    CHECK(t.hits > 100);
    CHECK(t.misses > 100);
    CHECK(t.undecided > 0);
  }
}
void of_scenes(batch::path p) {
  for_each_built_in([p](const auto& row) { of_scene(row, p); });
}

void of_texts(batch::path p, const std::vector<std::string>& texts, std::size_t rays_each) {
  const std::vector<box> domains = some_domains();
  tally certified, descents;
  std::size_t next = 0;
  random_source random(28);
  for (const std::string& text : texts) {
    INFO(text);
    const formula f = parsed(text);
    const long before = certified.differences + descents.differences;
    for (const box& domain : {domains[0], domains[1 + next++ % (domains.size() - 1)]}) {
      const std::vector<ray> rays = some_rays(random, domain, rays_each);
      compare_certified(f.surface(), domain, rays, p, certified);
      compare_descents(f.surface(), domain, std::vector<ray>(rays.begin(), rays.begin() + 6), 3, 12,
                       p, descents);
    }
    CHECK(certified.differences + descents.differences == before);
  }
  for (const tally& t : {certified, descents}) {
    CHECK(t.hits > t.rays / 20);
    CHECK(t.misses > t.rays / 20);
    CHECK(t.undecided > t.rays / 200);
  }
}
void of_operations(batch::path p) { of_texts(p, operation_texts(), 40); }
void of_random_formulas(batch::path p) { of_texts(p, random_texts(22, 150), 30); }

} // namespace

GRAZE_TEST_EACH_PATH("octree.twins", "first hits of the scenes are the scalar ones", "[property]",
                     of_scenes)
GRAZE_TEST_EACH_PATH("octree.twins", "first hits of every operation of a tape are the scalar ones",
                     "[property]", of_operations)
GRAZE_TEST_EACH_PATH("octree.twins", "first hits of random formulas are the scalar ones",
                     "[property]", of_random_formulas)
