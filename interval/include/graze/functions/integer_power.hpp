#pragma once
/// Powers and roots of intervals with any int as exponent. Error: 0 ulp per endpoint.
///
/// | function    | n            | domain    | range     |
/// |-------------|--------------|-----------|-----------|
/// | pown(x, n)  | n >= 0       | R         | R for n odd, [0, inf) for n even, {1} for n = 0 |
/// |             | n < 0        | R \ { 0 } | R \ { 0 } for n odd, (0, inf) for n even        |
/// | rootn(x, n) | n > 0 odd    | R         | R         |
/// |             | n > 0 even   | [0, inf)  | [0, inf)  |
/// |             | n < 0 odd    | R \ { 0 } | R \ { 0 } |
/// |             | n < 0 even   | (0, inf)  | (0, inf)  |
/// |             | 0            | empty     | empty     |
///
/// Source: graze/point_rare.hpp at the endpoints.
#include <graze/needs_cxx20.hpp>

#include <graze/functions/apply.hpp>

namespace graze {

namespace functions {
/// Encloses { t^n : t in x }, t != 0 for n < 0.
struct pown {
  static bounds value(bounds x, int n);
  static decoration local(bounds x, int n);
};
/// Encloses { y : y^n in x }, y >= 0 for n even.
struct rootn {
  static bounds value(bounds x, int n);
  static decoration local(bounds x, int n);
};
} // namespace functions

template <Real N, Policies P> interval_of<P, N> pown(const interval_of<P, N>& x, int n) {
  return apply<functions::pown>(x, n);
}
template <Real N, Policies P> interval_of<P, N> rootn(const interval_of<P, N>& x, int n) {
  return apply<functions::rootn>(x, n);
}

} // namespace graze
