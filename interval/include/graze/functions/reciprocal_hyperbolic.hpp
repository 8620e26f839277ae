#pragma once
/// coth, sech, csch and acoth of intervals. Error: 0 ulp per endpoint.
///
/// | function | domain    | range                | monotone                          |
/// |----------|-----------|----------------------|-----------------------------------|
/// | coth     | R \ { 0 } | (-inf, -1) u (1, inf) | decreasing on each side of 0     |
/// | sech     | R         | (0, 1]               | increasing to 0, then decreasing  |
/// | csch     | R \ { 0 } | R \ { 0 }            | decreasing on each side of 0      |
/// | acoth    | |x| > 1   | R \ { 0 }            | decreasing on each side           |
///
/// Source: graze/point_rare.hpp at the endpoints.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {

namespace functions {
/// Encloses { coth t : t in x, t != 0 }.
struct coth {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { sech t : t in x }.
struct sech {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { csch t : t in x, t != 0 }.
struct csch {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
/// Encloses { acoth t : t in x, |t| > 1 }.
struct acoth {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
} // namespace functions

template <Real N, Policies P> interval_of<P, N> coth(const interval_of<P, N>& x) {
  return apply<functions::coth>(x);
}
template <Real N, Policies P> interval_of<P, N> sech(const interval_of<P, N>& x) {
  return apply<functions::sech>(x);
}
template <Real N, Policies P> interval_of<P, N> csch(const interval_of<P, N>& x) {
  return apply<functions::csch>(x);
}
template <Real N, Policies P> interval_of<P, N> acoth(const interval_of<P, N>& x) {
  return apply<functions::acoth>(x);
}

} // namespace graze
