/// Maps of OctoMap, written to the folder named.
#include "written_map.hpp"
#include <octomap/ColorOcTree.h>
#include <octomap/octomap.h>

namespace {

/// Points on the faces of voxels, a block that is pruned, and a free voxel.
template <class Tree> written_map filled(Tree& tree, const std::string& path) {
  written_map map;
  map.path = path;
  const auto occupy = [&](const octomap::OcTreeKey& key) {
    tree.updateNode(key, true);
    map.voxels.insert({key[0], key[1], key[2]});
  };
  const double r = tree.getResolution();
  for (int k = -40; k <= 40; ++k)
    occupy(tree.coordToKey(k * r, -k * r, 3 * r));
  for (unsigned short x = 0; x < 8; ++x)
    for (unsigned short y = 0; y < 8; ++y)
      for (unsigned short z = 0; z < 8; ++z)
        occupy(octomap::OcTreeKey(32768 + 64 + x, 32768 - 64 + y, 32768 + z));
  tree.updateNode(tree.coordToKey(60 * r, 60 * r, 60 * r), false);
  map.plane = [r](unsigned, long key) { return static_cast<double>(key - 32768) * r; };
  map.index = [&tree](unsigned, double x) -> long { return tree.coordToKey(x); };
  return map;
}

} // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  for (const double r : {0.1, 0.3, 0.7, 0.25}) {
    const std::string name = folder + "/octomap-" + std::to_string(r).substr(0, 4);
    octomap::OcTree tree(r);
    filled(tree, name + ".ot").write();
    tree.write(name + ".ot"); // as it is: nothing pruned
    filled(tree, name + ".bt").write();
    tree.writeBinary(name + ".bt"); // prunes
    octomap::ColorOcTree colours(r);
    filled(colours, name + "-colours.ot").write();
    colours.prune();
    colours.write(name + "-colours.ot");
  }
}
