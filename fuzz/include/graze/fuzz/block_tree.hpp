#pragma once
/// The octree of a trial's block, never built: a node is an octant's integer position, and a child
/// is there where it overlaps the block. Models graze::octree::Tree.
#include <graze/fuzz/trial.hpp>
#include <graze/octree/descent.hpp>

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
    for (int a = 0; a < 3; ++a) {
      const std::uint64_t first = first_[a] >> shift;
      const std::uint64_t last = last_[a] >> shift;
      const std::uint64_t lower = n.index[a] * 2;
      unsigned there = 0;
      if (first <= lower && lower <= last)
        there |= side[a][0];
      if (first <= lower + 1 && lower + 1 <= last)
        there |= side[a][1];
      mask &= there;
    }
    return static_cast<std::uint8_t>(mask);
  }

  [[nodiscard]] node child(const node& n, unsigned i) const {
    return {
        {n.index[0] * 2 + (i & 1u), n.index[1] * 2 + (i >> 1 & 1u), n.index[2] * 2 + (i >> 2 & 1u)},
        n.level + 1};
  }

  /// The voxel of a node at the block's level.
  [[nodiscard]] voxel voxel_of(const node& n) const {
    return voxel_at(static_cast<unsigned>(n.index[0] - first_[0]),
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
