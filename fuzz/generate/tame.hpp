#pragma once
/// Rays that an owner takes: none from far away, none of strange numbers.
///
/// A ray is tame where
/// - its origin is at most 16 root sizes outside the root (of a grid or boxes: of the largest edge of all
///   together outside them), on each axis, and each component of it is 0, or
///   normal and at least 2^-80 root sizes;
/// - the components of its direction are 0, or normal and within 2^40 of each other, the largest between
///   2^-40 and 2^40 (times the root's size, where that brings them further apart); of a segment they are
///   those of end - origin.
/// The grids and boxes that a campaign of tame rays makes have tame edges.
#include <cstdint>
#include <trial/trial.hpp>

namespace graze::fuzz {

[[nodiscard]] bool is_tame(const trial& t);

/// Edges are tame where each is 0 (flat), or from 2^-40 to 2^40 and within 2^20 of all others: the spacings of
/// a grid, or what lies between planes that are given, and the edges of boxes.
[[nodiscard]] bool has_tame_edges(const grid_planes& g);
[[nodiscard]] bool has_tame_edges(const std::vector<octree::box>& boxes);

/// The trial itself where its ray is tame, and else one with the same block whose ray is tame, and hard in
/// the same respect where that can be: a direction that is too small or too large is scaled by a power of
/// two, exactly, a component that is too small beside the others is brought nearer to them, and a ray from
/// far away comes from nearby, through a vertex or a point of an edge of the block or a rounding beside it.
/// The same for a seed and a number, always. Of a ray, not of a segment.
[[nodiscard]] trial tamed(const trial& t, std::uint64_t seed, std::uint64_t number);

} // namespace graze::fuzz
