#pragma once
/// Correctly rounded functions of doubles that no library gives: towards -inf (`_down`) and towards
/// +inf (`_up`) for every double. At infinities the limit; outside of the domain, at poles and for
/// NaN: NaN. Computed in integers, so that no result depends on the rounding mode in force;
/// flushing (FTZ, DAZ) must be off, as everywhere.
#include <graze/functions/names.h>

namespace graze::point {

/// The greatest double that is at most a value, and the least that is at least the value.
struct directed {
  double down, up;
};

#define GRAZE_DECLARE(name) directed name(double x);
/// cot, sec, csc: 1/tan, 1/cos, 1/sin, NaN at infinities; acot: the inverse of cot with values in
/// (0, pi), continuous; coth, sech, csch: 1/tanh, 1/cosh, 1/sinh; acoth: the inverse of coth, |x| > 1.
GRAZE_FOR_EACH_POINT_RARE(GRAZE_DECLARE)
#undef GRAZE_DECLARE

/// x^n for any n: 1 for n = 0; not defined for x = 0 > n.
directed pown(double x, int n);
/// The n-th root: y with y^n = x, y >= 0 for n even. Not defined for n = 0; for x < 0 and n even;
/// for x = 0 > n.
directed rootn(double x, int n);

#define GRAZE_DEFINE(name)                                                                         \
  inline double name##_down(double x) { return name(x).down; }                                     \
  inline double name##_up(double x) { return name(x).up; }
GRAZE_FOR_EACH_POINT_RARE(GRAZE_DEFINE)
#undef GRAZE_DEFINE
inline double pown_down(double x, int n) { return pown(x, n).down; }
inline double pown_up(double x, int n) { return pown(x, n).up; }
inline double rootn_down(double x, int n) { return rootn(x, n).down; }
inline double rootn_up(double x, int n) { return rootn(x, n).up; }

} // namespace graze::point
