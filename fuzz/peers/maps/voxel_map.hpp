#pragma once
/// The voxels of a map that a library has read from its file, and the program's answer to `--voxels FILE`.
/// No library's header is included.
#include <cstdint>
#include <functional>
#include <peers/library.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace graze::peers {

/// Bounds of what is read: bytes of a file, voxels an axis, occupied voxels.
inline constexpr std::uint64_t most_map_bytes = std::uint64_t{1} << 32;
inline constexpr std::uint32_t most_map_count = std::uint32_t{1} << 20;
inline constexpr std::size_t most_map_voxels = std::size_t{1} << 26;

/// The file is not read: why, in one line.
struct map_refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a file may leave open.
struct map_options {
  double voxel_size = 0; ///< for points, and arrays of voxels; 0: not given
  bool cell_centred =
      false; ///< OpenVDB, NanoVDB: index i is at a voxel's centre, not its lowest corner
};

/// Occupied voxels, counted from 0 on each axis of a grid of planes.
struct voxel_map {
  std::string library; ///< and its version
  std::string rule;    ///< how planes and indices were made, in words
  /// What the library calls voxel [0, 0, 0].
  std::array<std::int64_t, 3> first{};
  std::array<std::vector<double>, 3> planes; ///< count + 1 an axis, as the library computes them
  vec3 spacing{}; ///< what it computes them by: they are told by a rule where one gives all of them
  std::vector<octant_index> voxels;
  /// The library's own index of a coordinate on an axis, less `first`; none where it has none.
  std::function<std::int64_t(unsigned axis, double x)> index;
  const char* names = ""; ///< what `first` and the indices are in the library: "keys", "Coord"

  /// Adds one; refuses the map when there are too many.
  void add(const octant_index& at) {
    if (voxels.size() == most_map_voxels)
      throw map_refused("more than 2^26 voxels are occupied: take a part of the map");
    voxels.push_back(at);
  }
  /// Adds a box of them, [lo, hi).
  void add(const octant_index& lo, const octant_index& hi);
};

/// Reads a map. Throws map_refused, or what the library throws.
using map_reader = voxel_map (*)(const std::string& path, const map_options& options);

/// A traversal that builds from a map's file itself.
struct map_variant {
  const char* name; ///< graze-fuzz's: the library's, and the variant's after a dash
  const char* promise;
  const char* summary;
  /// Reports keys of the voxels as `read` counts them, which has read the file into `map`. Throws map_refused, or
  /// what the library throws.
  std::unique_ptr<structure> (*build)(const std::string& path, const map_options& options,
                                      const voxel_map& map);
};

/// What an adapter does with maps.
struct map_library {
  map_reader read;
  std::vector<map_variant> variants;
};

/// The exception that is being handled, in one line.
std::string refusal();

/// Where indices are to count from, so that the planes can be told by a rule: 0, or, where some are
/// below, a power of two below all. A voxel more than the lowest and the highest is in the range, so that
/// the grid's far faces, which are closed, are no occupied voxel's. Refuses ranges of more than 2^20.
struct index_range {
  std::int64_t first = 0;
  std::uint32_t count = 1;
};
index_range range_of(std::int64_t lowest, std::int64_t highest);

/// Lowest and highest index an axis.
struct index_bounds {
  std::array<std::int64_t, 3> lo{INT64_MAX, INT64_MAX, INT64_MAX},
      hi{INT64_MIN, INT64_MIN, INT64_MIN};
  void add(const std::array<std::int64_t, 3>& from, const std::array<std::int64_t, 3>& to);
  [[nodiscard]] bool empty() const { return lo[0] > hi[0]; }
};

/// Reads the file and writes on standard output a line of JSON and the voxels' indices, x fastest, each
/// three numbers of 32 bits, least byte first. The line's members: `library`, `rule`, `grid` (as in replay
/// lines), `first`, `names`, `voxels` (their number), `ambiguous` (the number of those with a face whose
/// double lies in another voxel by the library's index than by the planes; null where the library has no
/// index of its own), `ambiguous_voxels`, the first eight, and `ambiguous_below`, of those for which the same
/// holds of the double below a face. Else one line on standard error. Gives main()'s exit
/// code: 2 where the file is refused. Memory is bounded, 16 GiB, and time, ten minutes of processor: what
/// hostile bytes do to the library ends the process.
int write_map(const char* program, const map_library& library, const std::string& path,
              const map_options& options);

} // namespace graze::peers
