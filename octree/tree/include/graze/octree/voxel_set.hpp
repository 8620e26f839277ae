#pragma once
/// A set of voxels of one level, kept as a sparse tree whose node covers two octree levels at once:
/// what rays are sent through when all that matters is which voxels are occupied.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <cstdint>
#include <graze/octree/descent.hpp>
#include <graze/octree/voxel.hpp>
#include <span>
#include <vector>

namespace graze::octree {

/// Occupied octants of one level (1..20) of a root cube. A node holds the 4x4x4 octants two levels
/// below it as the bits of one word (bit x + 4 y + 16 z) and the index of its first child; where
/// the level is odd, the root node covers one level. Memory: 12 bytes a node; voxels take none.
class voxel_set {
public:
  static constexpr int max_set_level = 20;
  static constexpr std::size_t bytes_per_node = sizeof(std::uint64_t) + sizeof(std::uint32_t);

  /// The octants of root.level() with these indices, in any order; those named twice count once.
  /// Refuses a level above 20, an index outside 0 .. 2^level - 1, and 2^32 voxels or more.
  [[nodiscard]] static expected<voxel_set>
  make(const root_cube& root, std::span<const std::array<std::uint32_t, 3>> voxels);

  /// The octants of root.level() that a Tree holds. Refuses a level above 20 and 2^32 voxels.
  template <Tree T>
  [[nodiscard]] static expected<voxel_set> from_tree(const root_cube& root, const T& tree) {
    if (root.level() > max_set_level)
      return unexpected{"a voxel set has at most 20 levels"};
    std::vector<std::uint64_t> keys;
    gather(tree, tree.root(), root.root_octant(), {0, 0, 0}, root.level(), root.level(), keys);
    return from_keys(root, std::move(keys));
  }

  [[nodiscard]] const root_cube& root() const { return root_; }
  [[nodiscard]] int level() const { return root_.level(); }
  [[nodiscard]] std::size_t voxel_count() const { return voxels_; }
  [[nodiscard]] std::size_t node_count() const { return mask_.size(); }
  [[nodiscard]] std::size_t bytes() const { return node_count() * bytes_per_node; }
  /// The voxel's cube; exact.
  [[nodiscard]] cube octant(const voxel& v) const {
    return root_.octant({v.index(0), v.index(1), v.index(2)}, level());
  }

  /// Levels of nodes: a walk from the root to a voxel meets so many.
  [[nodiscard]] int depth() const { return (level() + 1) / 2; }
  /// Node 0 is the root. Bit b of its mask: the octant with x = b & 3, y = b >> 2 & 3, z = b >> 4.
  [[nodiscard]] const std::uint64_t* masks() const { return mask_.data(); }
  /// The node of its first octant that is there; at the last level, the rank of its first voxel.
  [[nodiscard]] const std::uint32_t* firsts() const { return first_.data(); }

private:
  explicit voxel_set(const root_cube& root) : root_(root) {}

  /// Six bits a node level, the root's foremost: sorted keys are the tree's order.
  static std::uint64_t key_of(const std::array<std::uint32_t, 3>& index, int level);
  static expected<voxel_set> from_keys(const root_cube& root, std::vector<std::uint64_t>&& keys);

  template <Tree T>
  static void gather(const T& tree, const typename T::node& node, const cube& cell,
                     const std::array<std::uint32_t, 3>& index, int levels_below, int level,
                     std::vector<std::uint64_t>& keys) {
    if (levels_below == 0) {
      keys.push_back(key_of(index, level));
      return;
    }
    const unsigned mask = tree.child_mask(node, cell, 0xff);
    for (unsigned i = 0; i < 8; ++i)
      if ((mask >> i & 1) != 0)
        gather(tree, tree.child(node, i), cell.child(i),
               {index[0] * 2 + (i & 1), index[1] * 2 + (i >> 1 & 1), index[2] * 2 + (i >> 2)},
               levels_below - 1, level, keys);
  }

  root_cube root_;
  std::size_t voxels_ = 0;
  std::vector<std::uint64_t> mask_;
  std::vector<std::uint32_t> first_;
};

} // namespace graze::octree
