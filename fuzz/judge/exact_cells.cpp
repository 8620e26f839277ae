#include <judge/exact_cells.hpp>

namespace graze::fuzz {

namespace rational = oracle::rational;

namespace {

mpq_class plane_of(const trial& t, unsigned axis, unsigned k) {
  if (!t.grid)
    return mpq_class(t.plane(static_cast<int>(axis), k));
  const grid_planes& g = *t.grid;
  const auto index = static_cast<std::uint32_t>(t.base[axis] + k);
  const double o = g.origin[axis], s = g.spacing[axis];
  if (g.rule == plane_rule::given)
    return mpq_class(g.given[axis][g.flat(axis) ? 0 : index]);
  switch (g.rule) {
  case plane_rule::rounded:
    return mpq_class(rational::plane_rounded(o, s, index));
  case plane_rule::multiplied:
    return mpq_class(rational::plane_multiplied(o, s, index));
  case plane_rule::added:
    return mpq_class(rational::plane_added(o, s, index));
  case plane_rule::binary32:
    return mpq_class(rational::plane_binary32(o, s, index));
  default:
    return rational::plane_exactly(o, s, index);
  }
}

rational::box between(const trial& t, const std::array<unsigned, 3>& first,
                      const std::array<unsigned, 3>& last) {
  rational::box b;
  for (unsigned a = 0; a < 3; ++a) {
    b.lo[a] = plane_of(t, a, first[a]);
    b.hi[a] = plane_of(t, a, last[a]);
  }
  return b;
}

} // namespace

rational::line rational_line(const trial& t) {
  return t.end ? rational::segment_of(t.origin, *t.end) : rational::ray_of(t.origin, t.direction);
}

rational::box rational_cell(const trial& t, octant_number v) {
  if (t.boxes)
    return rational::box_of((*t.boxes)[v].lo, (*t.boxes)[v].hi);
  const std::array<unsigned, 3> at{v & 3u, v >> 2 & 3u, static_cast<unsigned>(v) >> 4};
  return between(t, at, {at[0] + 1, at[1] + 1, at[2] + 1});
}

rational::box rational_block(const trial& t) {
  return between(t, {0, 0, 0}, {t.extent[0], t.extent[1], t.extent[2]});
}

unsigned far_faces_of(const trial& t, octant_number v) {
  if (t.boxes)
    return 0;
  unsigned faces = 0;
  for (unsigned a = 0; a < 3; ++a)
    if (t.base[a] + (v >> (2 * a) & 3u) + 1 == t.count(a))
      faces |= 1u << a;
  return faces;
}

} // namespace graze::fuzz
