// Decisions about lines and cells: a filter in doubles, and sums of products where it does not
// decide. No statement here relies on a rounding mode or on subnormal numbers.
#include <graze/octree/exact_line.hpp>
#include <graze/octree/exact_sum.hpp>

namespace graze::octree {

using rounding::exact::equal;
using rounding::exact::is_zero;
using rounding::exact::less;

namespace {

/// A sum of doubles times integers.
struct exact_number {
  struct part {
    double x;
    std::uint32_t times = 1;
    bool negative = false;
  };
  std::array<part, 3> parts{};
  unsigned count = 0;

  void add(double x, std::uint32_t times, bool negative) { parts[count++] = {x, times, negative}; }
};

/// sum += x y, or -= where negative; y has no multiples.
void add_product(detail::exact_sum& sum, const exact_number& x, const exact_number& y,
                 bool negative) {
  for (unsigned i = 0; i < x.count; ++i)
    for (unsigned j = 0; j < y.count; ++j)
      sum.add_product(x.parts[i].x, y.parts[j].x, x.parts[i].times,
                      negative != (x.parts[i].negative != y.parts[j].negative));
}

bool is_double(const plane_value& p) { return p.multiple == 0 || is_zero(p.spacing); }

/// The sign of the plane - x.
int side(const plane_value& p, double x) {
  if (is_double(p))
    return less(p.origin, x) ? -1 : (less(x, p.origin) ? 1 : 0);
  detail::exact_sum sum;
  sum.add(p.origin);
  sum.add(p.spacing, p.multiple);
  sum.add(x, 1, true);
  return sum.sign();
}
/// The sign of p - q.
int side(const plane_value& p, const plane_value& q) {
  if (is_double(q))
    return side(p, q.origin);
  if (is_double(p))
    return -side(q, p.origin);
  if (equal(p.origin, q.origin) && equal(p.spacing, q.spacing)) // of one grid
    return (p.multiple > q.multiple) - (p.multiple < q.multiple);
  detail::exact_sum sum;
  sum.add(p.origin);
  sum.add(p.spacing, p.multiple);
  sum.add(q.origin, 1, true);
  sum.add(q.spacing, q.multiple, true);
  return sum.sign();
}

bounds enclosure(const detail::magnitude_bounds& m) { return {m.down(), m.up()}; }

} // namespace

/// A t: the arrival at a plane, or a limit of the line.
struct exact_line::time {
  double about, error; ///< |about - t| <= error, unless a comparison with them is false
  int axis;            ///< -1: a limit
  plane_value plane;
  double limit;
  bool upper;  ///< the plane is the cell's upper one
  bool closed; ///< t itself belongs to the interval that ends here
};

/// numerator / denominator, denominator > 0.
struct exact_line::fraction {
  exact_number numerator, denominator;
};

exact_line::exact_line(const ray& r, const ray_segment& part)
    : origin_(r.origin()), toward_(r.direction()), between_points_(false), first_(part.first()),
      last_(part.last()) {
  for (unsigned a = 0; a < 3; ++a) {
    const double d = toward_[a];
    speed_[a] = rounding::exact::negative(d) ? -d : d;
    heading_[a] = is_zero(d) ? 0 : (rounding::exact::below_zero(d) ? -1 : 1);
  }
}

exact_line::exact_line(const segment& s)
    : origin_(s.from()), toward_(s.to()), between_points_(true), first_(0), last_(1) {
  for (unsigned a = 0; a < 3; ++a) {
    const bool back = less(toward_[a], origin_[a]);
    heading_[a] = equal(toward_[a], origin_[a]) ? 0 : (back ? -1 : 1);
    speed_[a] = back ? origin_[a] - toward_[a] : toward_[a] - origin_[a];
  }
}

exact_line::time exact_line::limit_at(double t) const {
  return {t, 0x1p-1000, -1, {}, t, false, true};
}

/// Let e = 2^-52, which bounds the relative error of an operation in every mode. The plane is known
/// to 3e (|origin| + |multiple spacing|), exactly where it is a double; the difference and the
/// quotient add e each and the speed another where it is a difference: 3e |t| and what the plane's
/// error makes. 8e |t| and 16e leave room for the roundings of the error, and for those of sums and
/// differences with it. What flushing takes from an operand or a result is below 2^-1021. Nothing
/// is decided where something may have overflowed, which by mode ends at infinity or at the greatest
/// double: there the error is infinite.
exact_line::time exact_line::arrival_at(unsigned axis, const plane_value& p, bool upper) const {
  constexpr double tiny = 0x1p-1000;
  const double multiple = p.multiple, offset = multiple * p.spacing;
  const double plane = p.origin + offset;
  const double distance = heading_[axis] < 0 ? origin_[axis] - plane : plane - origin_[axis];
  const double speed = speed_[axis], t = distance / speed;
  const double size = t < 0 ? -t : t;
  double error = size * 0x1p-49 + tiny / speed + tiny;
  if (p.multiple != 0)
    error += ((p.origin < 0 ? -p.origin : p.origin) + offset) * 0x1p-48 / speed;
  for (const double x : {offset, plane, distance, speed, t, error})
    if (!(-0x1p1023 <= x && x <= 0x1p1023))
      error = std::numeric_limits<double>::infinity();
  return {t, error, static_cast<int>(axis), p, 0, upper, true};
}

exact_line::fraction exact_line::exactly(const time& t) const {
  fraction f;
  if (t.axis < 0) {
    f.numerator.add(t.limit, 1, false);
    f.denominator.add(1, 1, false);
    return f;
  }
  const auto a = static_cast<unsigned>(t.axis);
  const bool back = heading_[a] < 0;
  f.numerator.add(t.plane.origin, 1, back);
  f.numerator.add(t.plane.spacing, t.plane.multiple, back);
  f.numerator.add(origin_[a], 1, !back);
  f.denominator.add(toward_[a], 1, back);
  if (between_points_)
    f.denominator.add(origin_[a], 1, !back);
  return f;
}

/// The sign of x - y.
int exact_line::order(const time& x, const time& y) const {
  if (x.about + x.error < y.about - y.error)
    return -1;
  if (y.about + y.error < x.about - x.error)
    return 1;
  const fraction p = exactly(x), q = exactly(y);
  detail::exact_sum difference;
  add_product(difference, p.numerator, q.denominator, false);
  add_product(difference, q.numerator, p.denominator, true);
  return difference.sign();
}

bool exact_line::still_outside(unsigned axis, const slabs& cell, bool lower_closed,
                               bool upper_closed) const {
  const int from = side(cell.lower[axis], origin_[axis]),
            until = side(cell.upper[axis], origin_[axis]);
  return from > 0 || (from == 0 && !lower_closed) || until < 0 || (until == 0 && !upper_closed);
}

bool exact_line::meets(const slabs& cell, unsigned lower_closed, unsigned upper_closed) const {
  std::array<time, 4> enter, leave;
  unsigned count = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const bool with_lower = (lower_closed >> a & 1) != 0, with_upper = (upper_closed >> a & 1) != 0;
    if (heading_[a] == 0) {
      if (still_outside(a, cell, with_lower, with_upper))
        return false;
      continue;
    }
    time lower = arrival_at(a, cell.lower[a], false), upper = arrival_at(a, cell.upper[a], true);
    lower.closed = with_lower;
    upper.closed = with_upper;
    enter[count] = heading_[a] > 0 ? lower : upper;
    leave[count] = heading_[a] > 0 ? upper : lower;
    ++count;
  }
  const unsigned axes = count;
  enter[count] = limit_at(first_);
  if (last_ < std::numeric_limits<double>::infinity())
    leave[count++] = limit_at(last_);
  for (unsigned j = 0; j < count; ++j)
    for (unsigned i = 0; i <= axes; ++i) {
      if (i == j)
        continue; // planes are in order, and so are limits
      const int sign = order(enter[i], leave[j]);
      if (sign > 0 || (sign == 0 && !(enter[i].closed && leave[j].closed)))
        return false;
    }
  return true;
}

namespace {
/// Axes on which the cell is flat, or 8 if it is empty.
unsigned flat_axes(const slabs& cell) {
  unsigned flat = 0;
  for (unsigned a = 0; a < 3; ++a) {
    const int sign = side(cell.upper[a], cell.lower[a]);
    if (sign < 0)
      return 8;
    flat |= sign == 0 ? 1u << a : 0;
  }
  return flat;
}
} // namespace

bool exact_line::touches(const slabs& cell) const {
  return flat_axes(cell) != 8 && meets(cell, 7, 7);
}
bool exact_line::crosses(const slabs& cell) const {
  const unsigned flat = flat_axes(cell);
  return flat != 8 && meets(cell, flat, flat);
}
bool exact_line::owns(const slabs& cell) const {
  const unsigned flat = flat_axes(cell);
  return flat != 8 && meets(cell, 7, cell.closed_far | flat);
}

std::optional<passage> exact_line::through(const slabs& cell) const {
  if (flat_axes(cell) == 8)
    return std::nullopt;
  const auto face = [](const time& t) {
    return t.axis < 0 ? 0 : face_bit(static_cast<unsigned>(t.axis), t.upper);
  };
  // the latest entry and the earliest exit
  time enter = limit_at(first_), leave = limit_at(last_);
  bool bounded = last_ < std::numeric_limits<double>::infinity();
  unsigned entered = 0, left = 0;
  for (unsigned a = 0; a < 3; ++a) {
    if (heading_[a] == 0) {
      if (still_outside(a, cell, true, true))
        return std::nullopt;
      continue;
    }
    const time lower = arrival_at(a, cell.lower[a], false),
               upper = arrival_at(a, cell.upper[a], true);
    const time &near = heading_[a] > 0 ? lower : upper, &far = heading_[a] > 0 ? upper : lower;
    if (const int sign = order(near, enter); sign >= 0) {
      entered = (sign == 0 ? entered : 0) | face(near);
      if (sign > 0)
        enter = near;
    }
    if (const int sign = bounded ? order(far, leave) : -1; sign <= 0) {
      left = (sign == 0 ? left : 0) | face(far);
      if (sign < 0)
        leave = far;
    }
    bounded = true;
  }
  if (order(enter, leave) > 0)
    return std::nullopt;

  // t = n / d >= 0, and the difference of two
  const auto magnitude = [](const exact_number& n) {
    detail::exact_sum sum;
    exact_number one;
    one.add(1, 1, false);
    add_product(sum, n, one, false);
    return sum.magnitude();
  };
  const fraction from = exactly(enter), until = exactly(leave);
  const detail::magnitude_bounds from_scale = magnitude(from.denominator),
                                 until_scale = magnitude(until.denominator);
  detail::exact_sum difference, square;
  add_product(difference, until.numerator, from.denominator, false);
  add_product(difference, from.numerator, until.denominator, true);
  for (unsigned a = 0; a < 3; ++a) {
    exact_number d;
    d.add(toward_[a], 1, false);
    if (between_points_)
      d.add(origin_[a], 1, true);
    add_product(square, d, d, false);
  }
  const auto duration = quotient(difference.magnitude(), product(from_scale, until_scale));
  return passage{enclosure(quotient(magnitude(from.numerator), from_scale)),
                 enclosure(quotient(magnitude(until.numerator), until_scale)), entered, left,
                 enclosure(product(duration, square_root(square.magnitude())))};
}

} // namespace graze::octree
