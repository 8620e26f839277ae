#include "voxel_contestants.hpp"
#include "../fuzz/src/adapters/grid_walk.hpp"
#include "../fuzz/src/adapters/slab_tests.hpp"
#include "peers/mask_tree.hpp"
#include "peers/peers.hpp"
#include <ctime>
#include <graze/batch.hpp>
#include <graze/octree/exact.hpp>
#include <graze/octree/gargantini.hpp>
#include <graze/octree/plain.hpp>
#include <graze/octree/published.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>

namespace graze::bench {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

namespace {

using octree::convention;
using octree::cube;
using octree::exactness;
using octree::ray;
using rays = std::span<const ray>;

/// A traversal of one ray, `one(ray, voxels)`, as one of blocks of rays.
template <class One> auto each(One one) {
  return [one = std::move(one)](rays some, reported& out) {
    for (const ray& r : some) {
      const std::size_t before = out.voxels.size();
      one(r, out.voxels);
      out.counts.push_back(static_cast<std::uint32_t>(out.voxels.size() - before));
    }
  };
}

/// The sparse octree that every descent here goes through. Models octree::Tree.
class voxel_tree {
public:
  struct node {
    unsigned level;
    std::uint32_t at;
  };
  explicit voxel_tree(const voxel_grid& grid)
      : tree_(grid), box_(grid.root), level_(grid.level()) {}

  [[nodiscard]] static node root() { return {0, 0}; }
  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube&, std::uint8_t wanted) const {
    return static_cast<std::uint8_t>(tree_.mask(n.level, n.at) & wanted);
  }
  [[nodiscard]] node child(const node& n, unsigned i) const {
    return {n.level + 1, tree_.child(n.level, n.at, i)};
  }
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] const cube& box() const { return box_.box(); }
  /// Exact.
  [[nodiscard]] voxel_key key(const cube& voxel) const {
    voxel_index v{};
    for (unsigned a = 0; a < 3; ++a)
      v[a] = static_cast<std::uint32_t>((voxel.lo[a] - box().lo[a]) / voxel.size);
    return key_of(v);
  }

private:
  mask_tree tree_;
  octree::root_cube box_;
  int level_;
};
static_assert(octree::Tree<voxel_tree>);

using shared_tree = std::shared_ptr<const voxel_tree>;

/// One of octree's Methods; the rounding mode is set once a block of rays.
template <octree::Method M> auto descent(const shared_tree& tree) {
  return [tree](rays some, reported& out) {
    [[maybe_unused]] const typename M::scope in_mode;
    each([&](const ray& r, std::vector<voxel_key>& found) {
      octree::descend(M(r), tree->box(), tree->level(), *tree,
                      [&](const cube& c, const voxel_tree::node&, const auto&) {
                        found.push_back(tree->key(c));
                        return false;
                      });
    })(some, out);
  };
}

/// A ray/box test asked of a cell and, where it is hit, of its children, in the order of their
/// indices: what these tests are for. (Ours go front to back.)
template <class Test> struct box_descent {
  const voxel_tree& tree;
  const Test hits;
  std::vector<voxel_key>& found;

  void open(const cube& cell, const voxel_tree::node& n) const {
    if (!hits(cell.lo, {cell.hi(0), cell.hi(1), cell.hi(2)}))
      return;
    if (n.level == static_cast<unsigned>(tree.level())) {
      found.push_back(tree.key(cell));
      return;
    }
    for (unsigned mask = tree.child_mask(n, cell, 0xff); mask != 0; mask &= mask - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(mask));
      open(cell.child(i), tree.child(n, i));
    }
  }
};
template <class Test> auto by_boxes(const shared_tree& tree) {
  return each([tree](const ray& r, std::vector<voxel_key>& found) {
    box_descent<Test>{*tree, Test(r.origin(), r.direction()), found}.open(tree->box(), {0, 0});
  });
}

/// The whole grid, one bit a cell.
auto grid_walk(const voxel_grid& grid) {
  const int side = 1 << grid.level();
  const auto at = [level = grid.level()](std::size_t x, std::size_t y, std::size_t z) {
    return x + (y << level) + (z << (2 * level));
  };
  auto occupied = std::make_shared<std::vector<std::uint64_t>>(
      std::max(std::size_t{1}, at(0, 0, static_cast<std::size_t>(side)) / 64));
  for (const voxel_index& v : grid.voxels) {
    const std::size_t bit = at(v[0], v[1], v[2]);
    (*occupied)[bit / 64] |= std::uint64_t{1} << bit % 64;
  }
  const fuzz::cell_grid cells{grid.root.box().lo, grid.voxel_size(), {side, side, side}};
  return each([=](const ray& r, std::vector<voxel_key>& found) {
    fuzz::walk_grid(cells, r.origin(), r.direction(), [&](const std::array<int, 3>& cell) {
      const voxel_index v{static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]),
                          static_cast<std::uint32_t>(cell[2])};
      const std::size_t bit = at(v[0], v[1], v[2]);
      if (((*occupied)[bit / 64] >> bit % 64 & 1) != 0)
        found.push_back(key_of(v));
      return false;
    });
  });
}

auto lanes(const std::shared_ptr<const octree::voxel_set>& set, batch::path path, convention what,
           exactness how) {
  return [=](rays some, reported& out) {
    batch::force_path(path);
    const std::size_t before = out.counts.size();
    out.counts.resize(before + some.size());
    octree::visit_voxels(*set, some, what, how, {},
                         [&](std::size_t i, std::span<const octree::voxel> found) {
                           for (const octree::voxel& v : found)
                             out.voxels.push_back(v.packed);
                           out.counts[before + i] += static_cast<std::uint32_t>(found.size());
                         });
  };
}

/// Builds those that are wanted.
class maker {
public:
  explicit maker(const std::string& only) : only_(only) {}

  /// trace_of() builds; its time is noted.
  template <class Make>
  void add(const char* kind, const std::string& name, const std::string& traversal, Make&& trace_of,
           const std::string& path = {}) {
    if ((name + '\n' + traversal + '\n' + path).find(only_) == std::string::npos)
      return;
    const double start = cpu_seconds();
    contestant c{name, kind, traversal, path, 0, trace_of()};
    c.build_seconds = cpu_seconds() - start;
    all.push_back(std::move(c));
  }

  std::vector<contestant> all;

private:
  const std::string& only_;
};

void add_lanes(maker& to, const voxel_grid& grid) {
  const auto set = std::make_shared<const octree::voxel_set>(
      *octree::voxel_set::make(grid.root, std::span(grid.voxels)));
  struct variant {
    const char *name, *traversal;
    convention what;
    exactness how;
  };
  using enum convention;
  using enum exactness;
  for (const variant& v : {variant{"sound, owned", "lanes-sound", owned, conservative},
                           variant{"sound, closed", "lanes-sound-closed", closed, conservative},
                           variant{"exact, owned", "lanes-exact", owned, exact},
                           variant{"exact, closed", "lanes-exact-closed", closed, exact}})
    for (const batch::path p : {batch::path::avx512, batch::path::avx2, batch::path::baseline})
      if (!batch::refusal(p))
        to.add(
            "graze", std::string(v.name) + ", " + batch::name(p), v.traversal,
            [&] { return lanes(set, p, v.what, v.how); }, batch::name(p));
}

} // namespace

std::vector<contestant> contestants(const voxel_grid& grid, const std::string& only) {
  maker to(only);
  add_lanes(to, grid);
  const auto tree = std::make_shared<const voxel_tree>(grid);
  using up = rounding::upward;
  using enum convention;
  to.add("graze", "sound, owned, scalar", "sound",
         [&] { return descent<octree::sound<up, owned>>(tree); });
  to.add("graze", "sound, closed, scalar", "sound-closed",
         [&] { return descent<octree::sound<up, closed>>(tree); });
  to.add("graze", "exact, owned, scalar", "exact",
         [&] { return descent<octree::exact<up, owned>>(tree); });
  to.add("graze", "exact, closed, scalar", "exact-closed",
         [&] { return descent<octree::exact<up, closed>>(tree); });
  to.add("paper", "as published", "published", [&] { return descent<octree::published>(tree); });
  to.add("paper", "plain", "plain", [&] { return descent<octree::plain>(tree); });
  to.add("paper", "Gargantini", "gargantini", [&] { return descent<octree::gargantini>(tree); });
  to.add("published", "Amanatides-Woo", "amanatides-woo", [&] { return grid_walk(grid); });
  to.add("published", "Williams", "williams", [&] { return by_boxes<fuzz::williams_test>(tree); });
  to.add("published", "Ize", "ize", [&] { return by_boxes<fuzz::ize_test>(tree); });
  to.add("published", "Tavian", "tavian", [&] { return by_boxes<fuzz::tavian_test>(tree); });
  to.add("published", "pbrt", "pbrt", [&] { return by_boxes<fuzz::pbrt_test>(tree); });
  for_each_peer([&]<class Library>() {
    to.add(std::is_same_v<Library, revelles> ? "published" : "library", Library::name,
           Library::traversal, [&] {
             const auto p = std::make_shared<peer<Library>>(grid);
             return each([p](const ray& r, std::vector<voxel_key>& f) { p->occupied(r, f); });
           });
  });
  return std::move(to.all);
}

} // namespace graze::bench
