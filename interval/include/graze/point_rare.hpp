#pragma once
/// Correctly rounded functions of doubles that no library gives: towards -inf (`_down`) and towards
/// +inf (`_up`) for every double. At infinities the limit; outside of the domain, at poles and for
/// NaN: NaN. Computed in integers, so that no result depends on the rounding mode in force;
/// flushing (FTZ, DAZ) must be off, as everywhere.

namespace graze::point {

/// The greatest double that is at most a value, and the least that is at least the value.
struct directed {
  double down, up;
};

/// 1/tan, 1/cos, 1/sin; NaN at infinities.
directed cot(double x);
directed sec(double x);
directed csc(double x);
/// The inverse of cot with values in (0, pi), continuous.
directed acot(double x);

/// 1/tanh, 1/cosh, 1/sinh.
directed coth(double x);
directed sech(double x);
directed csch(double x);
/// The inverse of coth: |x| > 1.
directed acoth(double x);

/// x^n for any n: 1 for n = 0; not defined for x = 0 > n.
directed pown(double x, int n);
/// The n-th root: y with y^n = x, y >= 0 for n even. Not defined for n = 0; for x < 0 and n even;
/// for x = 0 > n.
directed rootn(double x, int n);

inline double cot_down(double x) { return cot(x).down; }
inline double cot_up(double x) { return cot(x).up; }
inline double sec_down(double x) { return sec(x).down; }
inline double sec_up(double x) { return sec(x).up; }
inline double csc_down(double x) { return csc(x).down; }
inline double csc_up(double x) { return csc(x).up; }
inline double acot_down(double x) { return acot(x).down; }
inline double acot_up(double x) { return acot(x).up; }
inline double coth_down(double x) { return coth(x).down; }
inline double coth_up(double x) { return coth(x).up; }
inline double sech_down(double x) { return sech(x).down; }
inline double sech_up(double x) { return sech(x).up; }
inline double csch_down(double x) { return csch(x).down; }
inline double csch_up(double x) { return csch(x).up; }
inline double acoth_down(double x) { return acoth(x).down; }
inline double acoth_up(double x) { return acoth(x).up; }
inline double pown_down(double x, int n) { return pown(x, n).down; }
inline double pown_up(double x, int n) { return pown(x, n).up; }
inline double rootn_down(double x, int n) { return rootn(x, n).down; }
inline double rootn_up(double x, int n) { return rootn(x, n).up; }

} // namespace graze::point
