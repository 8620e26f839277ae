#include <algorithm>
#include <cmath>
#include <graze/itf1788/tighter.hpp>
#include <graze/oracle/elementary.hpp>

namespace graze::itf1788 {

namespace {

using oracle::number;

constexpr mpfr_prec_t precision = 300;

/// What `got` leaves out of `stated` at one side: from its own bound, which is not part of the
/// piece, to the stated bound, which is.
struct piece {
  double open_end, closed_end;
};

std::vector<piece> left_out(const bounds& stated, const bounds& got) {
  std::vector<piece> pieces;
  if (stated.lo < got.lo)
    pieces.push_back({got.lo, stated.lo});
  if (got.hi < stated.hi)
    pieces.push_back({got.hi, stated.hi});
  return pieces;
}

/// The order of f(t), rounded in the direction `to`, and of y: below 0, 0 or above.
template <class Function> int compare(Function f, double t, mpfr_rnd_t to, double y) {
  number value(precision), argument(t);
  f(value, argument, to);
  return mpfr_cmp_d(value, y);
}

/// f is strictly monotone on the piece: is it outside of c?
template <class Function> bool avoids(Function f, const piece& p, const bounds& c) {
  const bool above =
      compare(f, p.closed_end, MPFR_RNDD, c.hi) > 0 && compare(f, p.open_end, MPFR_RNDD, c.hi) >= 0;
  const bool below =
      compare(f, p.closed_end, MPFR_RNDU, c.lo) < 0 && compare(f, p.open_end, MPFR_RNDU, c.lo) <= 0;
  return above || below;
}

/// floor(t / pi + shift). With 300 bits and |t| < 2^100 the quotient of a double t != 0 is never
/// so near an integer or the middle of two that its rounding could matter.
double half_turn(double t, double shift) {
  number pi(precision), quotient(precision), argument(t);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_div(quotient, argument, pi, MPFR_RNDN);
  mpfr_add_d(quotient, quotient, shift, MPFR_RNDN);
  mpfr_floor(quotient, quotient);
  return mpfr_get_d(quotient, MPFR_RNDN);
}

bool one_half_turn(const piece& p, double shift) {
  return std::fabs(p.open_end) < 0x1p100 && std::fabs(p.closed_end) < 0x1p100 &&
         half_turn(p.open_end, shift) == half_turn(p.closed_end, shift);
}

bool same_sign(const piece& p) {
  return std::min(p.open_end, p.closed_end) > 0 || std::max(p.open_end, p.closed_end) < 0;
}

/// For t > p.open_end and 0 < u < 1, u^t < u^open_end, which is greatest at an end of b; for u = 1
/// it is 1.
bool power_stays_below(const bounds& b, const piece& p, double y) {
  if (!(0 < b.lo && b.hi <= 1) || p.closed_end < p.open_end || (b.hi == 1 && y <= 1))
    return false;
  const auto bounded = [&](double u) {
    return compare(
               [&](mpfr_ptr r, mpfr_ptr t, mpfr_rnd_t to) { return mpfr_pow(r, number(u), t, to); },
               p.open_end, MPFR_RNDU, y) <= 0;
  };
  return bounded(b.lo) && bounded(b.hi);
}

const bounds* part_of(const value& v) {
  if (const auto* bare = std::get_if<bounds>(&v))
    return bare;
  const auto* decorated = std::get_if<decorated_bounds>(&v);
  return decorated == nullptr ? nullptr : &decorated->part;
}

bool same_label(const value& x, const value& y) {
  const auto *a = std::get_if<decorated_bounds>(&x), *b = std::get_if<decorated_bounds>(&y);
  return a == nullptr || b == nullptr ? a == b : a->label == b->label;
}

bool holds_no_solution(const statement& s, const piece& p) {
  const std::string_view name = s.operation;
  const bounds* first = part_of(s.operands[0]);
  if (first == nullptr || first->is_empty())
    return false;
  if (name == "sinRev" || name == "sinRevBin")
    return one_half_turn(p, 0.5) && avoids(mpfr_sin, p, *first);
  if (name == "cosRev" || name == "cosRevBin")
    return one_half_turn(p, 0) && avoids(mpfr_cos, p, *first);
  if (name == "tanRev" || name == "tanRevBin")
    return one_half_turn(p, 0.5) && avoids(mpfr_tan, p, *first);
  if (name == "pownRev" || name == "pownRevBin") {
    const auto* n = std::get_if<std::int64_t>(&s.operands[name == "pownRev" ? 1 : 2]);
    const auto power = [n](mpfr_ptr r, mpfr_ptr t, mpfr_rnd_t to) {
      return mpfr_pow_si(r, t, static_cast<long>(*n), to);
    };
    return n != nullptr && *n != 0 && same_sign(p) && avoids(power, p, *first);
  }
  if (name == "powRev2") {
    const bounds* c = part_of(s.operands[1]);
    return c != nullptr && !c->is_empty() && power_stays_below(*first, p, c->lo);
  }
  return false;
}

} // namespace

bool proved_tighter(const statement& s, const value& stated, const value& got) {
  const bounds *outer = part_of(stated), *inner = part_of(got);
  if (outer == nullptr || inner == nullptr || inner->is_empty() || !inner->within(*outer) ||
      !same_label(stated, got))
    return false;
  const std::vector<piece> pieces = left_out(*outer, *inner);
  return !pieces.empty() && std::all_of(pieces.begin(), pieces.end(),
                                        [&](const piece& p) { return holds_no_solution(s, p); });
}

} // namespace graze::itf1788
