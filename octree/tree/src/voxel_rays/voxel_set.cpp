// The tree of a voxel set from its sorted keys, one level of nodes after the other.
#include <algorithm>
#include <graze/octree/voxel_set.hpp>
#include <graze/rounding/hardware.hpp>

namespace graze::octree {

std::uint64_t voxel_set::key_of(const std::array<std::uint32_t, 3>& index, int level) {
  std::uint64_t key = 0;
  for (int shift = (level - 1) / 2 * 2; shift >= 0; shift -= 2)
    key = key << 6 | (index[0] >> shift & 3) | (index[1] >> shift & 3) << 2 |
          (index[2] >> shift & 3) << 4;
  return key;
}

namespace {
/// Why no voxel has this index; empty if one has.
std::string wrong_index(const std::array<std::uint32_t, 3>& index,
                        const std::array<std::uint32_t, 3>& count, const char* whole) {
  for (unsigned a = 0; a < 3; ++a)
    if (index[a] >= count[a])
      return "a voxel's index is outside the " + std::string(whole) + ": " +
             std::to_string(index[a]) + " on axis " + std::to_string(a) + ", where there are " +
             std::to_string(count[a]);
  return {};
}
} // namespace

expected<voxel_set> voxel_set::make(const root_cube& root,
                                    std::span<const std::array<std::uint32_t, 3>> voxels) {
  if (root.level() > max_set_level)
    return unexpected{"a voxel set has at most 20 levels"};
  return voxel_set(root).with(voxels, "root");
}

expected<voxel_set> voxel_set::make(const grid& planes,
                                    std::span<const std::array<std::uint32_t, 3>> voxels) {
  return voxel_set(planes).with(voxels, "grid");
}

expected<voxel_set> voxel_set::with(std::span<const std::array<std::uint32_t, 3>> voxels,
                                    const char* whole) && {
  std::array<std::uint32_t, 3> count{};
  for (int a = 0; a < 3; ++a)
    count[static_cast<unsigned>(a)] = grid_ ? grid_->count(a) : std::uint32_t{1} << level_;
  std::vector<std::uint64_t> keys;
  keys.reserve(voxels.size());
  for (const auto& index : voxels) {
    if (std::string why = wrong_index(index, count, whole); !why.empty())
      return unexpected{std::move(why)};
    keys.push_back(key_of(index, level_));
  }
  if (std::string why = take(std::move(keys)); !why.empty())
    return unexpected{std::move(why)};
  return std::move(*this);
}

voxel_set::voxel_set(const grid& planes) : grid_(planes), level_(1) {
  std::array<std::uint32_t, 3> count{};
  for (unsigned a = 0; a < 3; ++a) {
    count[a] = planes.count(static_cast<int>(a));
    level_ = std::max(level_, static_cast<int>(std::bit_width(count[a] - 1)));
  }
  const bool both = planes.rule() == plane_rule::exact;
  std::vector<double> tables;
  const auto add = [&](bool upper) {
    for (int d = 0; d < depth(); ++d) {
      const int shift = 2 * (depth() - 1 - d);
      for (unsigned a = 0; a < 3; ++a) {
        const std::span<const double> all = upper ? planes.upper_planes(static_cast<int>(a))
                                                  : planes.lower_planes(static_cast<int>(a));
        const std::uint64_t octants = ((count[a] - 1) >> shift) + 1, padded = (octants + 3) / 4 * 4;
        if (!upper)
          place_[static_cast<unsigned>(d)][a] = tables.size();
        for (std::uint64_t i = 0; i <= padded; ++i)
          tables.push_back(all[std::min<std::uint64_t>(i << shift, count[a])]);
      }
    }
  };
  add(false);
  if (both) {
    upper_after_ = tables.size();
    add(true);
  }
  tables_ = std::make_shared<const std::vector<double>>(std::move(tables));
}

slabs voxel_set::cell(const voxel& v) const {
  const std::array<std::uint32_t, 3> index{v.index(0), v.index(1), v.index(2)};
  if (grid_)
    return grid_->voxel(index);
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  return octant_cell(v);
}
[[gnu::noinline]] slabs voxel_set::octant_cell(const voxel& v) const {
  unsigned far = 0;
  for (int a = 0; a < 3; ++a)
    far |= v.index(a) + 1 == std::uint32_t{1} << level_ ? 1u << a : 0;
  return {closed_box(octant(v)), far};
}

std::string voxel_set::take(std::vector<std::uint64_t>&& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  if (keys.size() > 0xffff'ffffu)
    return "a voxel set has fewer than 2^32 voxels: split it into several";
  voxels_ = keys.size();
  const int nodes_deep = depth();
  for (int d = 0; d < nodes_deep; ++d) {
    const int below = 6 * (nodes_deep - 1 - d); // bits of a key below this level's own six
    const std::size_t begin = mask_.size();
    std::uint32_t octants = 0; // of this level, so far
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const std::uint64_t octant = keys[k] >> below;
      const bool new_node = k == 0 || octant >> 6 != keys[k - 1] >> below >> 6;
      if (!new_node && octant == keys[k - 1] >> below)
        continue;
      if (new_node) {
        mask_.push_back(0);
        first_.push_back(octants);
      }
      mask_.back() |= std::uint64_t{1} << (octant & 63);
      ++octants;
    }
    if (d == 0 && keys.empty()) {
      mask_.push_back(0);
      first_.push_back(0);
    }
    if (d + 1 < nodes_deep) // the next level's nodes follow this level's
      for (std::size_t n = begin; n < mask_.size(); ++n)
        first_[n] += static_cast<std::uint32_t>(mask_.size());
  }
  return {};
}

} // namespace graze::octree
