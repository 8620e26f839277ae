#pragma once
/* Graze for C and for other languages: bounds in, bounds out. Every operation of IEEE 1788.1 on bare
 * intervals, tightest (0 ulp per endpoint); link with graze::interval (libgraze_interval). The mode
 * in force must be round to nearest, as programs start; any thread. See the C++ headers for what
 * each operation means: graze_exp is graze::functions::exp, and so on.
 *
 * An interval is { t real : inf <= t <= sup }; -inf and +inf as bounds mean that there is none. What
 * holds no real number (NaN bounds, inf > sup, both +inf or both -inf) is the empty set, which is
 * given as {NaN, NaN}. */
#include <graze/functions/names.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct graze_interval {
  double inf, sup;
} graze_interval;

/* Constructors. With `false`, and the empty set, where the standard signals UndefinedOperation. */
bool graze_nums_to_interval(double lower, double upper, graze_interval* result);
graze_interval graze_empty(void);
graze_interval graze_entire(void);

/* Arithmetic */
graze_interval graze_pos(graze_interval x);
graze_interval graze_neg(graze_interval x);
graze_interval graze_add(graze_interval x, graze_interval y);
graze_interval graze_sub(graze_interval x, graze_interval y);
graze_interval graze_mul(graze_interval x, graze_interval y);
graze_interval graze_div(graze_interval x, graze_interval y);
graze_interval graze_recip(graze_interval x);
graze_interval graze_sqr(graze_interval x);
graze_interval graze_sqrt(graze_interval x);
graze_interval graze_fma(graze_interval x, graze_interval y, graze_interval z);
graze_interval graze_abs(graze_interval x);
graze_interval graze_min(graze_interval x, graze_interval y);
graze_interval graze_max(graze_interval x, graze_interval y);
graze_interval graze_fmod(graze_interval x, graze_interval y); /* C's fmod; not in the standard */
graze_interval graze_sign(graze_interval x);
graze_interval graze_ceil(graze_interval x);
graze_interval graze_floor(graze_interval x);
graze_interval graze_trunc(graze_interval x);
graze_interval graze_round_ties_to_even(graze_interval x);
graze_interval graze_round_ties_to_away(graze_interval x);

/* Powers and roots */
graze_interval graze_hypot(graze_interval x, graze_interval y);
graze_interval graze_pown(graze_interval x, int n);
graze_interval graze_pow(graze_interval x, graze_interval y);
graze_interval graze_rootn(graze_interval x, int n);
/* The angle of (x, y), radians */
graze_interval graze_atan2(graze_interval y, graze_interval x);

/* graze_NAME(x), of one argument, for cbrt; exp exp2 exp10 expm1 log log2 log10 logp1; in radians sin cos
 * tan cot sec csc asin acos atan acot; sinh cosh tanh coth sech csch asinh acosh atanh acoth */
#define GRAZE_PROTOTYPE(name) graze_interval graze_##name(graze_interval x);
GRAZE_FOR_EACH_ELEMENTARY(GRAZE_PROTOTYPE)
#undef GRAZE_PROTOTYPE

/* Sets, cancellative addition */
graze_interval graze_intersection(graze_interval x, graze_interval y);
graze_interval graze_convex_hull(graze_interval x, graze_interval y);
graze_interval graze_cancel_plus(graze_interval x, graze_interval y);
graze_interval graze_cancel_minus(graze_interval x, graze_interval y);

/* Reverse operations: the t in x with f(t) in c; x is graze_entire() for the unary ones. */
graze_interval graze_sqr_rev(graze_interval c, graze_interval x);
graze_interval graze_abs_rev(graze_interval c, graze_interval x);
graze_interval graze_sin_rev(graze_interval c, graze_interval x);
graze_interval graze_cos_rev(graze_interval c, graze_interval x);
graze_interval graze_tan_rev(graze_interval c, graze_interval x);
graze_interval graze_cosh_rev(graze_interval c, graze_interval x);
graze_interval graze_pown_rev(graze_interval c, graze_interval x, int n);
graze_interval graze_mul_rev(graze_interval b, graze_interval c, graze_interval x);
graze_interval graze_pow_rev1(graze_interval b, graze_interval c, graze_interval x);
graze_interval graze_pow_rev2(graze_interval a, graze_interval c, graze_interval x);
void graze_mul_rev_to_pair(graze_interval b, graze_interval c, graze_interval result[2]);

/* Numbers; NaN of the empty set, but inf is +inf and sup -inf then */
double graze_inf(graze_interval x);
double graze_sup(graze_interval x);
double graze_mid(graze_interval x);
double graze_rad(graze_interval x);
double graze_wid(graze_interval x);
double graze_mag(graze_interval x);
double graze_mig(graze_interval x);

/* Tests */
bool graze_is_empty(graze_interval x);
bool graze_is_entire(graze_interval x);
bool graze_is_singleton(graze_interval x);
bool graze_is_common_interval(graze_interval x);
bool graze_is_member(double m, graze_interval x);
bool graze_equal(graze_interval x, graze_interval y);
bool graze_subset(graze_interval x, graze_interval y);
bool graze_interior(graze_interval x, graze_interval y);
bool graze_less(graze_interval x, graze_interval y);
bool graze_strict_less(graze_interval x, graze_interval y);
bool graze_precedes(graze_interval x, graze_interval y);
bool graze_strict_precedes(graze_interval x, graze_interval y);
bool graze_disjoint(graze_interval x, graze_interval y);

/* The standard's name of how x lies to y: "before", "containedBy", ... */
const char* graze_overlap(graze_interval x, graze_interval y);

/* Text. The tightest enclosure of a literal; NULL where all is well, else the exception's name in the
 * standard ("UndefinedOperation", with the empty set, or "PossiblyUndefinedOperation"). */
const char* graze_text_to_interval(const char* text, graze_interval* result);
/* A literal that holds x, as snprintf would write it: at most `size` bytes with the final 0, and the
 * length of the whole is returned. Exact in the hexadecimal style, which reads back to x. */
size_t graze_interval_to_text(graze_interval x, bool hexadecimal, char* buffer, size_t size);

/* Exact sums, rounded once: direction < 0 down, 0 to nearest, > 0 up */
double graze_sum(const double* x, size_t n, int direction);
double graze_sum_abs(const double* x, size_t n, int direction);
double graze_sum_sqr(const double* x, size_t n, int direction);
double graze_dot(const double* x, const double* y, size_t n, int direction);

#ifdef __cplusplus
}
#endif
