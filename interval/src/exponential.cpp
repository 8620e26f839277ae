#include "elementary/monotone.hpp"
#include <graze/functions/exponential.hpp>

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;

template <class Function> bounds exponential(const bounds& x) {
  return x.is_empty() ? x : elementary::increasing<Function>(x);
}

/// An increasing function with the domain (pole, inf), at whose lower end it is -inf.
template <class Function> bounds logarithm(const bounds& x, double pole) {
  if (!(x.hi > pole))
    return bounds::empty();
  return elementary::increasing<Function>({x.lo > pole ? x.lo : pole, x.hi});
}

} // namespace

bounds exp::value(bounds x) { return exponential<point::exp>(x); }
bounds exp2::value(bounds x) { return exponential<point::exp2>(x); }
bounds exp10::value(bounds x) { return exponential<point::exp10>(x); }
bounds expm1::value(bounds x) { return exponential<point::expm1>(x); }
bounds log::value(bounds x) { return logarithm<point::log>(x, 0); }
bounds log2::value(bounds x) { return logarithm<point::log2>(x, 0); }
bounds log10::value(bounds x) { return logarithm<point::log10>(x, 0); }
bounds logp1::value(bounds x) { return logarithm<point::logp1>(x, -1); }

decoration exp::local(bounds x) { return everywhere(x); }
decoration exp2::local(bounds x) { return everywhere(x); }
decoration exp10::local(bounds x) { return everywhere(x); }
decoration expm1::local(bounds x) { return everywhere(x); }
decoration log::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration log2::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration log10::local(bounds x) { return elementary::continuous(x.lo > 0); }
decoration logp1::local(bounds x) { return elementary::continuous(x.lo > -1); }

} // namespace graze::functions
