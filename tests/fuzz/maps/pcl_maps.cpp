/// Point clouds of PCL, written to the folder named.
#include "written_map.hpp"
#include <cmath>
#include <limits>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/octree/octree_pointcloud_pointvector.h>

namespace {

using cloud = pcl::PointCloud<pcl::PointXYZ>;

struct tree : pcl::octree::OctreePointCloudPointVector<pcl::PointXYZ> {
  using OctreePointCloudPointVector::OctreePointCloudPointVector;
  index3 key(const pcl::PointXYZ& p) const {
    pcl::octree::OctreeKey k;
    genOctreeKeyforPoint(p, k);
    return {k.x, k.y, k.z};
  }
};

void write(const std::string& name, double size, bool reversed) {
  cloud points;
  for (int i = 0; i <= 200; ++i) {
    const int k = reversed ? 200 - i : i;
    points.push_back({static_cast<float>(k * size), static_cast<float>(-k * size / 2), 1.0f});
  }
  written_map map;
  map.options = "--voxel-size " + std::to_string(size);
  // the box from the voxel below the least coordinate on, as the reader says
  const double least[3] = {-1 * size, 0, 0};
  double from[3]{};
  for (int a = 0; a < 3; ++a) {
    double lo = INFINITY;
    for (const auto& p : points)
      lo = std::min(lo, static_cast<double>(p.data[a]));
    from[a] = (std::floor(lo / size) - 1) * size;
  }
  if (from[0] != least[0])
    std::abort();
  tree keys(size);
  keys.defineBoundingBox(from[0], from[1], from[2], from[0] + 256 * size, from[1] + 256 * size,
                         from[2] + 256 * size);
  for (const auto& p : points)
    map.voxels.insert(keys.key(p));
  map.plane = [=](unsigned a, long i) {
    const volatile double product = static_cast<double>(i) * size;
    return product + from[a];
  };
  map.index = [=](unsigned a, double x) {
    return static_cast<long>(std::floor((x - from[a]) / size));
  };
  points.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  points.width = static_cast<std::uint32_t>(points.size());
  points.height = 1;
  points.is_dense = false;
  map.path = name + ".pcd";
  pcl::io::savePCDFileBinary(map.path, points);
  map.write();
  map.path = name + ".ply";
  pcl::io::savePLYFileBinary(map.path, points);
  map.write();
}

} // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  for (const double size : {0.1, 0.3, 0.7}) {
    const std::string name = folder + "/pcl-" + std::to_string(size).substr(0, 3);
    write(name, size, false);
    write(name + "-reversed", size, true);
  }
}
