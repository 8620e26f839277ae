/// OctoMap, in float.
///
///   graze-adapter-octomap ray-keys|cast-ray
///
/// ray-keys: OcTree::computeRayKeys (bench/peers/octomap.cpp). cast-ray: OcTree::castRay again and
/// again, each time with the voxels that it has hit made free.
#include "peer.hpp"
#include <octomap/octomap.h>
#include <string_view>

namespace {

octomap::point3d point(const adapter::vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

void cast_ray(const adapter::request& r, adapter::answer& a) {
  constexpr int centre_key = 32768; // OctoMap's key of the cell [0, resolution)
  std::array<int, 3> first{};
  octomap::OcTreeKey key;
  const adapter::vec3 o = adapter::to_float(r.origin);
  const adapter::vec3 d = adapter::to_float(adapter::scaled(r.direction));
  octomap::OcTree tree(r.voxel_size());
  if (r.level > 14 || !r.in_cells(first) || !adapter::is_finite(o) ||
      !tree.coordToKeyChecked(point(o), key))
    return a.skip();
  a.received(o, d);
  for (const adapter::index3& v : r.voxels()) {
    for (unsigned k = 0; k < 3; ++k)
      key[k] = static_cast<octomap::key_type>(static_cast<int>(v[k]) + first[k] + centre_key);
    tree.setNodeValue(key, 1, true);
  }
  double range = 0; // so far that no voxel of the root lies behind
  for (unsigned k = 0; k < 3; ++k)
    range += std::fabs(o[k]) + std::fabs(r.lo[k]) + r.size;
  octomap::point3d centre;
  while (tree.castRay(point(o), point(d), centre, true, range)) {
    key = tree.coordToKey(centre);
    adapter::index3 voxel{};
    for (unsigned k = 0; k < 3; ++k)
      voxel[k] = static_cast<std::uint64_t>(static_cast<int>(key[k]) - first[k] - centre_key);
    a.visit(voxel);
    tree.setNodeValue(key, -1, true);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view variant = argc > 1 ? argv[1] : "";
  if (variant == "ray-keys")
    return adapter::serve("crossed", adapter::ask_peer<graze::bench::octomap>);
  if (variant == "cast-ray")
    return adapter::serve("crossed", cast_ray);
  std::fprintf(stderr, "usage: graze-adapter-octomap ray-keys|cast-ray\n");
  return 2;
}
