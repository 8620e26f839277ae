#pragma once
/// Monotone functions of bounds from their points. Internal.
#include "correctly_rounded.hpp"
#include <graze/bounds.hpp>
#include <graze/decoration.hpp>

namespace graze::elementary {

using correctly_rounded::infinity;

/// The range of an increasing function over x, which is not empty and within the closure of its
/// domain; at an end of the domain that is not in it, and at infinite ends, the limits of Function.
template <class Function> bounds increasing(const bounds& x) {
  [[maybe_unused]] const typename Function::scope scope;
  return {Function::down(x.lo), Function::up(x.hi)};
}
template <class Function> bounds decreasing(const bounds& x) {
  [[maybe_unused]] const typename Function::scope scope;
  return {Function::down(x.hi), Function::up(x.lo)};
}

/// x without what is outside of [lo, hi]; x is not empty. May be empty (lo > hi, not canonical).
constexpr bounds clipped(const bounds& x, double lo, double hi) {
  return {x.lo < lo ? lo : x.lo, x.hi > hi ? hi : x.hi};
}

/// The least and the greatest |t| of x, which is not empty.
inline double mignitude(const bounds& x) { return x.lo > 0 ? x.lo : x.hi < 0 ? -x.hi : 0; }
inline double magnitude(const bounds& x) { return x.hi > -x.lo ? x.hi : -x.lo; }

/// Of a function that is defined and continuous everywhere.
inline decoration everywhere(const bounds& x) {
  return x.is_empty() ? decoration::trv : decoration::dac;
}
/// Of a function that is continuous on its domain; `inside`: x is within it.
constexpr decoration continuous(bool inside) { return inside ? decoration::dac : decoration::trv; }

} // namespace graze::elementary
