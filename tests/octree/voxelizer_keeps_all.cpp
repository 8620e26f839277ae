// The voxelizer: no octant that the surface meets is left out; what is called certified is.
#include "surface_judge.hpp"
#include "surface_scenes.hpp"
#include <algorithm>
#include <catch2/catch.hpp>
#include <graze/octree/voxelizer.hpp>
#include <optional>

using namespace graze;
using namespace graze::octree;

namespace {

/// The leaf that is the octant `index` of the octree's level, if it is there.
std::optional<sparse_octree::node> leaf_at(const sparse_octree& tree,
                                           const std::array<unsigned, 3>& index) {
  sparse_octree::node n = tree.root();
  for (int bit = tree.level() - 1; bit >= 0; --bit) {
    const unsigned child =
        (index[0] >> bit & 1u) | (index[1] >> bit & 1u) << 1 | (index[2] >> bit & 1u) << 2;
    if (tree.child_mask(n, tree.root_octant(), static_cast<std::uint8_t>(1u << child)) == 0)
      return std::nullopt;
    n = tree.child(n, child);
  }
  return n;
}

std::array<unsigned, 3> owner(const sparse_octree& tree, const vec3& p) {
  std::array<unsigned, 3> index;
  const double cells = std::ldexp(1.0, tree.level());
  for (int a = 0; a < 3; ++a)
    index[a] =
        static_cast<unsigned>(std::min(cells - 1, std::floor((p[a] - tree.root_octant().lo[a]) /
                                                             tree.root_octant().size * cells)));
  return index;
}

cube octant(const sparse_octree& tree, const std::array<unsigned, 3>& index) {
  return root_cube::make(tree.root_octant(), tree.level())
      ->octant({index[0], index[1], index[2]}, tree.level());
}

/// Every leaf with its octant.
template <class Visit>
void each_leaf(const sparse_octree& tree, sparse_octree::node n, const cube& cell, int level,
               Visit visit) {
  if (level == tree.level())
    return visit(cell, n);
  for (unsigned i = 0; i < 8; ++i)
    if (tree.child_mask(n, cell, static_cast<std::uint8_t>(1u << i)) != 0)
      each_leaf(tree, tree.child(n, i), cell.child(i), level + 1, visit);
}

template <class F> bool opposite_corner_signs(const F& f, const box& b) {
  bool positive = false, negative = false;
  for (unsigned i = 0; i < 8; ++i) {
    const int s = judge::sign_at(f, b.corner(i));
    positive = positive || s > 0;
    negative = negative || s < 0;
  }
  return positive && negative;
}

struct plane { // x = 0, a face of octants at every level
  template <class N> N operator()(const N& x, const N&, const N&) const { return x; }
};
struct shifted { // x = 1, the domain's own face
  template <class N> N operator()(const N& x, const N&, const N&) const {
    return x - constants<N>::exact(1);
  }
};

} // namespace

TEST_CASE("octree.voxelizer: every octant with a point of the surface is kept",
          "[property][mpfr]") {
  scenes::for_each([](const auto& scene) {
    for (const int level : {3, 6, 9}) {
      const auto tree = voxelize(scene.surface, scene.domain(), level);
      REQUIRE(tree);
      judge::random_source random(91);
      int points = 0, lost = 0;
      for (int i = 0; i < 3000; ++i) {
        vec3 p, q;
        for (int a = 0; a < 3; ++a) {
          p[a] = random.in(-scene.reach, scene.reach);
          if (random.below(8) == 0)
            p[a] = std::ldexp(std::nearbyint(std::ldexp(p[a], 4)), -4); // in a face
          q[a] = p[a];
        }
        const int axis = i % 3;
        q[axis] = random.in(-scene.reach, scene.reach);
        const int sign = judge::sign_at(scene.surface, p);
        if (sign == judge::sign_at(scene.surface, q))
          continue;
        while (true) { // exact signs: a zero stays between p and q until they are neighbours
          vec3 middle = p;
          middle[axis] = p[axis] / 2 + q[axis] / 2;
          if (middle == p || middle == q)
            break;
          (judge::sign_at(scene.surface, middle) == sign ? p : q) = middle;
        }
        ++points;
        // faces of octants are doubles: both neighbours are in the closed octants of one or the
        // other
        lost += !leaf_at(*tree, owner(*tree, p)) && !leaf_at(*tree, owner(*tree, q));
        if (owner(*tree, p) == owner(*tree, q))
          lost += !leaf_at(*tree, owner(*tree, p));
      }
      INFO("reach " << scene.reach << ", level " << level);
      CHECK(points > 300);
      CHECK(lost == 0);
    }
  });
}

TEST_CASE("octree.voxelizer: at a low level, all octants against a fine grid of exact signs",
          "[exhaustive][mpfr]") {
  scenes::for_each([](const auto& scene) {
    constexpr int level = 4, fine = 2;
    const auto tree = voxelize(scene.surface, scene.domain(), level);
    REQUIRE(tree);
    int lost = 0, kept = 0, false_certificates = 0;
    for (unsigned x = 0; x < 1u << level; ++x)
      for (unsigned y = 0; y < 1u << level; ++y)
        for (unsigned z = 0; z < 1u << level; ++z) {
          const box b = intersection(closed_box(octant(*tree, {x, y, z})), scene.domain());
          const auto leaf = leaf_at(*tree, {x, y, z});
          if (b.empty()) {
            CHECK_FALSE(leaf.has_value());
            continue;
          }
          if (leaf) {
            ++kept;
            false_certificates +=
                tree->leaf(*leaf) == content::certified && !opposite_corner_signs(scene.surface, b);
            continue;
          }
          bool positive = false, negative = false;
          for (int i = 0; i < (fine + 1) * (fine + 1) * (fine + 1); ++i) {
            const std::array<int, 3> at{i % (fine + 1), i / (fine + 1) % (fine + 1),
                                        i / (fine + 1) / (fine + 1)};
            vec3 p;
            for (int a = 0; a < 3; ++a)
              p[a] = b.lo[a] + (b.hi[a] - b.lo[a]) * at[a] / fine;
            const int s = judge::sign_at(scene.surface, p);
            positive = positive || s >= 0;
            negative = negative || s <= 0;
          }
          lost += positive && negative;
        }
    INFO("reach " << scene.reach);
    CHECK(kept > 50);
    CHECK(lost == 0);
    CHECK(false_certificates == 0);
  });
}

TEST_CASE("octree.voxelizer: leaves are few, within the domain, and mostly certified", "[unit]") {
  scenes::for_each([](const auto& scene) {
    const auto tree = voxelize(scene.surface, scene.domain(), 7);
    REQUIRE(tree);
    std::size_t leaves = 0, certified = 0, outside = 0, checked = 0, false_certificates = 0;
    each_leaf(*tree, tree->root(), tree->root_octant(), 0,
              [&](const cube& cell, sparse_octree::node n) {
                const box b = intersection(closed_box(cell), scene.domain());
                ++leaves;
                outside += b.empty();
                certified += tree->leaf(n) == content::certified;
                if (leaves % 37 != 0 || tree->leaf(n) != content::certified)
                  return;
                ++checked;
                false_certificates += !opposite_corner_signs(scene.surface, b);
              });
    INFO("reach " << scene.reach);
    CHECK(leaves == tree->leaf_count());
    CHECK(outside == 0);
    CHECK(checked > 50);
    CHECK(false_certificates == 0);
    CHECK(certified > leaves * 9 / 10);
    // a surface of area A meets about 3/2 A / size^2 octants; the domains bound A
    CHECK(leaves < 12 * 128 * 128);
    CHECK(tree->bytes() == 5 * tree->node_count() + tree->leaf_count());
  });
}

TEST_CASE("octree.voxelizer: a surface that lies in octants' faces is kept on both sides",
          "[hardcase]") {
  const auto tree = voxelize(plane{}, box{{-1, -1, -1}, {1, 1, 1}}, 3);
  REQUIRE(tree);
  CHECK(tree->leaf_count() == 2 * 8 * 8);
  const auto edge = voxelize(shifted{}, box{{-1, -1, -1}, {1, 1, 1}}, 3);
  REQUIRE(edge);
  CHECK(edge->leaf_count() == 8 * 8);
}

TEST_CASE("octree.voxelizer: refuses bad domains and levels, and holds an empty scene", "[unit]") {
  const quartdef f;
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_FALSE(voxelize(f, box{{-1, -1, -1}, {1, 1, 1}}, 0));
  CHECK_FALSE(voxelize(f, box{{-1, -1, -1}, {1, 1, 1}}, 54));
  CHECK_FALSE(voxelize(f, box{{1, -1, -1}, {-1, 1, 1}}, 3));
  CHECK_FALSE(voxelize(f, box{{-1, -1, -1}, {1, 1, inf}}, 3));
  CHECK_FALSE(voxelize(f, box{{0, 0, 0}, {0, 0, 0}}, 3));
  const auto nothing = voxelize(f, box{{4, 4, 4}, {5, 5, 5}}, 3);
  REQUIRE(nothing);
  CHECK(nothing->leaf_count() == 0);
}
