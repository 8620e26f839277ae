#pragma once
/// Ray traversals of others, each behind the same two functions: built from a voxel_grid, and
/// asked for the occupied voxels on a ray. Nothing here measures or judges, and no library's header
/// is included, so that benchmarks, campaigns and reports can use the same adapters.
///
/// occupied(ray, found) appends the voxels that the library reports, in its order, doubles
/// included, and nothing of our own: a library that takes rays in single precision, or by two
/// points, gets the ray rounded to that. Not thread-safe: one peer a thread.
///
/// GRAZE_PEER_<NAME> is defined where a library was found when this was configured.
#include "voxel_grid.hpp"
#include <graze/octree/ray.hpp>
#include <memory>
#include <optional>

namespace graze::bench {

/// The traversal `Library`: a tag below, with its name and what it rounds a ray to.
template <class Library> class peer {
public:
  static constexpr const char* name = Library::name;
  explicit peer(const voxel_grid& grid);
  ~peer();
  void occupied(const octree::ray& r, std::vector<voxel_key>& found);
  /// The ray that the library gets for r, and to which occupied() is the answer. Nothing where
  /// there is none (a component that is infinite in single precision, a sum that loses the
  /// direction, an origin beyond the library's coordinates), or where it is no double.
  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const;

  struct structure; ///< the library's own; defined in its source file

private:
  std::unique_ptr<structure> structure_;
};

/// Revelles, Urena and Lastra 2000, "An efficient parametric algorithm for octree traversal", in
/// double: code of our own, from the paper (octree/revelles.hpp).
struct revelles {
  static constexpr const char* name = "Revelles";
};
/// PCL, OctreePointCloudSearch::getIntersectedVoxelIndices: rays in float.
struct pcl {
  static constexpr const char* name = "PCL";
};
/// CGAL, Octree::intersected_nodes with exact predicates: rays in double, by two points.
struct cgal {
  static constexpr const char* name = "CGAL";
};
/// OctoMap, OcTree::computeRayKeys and search(key) of each cell: rays in float, from the origin to
/// a point behind the root.
struct octomap {
  static constexpr const char* name = "OctoMap";
};
/// OpenVDB, LevelSetHDDA down to the voxel: rays in double.
struct openvdb {
  static constexpr const char* name = "OpenVDB";
};

// Defined in one source file each; those of a library that is missing are not.
#define GRAZE_PEER_DECLARE(Library)                                                                \
  template <> peer<Library>::peer(const voxel_grid&);                                              \
  template <> peer<Library>::~peer();                                                              \
  template <> void peer<Library>::occupied(const octree::ray&, std::vector<voxel_key>&);           \
  template <> std::optional<octree::ray> peer<Library>::received(const octree::ray&) const
GRAZE_PEER_DECLARE(revelles);
GRAZE_PEER_DECLARE(pcl);
GRAZE_PEER_DECLARE(cgal);
GRAZE_PEER_DECLARE(octomap);
GRAZE_PEER_DECLARE(openvdb);
#undef GRAZE_PEER_DECLARE

/// Calls f.template operator()<Library>() for each library that there is.
template <class F> void for_each_peer(F&& f) {
  f.template operator()<revelles>();
#ifdef GRAZE_PEER_PCL
  f.template operator()<pcl>();
#endif
#ifdef GRAZE_PEER_CGAL
  f.template operator()<cgal>();
#endif
#ifdef GRAZE_PEER_OCTOMAP
  f.template operator()<octomap>();
#endif
#ifdef GRAZE_PEER_OPENVDB
  f.template operator()<openvdb>();
#endif
}

} // namespace graze::bench
