#pragma once
/// What voxel_rays.hpp and the paths' files have in common: plain data, no code.
#include <graze/needs_cxx20.hpp>

#include <cstddef>
#include <cstdint>
#include <graze/batch/per_path.hpp>

namespace graze::octree {

/// Whether visits are only never too few (conservative), or exactly those that the convention
/// names.
enum class exactness { conservative, exact };

struct voxel;
class grid;

namespace detail {

/// An octant to be opened.
struct voxel_rays_entry {
  double lo[3];         ///< its lower corner, each coordinate times the ray's sign; not in a grid
  std::uint64_t packed; ///< of its first voxel
  std::uint32_t node;
};

/// One axis of a ray, prepared by the path.
struct voxel_rays_axis {
  double sign;                       ///< -1 where the ray goes backward, else 1
  double enter_origin, leave_origin; ///< times sign
  double c_down, c_up;               ///< infinite where the ray does not move
};

/// For each level of nodes and each axis, the planes of its octants, one after the other.
template <unsigned Depth> struct voxel_rays_planes {
  const double* of_level[Depth][3];
};

/// A walk that can be left and resumed: a queue of octants for each level of nodes, the deepest of
/// which is emptied first.
struct voxel_rays_state {
  static constexpr unsigned queue = 128;
  static constexpr unsigned most_depth = 10;
  using plane_tables = voxel_rays_planes<most_depth>;

  // the set
  const std::uint64_t* masks;
  const std::uint32_t* firsts;
  double lo[3], hi[3];       ///< of the root or grid; not within its outermost planes
  double far_plane[3];       ///< the upper outermost one, NaN if it is no double
  double root_size;          ///< of a root
  const grid* planes;        ///< null: those of a root
  plane_tables lower, upper; ///< of a grid: doubles not above, and not below
  double plane_width[3];     ///< the most that these two differ by
  int level;
  unsigned depth;                  ///< levels of nodes
  double sizes[most_depth];        ///< of a node's octants
  unsigned char shift[most_depth]; ///< levels below a node's octants
  // the ray and what is asked
  double origin[3], direction[3]; ///< the direction is the far end where between_points
  double first, last;
  bool between_points, owned, exact;
  unsigned most_queued; ///< queue: level by level; 64: the first voxel soonest
  // made by begin
  voxel_rays_axis axes[3];
  double from, to;           ///< the segment in scaled t, rounded outwards
  double certain;            ///< an overlap greater than this is not the work of rounding
  unsigned flip;             ///< index bits of the axes along which the ray goes backward
  plane_tables enter, leave; ///< of a grid: the planes of its octants' first slabs
  // the walk
  std::uint64_t opened;
  unsigned at;
  unsigned head[most_depth], tail[most_depth];
  voxel_rays_entry entries[most_depth][queue + 4];

  /// There are no more voxels; fill would write none.
  [[nodiscard]] bool ended() const { return at == 0 && head[0] == tail[0]; }
};

/// The kernels of a path, for sets over one kind of planes.
struct voxel_rays_walk {
  /// Prepares the ray and queues the root, then as fill: modes are set once.
  std::size_t (*begin)(voxel_rays_state&, voxel* out, std::size_t capacity);
  /// Writes up to `capacity` (at least 64) voxels; none only at the walk's end.
  std::size_t (*fill)(voxel_rays_state&, voxel* out, std::size_t capacity);
  /// Prepares the ray and queues the root; the number of all voxels.
  std::uint32_t (*count)(voxel_rays_state&);
};
struct voxel_rays_table {
  voxel_rays_walk in_root, in_grid;
};

GRAZE_DECLARE_ON_PATHS(voxel_rays_table, voxel_rays);

/// Decides what the filter leaves: whether the voxel is to be reported. In any rounding mode.
bool voxel_rays_meet(const voxel_rays_state& s, std::uint64_t packed);

} // namespace detail
} // namespace graze::octree
