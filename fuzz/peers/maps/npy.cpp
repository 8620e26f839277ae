/// NumPy's files, through xtensor's xnpy: an array of bool with three axes, whose element [i, j, k] is
/// voxel [i, j, k], or an array of integers with three columns, a voxel's index each row.
#include <algorithm>
#include <climits>
#include <fstream>
#include <peers/maps/voxel_map.hpp>
#include <utility>
#include <xtensor/xnpy.hpp>
#include <xtensor/xtensor_config.hpp>

namespace graze::peers {
namespace {

/// What is in the file is what its header says: xnpy does not look.
template <class Array> void check_size(const Array& array, std::istream& file, std::size_t bytes) {
  if (!file || file.peek() != std::char_traits<char>::eof())
    throw map_refused("the file's length is not that of its array");
  std::size_t number = 1;
  for (const std::size_t n : array.shape()) {
    if (n != 0 && number > most_map_bytes / n)
      throw map_refused("the array has more than 2^32 elements");
    number *= n;
  }
  if (number != array.size() || number > most_map_bytes / bytes)
    throw map_refused("the file's length is not that of its array");
}

void add_dense(voxel_map& map, std::array<std::size_t, 3>& count, std::istream& file) {
  const auto array = xt::load_npy<bool>(file);
  check_size(array, file, 1);
  if (array.dimension() != 3)
    throw map_refused("an array of bool with " + std::to_string(array.dimension()) +
                      " axes: three are wanted, of voxels in x, y and z");
  for (unsigned a = 0; a < 3; ++a)
    if (count[a] = array.shape()[a]; count[a] == 0 || count[a] > most_map_count)
      throw map_refused("an axis has " + std::to_string(count[a]) + " voxels: 1 to 2^20 are taken");
  for (std::uint32_t x = 0; x < count[0]; ++x)
    for (std::uint32_t y = 0; y < count[1]; ++y)
      for (std::uint32_t z = 0; z < count[2]; ++z)
        if (array(x, y, z))
          map.add(octant_index{x, y, z});
}

template <class Integer>
void add_rows(voxel_map& map, std::array<std::size_t, 3>& count, std::istream& file) {
  const auto array = xt::load_npy<Integer>(file);
  check_size(array, file, sizeof(Integer));
  if (array.dimension() != 2 || array.shape()[1] != 3)
    throw map_refused("an array of integers that is not N x 3: rows of voxels' indices are wanted");
  index_bounds bounds;
  std::vector<std::array<std::int64_t, 3>> rows;
  if (array.shape()[0] > most_map_voxels)
    throw map_refused("more than 2^26 rows: take a part of the map");
  for (std::size_t row = 0; row < array.shape()[0]; ++row) {
    std::array<std::int64_t, 3> at{};
    for (unsigned a = 0; a < 3; ++a) {
      const Integer i = array(row, a);
      if (std::cmp_greater(i, INT_MAX) || std::cmp_less(i, INT_MIN))
        throw map_refused("row " + std::to_string(row) + " has an index beyond 2^31");
      at[a] = static_cast<std::int64_t>(i);
    }
    rows.push_back(at);
    bounds.add(at, at);
  }
  for (unsigned a = 0; a < 3 && !bounds.empty(); ++a) {
    const index_range range = range_of(bounds.lo[a], bounds.hi[a]);
    map.first[a] = range.first;
    count[a] = range.count;
  }
  for (const auto& at : rows)
    map.add(octant_index{static_cast<std::uint32_t>(at[0] - map.first[0]),
                         static_cast<std::uint32_t>(at[1] - map.first[1]),
                         static_cast<std::uint32_t>(at[2] - map.first[2])});
}

using add_function = void (*)(voxel_map&, std::array<std::size_t, 3>&, std::istream&);

/// The element's type, as xnpy reads it from the header.
std::string type_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 256> start{};
  file.read(start.data(), start.size());
  const std::string text(start.data(), static_cast<std::size_t>(file.gcount()));
  const std::size_t key = text.find("'descr'");
  if (!text.starts_with("\x93NUMPY") || key == std::string::npos)
    throw map_refused("not a file of NumPy's (.npy)");
  const std::size_t from = text.find('\'', key + 7), to = text.find('\'', from + 1);
  if (from == std::string::npos || to == std::string::npos)
    throw map_refused("not an array of bool or of integers");
  return text.substr(from + 1, to - from - 1);
}

voxel_map read(const std::string& path, const map_options& options) {
  static const std::vector<std::pair<std::string, add_function>> types{
      {"|b1", add_dense},
      {"|i1", add_rows<signed char>},
      {"|u1", add_rows<unsigned char>},
      {"<i2", add_rows<short>},
      {"<u2", add_rows<unsigned short>},
      {"<i4", add_rows<int>},
      {"<u4", add_rows<unsigned>},
      {"<i8", add_rows<long>},
      {"<u8", add_rows<unsigned long>}};
  const std::string type = type_of(path);
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == type; });
  if (found == types.end())
    throw map_refused("elements of type '" + type +
                      "': bool, or integers, least byte first, are wanted (astype)");
  voxel_map map;
  map.library = "xtensor " + std::to_string(XTENSOR_VERSION_MAJOR) + "." +
                std::to_string(XTENSOR_VERSION_MINOR) + "." + std::to_string(XTENSOR_VERSION_PATCH);
  std::array<std::size_t, 3> count{};
  std::ifstream file(path, std::ios::binary);
  found->second(map, count, file);
  const double size = options.voxel_size == 0 ? 1 : options.voxel_size;
  map.names = type == "|b1" ? "indices of the array" : "indices of the rows";
  map.rule = std::string(type == "|b1" ? "element [x, y, z] of the array is voxel [x, y, z]"
                                       : "each row is a voxel's x, y, z") +
             ", in C's and in Fortran's order; planes: index * " + std::to_string(size) +
             " in double, since the file has no lengths";
  map.spacing = {size, size, size};
  for (unsigned a = 0; a < 3; ++a)
    for (std::size_t k = 0; count[a] != 0 && k <= count[a]; ++k)
      map.planes[a].push_back(static_cast<double>(static_cast<std::int64_t>(k) + map.first[a]) *
                              size);
  return map;
}

} // namespace

map_library npy_map() { return {read, {}}; }

} // namespace graze::peers
