#pragma once
/// What every library is built from and what it reports: occupied octants of one level of a root.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <optional>
#include <vector>

namespace graze::peers {

using octree::vec3;

using octant_index = std::array<std::uint32_t, 3>;

/// x + 2^21 y + 2^42 z, of 21 bits each.
using octant_key = std::uint64_t;
[[nodiscard]] constexpr octant_key key_of(const octant_index& at) {
  return at[0] | static_cast<std::uint64_t>(at[1]) << 21 | static_cast<std::uint64_t>(at[2]) << 42;
}
[[nodiscard]] constexpr octant_index index_of(octant_key key) {
  return {static_cast<std::uint32_t>(key & 0x1f'ffff),
          static_cast<std::uint32_t>(key >> 21 & 0x1f'ffff), static_cast<std::uint32_t>(key >> 42)};
}

/// The octants that are occupied, each named once; all others of the level are empty.
struct occupied_octants {
  octree::cube root;
  int level;
  std::array<std::uint64_t, 3> base{}; ///< the octant from which indices count
  std::vector<octant_index> indices;   ///< each below 2^21

  /// Of an octant.
  [[nodiscard]] double edge() const { return std::ldexp(root.size, -level); }
  /// An octant's lowest (side 0) or highest (side 1) corner; side 0.5 is its centre.
  [[nodiscard]] vec3 corner(const octant_index& at, double side) const {
    vec3 c{};
    for (unsigned a = 0; a < 3; ++a)
      c[a] = root.lo[a] + (static_cast<double>(base[a] + at[a]) + side) * edge();
    return c;
  }
};

/// Octants as cells of edge 1, counted from coordinate 0: for a library that knows no others. A
/// point p of the scene is p / edge among the cells.
class unit_cells {
public:
  /// Nothing where the division would round, or the root lies between cells or beyond 2^15 of them:
  /// an edge that is no power of two, levels beyond 15.
  [[nodiscard]] static std::optional<unit_cells> make(const occupied_octants& octants) {
    int exponent = 0;
    if (octants.level > 15 || std::frexp(octants.root.size, &exponent) != 0.5 ||
        !octree::root_cube::make(octants.root, std::max(octants.level, 1)))
      return std::nullopt;
    unit_cells cells;
    cells.edge = octants.edge();
    cells.side = 1 << octants.level;
    for (unsigned a = 0; a < 3; ++a) {
      const double lowest = octants.root.lo[a] / cells.edge;
      if (!(std::fabs(lowest) <= 0x1p15) || lowest != std::floor(lowest))
        return std::nullopt;
      cells.root[a] = static_cast<int>(lowest);
      cells.first[a] = cells.root[a] + static_cast<int>(octants.base[a]);
    }
    return cells;
  }

  [[nodiscard]] std::array<int, 3> cell(const octant_index& at) const {
    return {static_cast<int>(at[0]) + first[0], static_cast<int>(at[1]) + first[1],
            static_cast<int>(at[2]) + first[2]};
  }
  /// A cell that is no occupied octant has a key that is none's.
  [[nodiscard]] octant_key key(int x, int y, int z) const {
    const auto bits = [](int i) { return static_cast<std::uint32_t>(i) & 0x1f'ffff; };
    return key_of({bits(x - first[0]), bits(y - first[1]), bits(z - first[2])});
  }
  /// The same by the library's own triple.
  template <class Coordinates> [[nodiscard]] octant_key key(const Coordinates& at) const {
    return key(static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2]));
  }

  double edge = 1;            ///< of an octant, in the scene
  int side = 1;               ///< cells of the root, an axis
  std::array<int, 3> root{};  ///< the root's first cell
  std::array<int, 3> first{}; ///< the cell of octant {0, 0, 0}
};

} // namespace graze::peers
