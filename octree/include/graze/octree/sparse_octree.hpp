#pragma once
/// A sparse octree: a byte of child mask and one 32-bit index a node, a byte a leaf.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <graze/octree/children.hpp>
#include <graze/octree/cube.hpp>
#include <span>
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

  /// The arrays, in post-order: what is below a node comes before the group of its siblings, the
  /// root is last. The index of a node above its last level is among the nodes, of others among the
  /// leaves. The same leaves give the same arrays.
  [[nodiscard]] std::span<const std::uint8_t> masks() const { return mask_; }
  [[nodiscard]] std::span<const std::uint32_t> first_children() const { return first_child_; }
  [[nodiscard]] std::span<const content> leaves() const { return leaves_; }

  /// An octree of arrays that come from elsewhere. Refuses, in time proportional to their size,
  /// whatever is not the arrays of an octree: sizes that differ, an index out of range, shared or
  /// missing nodes, cycles, an order other than the one above, a node or a leaf without content.
  [[nodiscard]] static expected<sparse_octree>
  from_arrays(const root_cube& root, std::vector<std::uint8_t> masks,
              std::vector<std::uint32_t> first_children, std::vector<content> leaves);

  friend bool operator==(const sparse_octree&, const sparse_octree&) = default;

  class builder;

private:
  friend class builder;
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
  [[nodiscard]] std::uint32_t next_leaf() const { return static_cast<std::uint32_t>(leaf_count_); }
  /// Indices are 32 bits wide: no room is left for eight more.
  [[nodiscard]] bool full() const {
    constexpr std::size_t most = 0xffff'ffff - 8;
    return tree_.mask_.size() > most || leaf_count_ > most;
  }
  void add(const inner& n) {
    tree_.mask_.push_back(n.mask);
    tree_.first_child_.push_back(n.first_child);
  }
  /// Leaves beyond their number are room to write to, so that no branch depends on the mask.
  void add(const leaf_children& siblings) {
    if (tree_.leaves_.size() < leaf_count_ + 8) [[unlikely]]
      tree_.leaves_.resize(2 * leaf_count_ + 64);
    content* to = tree_.leaves_.data() + leaf_count_;
    unsigned count = 0;
    for (unsigned i = 0; i < 8; ++i) { // the next child overwrites one that is not kept
      to[count] = static_cast<content>(1 + (siblings.certified >> i & 1));
      count += siblings.mask >> i & 1u;
    }
    leaf_count_ += count;
  }
  /// The root is added last.
  [[nodiscard]] sparse_octree finish(const inner& root) && {
    add(root);
    tree_.leaves_.resize(leaf_count_);
    tree_.mask_.shrink_to_fit(); // what is kept is what bytes() says
    tree_.first_child_.shrink_to_fit();
    tree_.leaves_.shrink_to_fit();
    return std::move(tree_);
  }

  // For parts that are built apart (parallel_voxelizer.hpp).

  /// Makes room: afterwards the arrays have these sizes, and set, place write them.
  void resize(std::size_t nodes, std::size_t leaves) {
    tree_.mask_.resize(nodes);
    tree_.first_child_.resize(nodes);
    tree_.leaves_.resize(leaves);
    leaf_count_ = leaves;
  }
  void set(std::size_t node, const inner& n) {
    tree_.mask_[node] = n.mask;
    tree_.first_child_[node] = n.first_child;
  }
  /// Copies what is below `top`, a node at `level` in `part`, behind the given numbers of nodes and
  /// leaves. Different places may be written at the same time.
  void place(const builder& part, const inner& top, int level, std::uint32_t nodes_before,
             std::uint32_t leaves_before) {
    std::copy(part.tree_.mask_.begin(), part.tree_.mask_.end(), tree_.mask_.begin() + nodes_before);
    std::copy_n(part.tree_.leaves_.begin(), part.leaf_count_,
                tree_.leaves_.begin() + leaves_before);
    place_below(part, top, level, nodes_before, leaves_before);
  }
  /// The finished octree after resize, set and place.
  [[nodiscard]] sparse_octree finish() && { return std::move(tree_); }

private:
  void place_below(const builder& part, const inner& n, int level, std::uint32_t nodes_before,
                   std::uint32_t leaves_before) {
    if (level + 1 == tree_.level_)
      return;
    const bool above_leaves = level + 2 == tree_.level_;
    const auto count = static_cast<std::uint32_t>(std::popcount(n.mask));
    for (std::uint32_t i = n.first_child; i < n.first_child + count; ++i) {
      const std::uint32_t first = part.tree_.first_child_[i];
      tree_.first_child_[nodes_before + i] = first + (above_leaves ? leaves_before : nodes_before);
      if (!above_leaves)
        place_below(part, {part.tree_.mask_[i], first}, level + 1, nodes_before, leaves_before);
    }
  }

  sparse_octree tree_;
  std::size_t leaf_count_ = 0;
};

namespace detail {
/// Follows the order in which a builder adds nodes. The counters only grow, and what does not fit
/// them ends it, so that each node is seen at most once.
struct octree_order {
  std::span<const std::uint8_t> masks;
  std::span<const std::uint32_t> first_children;
  std::size_t leaf_count;
  int level;
  std::size_t nodes = 0, leaves = 0;

  bool follow(std::size_t node, int depth) {
    const auto count = static_cast<std::size_t>(std::popcount(masks[node]));
    const std::size_t first = first_children[node];
    if (depth + 1 == level) {
      if (first != leaves || count > leaf_count - leaves)
        return false;
      leaves += count;
      return true;
    }
    if (first > node || count > node - first) // also ends every cycle
      return false;
    for (std::size_t i = first; i < first + count; ++i)
      if (masks[i] == 0 || !follow(i, depth + 1))
        return false;
    if (first != nodes)
      return false;
    nodes += count;
    return true;
  }
};
} // namespace detail

inline expected<sparse_octree> sparse_octree::from_arrays(const root_cube& root,
                                                          std::vector<std::uint8_t> masks,
                                                          std::vector<std::uint32_t> first_children,
                                                          std::vector<content> leaves) {
  constexpr std::size_t most = 0xffff'ffff;
  if (masks.empty() || masks.size() != first_children.size())
    return unexpected{"the octree's arrays are not of one size"};
  if (masks.size() > most || leaves.size() > most)
    return unexpected{"the octree has more than 2^32 nodes"};
  for (const content c : leaves)
    if (c != content::possible && c != content::certified)
      return unexpected{"a leaf of the octree has no content"};
  detail::octree_order order{masks, first_children, leaves.size(), root.level()};
  if (!order.follow(masks.size() - 1, 0) || order.nodes + 1 != masks.size() ||
      order.leaves != leaves.size())
    return unexpected{"the octree's indices do not make an octree"};
  sparse_octree r(root);
  r.mask_ = std::move(masks);
  r.first_child_ = std::move(first_children);
  r.leaves_ = std::move(leaves);
  return r;
}

} // namespace graze::octree
