#pragma once
/// Roots in [0, 1] by Bernstein coefficients: Descartes' rule of signs and bisection by de Casteljau's
/// algorithm. Integer may be unbounded, and everything is exact; or of a fixed size, where coefficients
/// are known to within a radius. Source: Mourrain, Rouillier, Roy, The Bernstein Basis and Real Root
/// Isolation, 2005.
#include "exact_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace graze::octree::tape {

/// The coefficients, each of them to within `radius`, of a positive multiple of a polynomial.
template <class Integer> struct bernstein {
  std::vector<Integer> b;
  Integer radius;

  static constexpr bool is_exact = std::is_same_v<Integer, integer>;

  /// Of c[0] + c[1] s + ..., each to within `each`. A fixed Integer needs degree * 1.5 + 8 more bits than
  /// the coefficients have.
  static bernstein of(std::vector<Integer> c, const Integer& each) {
    const std::size_t n = c.size() - 1;
    // c[k] / binomial(n, k), times what they have in common: lcm(1, ..., n + 1) / (n + 1)
    std::uint64_t binomial = 1;
    Integer common(1);
    for (std::size_t k = 0; k <= n; ++k) {
      common = common / gcd(common, Integer(binomial)) * binomial;
      binomial = next_binomial(binomial, n, k);
    }
    bernstein r;
    r.radius = each * common * static_cast<std::uint64_t>(n + 1);
    binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
      c[k] *= common / binomial;
      binomial = next_binomial(binomial, n, k);
    }
    for (std::size_t j = 1; j <= n; ++j)
      for (std::size_t i = n; i >= j; --i)
        c[i] += c[i - 1];
    r.b = std::move(c);
    return r;
  }

  /// The sign of b[i]; 0 where it is not known, or is 0.
  [[nodiscard]] int sign(std::size_t i) const {
    if constexpr (is_exact)
      return b[i].sign();
    else
      return b[i] > radius ? 1 : b[i] < -radius ? -1 : 0;
  }

  /// This becomes the right half; the left one is returned.
  bernstein halve() {
    const std::size_t n = b.size() - 1;
    bernstein left = *this;
    for (std::size_t j = 1; j <= n; ++j) {
      for (std::size_t i = 0; i + j <= n; ++i) {
        b[i] += b[i + 1];
        if constexpr (!is_exact)
          b[i] >>= 1;
      }
      left.b[j] = b[0];
    }
    if constexpr (is_exact) {
      for (std::size_t i = 0; i <= n; ++i) {
        b[i] <<= static_cast<unsigned>(i);
        left.b[i] <<= static_cast<unsigned>(n - i);
      }
    } else {
      radius += static_cast<std::uint64_t>(n);
      left.radius = radius;
    }
    return left;
  }

private:
  static std::uint64_t next_binomial(std::uint64_t x, std::size_t n, std::size_t k) {
    // x (n - k) / (k + 1): the quotient and the rest apart, so that no product is too large
    const std::uint64_t d = k + 1;
    return x / d * (n - k) + x % d * (n - k) / d;
  }
};

enum class isolation {
  none, ///< no root in [0, 1]
  root, ///< the first one is the only one between `first` and `first + 1`, in units of 2^-depth, and simple
  at,      ///< the first one is `first`
  unknown, ///< the coefficients are not known well enough, or it takes too many halvings
};
struct isolated {
  isolation what;
  integer first;
  unsigned depth;
  int before; ///< the sign before the root
};

/// The first root in [0, 1] of a polynomial whose roots are simple, or that is not known exactly.
template <class Integer>
isolated first_root(bernstein<Integer> p, unsigned most_depth, unsigned most_halvings) {
  struct part {
    bernstein<Integer> p;
    integer first;
    unsigned depth;
  };
  std::vector<part> open;
  part x{std::move(p), integer(0), 0};
  for (unsigned halvings = 0;;) {
    // the least and the greatest number of changes of sign
    const std::size_t n = x.p.b.size() - 1;
    const int begin = x.p.sign(0), end = x.p.sign(n);
    int last = begin;
    unsigned least = 0, most = 0, unsure = 0;
    for (std::size_t i = 1; i <= n; ++i) {
      const int s = x.p.sign(i);
      if (s == 0) {
        unsure += bernstein<Integer>::is_exact ? 0 : 1;
        continue;
      }
      const unsigned change = last != 0 && s != last ? 1 : 0;
      least += change;
      most += change + (unsure + 1 - change) / 2 * 2;
      unsure = 0;
      last = s;
    }
    most += unsure;
    if (begin == 0) {
      if constexpr (bernstein<Integer>::is_exact)
        return {isolation::at, x.first, x.depth, 0};
      else
        return {isolation::unknown, {}, 0, 0};
    }
    if (most == 0) {
      if (open.empty()) {
        if (end != 0)
          return {isolation::none, {}, 0, 0};
        return {isolation::at, x.first + 1, x.depth, begin}; // exact: no sign is unsure
      }
      x = std::move(open.back());
      open.pop_back();
      continue;
    }
    if (most == 1 && least == 1 && end != 0)
      return {isolation::root, x.first, x.depth, begin};
    if (x.depth >= most_depth || halvings++ >= most_halvings)
      return {isolation::unknown, {}, 0, 0};
    bernstein<Integer> left = x.p.halve();
    open.push_back({std::move(x.p), 2 * x.first + 1, x.depth + 1});
    x = {std::move(left), 2 * x.first, x.depth + 1};
  }
}

inline double next(double t) { return std::nextafter(t, std::numeric_limits<double>::infinity()); }
inline double previous(double t) {
  return std::nextafter(t, -std::numeric_limits<double>::infinity());
}

struct enclosed {
  double near, far;
};

/// Narrows a root between t0 < t1 to doubles next to it: lo >= t0 is the least double there, hi <= t1 the
/// greatest, which may be less than lo. `before` is the sign from t0 to the root. sign(t) gives nothing
/// where it is not known, and 0 at the root.
template <class Sign>
std::optional<enclosed> narrowed(double lo, double hi, int before, const Sign& sign) {
  if (hi < lo)
    return enclosed{hi, lo};
  const auto at_lo = sign(lo), at_hi = sign(hi);
  if (!at_lo || !at_hi)
    return std::nullopt;
  if (*at_lo == 0 || *at_hi == 0)
    return *at_lo == 0 ? enclosed{lo, lo} : enclosed{hi, hi};
  if (*at_lo != before)
    return enclosed{previous(lo), lo};
  if (*at_hi == before)
    return enclosed{hi, next(hi)};
  while (next(lo) < hi) {
    const double middle = std::clamp(lo / 2 + hi / 2, next(lo), previous(hi));
    auto at_middle = sign(middle);
    if (!at_middle) { // so near that its two neighbours will do
      const double below = previous(middle), above = next(middle);
      const auto at_below = sign(below), at_above = sign(above);
      if (!at_below || !at_above || *at_below != before || *at_above == before)
        return std::nullopt;
      return enclosed{below, above};
    }
    if (*at_middle == 0)
      return enclosed{middle, middle};
    (*at_middle == before ? lo : hi) = middle;
  }
  return enclosed{lo, hi};
}

} // namespace graze::octree::tape
