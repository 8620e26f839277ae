/// Arrays as NumPy's files, by xtensor, written to the folder named.
#include "written_map.hpp"
#include <xtensor/xarray.hpp>
#include <xtensor/xnpy.hpp>

namespace {

template <class Array> void dense(const std::string& path) {
  Array array(std::vector<std::size_t>{5, 3, 7}, false);
  written_map map;
  map.path = path;
  for (long x = 0; x < 5; ++x)
    for (long y = 0; y < 3; ++y)
      for (long z = 0; z < 7; ++z)
        if ((x * x + 3 * y + z) % 4 == 1) {
          array(x, y, z) = true;
          map.voxels.insert({x, y, z});
        }
  map.plane = [](unsigned, long i) { return static_cast<double>(i); };
  xt::dump_npy(path, array);
  map.write();
}

template <class Integer, xt::layout_type Layout> void rows(const std::string& path, bool below) {
  xt::xarray<Integer, Layout> array(std::vector<std::size_t>{20, 3}, Integer{0});
  written_map map;
  map.path = path;
  map.options = "--voxel-size 0.3";
  for (long n = 0; n < 20; ++n) {
    const index3 v{n, (n * 7) % 11, 100 - n * (below ? 9 : 2)};
    for (long a = 0; a < 3; ++a)
      array(n, a) = static_cast<Integer>(v[static_cast<std::size_t>(a)]);
    map.voxels.insert(v);
  }
  map.plane = [](unsigned, long i) { return static_cast<double>(i) * 0.3; };
  xt::dump_npy(path, array);
  map.write();
}

} // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  dense<xt::xarray<bool, xt::layout_type::row_major>>(folder + "/npy-c.npy");
  dense<xt::xarray<bool, xt::layout_type::column_major>>(folder + "/npy-fortran.npy");
  rows<int, xt::layout_type::row_major>(folder + "/npy-rows-i4.npy", true);
  rows<long, xt::layout_type::column_major>(folder + "/npy-rows-i8-fortran.npy", true);
  rows<unsigned char, xt::layout_type::row_major>(folder + "/npy-rows-u1.npy", false);
}
