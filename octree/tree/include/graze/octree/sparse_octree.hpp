#pragma once
/// A sparse octree: a byte of child mask and one 32-bit index a node, a byte a leaf.
#include <graze/needs_cxx20.hpp>

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

  [[nodiscard]] const cube& root_octant() const { return cube_; }
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
  class assembly;

private:
  friend class builder;
  friend class assembly;
  explicit sparse_octree(const root_cube& root) : cube_(root.root_octant()), level_(root.level()) {}
  cube cube_;
  int level_;
  std::vector<std::uint8_t> mask_;
  std::vector<std::uint32_t> first_child_;
  std::vector<content> leaves_;
};

/// Fills an octree from its leaves upwards: siblings are added together, after what is below them.
/// Adding is always inlined and calls nothing but a function of the file that made the builder, so
/// that code compiled for instructions that not every machine has may add (batch/path.hpp).
class sparse_octree::builder {
public:
  struct inner {
    std::uint8_t mask;
    std::uint32_t first_child;
  };
  explicit builder(const root_cube& root) : tree_(root), more_(&enlarge) {}
  builder(const builder&) = delete;
  builder& operator=(const builder&) = delete;

  [[nodiscard, gnu::always_inline]] std::uint32_t next_node() const {
    return static_cast<std::uint32_t>(nodes_);
  }
  [[nodiscard, gnu::always_inline]] std::uint32_t next_leaf() const {
    return static_cast<std::uint32_t>(leaf_count_);
  }
  /// Indices are 32 bits wide: no room is left for eight more.
  [[nodiscard, gnu::always_inline]] bool full() const {
    constexpr std::size_t most = 0xffff'ffff - 8;
    return nodes_ > most || leaf_count_ > most;
  }
  /// At most eight siblings, unless it is full.
  [[gnu::always_inline]] void add(const inner* siblings, unsigned count) {
    if (nodes_ + 8 > most_nodes_) [[unlikely]]
      more_(*this);
    std::uint8_t* const masks = masks_ + nodes_;
    std::uint32_t* const first_children = first_children_ + nodes_;
    for (unsigned i = 0; i < count; ++i) {
      masks[i] = siblings[i].mask;
      first_children[i] = siblings[i].first_child;
    }
    nodes_ += count;
  }
  /// Those beyond their number are written over by the next, so that no branch depends on it.
  [[gnu::always_inline]] void add(const leaf_children& siblings) {
    if (leaf_count_ + 8 > most_leaves_) [[unlikely]]
      more_(*this);
    content* const to = leaves_ + leaf_count_;
    leaf_count_ += static_cast<unsigned>(__builtin_popcount(siblings.mask));
    if (siblings.mask == siblings.certified) [[likely]] {
      for (unsigned i = 0; i < 8; ++i)
        to[i] = content::certified;
      return;
    }
    unsigned count = 0;
    for (unsigned i = 0; i < 8; ++i) {
      to[count] = (siblings.certified >> i & 1) != 0 ? content::certified : content::possible;
      count += siblings.mask >> i & 1u;
    }
  }
  /// The root is added last.
  [[nodiscard]] sparse_octree finish(const inner& root) && {
    add(&root, 1);
    tree_.mask_.resize(nodes_);
    tree_.first_child_.resize(nodes_);
    tree_.leaves_.resize(leaf_count_);
    tree_.mask_.shrink_to_fit(); // what is kept is what bytes() says
    tree_.first_child_.shrink_to_fit();
    tree_.leaves_.shrink_to_fit();
    return std::move(tree_);
  }

private:
  friend class assembly;
  static void enlarge(builder& b) {
    constexpr std::size_t least = 1024;
    if (b.nodes_ + 8 > b.most_nodes_) {
      b.most_nodes_ = std::max(least, 2 * b.most_nodes_);
      b.tree_.mask_.resize(b.most_nodes_);
      b.tree_.first_child_.resize(b.most_nodes_);
    }
    if (b.leaf_count_ + 8 > b.most_leaves_) {
      b.most_leaves_ = std::max(least, 2 * b.most_leaves_);
      b.tree_.leaves_.resize(b.most_leaves_);
    }
    b.masks_ = b.tree_.mask_.data();
    b.first_children_ = b.tree_.first_child_.data();
    b.leaves_ = b.tree_.leaves_.data();
  }

  sparse_octree tree_;
  std::uint8_t* masks_ = nullptr;
  std::uint32_t* first_children_ = nullptr;
  content* leaves_ = nullptr;
  std::size_t nodes_ = 0, leaf_count_ = 0;       // written
  std::size_t most_nodes_ = 0, most_leaves_ = 0; // that there is room for
  void (*more_)(builder&);                       // makes room for at least eight more of each
};

/// An octree put together of parts that were built apart, by any number of builders.
class sparse_octree::assembly {
public:
  using inner = builder::inner;
  /// What is below one octant, its node `top`: a stretch of a builder's nodes and leaves.
  struct part {
    const builder* from = nullptr;
    inner top{};
    std::uint32_t first_node = 0, first_leaf = 0, nodes = 0, leaves = 0;
  };

  assembly(const root_cube& root, std::size_t nodes, std::size_t leaves) : tree_(root) {
    tree_.mask_.resize(nodes);
    tree_.first_child_.resize(nodes);
    tree_.leaves_.resize(leaves);
  }
  void set(std::size_t node, const inner& n) {
    tree_.mask_[node] = n.mask;
    tree_.first_child_[node] = n.first_child;
  }
  /// Copies a part, whose top is at `level`, behind the given numbers of nodes and leaves.
  /// Different places may be written at the same time.
  void place(const part& p, int level, std::uint32_t nodes_before, std::uint32_t leaves_before) {
    std::copy_n(p.from->masks_ + p.first_node, p.nodes, tree_.mask_.data() + nodes_before);
    std::copy_n(p.from->leaves_ + p.first_leaf, p.leaves, tree_.leaves_.data() + leaves_before);
    move_below(*p.from, p.top, level, nodes_before - p.first_node, leaves_before - p.first_leaf);
  }
  [[nodiscard]] sparse_octree finish() && { return std::move(tree_); }

private:
  /// Indices grow by the steps, modulo 2^32.
  void move_below(const builder& from, const inner& n, int level, std::uint32_t node_step,
                  std::uint32_t leaf_step) {
    if (level + 1 == tree_.level_)
      return;
    const bool above_leaves = level + 2 == tree_.level_;
    const auto count = static_cast<std::uint32_t>(std::popcount(n.mask));
    for (std::uint32_t i = n.first_child; i < n.first_child + count; ++i) {
      const std::uint32_t first = from.first_children_[i];
      tree_.first_child_[node_step + i] = first + (above_leaves ? leaf_step : node_step);
      if (!above_leaves)
        move_below(from, {from.masks_[i], first}, level + 1, node_step, leaf_step);
    }
  }

  sparse_octree tree_;
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
