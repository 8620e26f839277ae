#pragma once
/// Descent of a ray through an octree. A Method says which children the ray passes, in order; a
/// Tree says which children there are; the visitor gets the cells that are left at the last level.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <utility>

namespace graze::octree {

/// A child that the ray passes: its index and what the Method carries down for it.
template <class State> struct branch {
  unsigned index;
  State state;
};

/// The children that a ray passes, in the order in which they are to be visited.
template <class State> class branches {
public:
  void clear() { count_ = 0; }
  void push(unsigned index, const State& state) { items_[count_++] = {index, state}; }
  [[nodiscard]] unsigned size() const { return count_; }
  [[nodiscard]] const branch<State>& operator[](unsigned i) const { return items_[i]; }
  /// Bit `index` is set for each child present.
  [[nodiscard]] std::uint8_t mask() const {
    unsigned bits = 0;
    for (unsigned i = 0; i < count_; ++i)
      bits |= 1u << items_[i].index;
    return static_cast<std::uint8_t>(bits);
  }

private:
  std::array<branch<State>, 8> items_;
  unsigned count_ = 0;
};

namespace detail {
struct reordered_masks {
  std::uint8_t mask[8][256];
};
consteval reordered_masks make_reordered_masks() {
  reordered_masks r{};
  for (unsigned flip = 0; flip < 8; ++flip)
    for (unsigned mask = 0; mask < 256; ++mask)
      for (unsigned i = 0; i < 8; ++i)
        if ((mask >> i & 1) != 0)
          r.mask[flip][mask] = static_cast<std::uint8_t>(r.mask[flip][mask] | 1u << (i ^ flip));
  return r;
}
inline constexpr reordered_masks masks_reordered = make_reordered_masks();
} // namespace detail

/// Bit i of the mask (below 256) becomes bit i XOR flip (below 8).
[[gnu::always_inline]] inline unsigned reordered(unsigned mask, unsigned flip) {
  return detail::masks_reordered.mask[flip][mask];
}

/// How a prepared ray goes from a cell to its children.
/// enter(root, state): whether it passes the root at all. split(cell, state): the children passed.
template <class M>
concept Method = requires(const M method, const cube cell, typename M::state state,
                          branches<typename M::state>& out) {
  typename M::scope; ///< the rounding scope in which enter and split may be called
  { method.enter(cell, state) } -> std::same_as<bool>;
  method.split(cell, state, out);
};

/// An octree of any make. `child_mask(node, cell, wanted)` gives those of the wanted children that
/// are there (a tree of evaluated surfaces need not look at the others).
template <class T>
concept Tree = requires(const T tree, typename T::node node, const cube cell) {
  { tree.root() } -> std::convertible_to<typename T::node>;
  { tree.child_mask(node, cell, std::uint8_t{}) } -> std::convertible_to<std::uint8_t>;
  { tree.child(node, unsigned{}) } -> std::convertible_to<typename T::node>;
};

/// The way from a node to its first descendant that has several children, or to the last level:
/// `levels` steps, each to the only child. The index of the first child on it has the bits
/// `levels - 1` of `index`, that of the next the bits below, and so on.
template <class Node> struct only_way {
  Node end;
  int levels;
  std::array<std::uint64_t, 3> index;

  /// The child on the way of the node that is `left` levels above the end, left > 0.
  [[nodiscard, gnu::always_inline]] unsigned child(int left) const {
    const int bit = left - 1;
    return static_cast<unsigned>((index[0] >> bit & 1) | (index[1] >> bit & 1) << 1 |
                                 (index[2] >> bit & 1) << 2);
  }
};

/// Whether a descent can go child by child: the tree knows where it has but one child (`only_way
/// way_from(node)`), and the method can be asked about one of them.
/// first_child(cell): the child that is to be visited first; child i XOR first_child is the i-th.
/// enter_child(cell, i, state): makes the cell's state that of child i, and says whether it is
/// passed. Both tell what split tells.
template <class M, class T>
inline constexpr bool goes_child_by_child = requires(
    const M method, const T tree, const cube cell, typename M::state state, typename T::node node) {
  { method.first_child(cell) } -> std::same_as<unsigned>;
  { method.enter_child(cell, 0u, state) } -> std::same_as<bool>;
  { tree.way_from(node) } -> std::same_as<only_way<typename T::node>>;
};

/// As descend, which calls it: asks about those children alone that the tree holds, so that in a
/// tree of few children most cells cost one test.
template <Method M, Tree T, class Visit>
bool descend_child_by_child(const M& method, const cube& root, int level, const T& tree,
                            Visit&& visit, std::uint64_t* cells_opened) {
  struct frame {
    cube cell;
    typename T::node node;
    typename M::state at;
    int depth;
    unsigned first;
    unsigned pending; ///< bit i: child i XOR first is still to be asked about
  };
  std::array<frame, max_level> stack; // of cells that have several children
  unsigned waiting = 0;
  std::uint64_t opened = 0;

  // From a cell that is passed down to where there is a choice. True when visit said so.
  const auto open = [&](cube cell, const typename T::node& node, typename M::state at, int depth) {
    const only_way<typename T::node> way = tree.way_from(node);
    for (int left = way.levels; left > 0; --left) {
      ++opened;
      const unsigned index = way.child(left);
      if (!method.enter_child(cell, index, at))
        return false;
      cell = cell.child(index);
    }
    if (depth + way.levels == level)
      return static_cast<bool>(visit(std::as_const(cell), way.end, std::as_const(at)));
    ++opened;
    frame& f = stack[waiting++];
    f.cell = cell;
    f.node = way.end;
    f.at = at;
    f.depth = depth + way.levels;
    f.first = method.first_child(cell);
    f.pending = reordered(tree.child_mask(way.end, cell, 0xff), f.first);
    return false;
  };
  typename M::state at{};
  bool stopped = method.enter(root, at) && open(root, tree.root(), at, 0);
  while (!stopped && waiting != 0) {
    frame& f = stack[waiting - 1];
    const unsigned index = static_cast<unsigned>(std::countr_zero(f.pending)) ^ f.first;
    f.pending &= f.pending - 1;
    waiting -= f.pending == 0 ? 1 : 0; // its last child may take its place
    at = f.at;
    if (!method.enter_child(f.cell, index, at))
      continue;
    const cube cell = f.cell.child(index);
    const typename T::node node = tree.child(f.node, index);
    stopped = f.depth + 1 == level ? static_cast<bool>(visit(cell, node, std::as_const(at)))
                                   : open(cell, node, at, f.depth + 1);
  }
  if (cells_opened != nullptr)
    *cells_opened += opened;
  return stopped;
}

/// Calls visit(cell, node, state) for each cell of `level` that the method passes and the tree
/// holds, in the method's order; stops when visit returns true, and then returns true.
/// `cells_opened`, where given, counts the cells whose children were tested. The root must be exact
/// at `level` (root_cube). The caller holds a typename M::scope.
template <Method M, Tree T, class Visit>
bool descend(const M& method, const cube& root, int level, const T& tree, Visit&& visit,
             std::uint64_t* cells_opened = nullptr) {
  if constexpr (goes_child_by_child<M, T>)
    return descend_child_by_child(method, root, level, tree, visit, cells_opened);
  struct frame {
    cube cell;
    typename T::node node;
    branches<typename M::state> children;
    unsigned next;
    std::uint8_t present;
  };
  std::array<frame, max_level> stack;
  typename M::state state{};
  if (!method.enter(root, state))
    return false;

  const auto open = [&](frame& f, const cube& cell, const typename T::node& node,
                        const typename M::state& at) {
    f.cell = cell;
    f.node = node;
    f.children.clear();
    f.next = 0;
    method.split(cell, at, f.children);
    f.present = tree.child_mask(node, cell, f.children.mask());
    if (cells_opened != nullptr)
      ++*cells_opened;
  };
  open(stack[0], root, tree.root(), state);
  int depth = 0;
  while (depth >= 0) {
    frame& f = stack[static_cast<unsigned>(depth)];
    if (f.next == f.children.size()) {
      --depth;
      continue;
    }
    const branch<typename M::state>& b = f.children[f.next++];
    if ((f.present >> b.index & 1) == 0)
      continue;
    const cube cell = f.cell.child(b.index);
    const typename T::node node = tree.child(f.node, b.index);
    if (depth + 1 == level) {
      if (visit(cell, node, b.state))
        return true;
    } else {
      open(stack[static_cast<unsigned>(++depth)], cell, node, b.state);
    }
  }
  return false;
}

} // namespace graze::octree
