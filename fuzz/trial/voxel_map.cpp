#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <trial/voxel_map.hpp>

namespace graze::fuzz {

namespace {

constexpr unsigned key_bits = 18; // an axis has up to 2^20 voxels, bricks of 4

std::uint64_t key_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x | y << key_bits | z << 2 * key_bits;
}
std::uint64_t key_of(const voxel_index& v) { return key_of(v[0] >> 2, v[1] >> 2, v[2] >> 2); }
unsigned place_of(const voxel_index& v) { return (v[0] & 3) + 4 * ((v[1] & 3) + 4 * (v[2] & 3)); }

/// The place of the n-th bit that is set.
unsigned place_of_bit(std::uint64_t bits, std::uint64_t n) {
  for (; n > 0; --n)
    bits &= bits - 1;
  return static_cast<unsigned>(std::countr_zero(bits));
}

} // namespace

expected<std::shared_ptr<const voxel_map>> voxel_map::make(map_file file,
                                                           std::shared_ptr<const grid_planes> grid,
                                                           const std::vector<voxel_index>& voxels) {
  if (voxels.empty())
    return unexpected{fmt::format("{}: no voxel is occupied", file.path)};
  const std::shared_ptr<voxel_map> map(new voxel_map);
  map->lowest_ = map->highest_ = voxels.front();
  std::vector<std::uint64_t> keys;
  keys.reserve(voxels.size());
  for (const voxel_index& v : voxels) {
    for (unsigned a = 0; a < 3; ++a) {
      if (v[a] >= grid->count[a])
        return unexpected{
            fmt::format("{}: voxel [{}, {}, {}] is outside its grid", file.path, v[0], v[1], v[2])};
      map->lowest_[a] = std::min(map->lowest_[a], v[a]);
      map->highest_[a] = std::max(map->highest_[a], v[a]);
    }
    keys.push_back(key_of(v));
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  map->bricks_.resize(keys.size());
  for (const voxel_index& v : voxels) {
    const auto at = std::lower_bound(keys.begin(), keys.end(), key_of(v)) - keys.begin();
    map->bricks_[static_cast<std::size_t>(at)] |= std::uint64_t{1} << place_of(v);
  }
  std::uint64_t number = 0;
  for (const std::uint64_t brick : map->bricks_)
    map->up_to_.push_back(number += static_cast<std::uint64_t>(std::popcount(brick)));
  map->keys_ = std::move(keys);
  map->file_ = std::move(file);
  map->grid_ = std::move(grid);
  return std::shared_ptr<const voxel_map>(map);
}

voxel_index voxel_map::voxel(std::uint64_t n) const {
  const auto at =
      static_cast<std::size_t>(std::upper_bound(up_to_.begin(), up_to_.end(), n) - up_to_.begin());
  const std::uint64_t before = at == 0 ? 0 : up_to_[at - 1], key = keys_[at];
  const unsigned place = place_of_bit(bricks_[at], n - before);
  constexpr std::uint64_t mask = (std::uint64_t{1} << key_bits) - 1;
  return {static_cast<std::uint32_t>((key & mask) * 4 + (place & 3)),
          static_cast<std::uint32_t>((key >> key_bits & mask) * 4 + (place >> 2 & 3)),
          static_cast<std::uint32_t>((key >> 2 * key_bits) * 4 + (place >> 4))};
}

std::uint64_t voxel_map::brick(std::uint64_t key) const {
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), key);
  return found == keys_.end() || *found != key
             ? 0
             : bricks_[static_cast<std::size_t>(found - keys_.begin())];
}

bool voxel_map::occupied(const voxel_index& at) const {
  for (const std::uint32_t i : at)
    if (i >= max_count)
      return false;
  return (brick(key_of(at)) >> place_of(at) & 1) != 0;
}

std::uint64_t voxel_map::occupied(const std::array<std::uint64_t, 3>& base,
                                  const std::array<std::uint8_t, 3>& extent) const {
  std::uint64_t set = 0, key = ~std::uint64_t{0}, bits = 0;
  for (std::uint32_t z = 0; z < extent[2]; ++z)
    for (std::uint32_t y = 0; y < extent[1]; ++y)
      for (std::uint32_t x = 0; x < extent[0]; ++x) {
        if (base[0] + x >= max_count || base[1] + y >= max_count || base[2] + z >= max_count)
          continue;
        const voxel_index v{static_cast<std::uint32_t>(base[0]) + x,
                            static_cast<std::uint32_t>(base[1]) + y,
                            static_cast<std::uint32_t>(base[2]) + z};
        if (key != key_of(v)) {
          key = key_of(v);
          bits = brick(key);
        }
        set |= (bits >> place_of(v) & 1) << (x + 4 * (y + 4 * z));
      }
  return set;
}

} // namespace graze::fuzz
