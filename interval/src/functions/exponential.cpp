#include "../elementary/exponential_pair.hpp"
#include "../elementary/logarithm_pair.hpp"
#include "../elementary/monotone.hpp"
#include <graze/functions/exponential.hpp>

namespace graze::elementary {

__attribute__((noinline)) bounds exponential_each(double lo, double hi) {
  return increasing_everywhere<correctly_rounded::exp>(lo, hi);
}

/// An increasing function with the domain (pole, inf), at whose lower end it is -inf.
template <class Function> static bounds logarithm(double lo, double hi, double pole) {
  [[maybe_unused]] const typename Function::scope scope;
  hold(lo, hi);
  if (!(hi > pole && lo <= hi))
    return bounds::empty();
  return increasing_within_scope<Function>(lo > pole ? lo : pole, hi);
}

__attribute__((noinline)) bounds logarithm_each(double lo, double hi) {
  return logarithm<correctly_rounded::log>(lo, hi, 0);
}

} // namespace graze::elementary

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;

using elementary::increasing_everywhere;
using elementary::logarithm;

} // namespace

bounds exp::value(bounds x) {
#if defined(__x86_64__)
  if (point::core_math::fused)
    return elementary::exponential_pair(x.lo, x.hi);
#endif
  return elementary::exponential_each(x.lo, x.hi);
}
bounds exp2::value(bounds x) { return increasing_everywhere<point::exp2>(x.lo, x.hi); }
bounds exp10::value(bounds x) { return increasing_everywhere<point::exp10>(x.lo, x.hi); }
bounds expm1::value(bounds x) { return increasing_everywhere<point::expm1>(x.lo, x.hi); }
bounds log::value(bounds x) {
#if defined(__x86_64__)
  if (point::core_math::fused) {
    if (x.is_empty() || !rounding::exact::above_zero(x.hi))
      return bounds::empty();
    // the fast evaluation wants two positive ends; a lower one at the pole counts for nothing
    const bool pole = !rounding::exact::above_zero(x.lo);
    bounds r = elementary::logarithm_pair(pole ? x.hi : x.lo, x.hi);
    r.lo = pole ? -checking::infinity : r.lo;
    return r;
  }
#endif
  return elementary::logarithm_each(x.lo, x.hi);
}
bounds log2::value(bounds x) { return logarithm<point::log2>(x.lo, x.hi, 0); }
bounds log10::value(bounds x) { return logarithm<point::log10>(x.lo, x.hi, 0); }
bounds logp1::value(bounds x) { return logarithm<point::logp1>(x.lo, x.hi, -1); }

decoration exp::local(bounds x) { return everywhere(x); }
decoration exp2::local(bounds x) { return everywhere(x); }
decoration exp10::local(bounds x) { return everywhere(x); }
decoration expm1::local(bounds x) { return everywhere(x); }
decoration log::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration log2::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration log10::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration logp1::local(bounds x) { return elementary::continuous(x.lo > -1); }

} // namespace graze::functions
