#pragma once
/// A map: a grid, and which of its voxels are occupied, as a library reads them from a file.
#include <functional>
#include <graze/expected.hpp>
#include <memory>
#include <string>
#include <trial/grid.hpp>

namespace graze::fuzz {

/// A file, and what it leaves open.
struct map_file {
  std::string path;
  double voxel_size = 0;     ///< for points, and arrays; 0: not given
  bool cell_centred = false; ///< index i is at a voxel's centre (OpenVDB, NanoVDB)

  friend bool operator==(const map_file&, const map_file&) = default;
};

using voxel_index = std::array<std::uint32_t, 3>;

/// At least one voxel is occupied.
class voxel_map {
public:
  /// `voxels`: of the grid, in any order; the reason says which one is not.
  static expected<std::shared_ptr<const voxel_map>> make(map_file file,
                                                         std::shared_ptr<const grid_planes> grid,
                                                         const std::vector<voxel_index>& voxels);

  [[nodiscard]] const map_file& file() const { return file_; }
  [[nodiscard]] const std::shared_ptr<const grid_planes>& grid() const { return grid_; }
  /// The number of occupied voxels.
  [[nodiscard]] std::uint64_t size() const { return up_to_.back(); }
  /// The n-th of them, n < size(); neighbours have numbers near each other.
  [[nodiscard]] voxel_index voxel(std::uint64_t n) const;
  [[nodiscard]] bool occupied(const voxel_index& at) const;
  /// Those of a block of at most 4 x 4 x 4 that are occupied, bit x + 4 (y + 4 z); none outside the grid.
  [[nodiscard]] std::uint64_t occupied(const std::array<std::uint64_t, 3>& base,
                                       const std::array<std::uint8_t, 3>& extent) const;
  /// The lowest and the highest index of them on each axis.
  [[nodiscard]] const voxel_index& lowest() const { return lowest_; }
  [[nodiscard]] const voxel_index& highest() const { return highest_; }

  std::array<std::int64_t, 3> first{}; ///< what the library calls voxel [0, 0, 0]
  std::string about;                   ///< library, rule and ambiguous voxels: a line
  double read_seconds = 0;             ///< that its library took

private:
  voxel_map() = default;
  /// The occupied voxels of the brick of 4 x 4 x 4 voxels at `key`; 0 where there is none.
  [[nodiscard]] std::uint64_t brick(std::uint64_t key) const;

  map_file file_;
  std::shared_ptr<const grid_planes> grid_;
  std::vector<std::uint64_t> keys_, bricks_; ///< by keys, increasing
  std::vector<std::uint64_t> up_to_;         ///< occupied voxels up to each brick, this included
  voxel_index lowest_{}, highest_{};
};

/// Where maps come from by their files: most readers of trials have none.
using map_source = std::function<expected<std::shared_ptr<const voxel_map>>(const map_file&)>;

} // namespace graze::fuzz
