#include <graze/oracle/rational.hpp>

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

} // namespace

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
