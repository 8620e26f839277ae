#include <graze/oracle/rational_cells.hpp>
#include <mpfr.h>

namespace graze::oracle::rational {
namespace {

rational_point rational(const point& p) {
  return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}

/// The t at which the line is on an axis's plane, first and last.
struct axis_times {
  mpq_class at_near, at_far;
  bool near_is_upper;
};
axis_times times_on(const line& l, const cell& c, unsigned a) {
  const mpq_class &o = l.origin[a], &d = l.direction[a];
  const mpq_class lower = (c.lower[a] - o) / d, upper = (c.upper[a] - o) / d;
  if (d > 0)
    return {lower, upper, false};
  return {upper, lower, true};
}

/// `bits` of precision, numbers from 2^(least - 1) on; below, of the granularity that is left.
mpq_class rounded(const mpq_class& x, int bits, int least, int greatest) {
  const mpfr_exp_t old_least = mpfr_get_emin(), old_greatest = mpfr_get_emax();
  mpfr_set_emin(least - bits + 1);
  mpfr_set_emax(greatest);
  mpfr_t y;
  mpfr_init2(y, bits);
  const int order = mpfr_set_q(y, x.get_mpq_t(), MPFR_RNDN);
  mpfr_subnormalize(y, order, MPFR_RNDN);
  mpq_class result;
  if (mpfr_inf_p(y) != 0)
    result = mpfr_sgn(y) * (mpq_class(1) << 2000);
  else
    mpfr_get_q(result.get_mpq_t(), y);
  mpfr_clear(y);
  mpfr_set_emin(old_least);
  mpfr_set_emax(old_greatest);
  return result;
}

} // namespace

line ray_from(const point& origin, const point& direction) {
  return {rational(origin), rational(direction), 0, std::nullopt};
}
line between(const point& from, const point& to) {
  line l{rational(from), rational(to), 0, mpq_class(1)};
  for (unsigned a = 0; a < 3; ++a)
    l.direction[a] -= l.origin[a];
  return l;
}

bool meets(const line& l, const cell& c) {
  mpq_class first = l.first;
  std::optional<mpq_class> last = l.last;
  bool with_first = true, with_last = true;
  for (unsigned a = 0; a < 3; ++a) {
    const bool lower_closed = (c.lower_closed >> a & 1) != 0,
               upper_closed = (c.upper_closed >> a & 1) != 0;
    if (l.direction[a] == 0) {
      const mpq_class& o = l.origin[a];
      if (o < c.lower[a] || o > c.upper[a] || (o == c.lower[a] && !lower_closed) ||
          (o == c.upper[a] && !upper_closed))
        return false;
      continue;
    }
    const axis_times t = times_on(l, c, a);
    const bool near = t.near_is_upper ? upper_closed : lower_closed;
    const bool far = t.near_is_upper ? lower_closed : upper_closed;
    if (t.at_near > first) {
      first = t.at_near;
      with_first = near;
    } else if (t.at_near == first) {
      with_first = with_first && near;
    }
    if (!last || t.at_far < *last) {
      last = t.at_far;
      with_last = far;
    } else if (t.at_far == *last) {
      with_last = with_last && far;
    }
  }
  return !last || first < *last || (first == *last && with_first && with_last);
}

std::optional<part> common_part(const line& l, const cell& c) {
  cell closed = c;
  closed.lower_closed = closed.upper_closed = 7;
  if (!meets(l, closed))
    return std::nullopt;
  part p{l.first, 0, 0, 0};
  bool bounded = l.last.has_value();
  if (bounded)
    p.last = *l.last;
  for (unsigned a = 0; a < 3; ++a)
    if (l.direction[a] != 0) {
      const axis_times t = times_on(l, c, a);
      p.first = std::max(p.first, t.at_near);
      p.last = bounded ? std::min(p.last, t.at_far) : t.at_far;
      bounded = true;
    }
  for (unsigned a = 0; a < 3; ++a)
    if (l.direction[a] != 0) {
      const axis_times t = times_on(l, c, a);
      if (t.at_near == p.first)
        p.entered |= (t.near_is_upper ? 2u : 1u) << (2 * a);
      if (t.at_far == p.last)
        p.left |= (t.near_is_upper ? 1u : 2u) << (2 * a);
    }
  return p;
}

double nearest_double(const mpq_class& x) { return rounded(x, 53, -1021, 1024).get_d(); }
double nearest_float(const mpq_class& x) { return rounded(x, 24, -125, 128).get_d(); }

} // namespace graze::oracle::rational
