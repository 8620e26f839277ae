// Where a polynomial turns: the zeros of its derivative, exactly, or, where its coefficients are not known,
// boxes that hold all of them, by bisection.
#include "expressions.hpp"
#include "integer_polynomial.hpp"
#include "real_roots.hpp"

#include <algorithm>
#include <cmath>

namespace graze::octree::tape {
namespace {

using interval = number::interval;

interval value(const std::vector<number>& p, const interval& x) {
  interval r = p.front().enclosure();
  for (std::size_t i = 1; i < p.size(); ++i)
    r = r * x + p[i].enclosure();
  return r;
}

/// All zeros lie within [-bound, bound]: Cauchy's bound, 1 + max |c_i / c_n|.
double bound_of_zeros(const std::vector<number>& p) {
  double most = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    most = std::max(most, mag(p[i].enclosure() / p[0].enclosure()));
  return (interval(1.0) + interval(most)).upper();
}

bool excludes_zero(const interval& x) { return x.lower() > 0 || x.upper() < 0; }

/// Integers in proportion to numbers that are known, and the factor: `scale` times the numbers, lowest
/// first. Nothing where that takes too many bits.
struct scaled_numbers {
  integer_polynomial p;
  integer scale{1};
};
std::optional<scaled_numbers> scaled(const std::vector<number>& numbers) {
  constexpr unsigned most_bits = 8192;
  std::vector<rational> exact;
  scaled_numbers r;
  for (std::size_t i = numbers.size(); i-- > 0;) {
    const auto x = numbers[i].exact();
    if (!x)
      return std::nullopt;
    r.scale = lcm(r.scale, denominator_of(*x));
    if (bits_of(r.scale) > most_bits)
      return std::nullopt;
    exact.push_back(*x);
  }
  for (const rational& x : exact) {
    r.p.push_back(numerator_of(x) * (r.scale / denominator_of(x)));
    if (bits_of(r.p.back()) > most_bits)
      return std::nullopt;
  }
  return r;
}

rational value(const integer_polynomial& p, const rational& x) {
  rational r(0);
  for (std::size_t i = p.size(); i-- > 0;)
    r = r * x + p[i];
  return r;
}

rational magnitude(const rational& x) { return x.sign() < 0 ? rational(-x) : x; }

/// All values of p between doubles that have one turn between them, or of one of these.
turn turn_between(const scaled_numbers& p, double lo, double hi) {
  const rational from = exactly(lo), length = exactly(hi) - from;
  const rational first = value(p.p, from), last = value(p.p, exactly(hi));
  const integer_polynomial slope = derivative_of(p.p);
  integer_polynomial curvature = derivative_of(slope);
  for (integer& c : curvature)
    c = abs(c);
  const rational steepest =
      magnitude(value(slope, from)) +
      length * value(curvature, exactly(std::max(std::fabs(lo), std::fabs(hi))));
  const rational beyond = length * steepest;
  return {lo, hi, enclosure_of((std::min(first, last) - beyond) / p.scale).lower(),
          enclosure_of((std::max(first, last) + beyond) / p.scale).upper()};
}

/// Nothing where the coefficients are not known, or it takes too long.
std::optional<std::vector<turn>> exact_turns(const std::vector<number>& polynomial, double bound) {
  const auto p = scaled(polynomial);
  if (!p)
    return std::nullopt;
  auto simple = square_free(derivative_of(p->p));
  if (!simple)
    return std::nullopt;
  integer_polynomial& slope = simple->part;
  std::vector<turn> turns;
  const rational last = exactly(bound);
  for (rational first = -last; slope.size() > 1;) {
    const isolated root = first_root(
        bernstein<integer>::of(on_interval(slope, first, last), integer(0)), 3000, 10000);
    if (root.what == isolation::none)
      break;
    if (root.what == isolation::unknown)
      return std::nullopt;
    const rational step = (last - first) / (integer(1) << root.depth);
    const rational t0 = first + root.first * step, t1 = t0 + step;
    turn next{};
    if (root.what == isolation::at) {
      const auto at = enclosure_of(t0);
      next = turn_between(*p, at.lower(), at.upper());
      slope = *quotient_of(slope, {-numerator_of(t0), denominator_of(t0)});
      first = t0;
    } else {
      const auto at = narrowed(enclosure_of(t0).upper(), enclosure_of(t1).lower(), root.before,
                               [&](double x) { return std::optional(sign_at(slope, exactly(x))); });
      next = turn_between(*p, at->near, at->far);
      first = t1;
    }
    if (!turns.empty() && next.lo <= turns.back().hi) {
      turn& before = turns.back();
      before = {before.lo, std::max(before.hi, next.hi), std::min(before.least, next.least),
                std::max(before.greatest, next.greatest)};
    } else {
      turns.push_back(next);
    }
  }
  return turns;
}

} // namespace

std::optional<std::vector<turn>> turns_of(const std::vector<number>& polynomial,
                                          const std::vector<number>& derivative) {
  std::vector<turn> turns;
  if (derivative.size() == 1)
    return excludes_zero(derivative[0].enclosure()) ? std::optional(turns) : std::nullopt;
  if (!excludes_zero(derivative[0].enclosure()))
    return std::nullopt;
  const double bound = bound_of_zeros(derivative);
  if (!(bound < 0x1p1000))
    return std::nullopt;
  if (auto exact = exact_turns(polynomial, bound))
    return exact;
  // Level by level, so that where the zeros cannot be told apart, all of what is left is as narrow
  // as the effort allows. A root of multiplicity m stays in about 2^(53 (1 - 1/m)) boxes of the
  // finest width; the limit stops there.
  const std::size_t most = 16 + 8 * derivative.size();
  const double finest = bound * 0x1p-80;
  std::vector<interval> open{interval(-bound, bound)}, next;
  bool split = true;
  while (split && open.size() <= most) {
    split = false;
    next.clear();
    for (const interval& x : open) {
      const double middle = x.lower() / 2 + x.upper() / 2;
      if (!(x.lower() < middle && middle < x.upper()) || width(x) < finest) {
        next.push_back(x);
        continue;
      }
      split = true;
      for (const interval& half : {interval(x.lower(), middle), interval(middle, x.upper())})
        if (!excludes_zero(value(derivative, half)))
          next.push_back(half);
    }
    open.swap(next);
  }
  for (std::size_t i = 0; i < open.size();) {
    const double lo = open[i].lower();
    double hi = open[i].upper();
    for (++i; i < open.size() && open[i].lower() <= hi; ++i)
      hi = open[i].upper();
    const interval piece(lo, hi), centre(std::clamp(lo / 2 + hi / 2, lo, hi));
    const interval values =
        intersect(value(polynomial, piece),
                  value(polynomial, centre) + value(derivative, piece) * (piece - centre));
    turns.push_back({lo, hi, values.lower(), values.upper()});
  }
  return turns;
}

} // namespace graze::octree::tape
