#include "../elementary/monotone.hpp"
#include <graze/functions/hyperbolic.hpp>

namespace graze::functions {
namespace {

namespace point = correctly_rounded;
using elementary::everywhere;
using elementary::increasing;
using elementary::increasing_everywhere;

} // namespace

bounds sinh::value(bounds x) { return increasing_everywhere<point::sinh>(x.lo, x.hi); }
bounds tanh::value(bounds x) { return increasing_everywhere<point::tanh>(x.lo, x.hi); }
bounds asinh::value(bounds x) { return increasing_everywhere<point::asinh>(x.lo, x.hi); }

bounds cosh::value(bounds x) {
  if (x.is_empty())
    return bounds::empty();
  [[maybe_unused]] const point::cosh::scope scope;
  hold(x.lo, x.hi);
  return elementary::increasing_within_scope<point::cosh>(elementary::mignitude(x.lo, x.hi),
                                                          elementary::magnitude(x.lo, x.hi));
}

bounds acosh::value(bounds x) {
  if (!(x.hi >= 1))
    return bounds::empty();
  return increasing<point::acosh>(x.lo < 1 ? 1 : x.lo, x.hi);
}

bounds atanh::value(bounds x) {
  if (!(x.hi > -1 && x.lo < 1))
    return bounds::empty();
  return increasing<point::atanh>(x.lo < -1 ? -1 : x.lo, x.hi > 1 ? 1 : x.hi);
}

decoration sinh::local(bounds x) { return everywhere(x); }
decoration cosh::local(bounds x) { return everywhere(x); }
decoration tanh::local(bounds x) { return everywhere(x); }
decoration asinh::local(bounds x) { return everywhere(x); }
decoration acosh::local(bounds x) { return elementary::continuous(x.lo >= 1); }
decoration atanh::local(bounds x) { return elementary::continuous(x.lo > -1 && x.hi < 1); }

} // namespace graze::functions
