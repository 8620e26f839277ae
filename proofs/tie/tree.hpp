#pragma once
/// The tree of a line `t`, and the fold of what is visited in it.
#include <array>
#include <bit>
#include <cstdint>
#include <graze/octree/descent.hpp>

namespace graze::tie {

inline constexpr std::uint64_t fold_start = 0xcbf29ce484222325;
constexpr std::uint64_t fold(std::uint64_t h, std::uint64_t word) {
  h = (h ^ word) * 0x100000001b3;
  return h ^ h >> 32;
}

/// Three levels, every cell but those whose indices on the path from the root sum up to 4 modulo 5.
struct tree {
  struct node {
    unsigned sum = 0;
    std::array<std::uint8_t, 3> path{};
    unsigned depth = 0;
  };
  static constexpr int levels = 3;
  [[nodiscard]] node root() const { return {}; }
  [[nodiscard]] std::uint8_t child_mask(const node& n, const octree::cube&, std::uint8_t) const {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
      mask |= ((n.sum + i) % 5 != 4 ? 1u : 0u) << i;
    return static_cast<std::uint8_t>(mask);
  }
  [[nodiscard]] node child(const node& n, unsigned index) const {
    node c = n;
    c.sum += index;
    c.path[c.depth++] = static_cast<std::uint8_t>(index);
    return c;
  }
};

/// The cells of a descent in their order, folded: each one's path, corner and size.
template <octree::Method M>
std::uint64_t visits(const M& method, const octree::cube& root, unsigned& count) {
  std::uint64_t h = fold_start;
  count = 0;
  octree::descend(method, root, tree::levels, tree{},
                  [&](const octree::cube& cell, const tree::node& n, const auto&) {
                    ++count;
                    for (const std::uint8_t index : n.path)
                      h = fold(h, index);
                    for (const double x : cell.lo)
                      h = fold(h, std::bit_cast<std::uint64_t>(x));
                    h = fold(h, std::bit_cast<std::uint64_t>(cell.size));
                    return false;
                  });
  return h;
}

} // namespace graze::tie
