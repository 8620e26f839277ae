#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <judge/exact_cells.hpp>
#include <judge/first.hpp>
#include <judge/judge.hpp>
#include <limits>

namespace graze::fuzz {

std::string_view name_of(finding f) {
  static constexpr std::array<std::string_view, finding_kinds> names{
      "crash",        "hang",     "exception", "nan",      "malformed", "gross-miss",
      "crossed-miss", "gap",      "seam",      "miss",     "order",     "revisit",
      "far-spurious", "spurious", "outside",   "distance", "face",      "count"};
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
    return "the ray is in a voxel on more than 1e-3 of its greatest edge, and it was not reported";
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
  case finding::distance:
    return "the first voxel's t or distance is off by more than the tolerance";
  case finding::face:
    return "the face that was named is not where the ray comes into the first voxel";
  case finding::count:
    return "the number of crossings of the surface is wrong";
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

namespace {

/// A point of the ray is proven to be in the box from `near` to `beyond`, which is `box` with its
/// faces moved as far_spurious says, for numbers in its range. The point's coordinate as computed,
/// x, is off by less than 2^-49 (|o| + |x|), in every rounding mode: half of what the faces were
/// moved by is four times as much.
bool comes_near(const trial& t, const octree::box& box, const vec3& near, const vec3& beyond) {
  double enter = 0, leave = t.end ? 1 : std::numeric_limits<double>::infinity();
  for (unsigned a = 0; a < 3; ++a) {
    const double o = t.origin[a], d = t.direction[a];
    if (d == 0)
      continue;
    const double lo = (box.lo[a] - o) / d, hi = (box.hi[a] - o) / d;
    enter = std::max(enter, std::min(lo, hi));
    leave = std::min(leave, std::max(lo, hi));
  }
  const double when =
      std::clamp((enter + leave) / 2, 0.0, t.end ? 1 : std::numeric_limits<double>::infinity());
  bool inside = true;
  for (unsigned a = 0; a < 3; ++a) {
    const double x = t.origin[a] + when * t.direction[a];
    inside &= (near[a] + box.lo[a]) / 2 <= x;
    inside &= x <= (beyond[a] + box.hi[a]) / 2;
  }
  return inside;
}

/// Every product that a test may form stays within 2^-800..2^800.
bool in_range(const trial& t) {
  for (unsigned a = 0; a < 3; ++a) {
    const double d = std::fabs(t.direction[a]);
    if ((d != 0 && d < 0x1p-250) || d > 0x1p250 || std::fabs(t.origin[a]) > 0x1p250)
      return false;
  }
  return true;
}
bool in_range(const octree::box& b) {
  for (unsigned a = 0; a < 3; ++a) {
    const double size = b.hi[a] - b.lo[a];
    if (std::fabs(b.lo[a]) > 0x1p250 || std::fabs(b.hi[a]) > 0x1p250 ||
        (size != 0 && size < 0x1p-250))
      return false;
  }
  return true;
}

} // namespace

octant_set far_from(const trial& t, octant_set cells, double share) {
  if (!in_range(t) || (t.cells() == cell_kind::cube &&
                       (t.root.size > 0x1p250 || std::fabs(t.root.lo[0]) > 0x1p250 ||
                        std::fabs(t.root.lo[1]) > 0x1p250 || std::fabs(t.root.lo[2]) > 0x1p250)))
    return 0;
  octant_set far = 0;
  for (octant_set left = cells; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const octree::box box = t.cell(v);
    if (!in_range(box))
      continue;
    vec3 near, beyond;
    for (unsigned a = 0; a < 3; ++a) {
      const double lo = box.lo[a];
      const double hi = box.hi[a];
      const double reach =
          share * (std::fabs(t.origin[a]) + std::max(std::fabs(lo), std::fabs(hi))) + 0x1p-1000;
      near[a] = lo - reach;
      beyond[a] = hi + reach;
    }
    if (!comes_near(t, box, near, beyond) &&
        !(t.end ? oracle::meeting(line_of(t), oracle::box_of(near, beyond)).touches()
                : oracle::touches(t.origin, t.direction, near, beyond)))
      far |= octant_set{1} << v;
  }
  return far;
}

octant_set far_spurious(const trial& t, const truth& exact, const visited& answer,
                        const allowance& allowed) {
  const octant_set left = spurious(exact, answer);
  return left == 0 ? 0 : far_from(t, left, allowed.reach);
}

namespace {

/// The greatest edge of a box; 0 of a point.
double greatest_edge(const octree::box& b) {
  return std::max({b.hi[0] - b.lo[0], b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]});
}

/// Whether the ray's chord in a box is over edge / 1000, where long doubles prove it: their
/// exponents hold every value here, and each operation is off by at most epsilon of its result, in
/// any rounding mode; so a time is off by 3 epsilon of itself (a segment's components are rounded too),
/// the span by 7 of the later time.
std::optional<bool> is_gross(const trial& t, const octree::box& box, double edge) {
  using wide = long double;
  static_assert(std::numeric_limits<wide>::digits >= 53);
  constexpr wide unit = 8 * std::numeric_limits<wide>::epsilon();
  wide in = 0;
  wide out = t.end ? wide{1} : std::numeric_limits<wide>::infinity();
  wide square_of_length = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const wide d = t.end ? wide{(*t.end)[a]} - wide{t.origin[a]} : wide{t.direction[a]};
    square_of_length += d * d;
    if (d == 0) {
      if (t.origin[a] < box.lo[a] || t.origin[a] > box.hi[a])
        return false;
      continue;
    }
    const wide to_lo = (wide{box.lo[a]} - wide{t.origin[a]}) / d;
    const wide to_hi = (wide{box.hi[a]} - wide{t.origin[a]}) / d;
    in = std::max(in, std::min(to_lo, to_hi));
    out = std::min(out, std::max(to_lo, to_hi));
  }
  const wide length = std::sqrt(square_of_length);
  const wide off = unit * out;
  const wide least = wide{edge} / 1000;
  if ((out - in + off) * length < least * (1 - 0x1p-40L))
    return false;
  if ((out - in - off) * length > least * (1 + 0x1p-40L))
    return true;
  return std::nullopt;
}

bool is_gross_exactly(const trial& t, octant_number v) {
  const auto line = rational_line(t);
  const auto cell = rational_cell(t, v);
  mpq_class greatest = 0;
  for (unsigned a = 0; a < 3; ++a)
    greatest = std::max<mpq_class>(greatest, cell.hi[a] - cell.lo[a]);
  mpq_class square_of_length = 0; // of the direction
  for (const mpq_class& d : line.velocity)
    square_of_length += d * d;
  const auto in = oracle::rational::range_in(line, cell);
  if (!in)
    return false;
  const mpq_class least = greatest / 1000;
  const mpq_class span = in->second - in->first;
  return span * span * square_of_length > least * least;
}

} // namespace

octant_set gross(const trial& t, octant_set missed) {
  const bool doubles = !(t.grid && t.grid->rule == plane_rule::exact);
  octant_set result = 0;
  for (octant_set left = missed; left != 0; left &= left - 1) {
    const auto v = static_cast<octant_number>(std::countr_zero(left));
    const octree::box box = t.cell(v);
    const auto known = doubles ? is_gross(t, box, greatest_edge(box)) : std::nullopt;
    if (known ? *known : is_gross_exactly(t, v))
      result |= octant_set{1} << v;
  }
  return result;
}

std::optional<trial> trial_answered(const trial& t, const visited& answer) {
  if (answer.declined())
    return std::nullopt;
  if (!answer.received())
    return t;
  const received_ray& r = *answer.received();
  if (t.end.has_value() !=
      r.end.has_value()) // a segment that became a ray: it says nothing of ours
    return std::nullopt;
  trial at = r.end ? with_end(t, r.origin, *r.end) : with_ray(t, r.origin, r.direction);
  if (r.boxes)
    at.boxes = r.boxes;
  if (!judgeable(at))
    return std::nullopt;
  return at;
}

support::status judgeable(promise p, cell_kind cells) {
  if (cells == cell_kind::boxes && promises_owned(p))
    return unexpected{
        fmt::format("promise {} says nothing of boxes, which may overlap: owning is for "
                    "cells of a grid; take crossed or exactly-touched",
                    name_of(p))};
  return {};
}

allowance allowance_of(const traversal& under_test) {
  return {under_test.tolerance().value_or(usual_tolerance),
          under_test.in_float() ? reach_in_float : allowance{}.reach};
}

verdict judge(const trial& t, const truth& exact, const visited& answer, promise p,
              const allowance& allowed) {
  verdict v;
  v.touched = exact.touched;
  if (answer.failed() != fault::none) {
    v.findings = bit(finding_of(answer.failed()));
    return v;
  }
  if (!judgeable(p, t.cells())) {
    v.declined = true;
    return v;
  }
  switch (p) {
  case promise::first:
  case promise::first_touched:
    if (answer.elsewhere())
      return judge_elsewhere(t, exact, answer, p, allowed);
    return judge_first(t, exact, answer, p, allowed);
  case promise::any:
    return judge_any(t, exact, answer, allowed);
  case promise::count:
    return judge_count(t, exact, answer);
  default:
    break;
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
  if (v.spurious != 0 && far_spurious(t, exact, answer, allowed) != 0)
    v.findings |= bit(finding::far_spurious);
  if (v.spurious != 0 && is_exact(p))
    v.findings |= bit(finding::spurious);
  return v;
}

verdict judge_answer(const trial& t, const visited& answer, promise p, const allowance& allowed) {
  if (const auto at = trial_answered(t, answer))
    return judge(*at, truth_of(*at), answer, p, allowed);
  verdict v;
  v.declined = true;
  return v;
}

verdict judge(const trial& t, traversal& under_test) {
  visited answer;
  ask(under_test, t, answer);
  return judge_answer(t, answer, under_test.promises(), allowance_of(under_test));
}

} // namespace graze::fuzz
