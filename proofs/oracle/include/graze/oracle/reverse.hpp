#pragma once
/// The judges of the reverse operations of IEEE 1788.1. None is an inverse function rounded by the
/// same means as the code under test: algebraic ones are judged by MPFR's direct functions at the
/// result's ends, trigonometric ones by the formula in as many bits as the periods need.
#include <graze/oracle/reverse_judge.hpp>

namespace graze::oracle::reverse {

// The direct functions at a place: for judges, and for making operands near a solution.
image abs_at(place p);
image sqr_at(place p);
image cosh_at(place p);
image pown_at(place p, int n);

// Is a result the tightest enclosure of { t in x : ... }? No operand but x may be empty.

/// |t|, t^2, cosh t or t^n in c.
inline reverse_judge of_abs(const bounds& c) { return {abs_at, {0}, c}; }
inline reverse_judge of_sqr(const bounds& c) { return {sqr_at, {0}, c}; }
inline reverse_judge of_cosh(const bounds& c) { return {cosh_at, {0}, c}; }
inline reverse_judge of_pown(const bounds& c, int n) {
  return {[n](place p) { return pown_at(p, n); }, {0}, c};
}
/// u t in c for a u in b.
reverse_judge of_mul(const bounds& b, const bounds& c);
/// t^u in c for a u in b.
reverse_judge of_pow1(const bounds& b, const bounds& c);
/// u^t in c for a u in a.
reverse_judge of_pow2(const bounds& a, const bounds& c);

/// The tightest enclosure of { t in x : sin t in c }, and so on, for arguments of any size: the
/// solutions are the intervals between the inverse functions' values, moved by k periods, in MPFR
/// with as many bits as k and then 250. (The code under test uses no such reduction.)
bounds sin_rev(const bounds& c, const bounds& x);
bounds cos_rev(const bounds& c, const bounds& x);
bounds tan_rev(const bounds& c, const bounds& x);

} // namespace graze::oracle::reverse
