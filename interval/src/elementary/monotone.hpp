#pragma once
/// Monotone functions of bounds from their points. Internal.
#include "../border.hpp"
#include "correctly_rounded.hpp"
#include <graze/bounds.hpp>
#include <graze/decoration.hpp>

namespace graze::elementary {

using correctly_rounded::infinity;

/// The range of an increasing function over [lo, hi], which is not empty and within the closure of
/// its domain; at an end of the domain that is not in it, and at infinite ends, the limits of
/// Function. (Two doubles and not bounds: GCC 12 passes those through memory, at 2 ns.)
template <class Function> bounds increasing_within_scope(double lo, double hi) {
  return {Function::down(lo), Function::up(hi)};
}
template <class Function> bounds increasing(double lo, double hi) {
  [[maybe_unused]] const typename Function::scope scope;
  return increasing_within_scope<Function>(lo, hi);
}
template <class Function> bounds decreasing(double lo, double hi) {
  [[maybe_unused]] const typename Function::scope scope;
  return {Function::down(hi), Function::up(lo)};
}
/// The same for a function that is defined everywhere, and x empty or not (lo is a NaN).
template <class Function> bounds increasing_everywhere(double lo, double hi) {
  return lo != lo ? bounds::empty() : increasing<Function>(lo, hi);
}

/// The least and the greatest |t| of [lo, hi], which is not empty. Within a scope.
inline double mignitude(double lo, double hi) { return lo > 0 ? lo : hi < 0 ? -hi : 0; }
inline double magnitude(double lo, double hi) { return hi > -lo ? hi : -lo; }

/// Of a function that is defined and continuous everywhere.
inline decoration everywhere(const bounds& x) {
  return x.is_empty() ? decoration::trv : decoration::dac;
}
/// Of a function that is continuous on its domain; `inside`: x is within it.
constexpr decoration continuous(bool inside) { return inside ? decoration::dac : decoration::trv; }

} // namespace graze::elementary
