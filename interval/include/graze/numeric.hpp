#pragma once
/// Numbers that describe an interval: inf sup mid rad mid_rad wid mag mig of IEEE 1788.1, for
/// bounds, intervals and decorated intervals. Of the empty set (inf and sup apart) and of NaI they
/// are NaN. Inlined anywhere, in any environment.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <graze/bounds.hpp>
#include <graze/decorated_bounds.hpp>
#include <graze/rounding/nearest.hpp>

namespace graze {

template <Real N> struct centre_of {
  N mid, rad;
};
using centre = centre_of<double>;

namespace detail {
/// f of the ends, to nearest and with subnormal numbers.
template <class Function> double of_ends(const bounds& x, Function f) {
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  double lo = x.lo, hi = x.hi;
  rounding::hardware::pin(lo), rounding::hardware::pin(hi);
  double value = f(lo, hi);
  rounding::hardware::pin(value);
  return value;
}
} // namespace detail

/// The greatest lower bound; a zero is -0, of the empty set +inf. Exact.
constexpr double inf(const bounds& x) {
  return x.is_empty() ? checking::infinity : rounding::exact::is_zero(x.lo) ? -0.0 : x.lo;
}
/// The least upper bound; a zero is +0, of the empty set -inf. Exact.
constexpr double sup(const bounds& x) {
  return x.is_empty() ? -checking::infinity : rounding::exact::is_zero(x.hi) ? 0.0 : x.hi;
}
/// (lo + hi) / 2 rounded to nearest; of [-inf, inf] 0, of half-lines the last finite double. Always
/// in x, never -0.
inline double mid(const bounds& x) {
  return x.is_empty() ? checking::nan() : detail::of_ends(x, [](double lo, double hi) {
    return boost_rounding<rounding::nearest>::median(lo, hi);
  });
}
namespace detail {
template <Real N> N radius(N lo, N hi) {
  using round = boost_rounding<rounding::nearest>;
  const N m = round::median(lo, hi);
  return std::max(round::sub_up(m, lo), round::sub_up(hi, m));
}
} // namespace detail
/// The least double r such that [m - r, m + r] holds x, for m = mid(x).
inline double rad(const bounds& x) {
  return x.is_empty() ? checking::nan() : detail::of_ends(x, detail::radius<double>);
}
/// mid and rad, which belong together.
inline centre mid_rad(const bounds& x) { return {mid(x), rad(x)}; }
/// The least double >= hi - lo.
inline double wid(const bounds& x) {
  return x.is_empty() ? checking::nan() : detail::of_ends(x, [](double lo, double hi) {
    return rounding::nearest::sub_up(hi, lo);
  });
}
/// max { |t| : t in x }. Exact.
constexpr double mag(const bounds& x) {
  return x.is_empty() ? checking::nan() : detail::greater(0.0, detail::greater(-x.lo, x.hi));
}
/// min { |t| : t in x }. Exact.
constexpr double mig(const bounds& x) {
  return x.is_empty() ? checking::nan() : detail::greater(0.0, detail::greater(x.lo, -x.hi));
}

// Of float intervals all are floats: mid and rad as said above with floats for doubles.
namespace detail {
/// A double that is a float, or NaN, as the bounds' type; no conversion that might flush it.
template <Real N> N exactly(double x) {
  if constexpr (std::same_as<N, float>)
    return rounding::narrow_to_nearest(x);
  else
    return x;
}
/// f of the ends as numbers N, to nearest and with subnormal numbers.
template <Real N, class Function> N of_ends_as(const bounds& x, Function f) {
  return exactly<N>(x.is_empty() ? checking::nan() : of_ends(x, [f](double lo, double hi) {
    return static_cast<double>(f(static_cast<N>(lo), static_cast<N>(hi)));
  }));
}
} // namespace detail

template <Real N, Policies P> N inf(const interval_of<P, N>& x) {
  return detail::exactly<N>(inf(to_bounds(x)));
}
template <Real N, Policies P> N sup(const interval_of<P, N>& x) {
  return detail::exactly<N>(sup(to_bounds(x)));
}
template <Real N, Policies P> N mid(const interval_of<P, N>& x) {
  return detail::of_ends_as<N>(
      to_bounds(x), [](N lo, N hi) { return boost_rounding<rounding::nearest>::median(lo, hi); });
}
template <Real N, Policies P> N rad(const interval_of<P, N>& x) {
  return detail::of_ends_as<N>(to_bounds(x), detail::radius<N>);
}
template <Real N, Policies P> centre_of<N> mid_rad(const interval_of<P, N>& x) {
  return {mid(x), rad(x)};
}
template <Real N, Policies P> N wid(const interval_of<P, N>& x) {
  return detail::of_ends_as<N>(
      to_bounds(x), [](N lo, N hi) { return boost_rounding<rounding::nearest>::sub_up(hi, lo); });
}
template <Real N, Policies P> N mag(const interval_of<P, N>& x) {
  return detail::exactly<N>(mag(to_bounds(x)));
}
template <Real N, Policies P> N mig(const interval_of<P, N>& x) {
  return detail::exactly<N>(mig(to_bounds(x)));
}

inline double inf(const decorated_bounds& x) { return x.is_nai() ? checking::nan() : inf(x.part); }
inline double sup(const decorated_bounds& x) { return x.is_nai() ? checking::nan() : sup(x.part); }
// NaI's part is empty
inline double mid(const decorated_bounds& x) { return mid(x.part); }
inline double rad(const decorated_bounds& x) { return rad(x.part); }
inline centre mid_rad(const decorated_bounds& x) { return mid_rad(x.part); }
inline double wid(const decorated_bounds& x) { return wid(x.part); }
inline double mag(const decorated_bounds& x) { return mag(x.part); }
inline double mig(const decorated_bounds& x) { return mig(x.part); }

} // namespace graze
