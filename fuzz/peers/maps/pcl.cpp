/// Point clouds, .pcd and .ply, through PCL's readers: a voxel of the size that is asked for is occupied where
/// PCL's octree, with its bounding box defined beforehand, has a leaf.
#include <cmath>
#include <memory>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/octree/octree_search.h>
#include <pcl/pcl_config.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <peers/maps/voxel_map.hpp>
#include <peers/rounded_ray.hpp>

namespace graze::peers {
namespace {

using cloud = ::pcl::PointCloud<::pcl::PointXYZ>;

class leaves : public ::pcl::octree::OctreePointCloudSearch<::pcl::PointXYZ> {
public:
  using OctreePointCloudSearch::OctreePointCloudSearch;
  [[nodiscard]] octant_index key(const ::pcl::PointXYZ& p) const {
    ::pcl::octree::OctreeKey k;
    genOctreeKeyforPoint(p, k);
    return {k.x, k.y, k.z};
  }
  [[nodiscard]] std::int64_t key_on(unsigned axis, double x) const {
    const std::array<double, 3> least{min_x_, min_y_, min_z_};
    return static_cast<std::int64_t>(std::floor((x - least[axis]) / resolution_));
  }
};

/// PCL's reader of files ends the process where there is no header of points.
void check_header(const std::string& path) {
  ::pcl::PCLPointCloud2 header;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0, type = 0;
  unsigned at = 0;
  const int failed =
      ::pcl::PCDReader().readHeader(path, header, origin, orientation, version, type, at);
  if (failed != 0 || header.fields.empty() || header.width * header.height == 0)
    throw map_refused("PCL does not read it as a point cloud (.pcd)");
}

cloud::Ptr read_cloud(const std::string& path) {
  if (!path.ends_with(".ply"))
    check_header(path);
  cloud::Ptr points(new cloud);
  const int failed = path.ends_with(".ply") ? ::pcl::io::loadPLYFile(path, *points)
                                            : ::pcl::io::loadPCDFile(path, *points);
  if (failed != 0)
    throw map_refused("PCL does not read it as a point cloud");
  cloud::Ptr finite(new cloud);
  for (const ::pcl::PointXYZ& p : *points)
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      finite->push_back(p);
  if (finite->empty())
    throw map_refused("it holds no point that is finite");
  return finite;
}

/// The octree of a file's points, its bounding box defined from the voxel below the least coordinate on.
struct tree_of_points {
  cloud::Ptr points;
  std::unique_ptr<leaves> tree;
  std::array<double, 3> from{}, to{}; ///< its own bounding box
};

tree_of_points read_tree(const std::string& path, const map_options& options) {
  const double size = options.voxel_size;
  if (size == 0)
    throw map_refused("points have no voxels: say their size (--voxel-size)");
  tree_of_points t{read_cloud(path), std::make_unique<leaves>(size)};
  std::array<double, 3> lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
  for (const ::pcl::PointXYZ& p : *t.points)
    for (unsigned a = 0; a < 3; ++a) {
      lo[a] = std::min(lo[a], static_cast<double>(p.data[a]));
      hi[a] = std::max(hi[a], static_cast<double>(p.data[a]));
    }
  double side = 2; // voxels, a power of two: the tree's own box is then this one
  for (unsigned a = 0; a < 3; ++a) {
    lo[a] = (std::floor(lo[a] / size) - 1) * size;
    while (!(hi[a] < lo[a] + (side - 1) * size))
      if (side *= 2; side > most_map_count)
        throw map_refused("the points span more than 2^20 voxels of this size on an axis");
  }
  const double edge = side * size;
  t.tree->setInputCloud(t.points);
  t.tree->defineBoundingBox(lo[0], lo[1], lo[2], lo[0] + edge, lo[1] + edge, lo[2] + edge);
  t.tree->getBoundingBox(t.from[0], t.from[1], t.from[2], t.to[0], t.to[1], t.to[2]);
  t.tree->addPointsFromInputCloud();
  return t;
}

class octree_of_map final : public structure {
public:
  octree_of_map(const std::string& path, const map_options& options)
      : of_points_(read_tree(path, options)) {}

  [[nodiscard]] std::optional<octree::ray> received(const octree::ray& r) const override {
    return ray_in_float(r);
  }

  void visit(const octree::ray& r, std::vector<octant_key>& found) override {
    const auto eigen = [](const vec3& v) {
      return Eigen::Vector3f(static_cast<float>(v[0]), static_cast<float>(v[1]),
                             static_cast<float>(v[2]));
    };
    indices_.clear();
    of_points_.tree->getIntersectedVoxelIndices(eigen(r.origin()), eigen(r.direction()), indices_);
    for (const auto point : indices_) { // all points of one voxel after the other
      const octant_key at =
          key_of(of_points_.tree->key((*of_points_.points)[static_cast<std::size_t>(point)]));
      if (found.empty() || found.back() != at)
        found.push_back(at);
    }
  }

private:
  tree_of_points of_points_;
  ::pcl::Indices indices_;
};

std::unique_ptr<structure> built_from(const std::string& path, const map_options& options,
                                      const voxel_map&) {
  return std::make_unique<octree_of_map>(path, options);
}

voxel_map read(const std::string& path, const map_options& options) {
  const double size = options.voxel_size;
  const tree_of_points t = read_tree(path, options);
  const leaves& tree = *t.tree;
  const auto &from = t.from, &to = t.to;
  voxel_map map;
  for (auto leaf = tree.leaf_depth_begin(); leaf != tree.leaf_depth_end(); ++leaf) {
    const auto& key = leaf.getCurrentOctreeKey();
    map.add(octant_index{key.x, key.y, key.z});
  }
  const auto count = std::size_t{1} << tree.getTreeDepth();
  if (count > most_map_count)
    throw map_refused("PCL's octree is deeper than 20 levels");
  map.spacing = {size, size, size};
  for (unsigned a = 0; a < 3; ++a)
    for (std::size_t k = 0; k <= count; ++k) {
      const volatile double product = static_cast<double>(k) * size;
      map.planes[a].push_back(product + from[a]);
    }
  map.library = std::string("PCL ") + PCL_VERSION_PRETTY;
  map.names = "OctreeKey";
  map.rule =
      "a voxel is a leaf of its octree, whose bounding box was defined from the voxel below the "
      "least coordinate on; planes: key * resolution + least in double, before they are rounded to "
      "float; indices: floor((x - least) / resolution) in double; points that are not finite are "
      "left out";
  const auto keys = std::make_shared<leaves>(size);
  keys->defineBoundingBox(from[0], from[1], from[2], to[0], to[1], to[2]);
  map.index = [keys](unsigned axis, double x) { return keys->key_on(axis, x); };
  return map;
}

} // namespace

map_library pcl_map() {
  return {
      read,
      {{"pcl", "crossed", "PCL, getIntersectedVoxelIndices through the map (float)", built_from}}};
}

} // namespace graze::peers
