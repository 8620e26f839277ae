#pragma once
/// The arithmetic of IEEE 1788.1: forward operations that need no elementary function. Error: 0 ulp
/// per endpoint. Defined in interval/src/functions/arithmetic.cpp and integer_valued.cpp.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {
namespace functions {

#define GRAZE_UNARY_OPERATION(name)                                                                \
  struct name {                                                                                    \
    static bounds value(bounds x);                                                                 \
    static decoration local(bounds x);                                                             \
  }
#define GRAZE_BINARY_OPERATION(name)                                                               \
  struct name {                                                                                    \
    static bounds value(bounds x, bounds y);                                                       \
    static decoration local(bounds x, bounds y);                                                   \
  }
#define GRAZE_STEP_FUNCTION(name)                                                                  \
  struct name {                                                                                    \
    static bounds value(bounds x);                                                                 \
    static decoration local(bounds x);                                                             \
    static bool continuous_around(bounds x);                                                       \
  }

GRAZE_UNARY_OPERATION(pos);   ///< x
GRAZE_UNARY_OPERATION(neg);   ///< -x
GRAZE_BINARY_OPERATION(add);  ///< x + y
GRAZE_BINARY_OPERATION(sub);  ///< x - y
GRAZE_BINARY_OPERATION(mul);  ///< x y
GRAZE_BINARY_OPERATION(div);  ///< x / y, where y != 0
GRAZE_UNARY_OPERATION(recip); ///< 1 / x, where x != 0
GRAZE_UNARY_OPERATION(sqr);   ///< x^2
GRAZE_UNARY_OPERATION(sqrt);  ///< the square root, where x >= 0
GRAZE_UNARY_OPERATION(abs);   ///< |x|
GRAZE_BINARY_OPERATION(min);  ///< the lesser of x and y
GRAZE_BINARY_OPERATION(max);  ///< the greater of x and y

/// x y + z: the bounds are those of the exact expression, rounded once.
struct fma {
  static bounds value(bounds x, bounds y, bounds z);
  static decoration local(bounds x, bounds y, bounds z);
};

GRAZE_STEP_FUNCTION(sign);               ///< -1, 0 or 1
GRAZE_STEP_FUNCTION(ceil);               ///< the least integer >= x
GRAZE_STEP_FUNCTION(floor);              ///< the greatest integer <= x
GRAZE_STEP_FUNCTION(trunc);              ///< the nearest integer towards 0
GRAZE_STEP_FUNCTION(round_ties_to_even); ///< the nearest integer, of two the even one
GRAZE_STEP_FUNCTION(round_ties_to_away); ///< the nearest integer, of two the one further from 0

#undef GRAZE_UNARY_OPERATION
#undef GRAZE_BINARY_OPERATION
#undef GRAZE_STEP_FUNCTION

} // namespace functions

// +, -, *, /, sqr, sqrt, abs, min and max of intervals are in graze/interval.hpp.
template <Real N, Policies P> interval_of<P, N> recip(const interval_of<P, N>& x) {
  return apply<functions::recip>(x);
}
template <Real N, Policies P>
interval_of<P, N> fma(const interval_of<P, N>& x, const interval_of<P, N>& y,
                      const interval_of<P, N>& z) {
  return apply<functions::fma>(x, y, z);
}
template <Real N, Policies P> interval_of<P, N> sign(const interval_of<P, N>& x) {
  return apply<functions::sign>(x);
}
template <Real N, Policies P> interval_of<P, N> ceil(const interval_of<P, N>& x) {
  return apply<functions::ceil>(x);
}
template <Real N, Policies P> interval_of<P, N> floor(const interval_of<P, N>& x) {
  return apply<functions::floor>(x);
}
template <Real N, Policies P> interval_of<P, N> trunc(const interval_of<P, N>& x) {
  return apply<functions::trunc>(x);
}
template <Real N, Policies P> interval_of<P, N> round_ties_to_even(const interval_of<P, N>& x) {
  return apply<functions::round_ties_to_even>(x);
}
template <Real N, Policies P> interval_of<P, N> round_ties_to_away(const interval_of<P, N>& x) {
  return apply<functions::round_ties_to_away>(x);
}

} // namespace graze
