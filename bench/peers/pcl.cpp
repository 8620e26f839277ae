#include "peers.hpp"
#include "rounded_ray.hpp"
#include <cstdio>
#include <cstdlib>
#include <pcl/octree/octree_search.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace graze::bench {

template <> struct peer<pcl>::structure {
  explicit structure(const voxel_grid& grid) : tree(grid.voxel_size()) {
    keys.reserve(grid.voxels.size());
    cloud->reserve(grid.voxels.size());
    for (const voxel_index& v : grid.voxels) {
      const octree::vec3 c = grid.centre(v);
      cloud->push_back(
          {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
      keys.push_back(key_of(v));
    }
    const octree::cube& root = grid.root.box();
    tree.setInputCloud(cloud);
    tree.defineBoundingBox(root.lo[0], root.lo[1], root.lo[2], root.hi(0), root.hi(1), root.hi(2));
    tree.addPointsFromInputCloud();
    // Its voxels are ours only if its root is.
    double lo[3], hi[3];
    tree.getBoundingBox(lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]);
    bool same = static_cast<int>(tree.getTreeDepth()) == grid.level() &&
                tree.getLeafCount() == grid.voxels.size();
    for (int a = 0; a < 3; ++a)
      same = same && lo[a] == root.lo[static_cast<unsigned>(a)] && hi[a] == root.hi(a);
    if (!same) {
      std::fprintf(stderr, "PCL's octree has another root or other voxels\n");
      std::abort();
    }
  }
  ::pcl::PointCloud<::pcl::PointXYZ>::Ptr cloud{new ::pcl::PointCloud<::pcl::PointXYZ>};
  ::pcl::octree::OctreePointCloudSearch<::pcl::PointXYZ> tree;
  std::vector<voxel_key> keys;
  ::pcl::Indices points; ///< one a voxel: its rank
};

template <>
peer<pcl>::peer(const voxel_grid& grid) : structure_(std::make_unique<structure>(grid)) {}
template <> peer<pcl>::~peer() = default;

template <> void peer<pcl>::occupied(const octree::ray& r, std::vector<voxel_key>& found) {
  const auto eigen = [](const octree::vec3& v) {
    return Eigen::Vector3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                           static_cast<float>(v[2]));
  };
  structure& s = *structure_;
  s.points.clear();
  s.tree.getIntersectedVoxelIndices(eigen(r.origin()), eigen(r.direction()), s.points);
  for (const auto point : s.points)
    found.push_back(s.keys[static_cast<std::size_t>(point)]);
}

template <> std::optional<octree::ray> peer<pcl>::received(const octree::ray& r) const {
  return ray_if_any(single(r.origin()), single(r.direction()));
}

} // namespace graze::bench
