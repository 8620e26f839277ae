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
GRAZE_BESIDE_BOOST(sinh)
/// Encloses { cosh t : t in x }.
GRAZE_BESIDE_BOOST(cosh)
/// Encloses { tanh t : t in x }.
GRAZE_BESIDE_BOOST(tanh)
/// Encloses { asinh t : t in x }.
GRAZE_BESIDE_BOOST(asinh)
/// Encloses { acosh t : t in x, t >= 1 }.
GRAZE_BESIDE_BOOST(acosh)
/// Encloses { atanh t : t in x, |t| < 1 }.
GRAZE_BESIDE_BOOST(atanh)

} // namespace graze
