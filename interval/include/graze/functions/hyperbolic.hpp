#pragma once
/// Hyperbolic functions of intervals and their inverses. Each is the tightest enclosure, 0 ulp per
/// endpoint, of its range over the members of x that are in its domain; empty if there is none.
/// Source: CORE-MATH or CRlibm (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

struct sinh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct cosh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct tanh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct asinh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct acosh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct atanh {
  static bounds value(bounds x);
  static decoration local(bounds x);
};

} // namespace functions

/// Encloses { sinh t : t in x }.
template <Real N, Policies P> interval_of<P, N> sinh(const interval_of<P, N>& x) {
  return apply<functions::sinh>(x);
}
/// Encloses { cosh t : t in x }.
template <Real N, Policies P> interval_of<P, N> cosh(const interval_of<P, N>& x) {
  return apply<functions::cosh>(x);
}
/// Encloses { tanh t : t in x }.
template <Real N, Policies P> interval_of<P, N> tanh(const interval_of<P, N>& x) {
  return apply<functions::tanh>(x);
}
/// Encloses { asinh t : t in x }.
template <Real N, Policies P> interval_of<P, N> asinh(const interval_of<P, N>& x) {
  return apply<functions::asinh>(x);
}
/// Encloses { acosh t : t in x, t >= 1 }.
template <Real N, Policies P> interval_of<P, N> acosh(const interval_of<P, N>& x) {
  return apply<functions::acosh>(x);
}
/// Encloses { atanh t : t in x, |t| < 1 }.
template <Real N, Policies P> interval_of<P, N> atanh(const interval_of<P, N>& x) {
  return apply<functions::atanh>(x);
}

} // namespace graze
