#pragma once
/// Descent of a ray through an octree. A Method says which children the ray passes, in order; a
/// Tree says which children there are; the visitor gets the cells that are left at the last level.
#include <array>
#include <concepts>
#include <cstdint>
#include <graze/octree/cube.hpp>

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

/// Calls visit(cell, node, state) for each cell of `level` that the method passes and the tree
/// holds, in the method's order; stops when visit returns true, and then returns true.
/// `cells_opened`, where given, counts the cells whose children were tested. The root must be exact
/// at `level` (root_cube). The caller holds a typename M::scope.
template <Method M, Tree T, class Visit>
bool descend(const M& method, const cube& root, int level, const T& tree, Visit&& visit,
             std::uint64_t* cells_opened = nullptr) {
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
