// A user's own tree: the walk against the oracle at levels to 53, and examples of the interface.
#include "adversarial.hpp"
#include <catch2/catch.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/tree_rays.hpp>
#include <graze/octree/voxelizer.hpp>

using namespace graze;
using namespace graze::interface_tests;

namespace {

template <convention C, exactness E>
std::vector<fuzz::octant_number> walk(const fuzz::trial& t, const root_cube& root, const ray& r) {
  const fuzz::block_tree tree(t);
  std::vector<fuzz::octant_number> found;
  tree_walk<fuzz::block_tree, C, E> w(tree, root, t.level, r);
  for (const auto& met : w)
    found.push_back(tree.octant_of(met.node));
  return found;
}
fuzz::octant_set set_of(const std::vector<fuzz::octant_number>& v) {
  fuzz::octant_set s = 0;
  for (const fuzz::octant_number x : v)
    s |= fuzz::octant_set{1} << x;
  return s;
}

} // namespace

TEST_CASE("octree.tree_rays: exact walks report what the oracle does, at any level",
          "[mpfr][property]") {
  for (const fuzz::generator& g : fuzz::generators())
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const int level = 1 + static_cast<int>(i % 53);
      const fuzz::trial t = fuzz::make_trial(g, 9, i, level);
      const fuzz::truth is = fuzz::truth_of(t);
      const ray r = *ray::make(t.origin, t.direction);
      const root_cube root = *root_cube::make(t.root, level);
      INFO(g.name << " " << i);
      using enum convention;
      REQUIRE(set_of(walk<closed, exactness::exact>(t, root, r)) == is.touched);
      REQUIRE((is.touched & ~set_of(walk<closed, exactness::conservative>(t, root, r))) == 0);
      REQUIRE((is.owned & ~set_of(walk<owned, exactness::conservative>(t, root, r))) == 0);
      const auto in_order = walk<owned, exactness::exact>(t, root, r);
      REQUIRE(in_order == std::vector<fuzz::octant_number>(is.owner_order.begin(),
                                                           is.owner_order.begin() + is.owners));
      const auto first = first_cell(fuzz::block_tree(t), root, level, r);
      REQUIRE(first.has_value() == (is.owners != 0));
    }
}

namespace {
/// A user's octree: pointers.
struct my_node {
  std::array<std::unique_ptr<my_node>, 8> children;
  int payload = 0;
};
/// What the interface needs of it.
struct my_tree {
  using node = const my_node*;
  const my_node* top;
  [[nodiscard]] node root() const { return top; }
  [[nodiscard]] std::uint8_t child_mask(node n, const cube&, std::uint8_t wanted) const {
    unsigned there = 0;
    for (unsigned i = 0; i < 8; ++i)
      there |= (n->children[i] ? 1u : 0u) << i;
    return static_cast<std::uint8_t>(there & wanted);
  }
  [[nodiscard]] node child(node n, unsigned i) const { return n->children[i].get(); }
};
static_assert(Tree<my_tree>);
} // namespace

TEST_CASE("octree.tree_rays: examples", "[unit]") {
  // [docs/traversal.md shows these lines]
  my_node top;
  for (const unsigned i : {0u, 7u}) {
    top.children[i] = std::make_unique<my_node>();
    top.children[i]->payload = static_cast<int>(i) + 1;
  }
  const my_tree tree{&top};
  const root_cube root = *root_cube::make({{0, 0, 0}, 1}, 1);
  const ray r = *ray::make({-1, -1, -1}, {1, 1, 1});

  std::vector<int> met;
  tree_walk walk(tree, root, 1, r);
  for (const auto& [cell, node] : walk)
    met.push_back(node->payload);
  CHECK(met == std::vector<int>{1, 8});
  CHECK(first_cell(tree, root, 1, r)->node->payload == 1);

  const ray_segment later = *ray_segment::make(1.6, 2);
  CHECK(first_cell(tree, root, 1, r, later)->node->payload == 8);

  int calls = 0;
  CHECK(
      visit_cells(tree, root, 1, r, {}, [&](const cube&, const my_node*) { return ++calls == 1; }));
  const std::vector<ray> rays{r, *ray::make({0.25, 0.25, 3}, {0, 0, -1})};
  std::vector<int> sums(rays.size());
  visit_cells(tree, root, 1, std::span<const ray>(rays), {},
              [&](std::size_t i, const cube&, const my_node* n) {
                sums[i] += n->payload;
                return false;
              });
  CHECK(sums == std::vector<int>{9, 1});

  // made a voxel set, for speed
  const voxel_set set = *voxel_set::from_tree(root, tree);
  CHECK(set.voxel_count() == 2);
  CHECK(first_voxel(set, r, exactness::exact, later)->rank == 1);
}

TEST_CASE("octree.tree_rays: a sparse octree and its voxel set give the same", "[unit]") {
  const auto tree = *voxelize(tanglecube{}, box{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}}, 5);
  const root_cube root = *root_cube::make(tree.root_octant(), 5);
  const voxel_set set = *voxel_set::from_tree(root, tree);
  CHECK(set.voxel_count() == tree.leaf_count());
  fuzz::random_stream random(1, 1);
  std::size_t visits = 0;
  for (int i = 0; i < 500; ++i) {
    const auto x = [&] { return std::ldexp(static_cast<double>(random.bits(53)), -50) - 4; };
    const ray r = *ray::make({x(), x(), x()}, {x(), x(), x()});
    std::vector<cube> by_tree, by_set;
    visit_cells(tree, root, 5, r, {}, [&](const cube& c, std::uint32_t) {
      by_tree.push_back(c);
      return false;
    });
    visit_voxels(set, r, convention::owned, exactness::exact, {}, [&](const voxel& v) {
      by_set.push_back(set.octant(v));
      return false;
    });
    REQUIRE(by_tree == by_set);
    visits += by_tree.size();
  }
  CHECK(visits > 1000);
}
