#include "mask_tree.hpp"
#include "peers.hpp"
#include <graze/octree/revelles.hpp>

namespace graze::bench {
namespace {

/// One ray's recursion (proc_subtree) over the sparse tree.
struct walk {
  const mask_tree& tree;
  const octree::revelles method;
  const octree::vec3 corner;
  const double voxel;
  const unsigned levels;
  std::vector<voxel_key>& found;

  /// What the method asks of a cell; told only for an axis on which the ray does not move.
  struct cell {
    const walk& in;
    const voxel_index& at;
    unsigned level;
    [[nodiscard]] double mid(int axis) const {
      const auto a = static_cast<unsigned>(axis);
      const double voxels = static_cast<double>(1u << (in.levels - level - 1));
      return in.corner[a] + (2.0 * at[a] + 1.0) * voxels * in.voxel;
    }
  };

  /// `at` is the node's position in nodes of its level.
  void visit(unsigned level, std::uint32_t node, const voxel_index& at,
             const octree::revelles::state& times) const {
    if (level == levels) {
      found.push_back(key_of(at));
      return;
    }
    const std::uint32_t mask = tree.mask(level, node);
    method.for_each_child(
        cell{*this, at, level}, times, [&](unsigned i, const octree::revelles::state& part) {
          if ((mask >> i & 1) != 0)
            visit(level + 1, level + 1 == levels ? 0 : tree.child(level, node, i),
                  {2 * at[0] + (i & 1), 2 * at[1] + (i >> 1 & 1), 2 * at[2] + (i >> 2)}, part);
        });
  }
};

} // namespace

template <> struct peer<revelles>::structure {
  explicit structure(const voxel_grid& grid)
      : tree(grid), root(grid.root.box()), voxel(grid.voxel_size()),
        levels(static_cast<unsigned>(grid.level())) {}
  mask_tree tree;
  octree::cube root;
  double voxel;
  unsigned levels;
};

template <>
peer<revelles>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<revelles>::~peer() = default;

template <> void peer<revelles>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  const structure& s = *structure_;
  if (s.tree.empty())
    return;
  const walk w{s.tree, octree::revelles(r), s.root.lo, s.voxel, s.levels, found};
  if (octree::revelles::state times{}; w.method.enter(s.root, times))
    w.visit(0, 0, {0, 0, 0}, times);
}

template <> std::optional<octree::ray> peer<revelles>::received(const octree::ray& r) const {
  return r;
}

} // namespace graze::bench
