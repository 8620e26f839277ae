// PCL: getIntersectedVoxelIndices, at most one voxel.
#include "first_hits.hpp"
#include <pcl/octree/octree_search.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace graze::bench {

std::vector<first_hit_contestant> pcl_first_hits(const occupied_octants& octants) {
  struct scene {
    explicit scene(double edge) : tree(edge) {}
    ::pcl::PointCloud<::pcl::PointXYZ>::Ptr cloud{new ::pcl::PointCloud<::pcl::PointXYZ>};
    ::pcl::octree::OctreePointCloudSearch<::pcl::PointXYZ> tree;
    std::vector<octant_key> keys;
    ::pcl::Indices found;
  };
  const auto s = std::make_shared<scene>(octants.edge());
  for (const peers::octant_index& at : octants.indices) {
    const octree::vec3 c = octants.corner(at, 0.5);
    s->cloud->push_back(
        {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    s->keys.push_back(peers::key_of(at));
  }
  const octree::cube& root = octants.root;
  s->tree.setInputCloud(s->cloud);
  s->tree.defineBoundingBox(root.lo[0], root.lo[1], root.lo[2], root.hi(0), root.hi(1), root.hi(2));
  s->tree.addPointsFromInputCloud();
  return {{"PCL getIntersectedVoxelIndices, 1", "library", one_by_one([s](const octree::ray& r) {
             const auto eigen = [](const octree::vec3& v) {
               return Eigen::Vector3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                                      static_cast<float>(v[2]));
             };
             s->found.clear();
             s->tree.getIntersectedVoxelIndices(eigen(r.origin()), eigen(r.direction()), s->found,
                                                1);
             return s->found.empty() ? no_octant : s->keys[static_cast<std::size_t>(s->found[0])];
           })}};
}

} // namespace graze::bench
