#pragma once
/// A plain sparse octree, a level an array: for the descents and for the exact judge.
#include <algorithm>
#include <bit>
#include <peers/occupied_octants.hpp>

namespace graze::bench {

using peers::occupied_octants;
using peers::octant_index;
using peers::octant_key;

/// Node `n` of `level` has the children in its mask (bit x + 2y + 4z); they are consecutive nodes
/// of the next level. At the last but one level children are occupied octants.
class mask_tree {
public:
  explicit mask_tree(const occupied_octants& octants)
      : levels_(static_cast<unsigned>(octants.level)) {
    std::vector<std::uint64_t> codes;
    codes.reserve(octants.indices.size());
    for (const octant_index& v : octants.indices) {
      std::uint64_t code = 0;
      for (int bit = octants.level - 1; bit >= 0; --bit)
        for (unsigned a = 3; a-- > 0;)
          code = code << 1 | (v[a] >> bit & 1);
      codes.push_back(code);
    }
    std::sort(codes.begin(), codes.end());
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
      std::vector<std::uint64_t> parents;
      for (std::uint32_t i = 0; i < codes.size(); ++i) {
        if (parents.empty() || parents.back() != codes[i] >> 3) {
          parents.push_back(codes[i] >> 3);
          level->push_back({i, 0});
        }
        level->back().mask = static_cast<std::uint8_t>(level->back().mask | 1u << (codes[i] & 7));
      }
      codes = std::move(parents);
    }
  }

  [[nodiscard]] std::uint32_t mask(unsigned level, std::uint32_t n) const {
    return levels_[level][n].mask;
  }
  [[nodiscard]] std::uint32_t child(unsigned level, std::uint32_t n, unsigned index) const {
    const node& at = levels_[level][n];
    return at.first + static_cast<std::uint32_t>(std::popcount(at.mask & ((1u << index) - 1u)));
  }
  [[nodiscard]] bool empty() const { return levels_[0].empty(); }

private:
  struct node {
    std::uint32_t first;
    std::uint8_t mask;
  };
  std::vector<std::vector<node>> levels_;
};

} // namespace graze::bench
