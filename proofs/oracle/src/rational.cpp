#include <graze/oracle/elementary.hpp>
#include <graze/oracle/rational.hpp>
#include <mpfr.h>
#include <vector>

namespace graze::oracle::rational {
namespace {

/// An interval of t, from t = 0 (closed) and at first without end.
struct range {
  mpq_class first = 0, last = 0;
  bool first_closed = true, last_closed = true;
  bool endless = true;
  bool nothing = false;

  void keep_from(const mpq_class& t, bool closed) {
    if (t > first) {
      first = t;
      first_closed = closed;
    } else if (t == first) {
      first_closed = first_closed && closed;
    }
  }
  void keep_to(const mpq_class& t, bool closed) {
    if (endless || t < last) {
      last = t;
      last_closed = closed;
      endless = false;
    } else if (t == last) {
      last_closed = last_closed && closed;
    }
  }
  bool empty() const {
    if (nothing)
      return true;
    if (endless)
      return false;
    return last < first || (last == first && !(first_closed && last_closed));
  }
};

/// Keeps the t at which lo <= o + t d <= hi, where a face that is not closed makes its <= a <.
void clip(range& r, const mpq_class& o, const mpq_class& d, const mpq_class& lo,
          const mpq_class& hi, bool lo_closed, bool hi_closed) {
  if (d == 0) {
    const bool above = lo_closed ? lo <= o : lo < o;
    const bool below = hi_closed ? o <= hi : o < hi;
    if (!above || !below)
      r.nothing = true;
    return;
  }
  const mpq_class at_lo = (lo - o) / d;
  const mpq_class at_hi = (hi - o) / d;
  if (d > 0) {
    r.keep_from(at_lo, lo_closed);
    r.keep_to(at_hi, hi_closed);
  } else {
    r.keep_from(at_hi, hi_closed);
    r.keep_to(at_lo, lo_closed);
  }
}

/// Bit a of the masks: the lower, the upper face of axis a belongs to the box.
range in_box(const point& origin, const point& direction, const point& lo, const point& hi,
             unsigned lower_closed, unsigned upper_closed) {
  range r;
  for (unsigned a = 0; a < 3; ++a)
    clip(r, mpq_class(origin[a]), mpq_class(direction[a]), mpq_class(lo[a]), mpq_class(hi[a]),
         (lower_closed >> a & 1) != 0, (upper_closed >> a & 1) != 0);
  return r;
}

range in_box(const line& l, const box& b, unsigned lower_closed, unsigned upper_closed) {
  range r;
  r.first = l.first;
  if (l.last)
    r.keep_to(*l.last, true);
  for (unsigned a = 0; a < 3; ++a)
    clip(r, l.origin[a], l.velocity[a], b.lo[a], b.hi[a], (lower_closed >> a & 1) != 0,
         (upper_closed >> a & 1) != 0);
  return r;
}

/// Bit a is set where the box is flat on axis a.
unsigned flat(const box& b) {
  unsigned axes = 0;
  for (unsigned a = 0; a < 3; ++a)
    axes |= (b.lo[a] == b.hi[a] ? 1u : 0u) << a;
  return axes;
}

std::array<mpq_class, 3> exactly(const point& p) {
  return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}

/// `bits` of precision, numbers from 2^(least - 1) on; below, of the granularity that is left.
mpq_class nearest(const mpq_class& x, int bits, int least, int greatest) {
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

int multiply_add(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y, mpfr_srcptr z, mpfr_rnd_t to) {
  return mpfr_fma(r, x, y, z, to);
}

} // namespace

line ray_of(const point& origin, const point& direction) {
  return {exactly(origin), exactly(direction)};
}

line segment_of(const point& origin, const point& end) {
  line l{exactly(origin), exactly(end), 0, mpq_class(1)};
  for (unsigned a = 0; a < 3; ++a)
    l.velocity[a] -= l.origin[a];
  return l;
}

box box_of(const point& lo, const point& hi) { return {exactly(lo), exactly(hi)}; }

bool meets(const line& l, const box& b, unsigned lower_closed, unsigned upper_closed) {
  return !in_box(l, b, lower_closed, upper_closed).empty();
}
bool touches(const line& l, const box& b) { return meets(l, b, 7, 7); }
bool crosses(const line& l, const box& b) { return meets(l, b, flat(b), flat(b)); }
bool owns(const line& l, const box& b, unsigned closed_far) {
  return meets(l, b, 7, closed_far | flat(b));
}

std::optional<std::pair<mpq_class, mpq_class>> range_in(const line& l, const box& b) {
  const range r = in_box(l, b, 7, 7);
  if (r.empty() || r.endless)
    return std::nullopt;
  return std::pair(r.first, r.last);
}

std::optional<part> common_part(const line& l, const box& b) {
  const auto range = range_in(l, b);
  if (!range)
    return std::nullopt;
  part p{range->first, range->second, 0, 0};
  for (unsigned a = 0; a < 3; ++a)
    if (const mpq_class &o = l.origin[a], &d = l.velocity[a]; d != 0) {
      const bool back = d < 0;
      const mpq_class at_near = ((back ? b.hi[a] : b.lo[a]) - o) / d;
      const mpq_class at_far = ((back ? b.lo[a] : b.hi[a]) - o) / d;
      if (at_near == p.first)
        p.entered |= (back ? 2u : 1u) << (2 * a);
      if (at_far == p.last)
        p.left |= (back ? 1u : 2u) << (2 * a);
    }
  return p;
}

double nearest_double(const mpq_class& x) { return nearest(x, 53, -1021, 1024).get_d(); }
double nearest_float(const mpq_class& x) { return nearest(x, 24, -125, 128).get_d(); }

mpq_class plane_exactly(double origin, double spacing, std::uint32_t k) {
  return mpq_class(origin) + k * mpq_class(spacing);
}
double plane_rounded(double origin, double spacing, std::uint32_t k) {
  return rounded(multiply_add, MPFR_RNDN, static_cast<double>(k), spacing, origin);
}
double plane_multiplied(double origin, double spacing, std::uint32_t k) {
  const double product = rounded(mpfr_mul, MPFR_RNDN, static_cast<double>(k), spacing);
  return rounded(mpfr_add, MPFR_RNDN, origin, product);
}
double plane_added(double origin, double spacing, std::uint32_t k) {
  struct axis {
    double origin = 0, spacing = 0;
    std::vector<double> planes;
  };
  thread_local std::array<axis, 6> known;
  thread_local unsigned oldest = 0;
  axis* at = nullptr;
  for (axis& one : known)
    if (!one.planes.empty() && one.origin == origin && one.spacing == spacing)
      at = &one;
  if (at == nullptr) {
    at = &known[oldest++ % known.size()];
    *at = {origin, spacing, {origin}};
  }
  while (at->planes.size() <= k)
    at->planes.push_back(at->planes.back() + spacing);
  return at->planes[k];
}
double plane_binary32(double origin, double spacing, std::uint32_t k) {
  const auto nearest = [](double x) { return rounded_to<float>(mpfr_set, MPFR_RNDN, x); };
  const float product = rounded_to<float>(mpfr_mul, MPFR_RNDN, nearest(k), nearest(spacing));
  return static_cast<double>(rounded_to<float>(mpfr_add, MPFR_RNDN, nearest(origin), product));
}

bool touches(const point& origin, const point& direction, const point& lo, const point& hi) {
  return !in_box(origin, direction, lo, hi, 7, 7).empty();
}

bool crosses(const point& origin, const point& direction, const point& lo, const point& hi) {
  return !in_box(origin, direction, lo, hi, 0, 0).empty();
}

bool owns(const point& origin, const point& direction, const point& lo, const point& hi,
          unsigned closed_far) {
  return !in_box(origin, direction, lo, hi, 7, closed_far).empty();
}

std::optional<std::pair<mpq_class, mpq_class>> range_in(const point& origin, const point& direction,
                                                        const point& lo, const point& hi) {
  const range r = in_box(origin, direction, lo, hi, 7, 7);
  if (r.empty() || r.endless)
    return std::nullopt;
  return std::pair(r.first, r.last);
}

} // namespace graze::oracle::rational
