#include <algorithm>
#include <cmath>
#include <graze/oracle/geometry.hpp>
#include <graze/oracle/rational.hpp>
#include <judge/judge.hpp>
#include <limits>
#include <vector>

namespace graze::fuzz {

std::string_view name_of(finding f) {
  static constexpr std::array<std::string_view, finding_kinds> names{
      "crash", "hang", "exception", "nan",     "malformed",    "gross-miss", "crossed-miss", "gap",
      "seam",  "miss", "order",     "revisit", "far-spurious", "spurious",   "outside"};
  return names[static_cast<unsigned>(f)];
}

std::string_view sentence_of(finding f) {
  switch (f) {
  case finding::crash:
    return "asked about the ray, the program ended before it answered";
  case finding::hang:
    return "asked about the ray, the program did not answer in time";
  case finding::exception:
    return "asked about the ray, the traversal threw an exception";
  case finding::not_a_number:
    return "the answer holds a NaN";
  case finding::malformed:
    return "the answer is none that can be read";
  case finding::gross_miss:
    return "the ray is in a voxel on more than 1e-3 of its edge, and it was not reported";
  case finding::crossed_miss:
    return "the ray crosses the interior of a voxel that was not reported";
  case finding::gap:
    return "a length of the ray lies in no voxel that was reported";
  case finding::seam:
    return "the ray runs in the face of two voxels, and neither was reported";
  case finding::miss:
    return "a voxel that the promise names was not reported";
  case finding::order:
    return "voxels were reported in another order than the ray meets them";
  case finding::revisit:
    return "a voxel was reported twice";
  case finding::far_spurious:
    return "a voxel was reported that lies further from the ray than rounding explains";
  case finding::spurious:
    return "a voxel was reported that is none of those promised";
  case finding::outside:
    return "what was reported is no voxel of the grid";
  }
  return {};
}

std::optional<finding> finding_of(std::string_view name) {
  for (unsigned k = 0; k < finding_kinds; ++k)
    if (name_of(static_cast<finding>(k)) == name)
      return static_cast<finding>(k);
  return std::nullopt;
}

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

finding finding_of(fault f) {
  switch (f) {
  case fault::crash:
    return finding::crash;
  case fault::hang:
    return finding::hang;
  case fault::exception:
    return finding::exception;
  case fault::not_a_number:
    return finding::not_a_number;
  default:
    return finding::malformed;
  }
}

} // namespace

truth truth_of(const trial& t) {
  std::array<std::array<double, max_extent + 1>, 3> planes;
  std::array<std::span<const double>, 3> grid;
  for (unsigned a = 0; a < 3; ++a) {
    for (unsigned k = 0; k <= t.extent[a]; ++k)
      planes[a][k] = t.plane(static_cast<int>(a), k);
    grid[a] = std::span<const double>(planes[a].data(), t.extent[a] + 1u);
  }
  const unsigned far_face = t.at_far_face();
  const unsigned near_face = t.at_near_face();
  truth exact;
  thread_local std::vector<oracle::step> steps;
  oracle::steps_in_grid(t.origin, t.direction, grid, steps);
  std::array<const layers*, 3> on;
  for (unsigned a = 0; a < 3; ++a)
    on[a] = places[a][t.extent[a] - 1u][(near_face >> a & 1) | (far_face >> a & 1) << 1].data();
  for (const oracle::step& s : steps) {
    const layers &x = on[0][s.at[0]], &y = on[1][s.at[1]], &z = on[2][s.at[2]];
    const octant_set closed = x.closed & y.closed & z.closed;
    const octant_set owner = x.owner & y.owner & z.owner;
    const bool interior = (s.at[0] & s.at[1] & s.at[2] & 1) != 0;
    exact.touched |= closed;
    exact.crossed |= interior ? closed : 0;
    if (owner != 0 && (exact.owned & owner) == 0) {
      exact.owned |= owner;
      exact.owner_order[exact.owners++] = static_cast<octant_number>(std::countr_zero(owner));
    }
    const bool surrounded = x.surrounded & y.surrounded & z.surrounded;
    if (s.segment && surrounded && exact.length_count < exact.lengths.size())
      exact.lengths[exact.length_count++] = closed;
  }
  return exact;
}

namespace {

/// A point of the ray is proven to be in the box from `near` to `beyond`, which is `box` with its
/// faces moved as far_spurious says, for numbers in its range. The point's coordinate as computed,
/// x, is off by less than 2^-49 (|o| + |x|), in every rounding mode: half of what the faces were
/// moved by is four times as much.
bool comes_near(const trial& t, const cube& box, const vec3& near, const vec3& beyond) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (unsigned a = 0; a < 3; ++a) {
    const double o = t.origin[a], d = t.direction[a];
    if (d == 0)
      continue;
    const double lo = (box.lo[a] - o) / d, hi = (box.hi(static_cast<int>(a)) - o) / d;
    enter = std::max(enter, std::min(lo, hi));
    leave = std::min(leave, std::max(lo, hi));
  }
  const double when = std::max(0.0, (enter + leave) / 2);
  bool inside = true;
  for (unsigned a = 0; a < 3; ++a) {
    const double x = t.origin[a] + when * t.direction[a];
    inside &= (near[a] + box.lo[a]) / 2 <= x;
    inside &= x <= (beyond[a] + box.hi(static_cast<int>(a))) / 2;
  }
  return inside;
}

} // namespace

octant_set far_spurious(const trial& t, const truth& exact, const visited& answer) {
  octant_set left = spurious(exact, answer);
  if (left == 0)
    return 0;
  // every product that a test may form stays within 2^-800..2^800
  for (int a = 0; a < 3; ++a) {
    const double d = std::fabs(t.direction[a]);
    if ((d != 0 && d < 0x1p-250) || d > 0x1p250 || std::fabs(t.origin[a]) > 0x1p250 ||
        std::fabs(t.root.lo[a]) > 0x1p250)
      return 0;
  }
  if (t.root.size > 0x1p250 || t.size() < 0x1p-250)
    return 0;
  octant_set far = 0;
  for (; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const cube box = t.octant(v);
    vec3 near, beyond;
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = box.lo[a];
      const double hi = box.hi(static_cast<int>(a));
      const double reach =
          0x1p-47 * (std::fabs(t.origin[a]) + std::max(std::fabs(lo), std::fabs(hi))) + 0x1p-1000;
      near[a] = lo - reach;
      beyond[a] = hi + reach;
    }
    if (!comes_near(t, box, near, beyond) && !oracle::touches(t.origin, t.direction, near, beyond))
      far |= octant_set{1} << v;
  }
  return far;
}

namespace {

/// Whether the ray's chord in a box is over size / 1000, where long doubles prove it: their
/// exponents hold every value here, and each operation is off by at most epsilon of its result, in
/// any rounding mode; so a time is off by 2 epsilon of itself, the span by 5 of the later time.
std::optional<bool> is_gross(const trial& t, const cube& box) {
  using wide = long double;
  static_assert(std::numeric_limits<wide>::digits >= 53);
  constexpr wide unit = 8 * std::numeric_limits<wide>::epsilon();
  wide in = 0;
  wide out = std::numeric_limits<wide>::infinity();
  wide square_of_length = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const wide d = t.direction[a];
    square_of_length += d * d;
    if (d == 0) {
      if (t.origin[a] < box.lo[a] || t.origin[a] > box.hi(static_cast<int>(a)))
        return false;
      continue;
    }
    const wide to_lo = (wide{box.lo[a]} - wide{t.origin[a]}) / d;
    const wide to_hi = (wide{box.hi(static_cast<int>(a))} - wide{t.origin[a]}) / d;
    in = std::max(in, std::min(to_lo, to_hi));
    out = std::min(out, std::max(to_lo, to_hi));
  }
  const wide length = std::sqrt(square_of_length);
  const wide off = unit * out;
  const wide least = wide{t.size()} / 1000;
  if ((out - in + off) * length < least * (1 - 0x1p-40L))
    return false;
  if ((out - in - off) * length > least * (1 + 0x1p-40L))
    return true;
  return std::nullopt;
}

} // namespace

octant_set gross(const trial& t, octant_set missed) {
  octant_set result = 0;
  for (octant_set left = missed; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const cube box = t.octant(v);
    if (const auto known = is_gross(t, box)) {
      result |= octant_set{*known} << v;
      continue;
    }
    mpq_class square_of_length = 0; // of the direction
    for (const double d : t.direction)
      square_of_length += mpq_class(d) * mpq_class(d);
    const mpq_class least = mpq_class(t.size()) / 1000;
    const auto in = oracle::rational::range_in(t.origin, t.direction, box.lo,
                                               {box.hi(0), box.hi(1), box.hi(2)});
    if (!in)
      continue;
    const mpq_class span = in->second - in->first;
    if (span * span * square_of_length > least * least)
      result |= octant_set{1} << v;
  }
  return result;
}

std::optional<trial> trial_answered(const trial& t, const visited& answer) {
  if (answer.declined())
    return std::nullopt;
  if (!answer.received())
    return t;
  trial at = t;
  at.origin = answer.received()->origin;
  at.direction = answer.received()->direction;
  if (!octree::ray::make(at.origin, at.direction))
    return std::nullopt;
  return at;
}

verdict judge(const trial& t, const truth& exact, const visited& answer, promise p) {
  verdict v;
  v.touched = exact.touched;
  if (answer.failed() != fault::none) {
    v.findings = bit(finding_of(answer.failed()));
    return v;
  }
  v.missed = misses(exact, answer, p);
  v.crossed_missed = crossed_missed(exact, answer);
  v.touched_missed = touched_missed(exact, answer);
  v.visited = answer.set();
  v.spurious = spurious(exact, answer, p);
  v.seams = seams(exact, answer);
  v.gaps = gaps(exact, answer) - v.seams;
  v.order_error = promises_owned(p) && out_of_order(exact, answer);
  if (v.crossed_missed != 0) {
    v.findings |= bit(finding::crossed_miss);
    v.gross_missed = gross(t, v.crossed_missed);
    if (v.gross_missed != 0)
      v.findings |= bit(finding::gross_miss);
  }
  if (v.gaps != 0)
    v.findings |= bit(finding::gap);
  if (v.seams != 0)
    v.findings |= bit(finding::seam);
  if ((v.missed & ~v.crossed_missed) != 0)
    v.findings |= bit(finding::miss);
  if (v.order_error)
    v.findings |= bit(finding::order);
  if (answer.repeated())
    v.findings |= bit(finding::revisit);
  if (answer.outside())
    v.findings |= bit(finding::outside);
  if (v.spurious != 0 && far_spurious(t, exact, answer) != 0)
    v.findings |= bit(finding::far_spurious);
  if (v.spurious != 0 && is_exact(p))
    v.findings |= bit(finding::spurious);
  return v;
}

verdict judge_answer(const trial& t, const visited& answer, promise p) {
  if (const auto at = trial_answered(t, answer))
    return judge(*at, truth_of(*at), answer, p);
  verdict v;
  v.declined = true;
  return v;
}

verdict judge(const trial& t, traversal& under_test) {
  visited answer;
  ask(under_test, t, answer);
  return judge_answer(t, answer, under_test.promises());
}

} // namespace graze::fuzz
