/// OpenVDB, in double and in cells of edge 1.
///
///   graze-adapter-openvdb dda|level-set-hdda|volume-ray-intersector
///
/// dda: DDA from where the ray enters the root to where it leaves it. level-set-hdda: LevelSetHDDA
/// down to the voxel (bench/peers/openvdb.cpp). volume-ray-intersector: it tells leaves of 8^3
/// cells apart and no cells, so that an occupied voxel is a leaf; asked leaf by leaf.
#include "peer.hpp"
#include <openvdb/math/DDA.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/RayIntersector.h>
#include <string_view>

namespace {

using vector = openvdb::Vec3d;
using ray_in_cells = openvdb::math::Ray<double>;

/// The request's ray where the voxel's edge is `cells`, from t = 0 on; tells what was received.
bool ray_of(const adapter::request& r, double cells, ray_in_cells& ray, adapter::answer& a) {
  const adapter::vec3 d = adapter::scaled(r.direction);
  vector eye;
  adapter::vec3 back{};
  for (unsigned k = 0; k < 3; ++k) {
    eye[static_cast<int>(k)] = r.origin[k] / r.voxel_size() * cells;
    back[k] = eye[static_cast<int>(k)] / cells * r.voxel_size();
  }
  if (!adapter::is_finite(back))
    return a.skip(), false;
  a.received(back, d);
  ray = ray_in_cells(eye, vector(d[0], d[1], d[2]), 0.0);
  return true;
}

void dda(const adapter::request& r, adapter::answer& a) {
  std::array<int, 3> first{};
  ray_in_cells ray;
  if (!r.in_cells(first))
    return a.skip();
  const int side = 1 << r.level;
  const vector lo(first[0], first[1], first[2]);
  if (!ray_of(r, 1, ray, a) || !ray.clip(openvdb::BBoxd(lo, lo + vector(side))))
    return;
  openvdb::math::DDA<ray_in_cells> walk(ray);
  do {
    adapter::index3 voxel{};
    bool of_block = true; // the others are empty
    for (unsigned k = 0; k < 3; ++k) {
      voxel[k] = static_cast<std::uint64_t>(walk.voxel()[k] - first[k]);
      of_block = of_block && voxel[k] - r.base[k] < r.extent[k];
    }
    if (of_block)
      a.visit(voxel);
  } while (walk.step());
}

/// A tree of smaller nodes than OpenVDB's own: one is made for each voxel of each ray.
using leaves = openvdb::Grid<openvdb::tree::Tree4<bool, 2, 2, 3>::Type>;

void volume_ray_intersector(const adapter::request& r, adapter::answer& a) {
  constexpr int side = 8; // of a leaf
  std::array<int, 3> first{};
  ray_in_cells ray;
  if (!r.in_cells(first))
    return a.skip();
  if (!ray_of(r, side, ray, a))
    return;
  for (const adapter::index3& voxel : r.voxels()) {
    leaves grid;
    const openvdb::Coord at(static_cast<int>(voxel[0]) + first[0],
                            static_cast<int>(voxel[1]) + first[1],
                            static_cast<int>(voxel[2]) + first[2]);
    grid.tree().touchLeaf({at[0] * side, at[1] * side, at[2] * side})->setValuesOn();
    openvdb::tools::VolumeRayIntersector<leaves> intersector(grid);
    double from = 0, to = 0;
    if (intersector.setIndexRay(ray) && intersector.march(from, to))
      a.visit(voxel);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view variant = argc > 1 ? argv[1] : "";
  if (variant == "dda")
    return adapter::serve("crossed", dda);
  if (variant == "level-set-hdda")
    return adapter::serve("crossed", adapter::ask_peer<graze::bench::openvdb>);
  if (variant == "volume-ray-intersector")
    return adapter::serve("crossed", volume_ray_intersector);
  std::fprintf(stderr, "usage: graze-adapter-openvdb dda|level-set-hdda|volume-ray-intersector\n");
  return 2;
}
