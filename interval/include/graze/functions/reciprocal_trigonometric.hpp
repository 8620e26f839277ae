#pragma once
/// cot, sec, csc and acot of intervals. Error: 0 ulp per endpoint, for arguments of any size.
///
/// | function | domain                  | range                 | monotone |
/// |----------|-------------------------|-----------------------|------------------------------------|
/// | cot      | R \ { k pi }            | R                     | decreasing between poles | | sec
/// | R \ { (k + 1/2) pi }    | (-inf, -1] u [1, inf) | between multiples of pi/2          | | csc
/// | R \ { k pi }            | (-inf, -1] u [1, inf) | between multiples of pi/2          | | acot
/// | R                       | (0, pi)               | decreasing; continuous, also at 0  |
///
/// Source: graze/point_rare.hpp at the endpoints; poles and extrema from the endpoints' quadrants,
/// which are exact, since 0 is the only double that is a multiple of pi/2.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {

namespace functions {
/// Encloses { cot t : t in x, t != k pi }.
struct cot {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { sec t : t in x, t != (k + 1/2) pi }.
struct sec {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { csc t : t in x, t != k pi }.
struct csc {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { acot t : t in x }.
struct acot {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
} // namespace functions

template <Real N, Policies P> interval_of<P, N> cot(const interval_of<P, N>& x) {
  return apply<functions::cot>(x);
}
template <Real N, Policies P> interval_of<P, N> sec(const interval_of<P, N>& x) {
  return apply<functions::sec>(x);
}
template <Real N, Policies P> interval_of<P, N> csc(const interval_of<P, N>& x) {
  return apply<functions::csc>(x);
}
template <Real N, Policies P> interval_of<P, N> acot(const interval_of<P, N>& x) {
  return apply<functions::acot>(x);
}

} // namespace graze
