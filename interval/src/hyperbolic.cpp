#include "elementary/monotone.hpp"
#include <graze/functions/hyperbolic.hpp>

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;
using elementary::increasing;
using elementary::infinity;

} // namespace

bounds sinh::value(bounds x) { return x.is_empty() ? x : increasing<point::sinh>(x); }
bounds tanh::value(bounds x) { return x.is_empty() ? x : increasing<point::tanh>(x); }
bounds asinh::value(bounds x) { return x.is_empty() ? x : increasing<point::asinh>(x); }

bounds cosh::value(bounds x) {
  if (x.is_empty())
    return x;
  return increasing<point::cosh>({elementary::mignitude(x), elementary::magnitude(x)});
}

bounds acosh::value(bounds x) {
  if (!(x.hi >= 1))
    return bounds::empty();
  return increasing<point::acosh>(elementary::clipped(x, 1, infinity));
}

bounds atanh::value(bounds x) {
  if (!(x.hi > -1 && x.lo < 1))
    return bounds::empty();
  return increasing<point::atanh>(elementary::clipped(x, -1, 1));
}

decoration sinh::local(bounds x) { return everywhere(x); }
decoration cosh::local(bounds x) { return everywhere(x); }
decoration tanh::local(bounds x) { return everywhere(x); }
decoration asinh::local(bounds x) { return everywhere(x); }
decoration acosh::local(bounds x) { return elementary::continuous(x.lo >= 1); }
decoration atanh::local(bounds x) { return elementary::continuous(x.lo > -1 && x.hi < 1); }

} // namespace graze::functions
