#pragma once
/// Octrees as bytes and from files. A target of its own, graze::octree_file: it needs zlib for the
/// checksum, graze::octree needs nothing.
///
/// The format, version 1, all numbers little endian:
///   offset  size  what
///        0     8  "GRAZEOCT"
///        8     4  version
///       12     4  level, 1 to 53
///       16    32  the root cube: lower corner x, y, z, size (binary64)
///       48     8  number n of nodes, the root included
///       56     8  number m of leaves
///       64     4  length k of the description, at most 65536
///       68     k  description, the voxelizer's words on what was voxelized
///             n   child masks, sparse_octree::masks()
///             4n  first children, sparse_octree::first_children()
///             m   leaves: 1 possible, 2 certified
///             4   CRC-32 (zlib's, ISO 3309) of all bytes before
#include <cstdint>
#include <filesystem>
#include <graze/octree/sparse_octree.hpp>
#include <string>
#include <vector>

namespace graze::octree {

struct described_octree {
  sparse_octree octree;
  std::string description;
};

inline constexpr std::uint32_t octree_file_version = 1;
inline constexpr std::size_t longest_description = 65536; ///< bytes

/// The bytes of a file. The same octree and description give the same bytes. Refuses a description
/// that is longer than longest_description.
[[nodiscard]] expected<std::vector<unsigned char>> encode_octree(const sparse_octree& octree,
                                                                 const std::string& description);

/// An octree from bytes of any origin. Refuses, with one line that says what is wrong, whatever
/// encode_octree does not write: another kind of file or version, one cut short or with bytes after
/// its end, a wrong checksum, and, should the checksum be right, numbers that do not make an
/// octree. Takes memory and time in proportion to the bytes that are there, whatever numbers they
/// hold.
[[nodiscard]] expected<described_octree> decode_octree(std::span<const unsigned char> bytes);

/// Bytes of a file: more than 2^32 nodes and as many leaves need.
inline constexpr std::uint64_t largest_octree_file = std::uint64_t{6} << 32;

/// decode_octree of a regular file; the reason names it.
[[nodiscard]] expected<described_octree> load_octree(const std::filesystem::path& file);

} // namespace graze::octree
