#include <graze/octree_file.hpp>

#include <bit>
#include <cstring>
#include <graze/support/files.hpp>
#include <zlib.h>

namespace graze::octree {
namespace {

constexpr std::size_t header_size = 68, checksum_size = 4;
constexpr char magic[] = {'G', 'R', 'A', 'Z', 'E', 'O', 'C', 'T'};

class writer {
public:
  explicit writer(std::size_t size) { bytes_.reserve(size); }
  template <class N> void number(N value) {
    for (std::size_t i = 0; i < sizeof(N); ++i)
      bytes_.push_back(static_cast<unsigned char>(value >> (8 * i)));
  }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  template <class Range> void raw(const Range& r) {
    for (const auto b : r)
      bytes_.push_back(static_cast<unsigned char>(b));
  }
  std::vector<unsigned char> bytes_;
};

/// The number at the front, which is taken off. There must be enough bytes.
template <class N> N take(std::span<const unsigned char>& from) {
  N value = 0;
  for (std::size_t i = 0; i < sizeof(N); ++i)
    value = static_cast<N>(value | static_cast<N>(from[i]) << (8 * i));
  from = from.subspan(sizeof(N));
  return value;
}
double take_real(std::span<const unsigned char>& from) {
  return std::bit_cast<double>(take<std::uint64_t>(from));
}

std::uint32_t checksum(std::span<const unsigned char> bytes) {
  return static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), bytes.data(), bytes.size()));
}

} // namespace

expected<std::vector<unsigned char>> encode_octree(const sparse_octree& octree,
                                                   const std::string& description) {
  if (description.size() > longest_description)
    return unexpected{"the description is longer than 65536 bytes"};
  writer out(header_size + description.size() + octree.bytes() + checksum_size);
  out.raw(magic);
  out.number(octree_file_version);
  out.number(static_cast<std::uint32_t>(octree.level()));
  for (const double x : octree.root_octant().lo)
    out.real(x);
  out.real(octree.root_octant().size);
  out.number(std::uint64_t{octree.node_count()});
  out.number(std::uint64_t{octree.leaf_count()});
  out.number(static_cast<std::uint32_t>(description.size()));
  out.raw(description);
  out.raw(octree.masks());
  for (const std::uint32_t first : octree.first_children())
    out.number(first);
  out.raw(octree.leaves());
  out.number(checksum(out.bytes_));
  return std::move(out.bytes_);
}

expected<described_octree> decode_octree(std::span<const unsigned char> bytes) {
  const std::span<const unsigned char> all = bytes;
  if (all.size() < sizeof magic || std::memcmp(all.data(), magic, sizeof magic) != 0)
    return unexpected{"not an octree file"};
  if (all.size() < header_size + checksum_size)
    return unexpected{"the octree file is cut short"};
  bytes = bytes.subspan(sizeof magic);
  if (const auto version = take<std::uint32_t>(bytes); version != octree_file_version)
    return unexpected{"octree file of version " + std::to_string(version) +
                      "; this program knows " + std::to_string(octree_file_version)};
  const auto level = take<std::uint32_t>(bytes);
  cube box{};
  for (double& x : box.lo)
    x = take_real(bytes);
  box.size = take_real(bytes);
  const auto nodes = take<std::uint64_t>(bytes), leaves = take<std::uint64_t>(bytes);
  const auto length = take<std::uint32_t>(bytes);

  // none of these sums can overflow
  constexpr std::uint64_t most = 0xffff'ffff;
  if (nodes > most || leaves > most || length > longest_description)
    return unexpected{"the octree file is corrupt: its counts are out of range"};
  const std::uint64_t size = header_size + length + 5 * nodes + leaves + checksum_size;
  if (all.size() < size)
    return unexpected{"the octree file is cut short: " + std::to_string(all.size()) + " of " +
                      std::to_string(size) + " bytes"};
  if (all.size() > size)
    return unexpected{"the octree file has " + std::to_string(all.size() - size) +
                      " bytes after its end"};
  std::span<const unsigned char> stored = all.last(checksum_size);
  if (take<std::uint32_t>(stored) != checksum(all.first(all.size() - checksum_size)))
    return unexpected{"the octree file is corrupt: its checksum is wrong"};

  const auto root = root_cube::make(box, level > max_level ? 0 : static_cast<int>(level));
  if (!root)
    return unexpected{"the octree file is corrupt: " + root.reason()};
  const auto next = [&](std::size_t count) {
    const auto part = bytes.first(count);
    bytes = bytes.subspan(count);
    return part;
  };
  const auto text = next(length);
  const auto mask_bytes = next(nodes);
  std::vector<std::uint32_t> first(nodes);
  for (std::uint32_t& index : first)
    index = take<std::uint32_t>(bytes);
  std::vector<content> contents;
  contents.reserve(leaves);
  for (const unsigned char c : next(leaves))
    contents.push_back(static_cast<content>(c));
  auto octree = sparse_octree::from_arrays(
      *root, std::vector<std::uint8_t>(mask_bytes.begin(), mask_bytes.end()), std::move(first),
      std::move(contents));
  if (!octree)
    return unexpected{"the octree file is corrupt: " + octree.reason()};
  return described_octree{*std::move(octree), std::string(text.begin(), text.end())};
}

expected<described_octree> load_octree(const std::filesystem::path& path) {
  auto file = support::input_file::open(path.string());
  if (!file)
    return unexpected{file.reason()};
  const auto decoded = [](const std::string& bytes) {
    return decode_octree({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  };
  // what is no octree is refused by its head, however large it is
  auto bytes = file->read(header_size);
  if (bytes && bytes->starts_with(std::string_view(magic, sizeof magic))) {
    auto rest = file->read_all(largest_octree_file);
    if (!rest)
      return unexpected{rest.reason()};
    *bytes += *rest;
  }
  if (!bytes)
    return unexpected{bytes.reason()};
  auto result = decoded(*bytes);
  if (!result)
    return unexpected{support::in_quotes(path.string()) + ": " + result.reason()};
  return result;
}

} // namespace graze::octree
