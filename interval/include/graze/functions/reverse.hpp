#pragma once
/// The reverse operations of IEEE 1788-2015, 10.5.4 and 10.6.3: which arguments can have given a
/// result. They narrow x from what is known of f(x), the step of constraint propagation.
///
/// For a function f, f_rev(c, x) encloses { t in x : f(t) is defined and in c }, and f_rev(c) is
/// f_rev(c, entire). Every result is the tightest: each end is the least or greatest solution,
/// correctly rounded outward, for arguments of any size, and the result is empty exactly when there
/// is no solution. Thread-safe; the mode in force must be to-nearest.
///
/// | operation                 | solutions t in x                              | decoration |
/// |---------------------------|-----------------------------------------------|------------|
/// | sqr_rev(c, x)             | t^2 in c                                      | trv        |
/// | abs_rev(c, x)             | abs(t) in c                                   | trv        |
/// | pown_rev(c, x, n)         | t^n in c; t != 0 where n < 0; 0^0 = 1         | trv        |
/// | sin_rev, cos_rev, tan_rev | sin(t), cos(t), tan(t) in c; t in radians     | trv        |
/// | cosh_rev(c, x)            | cosh(t) in c                                  | trv        |
/// | mul_rev(b, c, x)          | u t in c for a u in b                         | trv        |
/// | mul_rev_to_pair(b, c)     | u t in c for a u in b, as one or two pieces   | see there  |
/// | pow_rev1(b, c, x)         | t^u in c for a u in b, t > 0 or t = 0 < u     | trv        |
/// | pow_rev2(a, c, x)         | u^t in c for a u in a, u > 0 or u = 0 < t     | trv        |
///
/// A reverse operation tells nothing of where f is defined or continuous, hence trv.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>
#include <utility>

namespace graze::functions {

/// Error: 0 ulp per endpoint, like all below. Source: src/reverse_even.cpp.
struct sqr_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};

/// Exact. Source: src/reverse_even.cpp.
struct abs_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};

/// Any n, the least integer too. Source: src/reverse_even.cpp; graze/point_rare.hpp (rootn).
struct pown_rev {
  static bounds value(bounds c, bounds x, int n);
  static bounds value(bounds c, int n) { return value(c, bounds::entire(), n); }
  static decoration local(bounds, bounds, int) { return decoration::trv; }
  static decoration local(bounds, int) { return decoration::trv; }
};

/// Source: src/reverse_trigonometric.cpp, with the proof.
struct sin_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};
struct cos_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};
struct tan_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};

/// Source: src/reverse_even.cpp; graze/point.hpp (acosh).
struct cosh_rev {
  static bounds value(bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds = bounds::entire()) { return decoration::trv; }
};

/// Source: src/reverse_mul.cpp.
struct mul_rev {
  static bounds value(bounds b, bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds, bounds = bounds::entire()) { return decoration::trv; }
};

/// The two-output division. The solutions of u t in c form one interval, which is `first`, `second`
/// being empty; or two, with 0 between them, where b holds 0 inside and c does not hold 0: `first`
/// is the negative one.
struct mul_rev_to_pair {
  static std::pair<bounds, bounds> value(bounds b, bounds c);
  /// Of `first`: that of the division c / b where b does not hold 0, else trv. `second` is trv.
  static decoration local(bounds b, bounds c);
};

/// Source: src/reverse_pow.cpp; graze/point.hpp (pow).
struct pow_rev1 {
  static bounds value(bounds b, bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds, bounds = bounds::entire()) { return decoration::trv; }
};
struct pow_rev2 {
  static bounds value(bounds a, bounds c, bounds x = bounds::entire());
  static decoration local(bounds, bounds, bounds = bounds::entire()) { return decoration::trv; }
};

} // namespace graze::functions

namespace graze {

/// { t in x : t^2 in c }, and so on: see the table above.
template <Real N, Policies P> interval_of<P, N> sqr_rev(const interval_of<P, N>& c) {
  return apply<functions::sqr_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> sqr_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::sqr_rev>(c, x);
}
template <Real N, Policies P> interval_of<P, N> abs_rev(const interval_of<P, N>& c) {
  return apply<functions::abs_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> abs_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::abs_rev>(c, x);
}
template <Real N, Policies P> interval_of<P, N> pown_rev(const interval_of<P, N>& c, int n) {
  return apply<functions::pown_rev>(c, n);
}
template <Real N, Policies P>
interval_of<P, N> pown_rev(const interval_of<P, N>& c, const interval_of<P, N>& x, int n) {
  return apply<functions::pown_rev>(c, x, n);
}
template <Real N, Policies P> interval_of<P, N> sin_rev(const interval_of<P, N>& c) {
  return apply<functions::sin_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> sin_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::sin_rev>(c, x);
}
template <Real N, Policies P> interval_of<P, N> cos_rev(const interval_of<P, N>& c) {
  return apply<functions::cos_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> cos_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::cos_rev>(c, x);
}
template <Real N, Policies P> interval_of<P, N> tan_rev(const interval_of<P, N>& c) {
  return apply<functions::tan_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> tan_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::tan_rev>(c, x);
}
template <Real N, Policies P> interval_of<P, N> cosh_rev(const interval_of<P, N>& c) {
  return apply<functions::cosh_rev>(c);
}
template <Real N, Policies P>
interval_of<P, N> cosh_rev(const interval_of<P, N>& c, const interval_of<P, N>& x) {
  return apply<functions::cosh_rev>(c, x);
}
template <Real N, Policies P>
interval_of<P, N> mul_rev(const interval_of<P, N>& b, const interval_of<P, N>& c) {
  return apply<functions::mul_rev>(b, c);
}
template <Real N, Policies P>
interval_of<P, N> mul_rev(const interval_of<P, N>& b, const interval_of<P, N>& c,
                          const interval_of<P, N>& x) {
  return apply<functions::mul_rev>(b, c, x);
}
template <Real N, Policies P>
std::pair<interval_of<P, N>, interval_of<P, N>> mul_rev_to_pair(const interval_of<P, N>& b,
                                                                const interval_of<P, N>& c) {
  const auto [first, second] = functions::mul_rev_to_pair::value(to_bounds(b), to_bounds(c));
  return {to_interval<P, N>(first), to_interval<P, N>(second)};
}
template <Real N, Policies P>
interval_of<P, N> pow_rev1(const interval_of<P, N>& b, const interval_of<P, N>& c) {
  return apply<functions::pow_rev1>(b, c);
}
template <Real N, Policies P>
interval_of<P, N> pow_rev1(const interval_of<P, N>& b, const interval_of<P, N>& c,
                           const interval_of<P, N>& x) {
  return apply<functions::pow_rev1>(b, c, x);
}
template <Real N, Policies P>
interval_of<P, N> pow_rev2(const interval_of<P, N>& a, const interval_of<P, N>& c) {
  return apply<functions::pow_rev2>(a, c);
}
template <Real N, Policies P>
interval_of<P, N> pow_rev2(const interval_of<P, N>& a, const interval_of<P, N>& c,
                           const interval_of<P, N>& x) {
  return apply<functions::pow_rev2>(a, c, x);
}

} // namespace graze
