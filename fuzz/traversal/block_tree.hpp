#pragma once
/// The octree of a trial's block, never built: a node is an octant's integer position, and a child
/// is there where it overlaps the block. Models graze::octree::Tree.
#include <algorithm>
#include <bit>
#include <graze/octree/descent.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

class block_tree {
public:
  struct node {
    std::array<std::uint64_t, 3> index; ///< position among the octants of its level
    int level;
  };

  explicit block_tree(const trial& t) : level_(t.level), first_(t.base) {
    for (int a = 0; a < 3; ++a)
      last_[a] = t.base[a] + t.extent[a] - 1;
  }

  [[nodiscard]] node root() const { return {{0, 0, 0}, 0}; }

  [[nodiscard]] std::uint8_t child_mask(const node& n, const cube&, std::uint8_t wanted) const {
    // the children on the lower and upper side of each axis
    static constexpr std::array<std::array<unsigned, 2>, 3> side{
        {{0x55, 0xaa}, {0x33, 0xcc}, {0x0f, 0xf0}}};
    const int shift = level_ - n.level - 1;
    unsigned mask = wanted;
    for (unsigned a = 0; a < 3; ++a) { // without a branch, since a side is a coin toss
      const std::uint64_t lower = n.index[a] * 2;
      const unsigned lower_there = first_[a] >> shift <= lower ? 1 : 0;
      const unsigned upper_there = last_[a] >> shift > lower ? 1 : 0;
      mask &= lower_there * side[a][0] + upper_there * side[a][1];
    }
    return static_cast<std::uint8_t>(mask);
  }

  [[nodiscard]] node child(const node& n, unsigned i) const {
    return {
        {n.index[0] * 2 + (i & 1u), n.index[1] * 2 + (i >> 1 & 1u), n.index[2] * 2 + (i >> 2 & 1u)},
        n.level + 1};
  }

  /// Down to where the part of the block within the node lies on both sides of a mid-plane.
  [[nodiscard]] octree::only_way<node> way_from(const node& n) const {
    const int below = level_ - n.level;
    std::array<std::uint64_t, 3> first;
    std::uint64_t differ = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const std::uint64_t lowest = n.index[a] << below;
      const std::uint64_t highest = lowest + ((std::uint64_t{1} << below) - 1);
      first[a] = std::max(first_[a], lowest);
      differ |= first[a] ^ std::min(last_[a], highest);
    }
    const int open = std::bit_width(differ); // levels from where the way ends to the last one
    for (std::uint64_t& i : first)
      i >>= open;
    return {{first, level_ - open}, below - open, first};
  }

  /// The octant that a node at the block's level is.
  [[nodiscard]] octant_number octant_of(const node& n) const {
    return octant_at(static_cast<unsigned>(n.index[0] - first_[0]),
                     static_cast<unsigned>(n.index[1] - first_[1]),
                     static_cast<unsigned>(n.index[2] - first_[2]));
  }

private:
  int level_;
  std::array<std::uint64_t, 3> first_;
  std::array<std::uint64_t, 3> last_{};
};

static_assert(octree::Tree<block_tree>);

} // namespace graze::fuzz
