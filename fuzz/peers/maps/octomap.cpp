/// OctoMap's files: .bt and .ot, through AbstractOcTree and OcTree::readBinary. The grid is the tree's whole
/// range of keys, a voxel's index its OcTreeKey. A leaf that was pruned is all the voxels of its depth.
#include <cmath>
#include <fstream>
#include <memory>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTreeStamped.h>
#include <octomap/octomap.h>
#include <peers/maps/voxel_map.hpp>

namespace graze::peers {
namespace {

constexpr unsigned depth = 16;
constexpr std::int64_t centre_key = 32768; // OctoMap's key of the cell [0, resolution)

template <class Tree> void add_leaves(voxel_map& map, const Tree& tree) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf))
      continue;
    const ::octomap::OcTreeKey key = leaf.getIndexKey();
    const auto side = std::uint32_t{1} << (depth - leaf.getDepth());
    map.add({key[0], key[1], key[2]}, {key[0] + side, key[1] + side, key[2] + side});
  }
}

std::unique_ptr<::octomap::AbstractOcTree> read_tree(const std::string& path) {
  if (path.ends_with(".bt")) {
    auto tree = std::make_unique<::octomap::OcTree>(1);
    if (!tree->readBinary(path))
      throw map_refused("OctoMap does not read it as a binary map (.bt)");
    return tree;
  }
  std::unique_ptr<::octomap::AbstractOcTree> tree(::octomap::AbstractOcTree::read(path));
  if (!tree)
    throw map_refused("OctoMap does not read it as a map (.ot)");
  return tree;
}

} // namespace

voxel_map octomap_map(const std::string& path, const map_options&) {
  const auto tree = read_tree(path);
  const double resolution = tree->getResolution();
  if (!(resolution > 0) || !std::isfinite(resolution * 65536) || !std::isfinite(1 / resolution))
    throw map_refused("its resolution is no length");
  voxel_map map;
  map.library = "OctoMap";
  map.names = "OcTreeKey";
  map.rule = "planes: (key - 32768) * resolution in double; indices: OcTreeKey, of a coordinate "
             "floor(coordinate * (1 / resolution)) + 32768 in double; pruned leaves expanded";
  if (const auto* t = dynamic_cast<const ::octomap::OcTree*>(tree.get()))
    add_leaves(map, *t);
  else if (const auto* c = dynamic_cast<const ::octomap::ColorOcTree*>(tree.get()))
    add_leaves(map, *c);
  else if (const auto* s = dynamic_cast<const ::octomap::OcTreeStamped*>(tree.get()))
    add_leaves(map, *s);
  else
    throw map_refused("a tree of type " + tree->getTreeType() +
                      ": OcTree, ColorOcTree and OcTreeStamped say which voxels are occupied");
  map.spacing = {resolution, resolution, resolution};
  for (auto& planes : map.planes)
    for (std::int64_t k = 0; k <= 2 * centre_key; ++k)
      planes.push_back(static_cast<double>(k - centre_key) * resolution);
  const auto keys = std::make_shared<::octomap::OcTree>(resolution);
  map.index = [keys](unsigned, double x) -> std::int64_t {
    ::octomap::key_type key = 0;
    if (keys->coordToKeyChecked(x, key))
      return key;
    return x < 0 ? -1 : 2 * centre_key;
  };
  return map;
}

} // namespace graze::peers
