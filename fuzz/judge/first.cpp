#include <algorithm>
#include <cmath>
#include <judge/exact_cells.hpp>
#include <judge/first.hpp>
#include <limits>

namespace graze::fuzz {

namespace rational = oracle::rational;

namespace {

constexpr octant_set bit_of(octant_number v) { return octant_set{1} << v; }

/// The first crossed cell is not reported, or another is that lies behind it.
void miss_first_crossed(const trial& t, const truth& exact, verdict& v) {
  v.missed = v.crossed_missed = bit_of(exact.first_crossed);
  v.findings |= bit(finding::crossed_miss);
  v.gross_missed = gross(t, v.crossed_missed);
  if (v.gross_missed != 0)
    v.findings |= bit(finding::gross_miss);
}

/// A box with its faces moved outwards, as allowance::reach says.
rational::box dilated(const trial& t, octant_number v, double share) {
  rational::box b = rational_cell(t, v);
  for (unsigned a = 0; a < 3; ++a) {
    const mpq_class reach =
        (abs(mpq_class(t.origin[a])) + std::max<mpq_class>(abs(b.lo[a]), abs(b.hi[a]))) *
            mpq_class(share) +
        mpq_class(0x1p-1000);
    b.lo[a] -= reach;
    b.hi[a] += reach;
  }
  return b;
}

/// An untouched cell for which rounding may account, but which the ray comes to only after it has left
/// the first crossed one.
bool behind_first_crossed(const trial& t, const truth& exact, octant_number v, double share) {
  const auto line = rational_line(t);
  const auto there = rational::range_in(line, dilated(t, v, share));
  const auto first = rational::range_in(line, rational_cell(t, exact.first_crossed));
  return there && first && there->first > first->second;
}

/// The entry of a line into a cell that it touches, and what rounding in double makes of it.
struct exact_entry {
  exact_entry(const trial& t, octant_number v) : line(rational_line(t)), cell(rational_cell(t, v)) {
    const auto range = rational::range_in(line, cell);
    at = range ? range->first : mpq_class(0);
    double largest_origin = 0, largest_point = 0, largest_speed = 0;
    unit = std::fabs(at.get_d());
    for (unsigned a = 0; a < 3; ++a) {
      const double o = std::fabs(t.origin[a]), d = std::fabs(line.velocity[a].get_d());
      const mpq_class place = line.origin[a] + at * line.velocity[a];
      const double p = std::fabs(place.get_d());
      largest_origin = std::max(largest_origin, o);
      largest_point = std::max(largest_point, p);
      largest_speed = std::max(largest_speed, d);
      speed += line.velocity[a] * line.velocity[a];
      if (d != 0 && at > 0 && (place == cell.lo[a] || place == cell.hi[a]))
        unit = std::max(unit, (o + p) / d);
    }
    unit = std::max(unit, (largest_origin + largest_point) / largest_speed) * 0x1p-52;
    unit = std::max(unit, least);
  }

  static constexpr double least = 0x1p-1074; ///< the ulp of what is subnormal

  rational::line line;
  rational::box cell;
  mpq_class at;        ///< t
  double unit = 0;     ///< an ulp of the largest quotient on the way to t
  mpq_class speed = 0; ///< squared
};

bool within(const mpq_class& x, double allowed) {
  return !std::isfinite(allowed) || abs(x) <= mpq_class(allowed);
}

constexpr double most = std::numeric_limits<double>::max();

bool right_t(const exact_entry& e, double said, double tolerance) {
  if (!std::isfinite(said)) // as good as any where it is beyond the doubles
    return said > 0 && e.at > mpq_class(most);
  return within(mpq_class(said) - e.at, tolerance * e.unit);
}

/// The way to the entry, and by how much what is said of it may be off.
struct exact_way {
  exact_way(const exact_entry& e, double tolerance) {
    const mpf_class speed = sqrt(mpf_class(e.speed, bits));
    length = mpf_class(e.at, bits) * speed;
    allowed = tolerance * std::max(e.unit * speed.get_d(), exact_entry::least);
  }
  static constexpr mp_bitcnt_t bits = 2400; ///< the square root of a double's square has no fewer
  mpf_class length{0, bits};
  double allowed = 0;
};

bool right_distance(const exact_entry& e, double said, double tolerance) {
  const exact_way way(e, tolerance);
  if (!std::isfinite(said))
    return said > 0 && way.length > most;
  const mpf_class off = mpf_class(said, exact_way::bits) - way.length;
  return !std::isfinite(way.allowed) || abs(off) <= mpf_class(way.allowed, exact_way::bits);
}

/// The entry lies on the face, or the ray comes to its plane within the tolerance of it: at an edge each
/// of the faces is right.
bool right_face(const exact_entry& e, const face& f, double tolerance) {
  const mpq_class& plane = f.upper ? e.cell.hi[f.axis] : e.cell.lo[f.axis];
  const mpq_class &o = e.line.origin[f.axis], &d = e.line.velocity[f.axis];
  if (d == 0)
    return plane == o;
  return within((plane - o) / d - e.at, tolerance * e.unit);
}

void judge_remarks(const trial& t, octant_number v, const remarks& said, double tolerance,
                   verdict& result) {
  if (!said.t && !said.distance && !said.entered && !said.no_face)
    return;
  const exact_entry e(t, v);
  if ((said.t && !right_t(e, *said.t, tolerance)) ||
      (said.distance && !right_distance(e, *said.distance, tolerance)))
    result.findings |= bit(finding::distance);
  if ((said.entered && !right_face(e, *said.entered, tolerance)) ||
      (said.no_face && !within(e.at, tolerance * e.unit)))
    result.findings |= bit(finding::face);
}

/// The least double that is not below x.
double at_least(const mpq_class& x) {
  if (x > mpq_class(most))
    return std::numeric_limits<double>::infinity();
  if (x < mpq_class(-most))
    return -most;
  const double near = x.get_d(); // towards 0
  return mpq_class(near) < x ? std::nextafter(near, std::numeric_limits<double>::infinity()) : near;
}

/// The doubles from which to which x is within what is allowed; above the greatest double all there are.
std::array<double, 2> around(const mpq_class& x, double allowed) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (!std::isfinite(allowed))
    return {-infinite, infinite};
  const mpq_class off(allowed);
  return {at_least(x - off), x > mpq_class(most) ? infinite : -at_least(-x - off)};
}

verdict verdict_of(const truth& exact, const visited& answer) {
  verdict v;
  v.touched = exact.touched;
  v.visited = answer.set();
  if (answer.outside())
    v.findings |= bit(finding::outside);
  return v;
}

} // namespace

right_entry entry_into(const trial& t, octant_number v, double tolerance) {
  const exact_entry e(t, v);
  const exact_way way(e, tolerance);
  right_entry right{
      around(e.at, tolerance * e.unit), around(mpq_class(way.length), way.allowed), {}};
  for (unsigned a = 0; a < 3; ++a)
    for (const bool upper : {false, true})
      if (right_face(e, {static_cast<std::uint8_t>(a), upper}, tolerance))
        right.faces.push_back({upper ? '+' : '-', "xyz"[a]});
  if (within(e.at, tolerance * e.unit))
    right.faces.emplace_back("none");
  return right;
}

verdict judge_first(const trial& t, const truth& exact, const visited& answer, promise p,
                    const allowance& allowed) {
  verdict v = verdict_of(exact, answer);
  const bool soonest = p == promise::first_touched;
  if (answer.size() > 1 || answer.repeated()) { // not one cell
    v.findings |= bit(finding::malformed);
    return v;
  }
  const auto miss_soonest = [&] {
    v.missed = exact.soonest & (~exact.soonest + 1);
    v.findings |= bit(finding::miss);
  };
  if (answer.size() == 0) {
    if (exact.crossed != 0)
      miss_first_crossed(t, exact, v);
    else if (soonest && exact.touched != 0)
      miss_soonest();
    return v;
  }
  const octant_number cell = answer[0];
  if ((exact.touched & bit_of(cell)) == 0) {
    v.spurious = bit_of(cell);
    if (far_from(t, v.spurious, allowed.reach) != 0)
      v.findings |= bit(finding::far_spurious);
    else if (exact.crossed != 0 && behind_first_crossed(t, exact, cell, allowed.reach))
      miss_first_crossed(t, exact, v);
    else if (soonest && exact.touched != 0)
      miss_soonest();
    else if (soonest)
      v.findings |= bit(finding::spurious);
    return v;
  }
  if (exact.crossed != 0 && (exact.not_after & bit_of(cell)) == 0)
    miss_first_crossed(t, exact, v);
  else if (soonest && (exact.soonest & bit_of(cell)) == 0)
    miss_soonest();
  judge_remarks(t, cell, answer.said(), allowed.tolerance, v);
  return v;
}

verdict judge_elsewhere(const trial& t, const truth& exact, const visited& answer, promise p,
                        const allowance& allowed) {
  verdict v = verdict_of(exact, answer);
  trial there = t; // a block of this one voxel
  std::copy(answer.elsewhere()->begin(), answer.elsewhere()->end(), there.base.begin());
  there.extent = {1, 1, 1};
  const truth at = truth_of(there);
  const auto line = rational_line(t);
  const auto range_of = [&](const trial& of, octant_number cell) {
    return rational::range_in(line, rational_cell(of, cell));
  };
  const auto first = exact.crossed == 0 ? std::nullopt : range_of(t, exact.first_crossed);
  if (at.touched == 0) {
    v.spurious = 1; // one voxel, which is not the block's
    v.visited |= 1;
    const auto near = rational::range_in(line, dilated(there, 0, allowed.reach));
    if (far_from(there, 1, allowed.reach) != 0)
      v.findings |= bit(finding::far_spurious);
    else if (first && near && near->first > first->second)
      miss_first_crossed(t, exact, v);
    return v;
  }
  const auto range = range_of(there, 0);
  if (first && range->first > first->first) {
    miss_first_crossed(t, exact, v);
  } else if (p == promise::first_touched && exact.touched != 0) {
    const octant_set soonest = exact.soonest & (~exact.soonest + 1);
    const auto sooner = range_of(t, static_cast<octant_number>(std::countr_zero(soonest)));
    if (range->first > sooner->first) {
      v.missed = soonest;
      v.findings |= bit(finding::miss);
    }
  }
  judge_remarks(there, 0, answer.said(), allowed.tolerance, v);
  return v;
}

verdict judge_any(const trial& t, const truth& exact, const visited& answer,
                  const allowance& allowed) {
  verdict v = verdict_of(exact, answer);
  v.visited = 0; // it says no cell
  const bool hit = answer.said().hit.value_or(answer.size() != 0);
  if (!hit && exact.crossed != 0) {
    v.missed = v.crossed_missed = exact.crossed;
    v.findings |= bit(finding::crossed_miss);
    v.gross_missed = gross(t, exact.crossed);
    if (v.gross_missed != 0)
      v.findings |= bit(finding::gross_miss);
  }
  if (hit && exact.touched == 0 && !t.map) {
    v.spurious = 1; // one answer too many
    if (far_from(t, t.all(), allowed.reach) == t.all())
      v.findings |= bit(finding::far_spurious);
  }
  return v;
}

namespace {

/// A closed box as the supporting line of a ray sees it.
struct passage {
  mpq_class enter, leave; ///< t, of any sign
  unsigned enter_axis, leave_axis;
  bool through_faces; ///< each in the interior of a face
};

/// Nothing where the line passes by.
std::optional<passage> passage_of(const rational::line& l, const rational::box& b) {
  std::optional<passage> p;
  bool clear = true; // no face's plane holds the line
  for (unsigned a = 0; a < 3; ++a) {
    const mpq_class &o = l.origin[a], &d = l.velocity[a];
    if (d == 0) {
      if (o < b.lo[a] || b.hi[a] < o)
        return std::nullopt;
      clear = clear && b.lo[a] < o && o < b.hi[a];
      continue;
    }
    const mpq_class enter = ((d > 0 ? b.lo[a] : b.hi[a]) - o) / d;
    const mpq_class leave = ((d > 0 ? b.hi[a] : b.lo[a]) - o) / d;
    if (!p)
      p = {enter, leave, a, a, true};
    if (enter > p->enter) {
      p->enter = enter;
      p->enter_axis = a;
    }
    if (leave < p->leave) {
      p->leave = leave;
      p->leave_axis = a;
    }
  }
  if (p->leave < p->enter)
    return std::nullopt;
  unsigned at_enter = 0, at_leave = 0;
  for (unsigned a = 0; a < 3; ++a)
    if (const mpq_class &o = l.origin[a], &d = l.velocity[a]; d != 0) {
      at_enter += ((d > 0 ? b.lo[a] : b.hi[a]) - o) / d == p->enter ? 1 : 0;
      at_leave += ((d > 0 ? b.hi[a] : b.lo[a]) - o) / d == p->leave ? 1 : 0;
    }
  p->through_faces = clear && at_enter == 1 && at_leave == 1 && p->enter < p->leave;
  return p;
}

enum class side { outside, surface, inside };

side side_of(const std::array<mpq_class, 3>& point, const std::vector<rational::box>& boxes) {
  side s = side::outside;
  for (const rational::box& b : boxes) {
    bool closed = true, open = true;
    for (unsigned a = 0; a < 3; ++a) {
      closed = closed && b.lo[a] <= point[a] && point[a] <= b.hi[a];
      open = open && b.lo[a] < point[a] && point[a] < b.hi[a];
    }
    if (open)
      return side::inside;
    if (closed)
      s = side::surface;
  }
  return s;
}

/// The number of t in (0, 1), or (0, infinity), at which the line comes into or out of the union; its
/// ends are on no surface of it.
std::optional<std::uint64_t> number_of_crossings(const rational::line& l,
                                                 const std::vector<rational::box>& boxes) {
  std::vector<passage> met;
  for (const rational::box& b : boxes) {
    const auto p = passage_of(l, b);
    // what lies behind the origin, or beyond the end, or begins there: these are on no surface
    if (!p || p->leave <= 0 || (l.last && p->enter >= 1))
      continue;
    if (!p->through_faces)
      return std::nullopt;
    met.push_back(*p);
  }
  std::sort(met.begin(), met.end(),
            [](const passage& x, const passage& y) { return x.enter < y.enter; });
  const auto counted = [&l](const mpq_class& t) {
    return t > 0 && !(l.last && t >= 1) ? std::uint64_t{1} : std::uint64_t{0};
  };
  std::uint64_t number = 0;
  std::optional<passage> part; // of the union
  for (const passage& p : met) {
    if (part && p.enter == part->enter && p.enter_axis != part->enter_axis)
      return std::nullopt;
    if (part && p.enter == part->leave && p.enter_axis != part->leave_axis)
      return std::nullopt; // over an edge where two boxes meet
    if (part && p.enter <= part->leave) {
      if (p.leave == part->leave && p.leave_axis != part->leave_axis)
        return std::nullopt;
      if (p.leave > part->leave) {
        part->leave = p.leave;
        part->leave_axis = p.leave_axis;
      }
      continue;
    }
    if (part)
      number += counted(part->enter) + counted(part->leave);
    part = p;
  }
  if (part)
    number += counted(part->enter) + counted(part->leave);
  return number;
}

} // namespace

std::optional<surface_crossings> crossings_of(const trial& t) {
  if (t.map) // of which the block is a part
    return std::nullopt;
  std::vector<rational::box> boxes;
  if (t.boxes)
    for (octant_set left = t.all(); left != 0; left &= left - 1)
      boxes.push_back(rational_cell(t, static_cast<octant_number>(std::countr_zero(left))));
  else
    boxes.push_back(rational_block(t));
  for (const rational::box& b : boxes)
    for (unsigned a = 0; a < 3; ++a)
      if (b.lo[a] == b.hi[a])
        return std::nullopt;
  const auto line = rational_line(t);
  const side from = side_of(line.origin, boxes);
  side to = side::outside;
  if (t.end)
    to = side_of({mpq_class((*t.end)[0]), mpq_class((*t.end)[1]), mpq_class((*t.end)[2])}, boxes);
  if (from == side::surface || to == side::surface)
    return std::nullopt;
  return surface_crossings{from != to, number_of_crossings(line, boxes)};
}

verdict judge_count(const trial& t, const truth& exact, const visited& answer) {
  verdict v = verdict_of(exact, answer);
  v.visited = 0;
  const auto known = answer.said().crossings ? crossings_of(t) : std::nullopt;
  if (!known) {
    v.declined = true;
    return v;
  }
  const std::uint64_t said = *answer.said().crossings;
  if (known->number ? said != *known->number : (said % 2 != 0) != known->odd)
    v.findings |= bit(finding::count);
  return v;
}

} // namespace graze::fuzz
