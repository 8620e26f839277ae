#pragma once
/// A trial: one ray and one small block of occupied octants. What a traversal is asked about.
#include <array>
#include <bit>
#include <cstdint>
#include <graze/expected.hpp>
#include <graze/octree/box.hpp>
#include <graze/octree/cube.hpp>
#include <graze/octree/ray.hpp>
#include <graze/support/status.hpp>
#include <memory>
#include <optional>
#include <trial/grid.hpp>
#include <trial/number.hpp>
#include <trial/voxel_map.hpp>
#include <vector>

namespace graze::fuzz {

using octree::cube;

/// The largest block: 4 x 4 x 4 octants, so that a set of them is 64 bits.
inline constexpr unsigned max_extent = 4;

/// An octant's number within its block: x + 4 (y + 4 z).
using octant_number = std::uint8_t;
/// A set of a block's octants, bit v for octant v.
using octant_set = std::uint64_t;

constexpr octant_number octant_at(unsigned x, unsigned y, unsigned z) {
  return static_cast<octant_number>(x + max_extent * (y + max_extent * z));
}

/// The exact spelling of the three numbers.
inline std::array<std::string, 3> hex(const vec3& v) { return {hex(v[0]), hex(v[1]), hex(v[2])}; }

/// What a trial's cells are: octants of a root cube, voxels of a grid with planes of any kind, boxes of
/// a list.
enum class cell_kind : std::uint8_t { cube, grid, boxes };
inline constexpr unsigned cell_kinds = 3;

/// Most boxes of a list, so that a set of them is an octant_set.
inline constexpr std::size_t max_boxes = 64;

/// A ray or a segment, and cells: the occupied octants of one level of a root cube (`extent` of them
/// from index `base` on), such a block of a grid's voxels, those of them that are occupied in a map, or a
/// list of boxes, whose places in the list are the octant_numbers.
struct trial {
  vec3 origin{};
  vec3 direction{1, 0, 0}; ///< of a segment: end - origin, rounded to nearest
  /// The segment's far end: its points are origin + t (end - origin), 0 <= t <= 1, exactly. No end: a
  /// ray.
  std::optional<vec3> end;
  cube root{{0, 0, 0}, 1};
  int level = 1; ///< 0 (the root is the only octant) to octree::max_level
  std::array<std::uint64_t, 3> base{};
  std::array<std::uint8_t, 3> extent{1, 1, 1}; ///< octants an axis, 1..max_extent
  std::shared_ptr<const grid_planes> grid; ///< where there is one, `root` and `level` say nothing
  std::shared_ptr<const voxel_map> map;    ///< where there is one, `grid` is its grid
  std::shared_ptr<const std::vector<octree::box>> boxes; ///< likewise, and `base` and `extent`

  [[nodiscard]] cell_kind cells() const {
    return boxes ? cell_kind::boxes : (grid ? cell_kind::grid : cell_kind::cube);
  }
  /// An octant's edge.
  [[nodiscard]] double size() const { return scaled(root.size, -level); }
  /// Octants or voxels an axis of the whole grid; a flat axis has one.
  [[nodiscard]] std::uint64_t count(unsigned axis) const {
    return grid ? grid->count[axis] : std::uint64_t{1} << level;
  }
  /// Whether the voxels' two faces on this axis are one plane.
  [[nodiscard]] bool flat(unsigned axis) const { return grid && grid->flat(axis); }
  /// Plane `index` of the level's grid, 0 <= index <= 2^level; an exact double. Counted from the
  /// middle, as root_cube::octant does: from the corner it would be rounded on some roots. Of a grid
  /// of any planes its plane; the nearest double where the rule is exact.
  [[nodiscard]] double grid_plane(int axis, std::uint64_t index) const {
    return grid ? nearest_plane(*grid, static_cast<unsigned>(axis),
                                static_cast<std::uint32_t>(index))
                : octant_plane(axis, index);
  }
  /// The same, of octants alone.
  [[nodiscard]] double octant_plane(int axis, std::uint64_t index) const {
    if (level == 0)
      return index == 0 ? root.lo[axis] : root.hi(axis);
    const auto half = std::int64_t{1} << (level - 1);
    return root.mid(axis) + static_cast<double>(static_cast<std::int64_t>(index) - half) * size();
  }
  /// The k-th plane of the block on an axis, 0 <= k <= extent; as grid_plane.
  [[nodiscard]] double plane(int axis, unsigned k) const {
    return grid_plane(axis, base[axis] + k);
  }
  /// Of a cube's octants.
  [[nodiscard]] cube octant(octant_number v) const {
    return {{octant_plane(0, base[0] + (v & 3u)), octant_plane(1, base[1] + (v >> 2 & 3u)),
             octant_plane(2, base[2] + (v >> 4))},
            size()};
  }
  /// The closed box of an octant, a voxel (as grid_plane), or the list's box of this place.
  [[nodiscard]] octree::box cell(octant_number v) const;
  /// Bit a is set where the block ends at the far face of axis a of the root or grid.
  [[nodiscard]] unsigned at_far_face() const {
    unsigned faces = 0;
    for (int a = 0; a < 3; ++a)
      if (base[a] + extent[a] == count(static_cast<unsigned>(a)))
        faces |= 1u << a;
    return faces;
  }
  /// Bit a is set where the block starts at the near face of axis a.
  [[nodiscard]] unsigned at_near_face() const {
    return (base[0] == 0 ? 1u : 0u) | (base[1] == 0 ? 2u : 0u) | (base[2] == 0 ? 4u : 0u);
  }
  /// Those that are occupied.
  [[nodiscard]] octant_set all() const {
    if (boxes)
      return boxes->size() >= max_boxes ? ~octant_set{0} : (octant_set{1} << boxes->size()) - 1;
    if (map)
      return map->occupied(base, extent);
    octant_set set = 0;
    for (unsigned z = 0; z < extent[2]; ++z)
      for (unsigned y = 0; y < extent[1]; ++y)
        for (unsigned x = 0; x < extent[0]; ++x)
          set |= octant_set{1} << octant_at(x, y, z);
    return set;
  }

  friend bool operator==(const trial& a, const trial& b);
};

/// Whether a trial can be judged, or why not: a ray or segment that is not one, a block outside its root
/// or grid, or without an occupied voxel of its map, octants that are not exact doubles, planes that are not finite and increasing, boxes that are
/// not finite with lo <= hi.
support::status judgeable(const trial& t);

/// The trial of the segment from `origin` to `end`, its cells as t's.
trial with_end(const trial& t, const vec3& origin, const vec3& end);
/// The trial of the ray, its cells as t's.
trial with_ray(const trial& t, const vec3& origin, const vec3& direction);

/// The trial of a single octant given by its corner and size. Refuses an octant that is not one of
/// the root's octree, and what is not judgeable().
expected<trial> trial_of_octant(const vec3& origin, const vec3& direction, const cube& octant,
                                const cube& root,
                                const std::array<std::uint8_t, 3>& extent = {1, 1, 1});
/// The same for the ray or segment and the extent of `line`.
expected<trial> trial_of_octant(const trial& line, const cube& octant, const cube& root);

} // namespace graze::fuzz
