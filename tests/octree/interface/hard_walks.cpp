// Walks that earlier tests did not reach: queues that are full, segments whose ends are touched
// exactly, roots of subnormal size. Judged by exact geometry.
#include "adversarial.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <graze/octree/tree_rays.hpp>
#include <graze/oracle/geometry.hpp>
#include <set>
#include <traversal/list.hpp>

using namespace graze;
using namespace graze::interface_tests;

namespace {

using index3 = std::array<std::uint32_t, 3>;

struct thick_ray {
  ray along;
  std::vector<index3> touched;
  std::size_t owned = 0;
};

/// All voxels of the root's grid that the ray touches, and how many own a point of it: those within
/// one of the voxels that its points lie in are asked, one by one. The ray goes from plane to plane
/// of the grid at multiples of t = 2^-level.
thick_ray touched_by(const root_cube& root, const vec3& o, const vec3& d) {
  thick_ray r{*ray::make(o, d), {}, 0};
  const int level = root.level();
  const double last = std::ldexp(1, level) - 1;
  std::set<index3> near;
  for (double k = 0; k <= last + 1; ++k) {
    index3 low{}, high{};
    for (unsigned a = 0; a < 3; ++a) {
      const double x = std::floor(std::ldexp(o[a], level) + k * d[a]);
      low[a] = static_cast<std::uint32_t>(std::clamp(x - 1, 0.0, last));
      high[a] = static_cast<std::uint32_t>(std::clamp(x + 1, 0.0, last));
    }
    for (std::uint32_t x = low[0]; x <= high[0]; ++x)
      for (std::uint32_t y = low[1]; y <= high[1]; ++y)
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
          near.insert({x, y, z});
  }
  for (const index3& i : near) {
    const cube c = root.octant({i[0], i[1], i[2]}, level);
    const vec3 hi{c.hi(0), c.hi(1), c.hi(2)};
    if (!oracle::touches(o, d, c.lo, hi))
      continue;
    r.touched.push_back(i);
    unsigned far = 0;
    for (unsigned a = 0; a < 3; ++a)
      far |= hi[a] == root.root_octant().hi(static_cast<int>(a)) ? 1u << a : 0;
    r.owned += oracle::owns(o, d, c.lo, hi, far);
  }
  return r;
}

} // namespace

TEST_CASE("octree.voxel_rays: every queue is filled, and every touched voxel comes once",
          "[mpfr][regression]") {
  // the diagonals: eight octants a vertex, 442 of level 6, so that queues of 128 fill at each level
  std::size_t most = 0;
  for (const int level : {6, 7, 9, 10}) {
    const root_cube root = *root_cube::make({{0, 0, 0}, 1}, level);
    const double middle = 0.5;
    std::vector<std::pair<vec3, vec3>> rays;
    for (unsigned corner = 0; corner < 8; ++corner) {
      vec3 o, d;
      for (unsigned a = 0; a < 3; ++a) {
        o[a] = corner >> a & 1;
        d[a] = o[a] == 0 ? 1 : -1;
      }
      rays.emplace_back(o, d);
    }
    for (unsigned still = 0; still < 3; ++still) // in a plane, diagonally
      for (const double sign : {1.0, -1.0}) {
        vec3 o{0, 0, 0}, d{1, 1, 1};
        o[still] = middle;
        d[still] = 0;
        o[(still + 1) % 3] = sign > 0 ? 0 : 1;
        d[(still + 1) % 3] = sign;
        rays.emplace_back(o, d);
      }
    for (const auto& [o, d] : rays) {
      const thick_ray t = touched_by(root, o, d);
      most = std::max(most, t.touched.size());
      const voxel_set set = *voxel_set::make(root, t.touched);
      REQUIRE(set.voxel_count() == t.touched.size());
      on_each_path([&](batch::path p) {
        INFO(batch::name(p) << ", level " << level << ", direction " << d[0] << ' ' << d[1] << ' '
                            << d[2]);
        for (const convention c : {convention::closed, convention::owned})
          for (const exactness e : {exactness::exact, exactness::conservative})
            for (const bool soonest : {false, true}) {
              voxel_walk walk(set, t.along, c, e, {}, soonest);
              std::vector<std::uint32_t> ranks;
              for (const voxel& v : walk)
                ranks.push_back(v.rank);
              const std::size_t wanted = c == convention::closed ? t.touched.size() : t.owned;
              if (e == exactness::exact)
                CHECK(ranks.size() == wanted);
              else
                CHECK(ranks.size() >= wanted);
              std::sort(ranks.begin(), ranks.end());
              CHECK(std::unique(ranks.begin(), ranks.end()) == ranks.end());
            }
        std::array<std::uint32_t, 1> count{};
        (void)count_voxels(set, std::span(&t.along, 1), convention::closed, exactness::exact,
                           count);
        CHECK(count[0] == t.touched.size());
      });
      if (level == 10 && d[0] != 0 && d[1] != 0 && d[2] != 0)
        CHECK(t.touched.size() == 7162);
    }
  }
  CHECK(most == 7162);
}

TEST_CASE("octree.voxel_rays: a segment that ends or begins exactly on a plane touches what is "
          "beyond it",
          "[regression][hardcase]") {
  // o = plane - d with full-precision d, so that t = 1 is the plane to the last bit, on one axis or
  // on all; and the same half-line in directions whose products underflow or overflow
  constexpr int level = 10;
  const root_cube root = *root_cube::make({{0, 0, 0}, 1}, level);
  fuzz::random_stream random(2027, 1);
  std::uint64_t ends = 0, missed = 0, beyond = 0;
  for (int i = 0; i < 6'000; ++i) {
    vec3 vertex, o, d;
    std::array<std::uint32_t, 3> at{};
    const bool from_vertex = random.one_in(3);
    const unsigned one_axis = random.below(3);
    for (unsigned a = 0; a < 3; ++a) {
      at[a] = 1 + static_cast<std::uint32_t>(random.below((1u << level) - 1));
      vertex[a] = std::ldexp(at[a], -level);
      if (!from_vertex && a != one_axis) // in the middle of a voxel, no plane
        vertex[a] += 0x1p-11 + std::ldexp(static_cast<double>(random.bits(20)), -33);
      // of 53 bits, and multiples of 2^-53 below 1, so that the difference is exact
      d[a] = random.sign() * std::ldexp(static_cast<double>(random.bits(53) | 1), -53);
      if (std::fabs(vertex[a] - d[a]) > 1)
        d[a] = -d[a];
      o[a] = vertex[a] - d[a];
      REQUIRE(o[a] + d[a] == vertex[a]);
    }
    // the voxels around the vertex
    std::vector<index3> voxels;
    for (unsigned k = 0; k < 8; ++k)
      voxels.push_back({at[0] - (k & 1), at[1] - (k >> 1 & 1), at[2] - (k >> 2)});
    const voxel_set set = *voxel_set::make(root, voxels);
    const int shift = std::array<int, 4>{0, 0, -960, 900}[random.below(4)];
    for (double& x : d)
      x = std::ldexp(x, shift);
    const double one = std::ldexp(1, -shift);
    const ray r = *ray::make(o, d);
    const std::size_t wanted_at_end = from_vertex ? 8 : 2;
    on_each_path([&](batch::path) {
      for (const auto& [first, last] :
           {std::pair(0.0, one), std::pair(one, one), std::pair(one, std::ldexp(one, 1)),
            std::pair(0.0, std::nextafter(one, 0)),
            std::pair(std::nextafter(one, INFINITY), 2 * one)})
        for (const exactness e : {exactness::exact, exactness::conservative}) {
          const ray_segment s = *ray_segment::make(first, last);
          std::size_t found = 0;
          visit_voxels(set, r, convention::closed, e, s, [&](const voxel&) {
            ++found;
            return false;
          });
          if (first <= one && one <= last) {
            ++ends;
            missed += found < wanted_at_end ? 1 : 0;
            // of the voxels at a vertex, and of the two at a plane, each is touched there
            if (e == exactness::exact && first == last)
              CHECK(found == wanted_at_end);
          } else if (e == exactness::exact && from_vertex) {
            ++beyond; // one ulp short of it: not all the voxels around it
            CHECK(found < wanted_at_end);
          }
        }
    });
  }
  CHECK(missed == 0);
  CHECK(ends > 10'000);
  CHECK(beyond > 1'000);
}

namespace {
/// 14 levels and fewer of 2^-1060, so that octants are multiples of 2^-1074; with planes at 0 on
/// either side, in the middle and not at all.
const std::array<cube, 4> subnormal_roots{{{{0, 0, 0}, 0x1p-1060},
                                           {{-0x1p-1060, -0x1p-1060, -0x1p-1060}, 0x1p-1059},
                                           {{-0x1p-1064, 0, 0x1p-1062}, 0x1p-1064},
                                           {{0x1p-1022, -0x1p-1040, -0x1p-1050}, 0x1p-1040}}};
} // namespace

TEST_CASE("octree.voxel_rays: roots of subnormal size, exactly", "[regression][hardcase]") {
  std::uint64_t reported = 0, on_zero = 0;
  for (const cube& box : subnormal_roots)
    for (const fuzz::generator& g : fuzz::generators())
      for (std::uint64_t i = 0; i < 120; ++i) {
        fuzz::random_stream random(19, i);
        const int level = random.between(1, 10);
        fuzz::trial t = fuzz::make_trial(g, 77, i, level, box);
        if (random.one_in(4)) { // still on an axis at 0, or at the root's far face
          const unsigned a = random.below(3);
          t.direction[a] = 0;
          t.origin[a] = random.coin() ? 0.0 : box.hi(static_cast<int>(a));
          if (t.direction == vec3{})
            t.direction[(a + 1) % 3] = random.sign();
        }
        if (!fuzz::judgeable(t))
          continue;
        on_zero += t.direction[0] == 0 && t.origin[0] == 0;
        std::vector<index3> voxels;
        for (unsigned v = 0; v < 64; ++v)
          if ((t.all() >> v & 1) != 0)
            voxels.push_back({static_cast<std::uint32_t>(t.base[0] + (v & 3)),
                              static_cast<std::uint32_t>(t.base[1] + (v >> 2 & 3)),
                              static_cast<std::uint32_t>(t.base[2] + (v >> 4))});
        const root_cube root = *root_cube::make(box, level);
        const sparse_trial s{t, t.all(), *ray::make(t.origin, t.direction), root,
                             *voxel_set::make(root, voxels)};
        const fuzz::truth is = fuzz::truth_of(t);
        on_each_path([&](batch::path p) {
          INFO(batch::name(p) << ", " << g.name << " " << i << ", root of " << box.size);
          for (const convention c : {convention::closed, convention::owned}) {
            const fuzz::octant_set wanted = c == convention::owned ? is.owned : is.touched;
            const fuzz::octant_set exactly = numbers(s, all_of(s, c, exactness::exact));
            REQUIRE(exactly == wanted);
            REQUIRE((wanted & ~numbers(s, all_of(s, c, exactness::conservative))) == 0);
            reported += static_cast<std::uint64_t>(std::popcount(exactly));
          }
        });
        const fuzz::block_tree tree(t);
        fuzz::octant_set by_tree = 0;
        visit_cells<convention::owned>(tree, root, level, s.the_ray, {},
                                       [&](const cube&, const fuzz::block_tree::node& n) {
                                         by_tree |= fuzz::octant_set{1} << tree.octant_of(n);
                                         return false;
                                       });
        REQUIRE(by_tree == is.owned);
      }
  CHECK(reported > 10'000);
  CHECK(on_zero > 100);
}

TEST_CASE("octree.traversals: no finding on roots of subnormal size", "[regression][hardcase]") {
  std::uint64_t asked = 0, declined = 0;
  for (const fuzz::traversal_entry& e : fuzz::traversals()) {
    if (!e.name.starts_with("sound") && !e.name.starts_with("exact") &&
        !e.name.starts_with("lanes"))
      continue;
    const auto under_test = e.make();
    for (const cube& box : subnormal_roots)
      for (const fuzz::generator& g : fuzz::generators())
        for (std::uint64_t i = 0; i < 60; ++i) {
          const fuzz::trial t = fuzz::make_trial(g, 78, i, 1 + static_cast<int>(i % 10), box);
          if (!fuzz::judgeable(t))
            continue;
          const fuzz::verdict v = fuzz::judge(t, *under_test);
          ++asked;
          declined += v.declined;
          INFO(e.name << ", " << g.name << " " << i << ", root of " << box.size);
          REQUIRE(v.findings == 0u);
        }
  }
  CHECK(asked > 10'000);
  CHECK(declined == 0);
}
