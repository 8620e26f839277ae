#pragma once
/// Shrinking of what is no ray through octants: grids, boxes, segments.
#include <shrink/shrink.hpp>

namespace graze::fuzz {

/// complexity_of() such a trial: fewer voxels or boxes, a smaller grid, shorter numbers. A decimal such as
/// 0.1 is a short number.
complexity complexity_of_scene(const trial& t);

/// simpler() than such a trial: fewer cells; a number, or all that are equal to it, replaced by a shorter
/// one; the scene moved, scaled; the block moved to the grid's first voxels, with the ray or without it. A
/// grid keeps its rule.
std::vector<trial> simpler_scenes(const trial& t);

} // namespace graze::fuzz
