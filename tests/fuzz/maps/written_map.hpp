#pragma once
/// What a test's map is beside its file: FILE.expected, lines of words that maps_test.py compares with what an
/// adapter reads. Written by the library that wrote the map, through its other functions than the reader's.
///   voxel I J K         an occupied voxel, by the library's own index
///   plane A I X         the library's coordinate (%a) of the lower face of index I on axis A
///   ambiguous N M       so many voxels have a face whose double has another index; of which the double below has
///   option --NAME ...   what the adapter is to be given
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <set>
#include <string>

using index3 = std::array<long, 3>;

struct written_map {
  std::string path, options;
  std::set<index3> voxels;
  std::function<double(unsigned axis, long index)> plane;
  std::function<long(unsigned axis, double x)> index; ///< none: not known

  void write() const {
    FILE* to = std::fopen((path + ".expected").c_str(), "w");
    if (to == nullptr)
      std::abort();
    long ambiguous = 0, ambiguous_below = 0;
    std::set<std::pair<unsigned, long>> planes;
    for (const index3& v : voxels) {
      std::fprintf(to, "voxel %ld %ld %ld\n", v[0], v[1], v[2]);
      bool is = false, is_below = false;
      for (unsigned a = 0; a < 3; ++a)
        for (long i = v[a]; i <= v[a] + 1; ++i) {
          planes.insert({a, i});
          const double p = plane(a, i);
          if (!index)
            continue;
          is = is || index(a, p) != i;
          is_below = is_below ||
                     index(a, std::nextafter(p, -std::numeric_limits<double>::infinity())) != i - 1;
        }
      ambiguous += is;
      ambiguous_below += is_below;
    }
    for (const auto& [a, i] : planes)
      std::fprintf(to, "plane %u %ld %a\n", a, i, plane(a, i));
    if (index)
      std::fprintf(to, "ambiguous %ld %ld\n", ambiguous, ambiguous_below);
    if (!options.empty())
      std::fprintf(to, "option %s\n", options.c_str());
    std::fclose(to);
  }
};
