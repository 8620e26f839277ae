#pragma once
/// A sparse octree: a byte of child mask and one 32-bit index a node, a byte a leaf.
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <graze/octree/inclusion.hpp>
#include <utility>
#include <vector>

namespace graze::octree {

/// Octants of levels 0..level that are not empty. The children that a node has are contiguous, so
/// its mask and the index of its first child find them all; at the last level a leaf's content is
/// kept instead. Models Tree. Memory: 5 bytes a node above the last level, 1 byte a leaf.
class sparse_octree {
public:
  using node = std::uint32_t;
  static constexpr std::size_t bytes_per_node = sizeof(std::uint8_t) + sizeof(std::uint32_t);
  static constexpr std::size_t bytes_per_leaf = sizeof(content);

  [[nodiscard]] const cube& box() const { return box_; }
  [[nodiscard]] int level() const { return level_; }

  [[nodiscard]] node root() const { return static_cast<node>(mask_.size()) - 1; }
  [[nodiscard]] std::uint8_t child_mask(node n, const cube&, std::uint8_t wanted) const {
    return mask_[n] & wanted;
  }
  /// The child with `index`, which child_mask must have shown to be there.
  [[nodiscard]] node child(node n, unsigned index) const {
    const unsigned before = mask_[n] & ((1u << index) - 1u);
    return first_child_[n] + static_cast<node>(std::popcount(before));
  }
  /// What is proven about a node of the last level.
  [[nodiscard]] content leaf(node n) const { return leaves_[n]; }

  [[nodiscard]] std::size_t node_count() const { return mask_.size(); }
  [[nodiscard]] std::size_t leaf_count() const { return leaves_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return node_count() * bytes_per_node + leaf_count() * bytes_per_leaf;
  }

  class builder;

private:
  explicit sparse_octree(const root_cube& root) : box_(root.box()), level_(root.level()) {}
  cube box_;
  int level_;
  std::vector<std::uint8_t> mask_;
  std::vector<std::uint32_t> first_child_;
  std::vector<content> leaves_;
};

/// Fills an octree from its leaves upwards. Siblings are added together, after what is below them.
class sparse_octree::builder {
public:
  struct inner {
    std::uint8_t mask;
    std::uint32_t first_child;
  };
  explicit builder(const root_cube& root) : tree_(root) {}

  [[nodiscard]] std::uint32_t next_node() const {
    return static_cast<std::uint32_t>(tree_.mask_.size());
  }
  [[nodiscard]] std::uint32_t next_leaf() const {
    return static_cast<std::uint32_t>(tree_.leaves_.size());
  }
  /// Indices are 32 bits wide: no room is left for eight more.
  [[nodiscard]] bool full() const {
    constexpr std::size_t most = 0xffff'ffff - 8;
    return tree_.mask_.size() > most || tree_.leaves_.size() > most;
  }
  void add(const inner& n) {
    tree_.mask_.push_back(n.mask);
    tree_.first_child_.push_back(n.first_child);
  }
  void add(content leaf) { tree_.leaves_.push_back(leaf); }
  /// The root is added last.
  [[nodiscard]] sparse_octree finish(const inner& root) && {
    add(root);
    return std::move(tree_);
  }

private:
  sparse_octree tree_;
};

} // namespace graze::octree
