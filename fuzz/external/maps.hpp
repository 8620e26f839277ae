#pragma once
/// Maps from files, each read by a program of its own: graze-adapter-NAME --voxels FILE.
#include <optional>
#include <string>
#include <trial/voxel_map.hpp>

namespace graze::fuzz {

/// Who reads files of an extension.
struct map_reader {
  std::string library, package;
};
/// By the path's extension, whatever its case; the reason lists those that are known.
expected<map_reader> map_reader_of(const std::string& path);

/// Bounds of a map: bytes of its header (planes), occupied voxels.
inline constexpr std::size_t longest_map_header = std::size_t{1} << 28, most_map_voxels = 1u << 26;

/// Reads a map; the reason is one line: no library for this extension, no such program (its package is
/// named), what the library says of the file, or that it ended by a signal.
expected<std::shared_ptr<const voxel_map>> read_map(const map_file& file);
/// The same, where a file is read once in this process.
expected<std::shared_ptr<const voxel_map>> known_map(const map_file& file);

/// As options of an adapter: --voxel-size and --cell-centred, where they are asked for.
std::string adapter_options(const map_file& file);

/// The path from the root, for a program that may work in another folder.
std::string whole_path(const map_file& file);

} // namespace graze::fuzz
