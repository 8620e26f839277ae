/// PCL: OctreePointCloudSearch::getIntersectedVoxelIndices, rays in float.
#include <cstdio>
#include <cstdlib>
#include <pcl/octree/octree_search.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <peers/library.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

class point_octree final : public structure {
public:
  point_octree(const occupied_octants& octants, const unit_cells& cells) : tree_(cells.edge) {
    keys_.reserve(octants.indices.size());
    cloud_->reserve(octants.indices.size());
    for (const octant_index& at : octants.indices) {
      const vec3 c = octants.corner(at, 0.5);
      cloud_->push_back(
          {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
      keys_.push_back(key_of(at));
    }
    const octree::cube& root = octants.root;
    tree_.setInputCloud(cloud_);
    tree_.defineBoundingBox(root.lo[0], root.lo[1], root.lo[2], root.hi(0), root.hi(1), root.hi(2));
    tree_.addPointsFromInputCloud();
    // Its voxels are ours only if its root is.
    double lo[3], hi[3];
    tree_.getBoundingBox(lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]);
    bool same = static_cast<int>(tree_.getTreeDepth()) == octants.level &&
                tree_.getLeafCount() == octants.indices.size();
    for (int a = 0; a < 3; ++a)
      same = same && lo[a] == root.lo[static_cast<unsigned>(a)] && hi[a] == root.hi(a);
    if (!same) {
      std::fprintf(stderr, "PCL's octree has another root or other voxels\n");
      std::abort();
    }
  }

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return ray_in_float(r);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto eigen = [](const vec3& v) {
      return Eigen::Vector3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                             static_cast<float>(v[2]));
    };
    points_.clear();
    tree_.getIntersectedVoxelIndices(eigen(r.origin()), eigen(r.direction()), points_);
    for (const auto point : points_)
      found.push_back(keys_[static_cast<std::size_t>(point)]);
  }

private:
  ::pcl::PointCloud<::pcl::PointXYZ>::Ptr cloud_{new ::pcl::PointCloud<::pcl::PointXYZ>};
  ::pcl::octree::OctreePointCloudSearch<::pcl::PointXYZ> tree_;
  std::vector<octant_key> keys_;
  ::pcl::Indices points_; ///< one an octant: its rank
};

} // namespace

std::vector<variant> pcl_variants() {
  return {{"pcl", "crossed", timed::yes, "PCL", "PCL, getIntersectedVoxelIndices (float)",
           built_in_cells<point_octree>}};
}

} // namespace graze::peers
