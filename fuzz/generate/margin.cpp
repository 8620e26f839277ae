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

/// The planes of the block on an axis, or of a box of a list: in pairs, or more.
using planes_of_axis = std::array<double, max_extent + 1>;

/// Of the edges between so many planes an axis.
wide margin_among(const trial& t, const std::array<planes_of_axis, 3>& places,
                  const std::array<unsigned, 3>& last) {
  std::array<std::array<approach, max_extent + 1>, 3> planes;
  std::array<wide, 3> speed, speed_unit;
  for (unsigned a = 0; a < 3; ++a) {
    speed[a] = t.end ? wide{(*t.end)[a]} - wide{t.origin[a]} : wide{t.direction[a]};
    speed_unit[a] = ulp(speed[a]);
    for (unsigned k = 0; k <= last[a]; ++k) {
      const wide plane = places[a][k];
      const wide origin = t.origin[a];
      planes[a][k] = {plane - origin, ulp(std::max(magnitude(plane), magnitude(origin)))};
    }
  }
  const wide longest = t.end ? wide{1} + 0x1p-10L : std::numeric_limits<wide>::infinity();
  wide least = std::numeric_limits<wide>::infinity();
  for (unsigned c = 0; c < 3; ++c) { // edges along axis c
    const unsigned a = (c + 1) % 3;
    const unsigned b = (c + 2) % 3;
    const wide da = speed[a];
    const wide db = speed[b];
    const wide dc = speed[c];
    if (da == 0 && db == 0)
      continue;
    // the edge's ends, a thousandth of an octant further out
    const wide edge = t.cells() == cell_kind::cube
                          ? wide{t.size()}
                          : (wide{places[c][last[c]]} - wide{places[c][0]}) / last[c];
    const wide slack = edge * 0x1p-10L;
    const wide first = planes[c][0].distance - slack;
    const wide end = planes[c][last[c]].distance + slack;
    for (unsigned i = 0; i <= last[a]; ++i)
      for (unsigned j = 0; j <= last[b]; ++j) {
        const approach& pa = planes[a][i];
        const approach& pb = planes[b][j];
        const wide reached = magnitude(da) >= magnitude(db) ? pa.distance / da : pb.distance / db;
        const wide there = reached * dc;
        if (!(reached >= 0) || !(reached <= longest) || !(first <= there) || !(there <= end))
          continue;
        const wide determinant = magnitude(pa.distance * db - pb.distance * da);
        const wide unit = pa.unit * magnitude(db) + magnitude(pa.distance) * speed_unit[b] +
                          pb.unit * magnitude(da) + magnitude(pb.distance) * speed_unit[a];
        least = std::min(least, determinant / unit);
      }
  }
  return least;
}

} // namespace

double margin(const trial& t) {
  std::array<planes_of_axis, 3> planes;
  if (!t.boxes) {
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned k = 0; k <= t.extent[a]; ++k)
        planes[a][k] = t.plane(static_cast<int>(a), k);
    return static_cast<double>(margin_among(t, planes, {t.extent[0], t.extent[1], t.extent[2]}));
  }
  wide least = std::numeric_limits<wide>::infinity();
  for (const octree::box& box : *t.boxes) {
    for (unsigned a = 0; a < 3; ++a) {
      planes[a][0] = box.lo[a];
      planes[a][1] = box.hi[a];
    }
    least = std::min(least, margin_among(t, planes, {1, 1, 1}));
  }
  return static_cast<double>(least);
}

} // namespace graze::fuzz
