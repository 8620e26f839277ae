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
  class room;

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

/// A builder's arrays, for code that writes in place and calls no function of the library but
/// `more`: what is compiled for instructions that not every machine has. As the builder, siblings
/// are written together, after what is below them.
class sparse_octree::room {
public:
  std::uint8_t* masks = nullptr;
  std::uint32_t* first_children = nullptr;
  content* leaves = nullptr;
  std::size_t nodes = 0, leaf_count = 0; ///< written
  std::size_t most_nodes = 0, most_leaves = 0;
  void (*more)(room&); ///< makes room for at least eight more of each
  bool overflowed = false;

  explicit room(const root_cube& root) : more(&enlarge), tree_(sparse_octree(root)) {
    enlarge(*this);
  }
  room(const room&) = delete;
  room& operator=(const room&) = delete;

  /// The root is the last node.
  [[nodiscard]] sparse_octree finish(const builder::inner& root) && {
    tree_.mask_.resize(nodes);
    tree_.first_child_.resize(nodes);
    tree_.leaves_.resize(leaf_count);
    tree_.mask_.push_back(root.mask);
    tree_.first_child_.push_back(root.first_child);
    return std::move(tree_);
  }

private:
  static void enlarge(room& r) {
    constexpr std::size_t least = 1024;
    if (r.nodes + 8 > r.most_nodes) {
      r.most_nodes = std::max(least, 2 * r.most_nodes);
      r.tree_.mask_.resize(r.most_nodes);
      r.tree_.first_child_.resize(r.most_nodes);
    }
    if (r.leaf_count + 8 > r.most_leaves) {
      r.most_leaves = std::max(least, 2 * r.most_leaves);
      r.tree_.leaves_.resize(r.most_leaves);
    }
    r.masks = r.tree_.mask_.data();
    r.first_children = r.tree_.first_child_.data();
    r.leaves = r.tree_.leaves_.data();
  }
  sparse_octree tree_;
};

} // namespace graze::octree
