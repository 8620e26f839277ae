#include "default_mode.hpp"
#include "dyadic.hpp"
#include "grid_walk.hpp"
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <graze/oracle/lines.hpp>
#include <limits>

namespace graze::oracle {
namespace {

/// result 2^e is the sum; returns e.
int sum(mpz_t result, std::span<const double> terms) {
  thread_local integer term;
  int lowest = 2000;
  for (const double x : terms)
    if (const dyadic d = split(x); d.significand != 0)
      lowest = std::min(lowest, d.exponent);
  mpz_set_ui(result, 0);
  for (const double x : terms) {
    const dyadic d = split(x);
    if (d.significand == 0)
      continue;
    mpz_set_ui(term.value, d.significand);
    mpz_mul_2exp(term.value, term.value, static_cast<mp_bitcnt_t>(d.exponent - lowest));
    (d.negative ? mpz_sub : mpz_add)(result, result, term.value);
  }
  return lowest;
}

int sign_exactly(std::span<const double> terms) {
  thread_local integer total;
  sum(total.value, terms);
  return mpz_sgn(total.value);
}

/// In the default mode. Each of up to five additions is off by 2^-53 of a sum of the magnitudes, which is
/// at most (1 + 2^-50) times theirs.
[[gnu::noinline]] int sign_in_mode(std::span<const double> terms) {
  volatile double first = terms[0];
  double total = first, magnitude = std::fabs(total);
  for (const double x : terms.subspan(1)) {
    total += x;
    magnitude += std::fabs(x);
  }
  if (magnitude > 0x1p-900 && magnitude < 0x1p1022) {
    if (total > 0x1p-50 * magnitude)
      return 1;
    if (total < -0x1p-50 * magnitude)
      return -1;
  }
  return sign_exactly(terms);
}

bool is_double(const plane_terms& p) { return p[1] == 0 && p[2] == 0; }

/// The sign of p - x.
int against(const plane_terms& p, double x) {
  if (is_double(p))
    return (p[0] > x ? 1 : 0) - (p[0] < x ? 1 : 0);
  const std::array<double, 4> terms{p[0], p[1], p[2], -x};
  return sign_in_mode(terms);
}

bool equal(const plane_terms& p, const plane_terms& q) {
  if (is_double(p) && is_double(q))
    return p[0] == q[0];
  const std::array<double, 6> terms{p[0], p[1], p[2], -q[0], -q[1], -q[2]};
  return sign_in_mode(terms) == 0;
}

/// A line on one axis.
struct motion {
  motion(const line& l, unsigned a)
      : origin(l.origin[a]), has_end(l.end.has_value()), end(has_end ? (*l.end)[a] : 0),
        speed{end, -origin} {
    if (has_end) {
      heading = (end > origin ? 1 : 0) - (end < origin ? 1 : 0);
    } else {
      heading = (l.direction[a] > 0 ? 1 : 0) - (l.direction[a] < 0 ? 1 : 0);
      speed = {l.direction[a], 0};
    }
  }
  [[nodiscard]] sum_arrival at(const plane_terms& p) const {
    return {{p[0], p[1], p[2], -origin}, speed};
  }
  /// The sign of t - 1 for the t at which it is on a plane before it.
  [[nodiscard]] int against_end(const plane_terms& p) const {
    return has_end ? heading * against(p, end) : -1;
  }

  double origin;
  bool has_end;
  double end;
  int heading;
  std::array<double, 2> speed;
};

struct axis_of_sums : axis_place {
  static constexpr bool may_end = true;

  void start(const motion& m, std::span<const plane_terms> planes_) {
    assert(!planes_.empty() && planes_.size() <= most_planes);
    planes = planes_;
    by = &m;
    int below = 0, on = 0;
    for (const plane_terms& p : planes) {
      const int side = against(p, m.origin);
      below += side < 0 ? 1 : 0;
      on |= side == 0 ? 1 : 0;
    }
    begin(m.heading, static_cast<int>(planes.size()), below, on);
    ends_on_plane = false;
    if (m.has_end)
      for (int i = 0; i < ahead; ++i) {
        const int side = m.against_end(plane_ahead(i));
        if (side < 0)
          continue;
        ends_on_plane = side == 0;
        ahead = i + (side == 0 ? 1 : 0);
      }
    for (int i = 0; i < ahead; ++i)
      times[static_cast<unsigned>(i)] = m.at(plane_ahead(i)).time();
    times[static_cast<unsigned>(ahead)] = std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] const plane_terms& plane_ahead(int i) const {
    return planes[static_cast<unsigned>(first + i * heading)];
  }
  [[nodiscard]] sum_arrival next() const { return by->at(plane_ahead(passed)); }
  [[nodiscard]] bool at_end() const { return ends_on_plane && passed == ahead; }

  std::span<const plane_terms> planes;
  const motion* by;
  bool ends_on_plane;
};

[[maybe_unused]] bool legal(const line& l) {
  bool moves = false;
  for (unsigned a = 0; a < 3; ++a) {
    const double d = l.end ? (*l.end)[a] : l.direction[a];
    if (!std::isfinite(l.origin[a]) || !std::isfinite(d))
      return false;
    moves |= l.end ? d != l.origin[a] : d != 0;
  }
  return moves;
}

/// x + y = sum + error, exactly, unless it overflows. Knuth.
double two_sum(double x, double y, double& error) {
  const double total = x + y;
  const double part = total - x;
  error = (x - (total - part)) + (y - part);
  return total;
}

} // namespace

// The distance is p0 - o + p1 + p2 = s + e1 + e2 + p2, of which the last three are summed with an error
// of 2^-52 of their magnitudes. Where these are at most 2^-8 |s| the distance is off by 2^-53 + 2^-60 of
// itself and a little, the speed by 2^-53, the quotient by 2^-53: together less than the two roundings of
// 2^-52 each that certainly_before allows for.
double sum_arrival::time() const {
  double e1, e2;
  const double near = two_sum(distance[0], distance[3], e1);
  const double s = two_sum(near, distance[1], e2);
  const double rest = e1 + e2 + distance[2];
  const double length = std::fabs(s + rest);
  const double t = length / std::fabs(speed[0] + speed[1]);
  const bool in_range =
      (t >= 0x1p-1000) & (t <= 0x1p1000) & (length <= 0x1p1020) &
      (std::fabs(e1) + std::fabs(e2) + std::fabs(distance[2]) <= 0x1p-8 * std::fabs(s));
  return in_range ? t : std::numeric_limits<double>::quiet_NaN();
}

int compare_exactly(const sum_arrival& a, const sum_arrival& b) {
  ++decisions.gmp;
  thread_local integer x, y, factor;
  int i = sum(x.value, a.distance);
  i += sum(factor.value, b.speed);
  mpz_mul(x.value, x.value, factor.value);
  mpz_abs(x.value, x.value);
  int j = sum(y.value, b.distance);
  j += sum(factor.value, a.speed);
  mpz_mul(y.value, y.value, factor.value);
  mpz_abs(y.value, y.value);
  if (i > j)
    mpz_mul_2exp(x.value, x.value, static_cast<mp_bitcnt_t>(i - j));
  else
    mpz_mul_2exp(y.value, y.value, static_cast<mp_bitcnt_t>(j - i));
  const int order = mpz_cmp(x.value, y.value);
  return (order > 0 ? 1 : 0) - (order < 0 ? 1 : 0);
}

namespace {

[[gnu::noinline]] int compare_in_mode(const sum_arrival& a, const sum_arrival& b) {
  volatile double first = a.time();
  const double at_a = first, at_b = b.time();
  if (certainly_before(at_b, at_a))
    return ++decisions.filter, 1;
  if (certainly_before(at_a, at_b))
    return ++decisions.filter, -1;
  return compare_exactly(a, b);
}

[[gnu::noinline]] void walk_sums(const line& l,
                                 const std::array<std::span<const plane_terms>, 3>& planes,
                                 std::vector<step>& steps) {
  const std::array<motion, 3> motions{motion(l, 0), motion(l, 1), motion(l, 2)};
  std::array<axis_of_sums, 3> axes;
  for (unsigned a = 0; a < 3; ++a) {
    axes[a].start(motions[a], planes[a]);
    if (axes[a].lost())
      return;
  }
  walk(axes, steps);
}

} // namespace

int compare(const sum_arrival& a, const sum_arrival& b) {
  const default_mode scope;
  return compare_in_mode(a, b);
}

int sign_of_sum(std::span<const double> terms) {
  const default_mode scope;
  return terms.empty() ? 0 : sign_exactly(terms);
}

void steps_in_grid(const line& l, const std::array<std::span<const plane_terms>, 3>& planes,
                   std::vector<step>& steps) {
  const default_mode scope;
  assert(legal(l));
  steps.clear();
  walk_sums(l, planes, steps);
}

int meeting::order(const bound& a, const bound& b) {
  if (!a.positive || !b.positive)
    return (a.positive ? 1 : 0) - (b.positive ? 1 : 0);
  return compare(a.when, b.when);
}

// On each axis the t at which the line is in the box, or its interior, are an interval; intervals of t,
// 0 <= t <= 1 among them, have a common point if every lower bound lies below every upper one, or equals
// it and both are closed.
[[gnu::noinline]] void meeting::meet(const line& l, const planes_box& box) {
  bool inside = true; // the interior is not ruled out
  for (unsigned a = 0; a < 3; ++a) {
    const motion m(l, a);
    const int lower = against(box.lo[a], m.origin), upper = against(box.hi[a], m.origin);
    const bool flat = equal(box.lo[a], box.hi[a]);
    if (m.heading == 0) {
      if (lower > 0 || upper < 0)
        return;
      inside = inside && (flat || (lower < 0 && upper > 0));
      continue;
    }
    const plane_terms &near = m.heading > 0 ? box.lo[a] : box.hi[a],
                      &far = m.heading > 0 ? box.hi[a] : box.lo[a];
    const int near_side = m.heading * (m.heading > 0 ? lower : upper);
    const int far_side = m.heading * (m.heading > 0 ? upper : lower);
    if (far_side < 0)
      return; // behind it from the start
    inside = inside && (flat || far_side > 0);
    leave_[leaves_++] = {far_side > 0, m.at(far), m.against_end(far), flat};
    if (near_side < 0)
      continue;
    const int near_end = near_side > 0 ? m.against_end(near) : -1;
    if (near_end > 0)
      return; // the segment ends before it
    inside = inside && (flat || near_end < 0);
    enter_[enters_++] = {near_side > 0, m.at(near), near_end, flat};
  }
  for (unsigned i = 0; i < enters_; ++i)
    for (unsigned j = 0; j < leaves_; ++j) {
      const int sign = order(enter_[i], leave_[j]);
      if (sign > 0)
        return;
      inside = inside && (sign < 0 || (enter_[i].flat && leave_[j].flat));
    }
  touches_ = true;
  crosses_ = inside;
}

meeting::meeting(const line& l, const planes_box& box) {
  const default_mode scope;
  assert(legal(l));
  meet(l, box);
}

const meeting::bound* meeting::entry() const {
  const bound* latest = nullptr;
  for (unsigned i = 0; i < enters_; ++i)
    if (enter_[i].positive && (latest == nullptr || order(*latest, enter_[i]) < 0))
      latest = &enter_[i];
  return latest;
}

int compare_entries(const meeting& a, const meeting& b) {
  const meeting::bound *x = a.entry(), *y = b.entry();
  if (x == nullptr || y == nullptr)
    return (x != nullptr ? 1 : 0) - (y != nullptr ? 1 : 0);
  return meeting::order(*x, *y);
}

} // namespace graze::oracle
