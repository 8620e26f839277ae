#pragma once
/// Exponentials and logarithms of intervals. Each is the tightest enclosure, 0 ulp per endpoint, of
/// its range over the members of x that are in its domain; empty if there is none. Source:
/// CORE-MATH or CRlibm (see graze/point.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

struct exp {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct exp2 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct exp10 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct expm1 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct log {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct log2 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct log10 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};
struct logp1 {
  static bounds value(bounds x);
  static decoration local(bounds x);
};

} // namespace functions

/// Encloses { e^t : t in x }.
GRAZE_BESIDE_BOOST(exp)
/// Encloses { 2^t : t in x }.
template <Real N, Policies P> interval_of<P, N> exp2(const interval_of<P, N>& x) {
  return apply<functions::exp2>(x);
}
/// Encloses { 10^t : t in x }.
template <Real N, Policies P> interval_of<P, N> exp10(const interval_of<P, N>& x) {
  return apply<functions::exp10>(x);
}
/// Encloses { e^t - 1 : t in x }.
template <Real N, Policies P> interval_of<P, N> expm1(const interval_of<P, N>& x) {
  return apply<functions::expm1>(x);
}
/// Encloses { log t : t in x, t > 0 }.
GRAZE_BESIDE_BOOST(log)
/// Encloses { log_2 t : t in x, t > 0 }.
template <Real N, Policies P> interval_of<P, N> log2(const interval_of<P, N>& x) {
  return apply<functions::log2>(x);
}
/// Encloses { log_10 t : t in x, t > 0 }.
template <Real N, Policies P> interval_of<P, N> log10(const interval_of<P, N>& x) {
  return apply<functions::log10>(x);
}
/// Encloses { log(1 + t) : t in x, t > -1 }.
template <Real N, Policies P> interval_of<P, N> logp1(const interval_of<P, N>& x) {
  return apply<functions::logp1>(x);
}

} // namespace graze
