// The tree of a voxel set from its sorted keys, one level of nodes after the other.
#include <algorithm>
#include <graze/octree/voxel_set.hpp>

namespace graze::octree {

std::uint64_t voxel_set::key_of(const std::array<std::uint32_t, 3>& index, int level) {
  std::uint64_t key = 0;
  for (int shift = (level - 1) / 2 * 2; shift >= 0; shift -= 2)
    key = key << 6 | (index[0] >> shift & 3) | (index[1] >> shift & 3) << 2 |
          (index[2] >> shift & 3) << 4;
  return key;
}

expected<voxel_set> voxel_set::make(const root_cube& root,
                                    std::span<const std::array<std::uint32_t, 3>> voxels) {
  if (root.level() > max_set_level)
    return unexpected{"a voxel set has at most 20 levels"};
  std::vector<std::uint64_t> keys;
  keys.reserve(voxels.size());
  for (const auto& index : voxels) {
    for (const std::uint32_t i : index)
      if (i >> root.level() != 0)
        return unexpected{"a voxel's index is outside the root"};
    keys.push_back(key_of(index, root.level()));
  }
  return from_keys(root, std::move(keys));
}

expected<voxel_set> voxel_set::from_keys(const root_cube& root, std::vector<std::uint64_t>&& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  if (keys.size() > 0xffff'ffffu)
    return unexpected{"a voxel set has fewer than 2^32 voxels"};
  voxel_set set(root);
  set.voxels_ = keys.size();
  const int depth = set.depth();
  for (int d = 0; d < depth; ++d) {
    const int below = 6 * (depth - 1 - d); // bits of a key below this level's own six
    const std::size_t begin = set.mask_.size();
    std::uint32_t octants = 0; // of this level, so far
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const std::uint64_t octant = keys[k] >> below;
      const bool new_node = k == 0 || octant >> 6 != keys[k - 1] >> below >> 6;
      if (!new_node && octant == keys[k - 1] >> below)
        continue;
      if (new_node) {
        set.mask_.push_back(0);
        set.first_.push_back(octants);
      }
      set.mask_.back() |= std::uint64_t{1} << (octant & 63);
      ++octants;
    }
    if (d == 0 && keys.empty()) {
      set.mask_.push_back(0);
      set.first_.push_back(0);
    }
    if (d + 1 < depth) // the next level's nodes follow this level's
      for (std::size_t n = begin; n < set.mask_.size(); ++n)
        set.first_[n] += static_cast<std::uint32_t>(set.mask_.size());
  }
  return set;
}

} // namespace graze::octree
