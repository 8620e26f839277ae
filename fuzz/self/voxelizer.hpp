#pragma once
/// Trials of the voxelizer: no octant that holds a point of the surface is dropped.
#include <graze/octree/cube.hpp>
#include <self/subject.hpp>

namespace graze::fuzz::self {

/// True for a leaf to be left out: for tests of the campaign itself.
using dropped_leaf = std::function<bool(const octree::cube&)>;

/// A part a surface. Trial k of a part looks along a line in an octree that 64 trials share: the
/// exact first zero of the polynomial along the line (Sturm's theorem), and every leaf that holds
/// it, on a face, an edge or a vertex too, must be kept, by the eager octree and the lazy one. The
/// first of the 64 compares the octrees by lanes of each path and on threads, byte for byte.
subject voxelizer_subject(const dropped_leaf& dropped = {});

} // namespace graze::fuzz::self
