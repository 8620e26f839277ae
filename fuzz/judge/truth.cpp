#include <graze/oracle/lines.hpp>
#include <judge/judge.hpp>

namespace graze::fuzz {

namespace {

/// layer[a][k]: the voxels of index k on axis a.
constexpr auto layer = [] {
  std::array<std::array<octant_set, max_extent>, 3> result{};
  for (unsigned z = 0; z < max_extent; ++z)
    for (unsigned y = 0; y < max_extent; ++y)
      for (unsigned x = 0; x < max_extent; ++x) {
        const octant_set v = octant_set{1} << octant_at(x, y, z);
        result[0][x] |= v;
        result[1][y] |= v;
        result[2][z] |= v;
      }
  return result;
}();

/// What a place on one axis of a block (oracle::place) says about the octants there.
struct layers {
  octant_set closed; ///< those whose closed boxes reach the place
  octant_set owner;  ///< those whose half-open boxes do
  bool surrounded;   ///< on either side there are octants of the block, or the outside of the root
};

/// The one place of a flat axis that lies in the grid.
constexpr std::array<layers, 3> on_flat_axis{layers{layer[0][0], layer[0][0], true},
                                             layers{layer[1][0], layer[1][0], true},
                                             layers{layer[2][0], layer[2][0], true}};

/// places[axis][extent - 1][faces][place]; faces: bit 0 the block starts at the root's near face,
/// bit 1 it ends at the far face.
constexpr auto places = [] {
  std::array<std::array<std::array<std::array<layers, 2 * max_extent + 1>, 4>, max_extent>, 3>
      all{};
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned n = 1; n <= max_extent; ++n)
      for (unsigned faces = 0; faces < 4; ++faces)
        for (unsigned place = 0; place <= 2 * n; ++place) {
          const unsigned k = place / 2;
          layers& at = all[a][n - 1][faces][place];
          at.surrounded = true;
          if (place % 2 != 0) {
            at.closed = at.owner = layer[a][k];
            continue;
          }
          at.closed = (k < n ? layer[a][k] : 0) | (k > 0 ? layer[a][k - 1] : 0);
          at.owner = k < n ? layer[a][k] : ((faces & 2) != 0 ? layer[a][k - 1] : 0);
          at.surrounded = !(k == 0 && (faces & 1) == 0) && !(k == n && (faces & 2) == 0);
        }
  return all;
}();

/// The steps of a ray through octants.
void step_through_octants(const trial& t, std::vector<oracle::step>& steps) {
  std::array<std::array<double, max_extent + 1>, 3> planes;
  std::array<std::span<const double>, 3> grid;
  for (unsigned a = 0; a < 3; ++a) {
    for (unsigned k = 0; k <= t.extent[a]; ++k)
      planes[a][k] = t.octant_plane(static_cast<int>(a), t.base[a] + k);
    grid[a] = std::span<const double>(planes[a].data(), t.extent[a] + 1u);
  }
  oracle::steps_in_grid(t.origin, t.direction, grid, steps);
}

/// The steps of a ray through planes that are doubles.
void step_through_doubles(const trial& t, std::vector<oracle::step>& steps) {
  std::array<std::array<double, max_extent + 1>, 3> planes;
  std::array<std::span<const double>, 3> grid;
  for (unsigned a = 0; a < 3; ++a) {
    const unsigned last = t.flat(a) ? 0 : t.extent[a];
    for (unsigned k = 0; k <= last; ++k)
      planes[a][k] = t.plane(static_cast<int>(a), k);
    grid[a] = std::span<const double>(planes[a].data(), last + 1u);
  }
  oracle::steps_in_grid(t.origin, t.direction, grid, steps);
}

/// Of a segment, or through planes that are none.
void step_through_sums(const trial& t, std::vector<oracle::step>& steps) {
  std::array<std::array<oracle::plane_terms, max_extent + 1>, 3> planes;
  std::array<std::span<const oracle::plane_terms>, 3> grid;
  for (unsigned a = 0; a < 3; ++a) {
    const unsigned last = t.flat(a) ? 0 : t.extent[a];
    for (unsigned k = 0; k <= last; ++k)
      planes[a][k] = exact_plane(t, a, k);
    grid[a] = std::span<const oracle::plane_terms>(planes[a].data(), last + 1u);
  }
  oracle::steps_in_grid(line_of(t), grid, steps);
}

truth truth_of_boxes(const trial& t) {
  truth exact;
  const oracle::line l = line_of(t);
  std::optional<oracle::meeting> soonest, crossed;
  thread_local std::vector<std::pair<octant_number, oracle::meeting>> met;
  met.clear();
  for (std::size_t i = 0; i < t.boxes->size(); ++i) {
    const octree::box& b = (*t.boxes)[i];
    const oracle::meeting m(l, oracle::box_of(b.lo, b.hi));
    if (!m.touches())
      continue;
    const octant_set bit = octant_set{1} << i;
    exact.touched |= bit;
    met.emplace_back(static_cast<octant_number>(i), m);
    const int order = soonest ? compare_entries(m, *soonest) : -1;
    if (order < 0)
      soonest = m;
    exact.soonest = (order < 0 ? 0 : exact.soonest) | (order <= 0 ? bit : 0);
    if (!m.crosses())
      continue;
    exact.crossed |= bit;
    if (!crossed || compare_entries(m, *crossed) < 0) {
      crossed = m;
      exact.first_crossed = static_cast<octant_number>(i);
    }
  }
  for (const auto& [v, m] : met)
    if (!crossed || compare_entries(m, *crossed) <= 0)
      exact.not_after |= octant_set{1} << v;
  return exact;
}

} // namespace

oracle::line line_of(const trial& t) { return {t.origin, t.direction, t.end}; }

oracle::plane_terms exact_plane(const trial& t, unsigned axis, unsigned k) {
  if (t.grid)
    return exact_plane(*t.grid, axis, static_cast<std::uint32_t>(t.base[axis] + k));
  return {t.plane(static_cast<int>(axis), k), 0, 0};
}

truth truth_of(const trial& t) {
  if (t.boxes)
    return truth_of_boxes(t);
  const unsigned far_face = t.at_far_face();
  const unsigned near_face = t.at_near_face();
  truth exact;
  thread_local std::vector<oracle::step> steps;
  if (t.end || (t.grid && t.grid->rule == plane_rule::exact))
    step_through_sums(t, steps);
  else if (t.grid)
    step_through_doubles(t, steps);
  else
    step_through_octants(t, steps);
  std::array<const layers*, 3> on;
  for (unsigned a = 0; a < 3; ++a)
    on[a] =
        t.flat(a)
            ? &on_flat_axis[a]
            : places[a][t.extent[a] - 1u][(near_face >> a & 1) | (far_face >> a & 1) << 1].data();
  const octant_set occupied = t.map ? t.all() : ~octant_set{0};
  const int flat = (t.flat(0) ? 1 : 0) | (t.flat(1) ? 2 : 0) | (t.flat(2) ? 4 : 0);
  for (const oracle::step& s : steps) {
    const layers &x = on[0][s.at[0]], &y = on[1][s.at[1]], &z = on[2][s.at[2]];
    const octant_set around = x.closed & y.closed & z.closed, closed = around & occupied;
    const octant_set owner = x.owner & y.owner & z.owner & occupied;
    const bool interior =
        closed != 0 && ((s.at[0] | flat) & (s.at[1] | flat >> 1) & (s.at[2] | flat >> 2) & 1) != 0;
    if (exact.touched == 0)
      exact.soonest = closed;
    if (interior &&
        exact.crossed == 0) { // entered here, or at the point before this length: touched there
      exact.not_after = exact.touched | closed;
      exact.first_crossed = static_cast<octant_number>(std::countr_zero(closed));
    }
    exact.touched |= closed;
    exact.crossed |= interior ? closed : 0;
    if (owner != 0 && (exact.owned & owner) == 0) {
      exact.owned |= owner;
      exact.owner_order[exact.owners++] = static_cast<octant_number>(std::countr_zero(owner));
    }
    // beside a voxel that is not occupied nobody need report the other
    const bool surrounded =
        (x.surrounded & y.surrounded & z.surrounded) && around == closed && closed != 0;
    if (s.segment && surrounded && exact.length_count < exact.lengths.size())
      exact.lengths[exact.length_count++] = closed;
  }
  if (exact.crossed == 0)
    exact.not_after = exact.touched;
  return exact;
}

} // namespace graze::fuzz
