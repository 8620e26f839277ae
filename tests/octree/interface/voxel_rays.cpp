// Rays through voxel sets against the exact oracle: adversarial rays, both conventions, both modes,
// all paths.
#include "../../support/test_inputs.hpp"
#include "adversarial.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <graze/octree/sound.hpp>
#include <graze/oracle/geometry.hpp>
#include <graze/rounding/nearest.hpp>
#include <random>

using namespace graze;
using namespace graze::interface_tests;

namespace {
const auto trials_a_generator = static_cast<std::uint64_t>(test::input_count() / 5);

/// The owners of the occupied octants in the order of t.
std::vector<fuzz::octant_number> owners(const fuzz::truth& is, fuzz::octant_set occupied) {
  std::vector<fuzz::octant_number> order;
  for (unsigned i = 0; i < is.owners; ++i)
    if ((occupied >> is.owner_order[i] & 1) != 0)
      order.push_back(is.owner_order[i]);
  return order;
}
} // namespace

TEST_CASE("octree.voxel_rays: exact mode reports what the oracle does, conservative no less",
          "[mpfr][property]") {
  std::uint64_t reported = 0, extra = 0, misses = 0, spurious = 0, order_errors = 0, apart = 0;
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < trials_a_generator; ++i) {
      const sparse_trial t = make_sparse(g, 4, i);
      const fuzz::truth is = fuzz::truth_of(t.trial);
      std::array<std::vector<voxel>, 4> first_path;
      bool first = true;
      on_each_path([&](batch::path) {
        for (unsigned k = 0; k < 4; ++k) {
          const convention c = (k & 1) != 0 ? convention::owned : convention::closed;
          const exactness e = (k & 2) != 0 ? exactness::exact : exactness::conservative;
          const std::vector<voxel> found = all_of(t, c, e);
          const fuzz::octant_set answer = numbers(t, found),
                                 wanted =
                                     t.occupied & (c == convention::owned ? is.owned : is.touched);
          reported += found.size();
          misses += std::popcount(wanted & ~answer);
          spurious += found.size() - std::popcount(answer); // twice
          if (e == exactness::exact)
            spurious += std::popcount(answer & ~wanted);
          else
            extra += std::popcount(answer & ~wanted);
          if (c == convention::owned) {
            std::vector<fuzz::octant_number> order;
            for (const voxel& v : found)
              if ((is.owned >> t.number_of(v) & 1) != 0)
                order.push_back(t.number_of(v));
            order_errors += order != owners(is, t.occupied);
          }
          if (first)
            first_path[k] = found;
          apart += found != first_path[k];
        }
        first = false;
      });
      INFO(g.name << " " << i << ": " << misses << " missed, " << spurious << " spurious, "
                  << order_errors << " out of order, " << apart << " paths apart");
      if (misses + spurious + order_errors + apart != 0)
        FAIL();
    }
  CHECK(misses == 0);
  CHECK(spurious == 0);
  CHECK(order_errors == 0);
  CHECK(apart == 0);
  CHECK(reported > 1'000'000);
  CHECK(extra > 0); // rays that no filter decides were among them
}

TEST_CASE("octree.voxel_rays: conservative visits are those of the sound method, in all sets",
          "[property]") {
  std::uint64_t visits = 0;
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < 500; ++i) {
      const sparse_trial t = make_sparse(g, 5, i);
      const auto of_sound = [&]<convention C>() {
        fuzz::octant_set answer = 0;
        const sound<rounding::nearest, C> method(t.the_ray);
        const fuzz::block_tree tree(t.trial);
        descend(method, t.trial.root, t.trial.level, tree,
                [&](const cube&, const fuzz::block_tree::node& n, const auto&) {
                  answer |= fuzz::octant_set{1} << tree.octant_of(n);
                  return false;
                });
        return answer & t.occupied;
      };
      on_each_path([&](batch::path) {
        const auto closed = all_of(t, convention::closed, exactness::conservative);
        visits += closed.size();
        REQUIRE(numbers(t, closed) == of_sound.operator()<convention::closed>());
        REQUIRE(numbers(t, all_of(t, convention::owned, exactness::conservative)) ==
                of_sound.operator()<convention::owned>());
      });
    }
  CHECK(visits > 10'000);
}

TEST_CASE("octree.voxel_rays: range, callback, first, count and batch agree", "[unit]") {
  std::vector<std::array<std::uint32_t, 3>> voxels;
  std::mt19937_64 random(7);
  for (int i = 0; i < 60'000; ++i)
    voxels.push_back({static_cast<std::uint32_t>(random() % 64),
                      static_cast<std::uint32_t>(random() % 64),
                      static_cast<std::uint32_t>(random() % 64)});
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  for (const int level : {6, 7}) { // both kinds of root node
    const root_cube root = *root_cube::make({{-1, -1, -1}, 2}, level);
    const voxel_set set = *voxel_set::make(root, voxels);
    std::vector<ray> rays;
    const auto number = [&] { return static_cast<double>(random() % 4097) / 1024 - 2; };
    while (rays.size() < 300)
      if (const auto r = ray::make({number(), number(), number()}, {number(), number(), number()}))
        rays.push_back(*r);
    on_each_path([&](batch::path) {
      for (const convention c : {convention::closed, convention::owned}) {
        std::vector<std::uint32_t> counts(rays.size());
        const std::uint64_t opened = count_voxels(set, rays, c, exactness::exact, counts);
        std::vector<std::vector<voxel>> lists(rays.size());
        CHECK(visit_voxels(set, rays, c, exactness::exact, {},
                           [&](std::size_t i, std::span<const voxel> v) {
                             lists[i].insert(lists[i].end(), v.begin(), v.end());
                           }) == opened);
        for (std::size_t i = 0; i < rays.size(); ++i) {
          std::vector<voxel> by_callback, by_range;
          CHECK_FALSE(visit_voxels(set, rays[i], c, exactness::exact, {}, [&](const voxel& v) {
            by_callback.push_back(v);
            return false;
          }));
          voxel_walk walk(set, rays[i], c);
          for (const voxel& v : walk)
            by_range.push_back(v);
          REQUIRE(by_callback == lists[i]);
          REQUIRE(by_range == lists[i]);
          REQUIRE(counts[i] == lists[i].size());
          const auto first = first_voxel(set, rays[i]);
          if (c == convention::owned) {
            REQUIRE(first.has_value() == !lists[i].empty());
            if (first)
              REQUIRE(*first == lists[i].front());
          }
          if (i < 20) { // no voxel that the list leaves out is met
            std::size_t met = 0;
            for (const auto& index : voxels) {
              const cube b = root.octant({index[0], index[1], index[2]}, level);
              const unsigned far =
                  (b.hi(0) == 1 ? 1u : 0) | (b.hi(1) == 1 ? 2u : 0) | (b.hi(2) == 1 ? 4u : 0);
              met += c == convention::closed ? octree::touches(rays[i], b)
                                             : octree::owns(rays[i], b, far);
            }
            CHECK(met == lists[i].size());
          }
        }
      }
    });
  }
}

TEST_CASE("octree.voxel_rays: a thick set overflows no queue, and every touched voxel comes once",
          "[mpfr]") {
  // all voxels of a block through which a ray runs in mid-planes: the most octants a ray touches
  std::vector<std::array<std::uint32_t, 3>> voxels;
  for (std::uint32_t x = 0; x < 64; ++x)
    for (std::uint32_t y = 0; y < 64; ++y)
      for (std::uint32_t z = 0; z < 64; ++z)
        voxels.push_back({x, y, z});
  for (const int level : {6, 7, 8}) {
    const root_cube root = *root_cube::make({{0, 0, 0}, 1}, level);
    const voxel_set set = *voxel_set::make(root, voxels);
    REQUIRE(set.voxel_count() == voxels.size());
    const double middle = std::ldexp(32.0, -level);
    for (const vec3& d : {vec3{1, 0, 0}, vec3{0, -1, 0}, vec3{1, 1, 0}, vec3{1, 1, 1}}) {
      const ray r = *ray::make({d[0] > 0 ? 0.0 : middle,
                                d[1] == 0  ? middle
                                : d[1] > 0 ? 0.0
                                           : 1.0,
                                d[2] > 0 ? 0.0 : middle},
                               d);
      std::size_t touched = 0, owned = 0;
      for (const auto& i : voxels) {
        const cube c = root.octant({i[0], i[1], i[2]}, level);
        const vec3 hi{c.hi(0), c.hi(1), c.hi(2)};
        const unsigned far = (hi[0] == 1 ? 1u : 0) | (hi[1] == 1 ? 2u : 0) | (hi[2] == 1 ? 4u : 0);
        touched += oracle::touches(r.origin(), r.direction(), c.lo, hi);
        owned += oracle::owns(r.origin(), r.direction(), c.lo, hi, far);
      }
      on_each_path([&](batch::path) {
        for (const convention c : {convention::closed, convention::owned}) {
          std::vector<std::uint32_t> ranks;
          visit_voxels(set, r, c, exactness::exact, {}, [&](const voxel& v) {
            ranks.push_back(v.rank);
            return false;
          });
          CHECK(ranks.size() == (c == convention::closed ? touched : owned));
          std::sort(ranks.begin(), ranks.end());
          CHECK(std::unique(ranks.begin(), ranks.end()) == ranks.end());
        }
      });
    }
  }
}

TEST_CASE("octree.voxel_set: refuses what it cannot hold; an empty set is met by no ray",
          "[unit]") {
  const root_cube deep = *root_cube::make({{0, 0, 0}, 1}, 21),
                  root = *root_cube::make({{0, 0, 0}, 1}, 3);
  const std::vector<std::array<std::uint32_t, 3>> outside{{8, 0, 0}};
  CHECK_FALSE(voxel_set::make(deep, {}));
  CHECK_FALSE(voxel_set::make(root, outside));
  const voxel_set empty = *voxel_set::make(root, {});
  CHECK(empty.voxel_count() == 0);
  CHECK_FALSE(first_voxel(empty, *ray::make({0, 0, 0}, {1, 1, 1})));
}
