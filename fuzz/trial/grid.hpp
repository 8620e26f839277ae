#pragma once
/// A grid whose planes come about by a rule, or are given.
#include <array>
#include <cstdint>
#include <graze/octree/cube.hpp>
#include <graze/octree/plane_rule.hpp>
#include <graze/oracle/planes.hpp>
#include <graze/support/status.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace graze::fuzz {

using octree::plane_rule;
using octree::vec3;

/// "exact", "rounded", "multiplied", "added", "float", "given".
std::string_view name_of(plane_rule rule);
/// By the names of name_of().
std::optional<plane_rule> plane_rule_of(std::string_view name);

/// Most voxels an axis of a grid.
inline constexpr std::uint32_t max_count = std::uint32_t{1} << 20;

/// The planes of a grid: by a rule from origin, spacing and count, or, where the rule is `given`, three
/// increasing arrays. An axis of spacing 0 and count 1, or of one given plane, is flat: both faces of its
/// voxels are one plane.
struct grid_planes {
  vec3 origin{}, spacing{1, 1, 1};             ///< of no meaning where planes are given
  std::array<std::uint32_t, 3> count{1, 1, 1}; ///< voxels an axis, 1..max_count
  plane_rule rule = plane_rule::exact;
  std::array<std::vector<double>, 3> given; ///< count + 1 planes an axis, one on a flat axis

  [[nodiscard]] bool flat(unsigned axis) const {
    return rule == plane_rule::given ? given[axis].size() == 1 : spacing[axis] == 0;
  }
  /// The number of the last plane.
  [[nodiscard]] std::uint32_t last(unsigned axis) const { return flat(axis) ? 0 : count[axis]; }

  friend bool operator==(const grid_planes&, const grid_planes&) = default;
};

/// The grid of these planes; count follows. One that has none, or too many, is refused by judgeable().
grid_planes grid_of(std::array<std::vector<double>, 3> planes);

/// Plane `index`, 0 <= index <= count, of which all on a flat axis are the one plane: not rounded.
oracle::plane_terms exact_plane(const grid_planes& g, unsigned axis, std::uint32_t index);
/// The same, or the nearest double where the rule is exact.
double nearest_plane(const grid_planes& g, unsigned axis, std::uint32_t index);

/// Whether it is a grid: 1 to max_count voxels an axis; planes finite and strictly increasing. The reason
/// names the axis, the planes and a way out. Takes up to a few milliseconds for planes that lie so close
/// that each has to be looked at.
support::status judgeable(const grid_planes& g);

} // namespace graze::fuzz
