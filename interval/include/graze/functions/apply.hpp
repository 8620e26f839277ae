#pragma once
/// How a function on bounds becomes one on every interval type.
///
/// A function is a struct in graze::functions with
///   static bounds value(bounds...);          the tightest enclosure of its range, empty on empty
///   static decoration local(bounds...);      trv, def or dac: what holds on a non-empty box
///                                            whatever its size (dac stands for com too: apply()
///                                            tells them apart by boundedness); trv where an
///                                            operand is empty
///   static bool continuous_around(bounds...);  only where it can differ from local() == dac: is
///                                            the function continuous at every point of the box,
///                                            seen from the whole domain? (floor on [1, 1] is
///                                            constant, hence dac, but jumps at 1, hence not com.)
/// defined in interval/src, compiled with Graze's own flags whatever those of the user. Parameters
/// other than bounds (an integer exponent) are passed through.
#include <graze/needs_cxx20.hpp>

#include <algorithm>
#include <concepts>
#include <graze/bounds.hpp>
#include <graze/decorated_bounds.hpp>
#include <graze/decoration.hpp>
#include <graze/functions/names.h>
#include <graze/rounding/hardware.hpp>

namespace graze {

namespace detail {
template <Real N, Policies P> bounds as_bounds(const interval_of<P, N>& x) { return to_bounds(x); }
inline bounds as_bounds(const bounds& x) { return x; }
inline bounds as_bounds(const decorated_bounds& x) { return x.part; }
template <std::integral Integer> Integer as_bounds(Integer n) { return n; }

inline bool is_common(const bounds& x) { return x.is_common(); }
template <std::integral Integer> bool is_common(Integer) { return true; }

inline decoration label_of(const decorated_bounds& x) { return x.label; }
template <std::integral Integer> decoration label_of(Integer) { return decoration::com; }
} // namespace detail

// A function of one set of bounds, for the lists of graze/functions/names.h.
#define GRAZE_FUNCTION_OF_ONE(name)                                                                \
  struct name {                                                                                    \
    static bounds value(bounds x);                                                                 \
    static decoration local(bounds x);                                                             \
  };

/// F on bare intervals of the policies P.
template <class F, Real N, Policies P, class... Operands>
interval_of<P, N> apply(const interval_of<P, N>& x, const Operands&... more) {
  return to_interval<P, N>(F::value(to_bounds(x), detail::as_bounds(more)...));
}

// A function that boost_functions.hpp has too, for any checking and by way of C: for bounds of one
// type as there, so that this one, more constrained, is taken.
#define GRAZE_BESIDE_BOOST(name)                                                                   \
  template <Policies P> interval_of<P, double> name(const interval_of<P, double>& x) {             \
    return apply<functions::name>(x);                                                              \
  }                                                                                                \
  template <Policies P> interval_of<P, float> name(const interval_of<P, float>& x) {               \
    return apply<functions::name>(x);                                                              \
  }
#define GRAZE_BESIDE_BOOST_2(name)                                                                 \
  template <Policies P>                                                                            \
  interval_of<P, double> name(const interval_of<P, double>& x, const interval_of<P, double>& y) {  \
    return apply<functions::name>(x, y);                                                           \
  }                                                                                                \
  template <Policies P>                                                                            \
  interval_of<P, float> name(const interval_of<P, float>& x, const interval_of<P, float>& y) {     \
    return apply<functions::name>(x, y);                                                           \
  }

/// The decoration of F's result `value` on these bounds, before the operands' own are joined.
/// Source: IEEE 1788-2015, 11.2 (com asks for continuity at each point, dac for that of the
/// restriction).
template <class F, class... Operands>
decoration local_decoration(const bounds& value, const Operands&... x) {
  // F::local and continuous_around compare bounds with 0
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  decoration d = F::local(x...);
  if (d != decoration::dac || !value.is_common() || !(detail::is_common(x) && ...))
    return d;
  if constexpr (requires { F::continuous_around(x...); }) {
    if (!F::continuous_around(x...))
      return d;
  }
  return decoration::com;
}

/// F on decorated bounds: NaI if an operand is; else F's own decoration joined with the operands'.
template <class F, class... Operands> decorated_bounds apply_decorated(const Operands&... x) {
  const decoration operands = std::min({detail::label_of(x)...});
  if (operands == decoration::ill)
    return decorated_bounds::nai();
  const bounds value = F::value(detail::as_bounds(x)...);
  return {value, std::min(operands, local_decoration<F>(value, detail::as_bounds(x)...))};
}

} // namespace graze
