#pragma once
/// How a function on bounds becomes one on every interval type.
///
/// A function is a struct in graze::functions with
///   static bounds value(bounds...);          the tightest enclosure of its range, empty on empty
///   static decoration local(bounds...);      trv, def or dac: what holds on a non-empty box whatever
///                                            its size (dac stands for com too: apply() tells them
///                                            apart by boundedness); trv where an operand is empty
/// defined in interval/src, compiled with Graze's own flags whatever those of the user. Parameters
/// other than bounds (an integer exponent) are passed through.
#include <algorithm>
#include <concepts>
#include <graze/bounds.hpp>
#include <graze/decoration.hpp>

namespace graze {

namespace detail {
template <Policies P> bounds as_bounds(const interval_of<P>& x) { return to_bounds(x); }
inline bounds as_bounds(const bounds& x) { return x; }
template <std::integral Integer> Integer as_bounds(Integer n) { return n; }

inline bool is_common(const bounds& x) { return x.is_common(); }
template <std::integral Integer> bool is_common(Integer) { return true; }
} // namespace detail

/// F on bare intervals of the policies P.
template <class F, Policies P, class... Operands>
interval_of<P> apply(const interval_of<P>& x, const Operands&... more) {
  return to_interval<P>(F::value(to_bounds(x), detail::as_bounds(more)...));
}

/// The decoration of F's result `value` on these bounds, before the operands' own are joined.
template <class F, class... Operands>
decoration local_decoration(const bounds& value, const Operands&... x) {
  const decoration d = F::local(x...);
  return d == decoration::dac && value.is_common() && (detail::is_common(x) && ...)
             ? decoration::com
             : d;
}

} // namespace graze
