/// decode_octree() refuses what is no octree; what it takes can be walked by rays and is written
/// again as the same bytes.
#include "target.hpp"
#include <algorithm>
#include <graze/octree/descent.hpp>
#include <graze/octree/sound.hpp>
#include <graze/octree/surfaces.hpp>
#include <graze/octree/voxelizer.hpp>
#include <graze/octree_file.hpp>
#include <graze/rounding/nearest.hpp>
#include <zlib.h>

using namespace graze;

namespace {

constexpr std::size_t checksum_size = 4;

/// Puts the right checksum at the end: without it nothing behind it would be reached.
void sign(std::uint8_t* data, std::size_t size) {
  const auto sum = static_cast<std::uint32_t>(crc32_z(0, data, size - checksum_size));
  for (unsigned i = 0; i < checksum_size; ++i)
    data[size - checksum_size + i] = static_cast<std::uint8_t>(sum >> (8 * i));
}

/// The leaves that a ray from the root's corner through its middle meets.
std::size_t leaves_on_diagonal(const octree::sparse_octree& tree) {
  using method = octree::sound<rounding::nearest, octree::convention::closed>;
  const auto ray = octree::ray::make(tree.root_octant().lo, {1, 1, 1});
  std::size_t count = 0;
  const method m(*ray);
  octree::descend(m, tree.root_octant(), tree.level(), tree,
                  [&](const octree::cube&, std::uint32_t n, const method::state&) {
                    count += tree.leaf(n) == octree::content::possible ? 1 : 2;
                    return false;
                  });
  return count;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = octree::decode_octree({data, size});
  if (!read) {
    fuzz::target::require(!read.reason().empty(), "refused without a reason");
    return 0;
  }
  fuzz::target::require(leaves_on_diagonal(read->octree) <= 2 * read->octree.leaf_count(),
                        "more leaves on a ray than there are");
  const auto written = octree::encode_octree(read->octree, read->description);
  fuzz::target::require(written && std::equal(written->begin(), written->end(), data, data + size),
                        "what was read is written as other bytes");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  size = LLVMFuzzerMutate(data, size, max_size);
  if (size > checksum_size && seed % 16 != 0)
    sign(data, size);
  return size;
}

std::vector<std::string> fuzz::target::seeds() {
  std::vector<std::string> all;
  for (const int level : {1, 2, 3})
    for (const double far : {0.0, 1.5, 4.0}) { // part of the surface, all of it, nothing
      const octree::box part{{far == 4 ? 3.0 : -1.5, -1.5, -1.5}, {far, 1.5, 1.5}};
      const auto tree = octree::voxelize(octree::quartdef{}, part, level);
      all.push_back(text_of(*octree::encode_octree(*tree, "quartdef")));
    }
  return all;
}
