#pragma once
/// An octree that is built where it is looked at: only the octants that rays need are evaluated.
#include <graze/needs_cxx20.hpp>

#include <atomic>
#include <bit>
#include <graze/octree/children.hpp>
#include <memory>
#include <mutex>
#include <new>

namespace graze::octree {

/// The octants of levels 0..root.level() that the judge keeps, each octant's children decided when
/// they are first asked for, all eight at once, and remembered. Models Tree. The leaves, and what
/// is proven about them, are those of the eager octree; above them an octant stays in which no leaf
/// is left, which the eager octree prunes, so a traversal reports the same leaves in the same
/// order.
///
/// Any number of threads may share one. What is decided depends on the octant alone; where two
/// decide the same octant at once, the first to publish it wins, and the other's room is lost.
/// Memory: 8 bytes an octant looked at above the last level, none for a leaf. Any rounding
/// mode: it takes the judge's scope where it decides.
template <ChildrenJudge J> class lazy_octree {
public:
  struct node {
    std::uint32_t index; ///< of the parent, for a leaf
    std::uint8_t depth, child;
  };
  static constexpr std::size_t bytes_per_node = sizeof(std::uint64_t);

  lazy_octree(const J& judge, const root_cube& root) : judge_(judge), root_(root) {
    static_cast<void>(take(1));
  }
  lazy_octree(const lazy_octree&) = delete;
  lazy_octree& operator=(const lazy_octree&) = delete;

  [[nodiscard]] const cube& root_octant() const { return root_.root_octant(); }
  [[nodiscard]] int level() const { return root_.level(); }
  [[nodiscard]] node root() const { return {0, 0, 0}; }

  /// `cell` must be the node's octant. Where there is no room for more nodes (2^32), or no memory,
  /// throws std::bad_alloc.
  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube& cell,
                                        std::uint8_t wanted) const {
    std::atomic<std::uint64_t>& word = at(n.index);
    std::uint64_t w = word.load(std::memory_order_acquire);
    if (w == 0) [[unlikely]]
      w = decide(word, cell, n.depth);
    return static_cast<std::uint8_t>(w) & wanted;
  }
  /// The child with `index`, which child_mask must have shown to be there.
  [[nodiscard]] node child(const node& n, unsigned index) const {
    const auto depth = static_cast<std::uint8_t>(n.depth + 1);
    if (depth == level())
      return {n.index, depth, static_cast<std::uint8_t>(index)};
    const std::uint64_t w = at(n.index).load(std::memory_order_acquire);
    const auto before = static_cast<unsigned>(w) & ((1u << index) - 1u);
    return {static_cast<std::uint32_t>(w >> 32) + static_cast<std::uint32_t>(std::popcount(before)),
            depth, 0};
  }
  /// What is proven about a node of the last level.
  [[nodiscard]] content leaf(const node& n) const {
    const std::uint64_t w = at(n.index).load(std::memory_order_acquire);
    return (w >> (certified_bits + n.child) & 1) != 0 ? content::certified : content::possible;
  }

  /// Octants above the last level whose room is taken, looked at or not.
  [[nodiscard]] std::size_t node_count() const { return taken_.load(std::memory_order_relaxed); }
  /// Octants whose children have been decided.
  [[nodiscard]] std::size_t decided_count() const {
    return decided_.load(std::memory_order_relaxed);
  }

private:
  // A word: the mask in bits 0 to 7, certified children in bits 8 to 15, bit 16 once decided, the
  // first child's index in bits 32 to 63.
  static constexpr int certified_bits = 8;
  static constexpr std::uint64_t decided_bit = 1u << 16;
  // Words are in blocks that never move: block b has first_size << b of them.
  static constexpr std::uint64_t first_size = 1024;
  static constexpr int blocks = 23;
  using words = std::unique_ptr<std::atomic<std::uint64_t>[]>;

  static int block_of(std::uint64_t index) { return std::bit_width(index / first_size + 1) - 1; }
  [[nodiscard]] std::atomic<std::uint64_t>& at(std::uint64_t index) const {
    const int b = block_of(index);
    return block_[b].load(std::memory_order_acquire)[index - ((first_size << b) - first_size)];
  }

  [[nodiscard]] std::uint64_t take(unsigned count) const {
    const std::uint64_t first = taken_.fetch_add(count, std::memory_order_relaxed);
    if (first + count > 0xffff'ffff)
      throw std::bad_alloc();
    for (int b = block_of(first); b <= block_of(first + count - 1); ++b)
      if (block_[b].load(std::memory_order_acquire) == nullptr) {
        const std::lock_guard lock(growing_);
        if (block_[b].load(std::memory_order_relaxed) == nullptr) {
          owned_[b] = words(new std::atomic<std::uint64_t>[first_size << b]());
          block_[b].store(owned_[b].get(), std::memory_order_release);
        }
      }
    return first;
  }

  std::uint64_t decide(std::atomic<std::uint64_t>& word, const cube& cell, int depth) const {
    std::uint64_t w = decided_bit;
    [[maybe_unused]] const typename J::scope scope; // the caller's mode may be another
    typename J::octant octant(cell);
    if (depth + 1 == level()) {
      const leaf_children leaves = judge_.leaves(octant);
      w |= leaves.mask | std::uint64_t{leaves.certified} << certified_bits;
    } else {
      const std::uint8_t open = judge_.open(octant);
      w |= open;
      if (open != 0)
        w |= take(static_cast<unsigned>(std::popcount(open))) << 32;
    }
    std::uint64_t found = 0;
    if (!word.compare_exchange_strong(found, w, std::memory_order_acq_rel))
      return found;
    decided_.fetch_add(1, std::memory_order_relaxed);
    return w;
  }

  J judge_;
  root_cube root_;
  mutable std::atomic<std::uint64_t> taken_{0}, decided_{0};
  mutable std::mutex growing_;
  mutable words owned_[blocks];
  mutable std::atomic<std::atomic<std::uint64_t>*> block_[blocks]{};
};

} // namespace graze::octree
