#include <algorithm>
#include <generate/margin.hpp>
#include <limits>

namespace graze::fuzz {

namespace {

using wide = long double;

wide magnitude(wide x) { return x < 0 ? -x : x; }

/// 2^-52 of a number, at least the least positive double: its ulp, or up to twice that.
wide ulp(wide x) { return std::max(magnitude(x) * 0x1p-52L, wide{0x1p-1074}); }

/// A plane as the ray sees it.
struct approach {
  wide distance; ///< plane - origin
  wide unit;     ///< an ulp of the larger of the two
};

} // namespace

double margin(const trial& t) {
  std::array<std::array<approach, max_extent + 1>, 3> planes;
  std::array<wide, 3> speed_unit;
  for (unsigned a = 0; a < 3; ++a) {
    speed_unit[a] = ulp(t.direction[a]);
    for (unsigned k = 0; k <= t.extent[a]; ++k) {
      const wide plane = t.plane(static_cast<int>(a), k);
      const wide origin = t.origin[a];
      planes[a][k] = {plane - origin, ulp(std::max(magnitude(plane), magnitude(origin)))};
    }
  }
  wide least = std::numeric_limits<wide>::infinity();
  for (unsigned c = 0; c < 3; ++c) { // edges along axis c
    const unsigned a = (c + 1) % 3;
    const unsigned b = (c + 2) % 3;
    const wide da = t.direction[a];
    const wide db = t.direction[b];
    const wide dc = t.direction[c];
    if (da == 0 && db == 0)
      continue;
    // the edge's ends, a thousandth of an octant further out
    const wide slack = wide{t.size()} * 0x1p-10L;
    const wide first = planes[c][0].distance - slack;
    const wide last = planes[c][t.extent[c]].distance + slack;
    for (unsigned i = 0; i <= t.extent[a]; ++i)
      for (unsigned j = 0; j <= t.extent[b]; ++j) {
        const approach& pa = planes[a][i];
        const approach& pb = planes[b][j];
        const wide reached = magnitude(da) >= magnitude(db) ? pa.distance / da : pb.distance / db;
        const wide there = reached * dc;
        if (!(reached >= 0) || !(first <= there) || !(there <= last))
          continue;
        const wide determinant = magnitude(pa.distance * db - pb.distance * da);
        const wide unit = pa.unit * magnitude(db) + magnitude(pa.distance) * speed_unit[b] +
                          pb.unit * magnitude(da) + magnitude(pb.distance) * speed_unit[a];
        least = std::min(least, determinant / unit);
      }
  }
  return static_cast<double>(least);
}

} // namespace graze::fuzz
