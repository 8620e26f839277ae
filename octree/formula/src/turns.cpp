// Where a polynomial turns: boxes that hold all zeros of its derivative, by bisection.
#include "expressions.hpp"

#include <algorithm>
#include <cmath>

namespace graze::octree::tape {
namespace {

number value(const std::vector<number>& p, const number& x) {
  number r = p.front();
  for (std::size_t i = 1; i < p.size(); ++i)
    r = r * x + p[i];
  return r;
}

/// All zeros lie within [-bound, bound]: Cauchy's bound, 1 + max |c_i / c_n|.
double bound_of_zeros(const std::vector<number>& p) {
  double most = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    most = std::max(most, mag(p[i] / p[0]));
  return (number(1.0) + number(most)).upper();
}

bool excludes_zero(const number& x) { return x.lower() > 0 || x.upper() < 0; }

} // namespace

std::optional<std::vector<turn>> turns_of(const std::vector<number>& polynomial,
                                          const std::vector<number>& derivative) {
  std::vector<turn> turns;
  if (derivative.size() == 1)
    return excludes_zero(derivative[0]) ? std::optional(turns) : std::nullopt;
  if (!excludes_zero(derivative[0]))
    return std::nullopt;
  const double bound = bound_of_zeros(derivative);
  if (!(bound < 0x1p1000))
    return std::nullopt;
  // Level by level, so that where the zeros cannot be told apart, all of what is left is as narrow
  // as the effort allows. A root of multiplicity m stays in about 2^(53 (1 - 1/m)) boxes of the
  // finest width; the limit stops there.
  const std::size_t most = 16 + 8 * derivative.size();
  const double finest = bound * 0x1p-80;
  std::vector<number> open{number(-bound, bound)}, next;
  bool split = true;
  while (split && open.size() <= most) {
    split = false;
    next.clear();
    for (const number& x : open) {
      const double middle = x.lower() / 2 + x.upper() / 2;
      if (!(x.lower() < middle && middle < x.upper()) || width(x) < finest) {
        next.push_back(x);
        continue;
      }
      split = true;
      for (const number& half : {number(x.lower(), middle), number(middle, x.upper())})
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
    const number piece(lo, hi), centre(std::clamp(lo / 2 + hi / 2, lo, hi));
    const number values =
        intersect(value(polynomial, piece),
                  value(polynomial, centre) + value(derivative, piece) * (piece - centre));
    turns.push_back({lo, hi, values.lower(), values.upper()});
  }
  return turns;
}

} // namespace graze::octree::tape
