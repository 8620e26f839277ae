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

/// The traversal `Library`: a tag below, with its name, and what graze-fuzz calls it.
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
  static constexpr const char* traversal = "revelles";
};
/// PCL, OctreePointCloudSearch::getIntersectedVoxelIndices: rays in float.
struct pcl {
  static constexpr const char* name = "PCL";
  static constexpr const char* traversal = "pcl";
};
/// CGAL, Octree::intersected_nodes with exact predicates (EPICK): rays in double, by two points.
struct cgal {
  static constexpr const char* name = "CGAL";
  static constexpr const char* traversal = "cgal-octree";
};
/// The same tree asked with a ray of exact constructions (EPECK): any ray in double, as it is.
struct cgal_exact {
  static constexpr const char* name = "CGAL, exact rays";
  static constexpr const char* traversal = "cgal-octree-epeck";
};
/// OctoMap, OcTree::computeRayKeys and search(key) of each cell: rays in float, from the origin to
/// a point behind the root.
struct octomap {
  static constexpr const char* name = "OctoMap";
  static constexpr const char* traversal = "octomap-ray-keys";
};
/// OpenVDB, LevelSetHDDA down to the voxel: rays in double.
struct openvdb {
  static constexpr const char* name = "OpenVDB";
  static constexpr const char* traversal = "openvdb-level-set-hdda";
};
/// NanoVDB: the loop of ZeroCrossing() in its HDDA.h, which keeps each active voxel that it comes
/// to; and firstActive() again and again, each time without the voxels that it has found. Rays in
/// float, normalised as its own examples do: the steps forward in HDDA.h (Delta) are lengths.
struct nanovdb_hdda {
  static constexpr const char* name = "NanoVDB";
  static constexpr const char* traversal = "nanovdb-hdda";
};
struct nanovdb_first_active {
  static constexpr const char* name = "NanoVDB, firstActive";
  static constexpr const char* traversal = "nanovdb-first-active";
};
/// Embree 3: the voxels as user geometry, rays in float. Reported is every box that Embree calls
/// back for, by its own conservative test; with RTC_SCENE_FLAG_ROBUST; and those of them that
/// slabs in float find on the ray, as a user would test them.
struct embree {
  static constexpr const char* name = "Embree";
  static constexpr const char* traversal = "embree-boxes";
};
struct embree_robust {
  static constexpr const char* name = "Embree, robust";
  static constexpr const char* traversal = "embree-boxes-robust";
};
struct embree_tested {
  static constexpr const char* name = "Embree, boxes tested";
  static constexpr const char* traversal = "embree-boxes-tested";
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
GRAZE_PEER_DECLARE(cgal_exact);
GRAZE_PEER_DECLARE(nanovdb_hdda);
GRAZE_PEER_DECLARE(nanovdb_first_active);
GRAZE_PEER_DECLARE(embree);
GRAZE_PEER_DECLARE(embree_robust);
GRAZE_PEER_DECLARE(embree_tested);
#undef GRAZE_PEER_DECLARE

/// Calls f.template operator()<Library>() for each library that there is.
template <class F> void for_each_peer(F&& f) {
  f.template operator()<revelles>();
#ifdef GRAZE_PEER_PCL
  f.template operator()<pcl>();
#endif
#ifdef GRAZE_PEER_CGAL
  f.template operator()<cgal>();
  f.template operator()<cgal_exact>();
#endif
#ifdef GRAZE_PEER_OCTOMAP
  f.template operator()<octomap>();
#endif
#ifdef GRAZE_PEER_OPENVDB
  f.template operator()<openvdb>();
#endif
#ifdef GRAZE_PEER_NANOVDB
  f.template operator()<nanovdb_hdda>();
  f.template operator()<nanovdb_first_active>();
#endif
#ifdef GRAZE_PEER_EMBREE
  f.template operator()<embree>();
  f.template operator()<embree_robust>();
  f.template operator()<embree_tested>();
#endif
}

} // namespace graze::bench
