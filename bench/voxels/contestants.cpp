#include "contestants.hpp"
#include "mask_tree.hpp"
#include <ctime>
#include <graze/batch.hpp>
#include <graze/octree/exact.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/upward.hpp>
#include <peers/library.hpp>
#include <peers/list.hpp>

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

/// A traversal of a ray, `trace_ray(ray, octants)`, as one of blocks of rays.
template <class Trace> auto ray_by_ray(Trace trace_ray) {
  return [trace_ray = std::move(trace_ray)](rays some, reported& out) {
    for (const ray& r : some) {
      const std::size_t before = out.octants.size();
      trace_ray(r, out.octants);
      out.counts.push_back(static_cast<std::uint32_t>(out.octants.size() - before));
    }
  };
}

/// The sparse octree that every descent here goes through. Models octree::Tree.
class octant_tree {
public:
  struct node {
    unsigned level;
    std::uint32_t at;
  };
  explicit octant_tree(const occupied_octants& octants)
      : tree_(octants), root_(octants.root), level_(octants.level), edge_(octants.edge()) {}

  [[nodiscard]] static node root() { return {0, 0}; }
  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube&, std::uint8_t wanted) const {
    return static_cast<std::uint8_t>(tree_.mask(n.level, n.at) & wanted);
  }
  [[nodiscard]] node child(const node& n, unsigned i) const {
    return {n.level + 1, tree_.child(n.level, n.at, i)};
  }
  [[nodiscard]] unsigned mask(const node& n) const { return tree_.mask(n.level, n.at); }
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] double edge() const { return edge_; }
  [[nodiscard]] const cube& root_box() const { return root_; }
  /// Exact.
  [[nodiscard]] octant_key key(const cube& octant) const {
    octant_index v{};
    for (unsigned a = 0; a < 3; ++a)
      v[a] = static_cast<std::uint32_t>((octant.lo[a] - root_.lo[a]) / octant.size);
    return peers::key_of(v);
  }

private:
  mask_tree tree_;
  cube root_;
  int level_;
  double edge_; ///< of an octant
};
static_assert(octree::Tree<octant_tree>);

using shared_tree = std::shared_ptr<const octant_tree>;

/// One of octree's Methods; the rounding mode is set once a block of rays.
template <octree::Method M> auto descent(const shared_tree& tree) {
  return [tree](rays some, reported& out) {
    [[maybe_unused]] const typename M::scope in_mode;
    ray_by_ray([&](const ray& r, std::vector<octant_key>& found) {
      octree::descend(M(r), tree->root_box(), tree->level(), *tree,
                      [&](const cube& c, const octant_tree::node&, const auto&) {
                        found.push_back(tree->key(c));
                        return false;
                      });
    })(some, out);
  };
}

/// A Method that can also hand over a cell's children one by one, of a cell that it asks for
/// mid-planes alone: without the list and the cubes of octree::descend.
template <class M>
concept ChildByChild = requires(const M method, const cube c, const typename M::state s) {
  method.for_each_child(c, s, [](unsigned, const typename M::state&) {});
};
template <ChildByChild M> struct child_descent {
  const octant_tree& tree;
  const M method;
  std::vector<octant_key>& found;

  struct cell {
    const octant_tree& tree;
    const octant_index& at;
    unsigned level;
    [[nodiscard]] double mid(int axis) const {
      const auto a = static_cast<unsigned>(axis);
      const double edges = static_cast<double>(1u << (tree.level() - static_cast<int>(level) - 1));
      return tree.root_box().lo[a] + (2.0 * at[a] + 1.0) * edges * tree.edge();
    }
  };

  /// Of a node above the last level; `at` is its place among those of its own.
  void open(const octant_tree::node& n, const octant_index& at, const typename M::state& s) const {
    const unsigned mask = tree.mask(n);
    const auto child = [&](unsigned i, const typename M::state& part) {
      if ((mask >> i & 1) == 0)
        return;
      const octant_index place{2 * at[0] + (i & 1), 2 * at[1] + (i >> 1 & 1), 2 * at[2] + (i >> 2)};
      if (n.level + 1 == static_cast<unsigned>(tree.level()))
        found.push_back(peers::key_of(place));
      else
        open(tree.child(n, i), place, part);
    };
    method.for_each_child(cell{tree, at, n.level}, s, child);
  }
};
template <ChildByChild M> auto child_by_child(const shared_tree& tree) {
  return ray_by_ray([tree](const ray& r, std::vector<octant_key>& found) {
    const child_descent<M> d{*tree, M(r), found};
    if (typename M::state s{}; d.method.enter(tree->root_box(), s))
      d.open({0, 0}, {0, 0, 0}, s);
  });
}

/// A ray/box test asked of a cell and, where it is hit, of its children, in the order of their
/// indices: what these tests are for. (Ours go front to back.)
template <class Test> struct box_descent {
  const octant_tree& tree;
  const Test hits;
  std::vector<octant_key>& found;

  void open(const cube& cell, const octant_tree::node& n) const {
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
template <peers::BoxTest Test> auto box_by_box(const shared_tree& tree) {
  return ray_by_ray([tree](const ray& r, std::vector<octant_key>& found) {
    box_descent<Test>{*tree, Test(r.origin(), r.direction()), found}.open(tree->root_box(), {0, 0});
  });
}

/// The whole grid, one bit a cell.
template <class Walk> auto cell_by_cell(const occupied_octants& octants) {
  const int side = 1 << octants.level;
  const auto at = [level = octants.level](std::size_t x, std::size_t y, std::size_t z) {
    return x + (y << level) + (z << (2 * level));
  };
  auto occupied = std::make_shared<std::vector<std::uint64_t>>(
      std::max(std::size_t{1}, at(0, 0, static_cast<std::size_t>(side)) / 64));
  for (const octant_index& v : octants.indices) {
    const std::size_t bit = at(v[0], v[1], v[2]);
    (*occupied)[bit / 64] |= std::uint64_t{1} << bit % 64;
  }
  const peers::cell_grid cells{octants.root.lo, octants.edge(), {side, side, side}};
  return ray_by_ray([=](const ray& r, std::vector<octant_key>& found) {
    Walk::walk(cells, r.origin(), r.direction(), [&](const std::array<int, 3>& cell) {
      const octant_index v{static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]),
                           static_cast<std::uint32_t>(cell[2])};
      const std::size_t bit = at(v[0], v[1], v[2]);
      if (((*occupied)[bit / 64] >> bit % 64 & 1) != 0)
        found.push_back(peers::key_of(v));
      return false;
    });
  });
}

auto lane_walk(const std::shared_ptr<const octree::voxel_set>& set, batch::path path,
               convention rule, exactness certainty) {
  return [=](rays some, reported& out) {
    batch::force_path(path);
    const std::size_t before = out.counts.size();
    out.counts.resize(before + some.size());
    octree::visit_voxels(*set, some, rule, certainty, {},
                         [&](std::size_t i, std::span<const octree::voxel> found) {
                           for (const octree::voxel& v : found)
                             out.octants.push_back(v.packed);
                           out.counts[before + i] += static_cast<std::uint32_t>(found.size());
                         });
  };
}

/// Builds those that are wanted.
class maker {
public:
  explicit maker(const std::string& only) : only_(only) {}

  /// make_trace() builds; its time is noted.
  template <class Make>
  void add(const char* kind, const std::string& name, const std::string& traversal,
           Make&& make_trace, const std::string& path = {}) {
    if ((name + '\n' + traversal + '\n' + path).find(only_) == std::string::npos)
      return;
    const double start = cpu_seconds();
    contestant c{name, kind, traversal, path, 0, make_trace()};
    c.build_seconds = cpu_seconds() - start;
    all.push_back(std::move(c));
  }

  std::vector<contestant> all;

private:
  const std::string& only_;
};

void add_lanes(maker& to, const occupied_octants& octants) {
  const auto set = std::make_shared<const octree::voxel_set>(*octree::voxel_set::make(
      *octree::root_cube::make(octants.root, octants.level), std::span(octants.indices)));
  struct variant {
    const char *name, *traversal;
    convention rule;
    exactness certainty;
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
            [&] { return lane_walk(set, p, v.rule, v.certainty); }, batch::name(p));
  // the same planes, loaded: as doubles, and as real numbers
  const double edge = octants.edge();
  const std::uint32_t side = 1u << octants.level;
  for (const auto& [rule, name] : {std::pair(octree::plane_rule::rounded, "grid of doubles"),
                                   std::pair(octree::plane_rule::exact, "grid of real numbers")}) {
    const auto grid =
        octree::grid::make(octants.root.lo, {edge, edge, edge}, {side, side, side}, rule);
    const auto over_grid = std::make_shared<const octree::voxel_set>(
        *octree::voxel_set::make(*grid, std::span(octants.indices)));
    for (const batch::path p : {batch::path::avx512, batch::path::avx2, batch::path::baseline})
      if (!batch::refusal(p))
        to.add(
            "graze", std::string("exact, closed, ") + name + ", " + batch::name(p),
            "lanes-exact-closed-grid", [&] { return lane_walk(over_grid, p, closed, exact); },
            batch::name(p));
  }
}

/// What drives a traversal from a paper, by what it is (peers/list.hpp).
template <class Peer> auto driven(const occupied_octants& octants, const shared_tree& tree) {
  if constexpr (ChildByChild<Peer>)
    return child_by_child<Peer>(tree);
  else if constexpr (octree::Method<Peer>)
    return descent<Peer>(tree);
  else if constexpr (peers::BoxTest<Peer>)
    return box_by_box<Peer>(tree);
  else
    return cell_by_cell<Peer>(octants);
}
template <class... Peer>
void add_peers(maker& to, const char* kind, peers::list<Peer...>, const occupied_octants& octants,
               const shared_tree& tree) {
  (to.add(kind, Peer::title, Peer::name, [&] { return driven<Peer>(octants, tree); }), ...);
}

} // namespace

std::vector<contestant> contestants(const occupied_octants& octants, const std::string& only) {
  maker to(only);
  add_lanes(to, octants);
  const auto tree = std::make_shared<const octant_tree>(octants);
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
  add_peers(to, "paper", peers::paper2005{}, octants, tree);
  add_peers(to, "published", peers::papers{}, octants, tree);
  for (const peers::library& library : peers::libraries())
    for (const peers::variant& v : library.variants)
      if (v.in_benchmarks == peers::timed::yes)
        to.add("library", v.title, v.name, [&] {
          std::shared_ptr<peers::structure> built = v.build(octants);
          return ray_by_ray(
              [built = std::move(built)](const ray& r, std::vector<octant_key>& found) {
                built->visit(r, found);
              });
        });
  return std::move(to.all);
}

} // namespace graze::bench
