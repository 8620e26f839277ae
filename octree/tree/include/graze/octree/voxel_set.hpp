#pragma once
/// A set of voxels, of one level of a root cube or of a grid, kept as a sparse tree whose node covers two octree levels at once:
/// what rays are sent through when all that matters is which voxels are occupied.
#include <graze/needs_cxx20.hpp>

#include <bit>
#include <cassert>
#include <cstdint>
#include <graze/octree/descent.hpp>
#include <graze/octree/grid.hpp>
#include <graze/octree/voxel.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace graze::octree {

/// Occupied octants of one level (1..20) of a root cube, or voxels of a grid, whose indices are
/// padded to those of the level that holds them all. A node holds the 4x4x4 octants two levels
/// below it as the bits of one word (bit x + 4 y + 16 z) and the index of its first child; where
/// the level is odd, the root node covers one level. Memory: 12 bytes a node; voxels take none; over
/// a grid its planes once more, and a third of them again.
class voxel_set {
public:
  static constexpr int max_set_level = 20;
  static constexpr std::size_t bytes_per_node = sizeof(std::uint64_t) + sizeof(std::uint32_t);

  /// The octants of root.level() with these indices, in any order; those named twice count once.
  /// Refuses a level above 20, an index outside 0 .. 2^level - 1, and 2^32 voxels or more.
  [[nodiscard]] static expected<voxel_set>
  make(const root_cube& root, std::span<const std::array<std::uint32_t, 3>> voxels);

  /// The voxels of a grid with these indices, likewise.
  [[nodiscard]] static expected<voxel_set>
  make(const grid& planes, std::span<const std::array<std::uint32_t, 3>> voxels);

  /// The octants of root.level() that a Tree holds. Refuses a level above 20 and 2^32 voxels.
  template <Tree T>
  [[nodiscard]] static expected<voxel_set> from_tree(const root_cube& root, const T& tree) {
    if (root.level() > max_set_level)
      return unexpected{"a voxel set has at most 20 levels"};
    std::vector<std::uint64_t> keys;
    gather(tree, tree.root(), root.root_octant(), {0, 0, 0}, root.level(), root.level(), keys);
    voxel_set set(root);
    if (std::string why = set.take(std::move(keys)); !why.empty())
      return unexpected{std::move(why)};
    return set;
  }

  /// Of a set of octants.
  [[nodiscard]] const root_cube& root() const { return assert(root_), *root_; }
  /// Of a set over a grid; null for octants.
  [[nodiscard]] const grid* planes() const { return grid_ ? &*grid_ : nullptr; }
  /// Indices are below 2^level.
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] std::size_t voxel_count() const { return voxels_; }
  [[nodiscard]] std::size_t node_count() const { return mask_.size(); }
  /// Of the tree, and of the planes where they are loaded.
  [[nodiscard]] std::size_t bytes() const {
    return node_count() * bytes_per_node + (tables_ ? tables_->size() * sizeof(double) : 0);
  }
  /// The voxel's cube; exact. Of a set of octants.
  [[nodiscard]] cube octant(const voxel& v) const {
    return root().octant({v.index(0), v.index(1), v.index(2)}, level());
  }
  /// What the voxel lies between, for exact_line.hpp; of any set.
  [[nodiscard]] slabs cell(const voxel& v) const;

  /// Levels of nodes: a walk from the root to a voxel meets so many.
  [[nodiscard]] int depth() const { return (level() + 1) / 2; }
  /// Node 0 is the root. Bit b of its mask: the octant with x = b & 3, y = b >> 2 & 3, z = b >> 4.
  [[nodiscard]] const std::uint64_t* masks() const { return mask_.data(); }
  /// The node of its first octant that is there; at the last level, the rank of its first voxel.
  [[nodiscard]] const std::uint32_t* firsts() const { return first_.data(); }

  /// Over a grid: doubles not above, and not below, the planes of the octants of nodes `depth` below
  /// the root, along an axis. Planes past the last are the last again.
  [[nodiscard]] const double* lower_planes(unsigned depth, unsigned axis) const {
    return tables_->data() + place_[depth][axis];
  }
  [[nodiscard]] const double* upper_planes(unsigned depth, unsigned axis) const {
    return lower_planes(depth, axis) + upper_after_;
  }

private:
  explicit voxel_set(const root_cube& root) : root_(root), level_(root.level()) {}
  explicit voxel_set(const grid& planes);

  /// Six bits a node level, the root's foremost: sorted keys are the tree's order.
  static std::uint64_t key_of(const std::array<std::uint32_t, 3>& index, int level);
  expected<voxel_set> with(std::span<const std::array<std::uint32_t, 3>> voxels,
                           const char* whole) &&;
  [[nodiscard]] slabs octant_cell(const voxel& v) const;
  /// Makes the tree; why it cannot, if so.
  std::string take(std::vector<std::uint64_t>&& keys);

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

  std::optional<root_cube> root_; ///< or else grid_
  std::optional<grid> grid_;
  int level_;
  std::shared_ptr<const std::vector<double>> tables_; ///< of planes; copies share them
  std::array<std::array<std::size_t, 3>, max_set_level / 2> place_{};
  std::size_t upper_after_ = 0; ///< from a table of lower ones to that of upper ones
  std::size_t voxels_ = 0;
  std::vector<std::uint64_t> mask_;
  std::vector<std::uint32_t> first_;
};

} // namespace graze::octree
