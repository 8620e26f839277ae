/* graze.h from plain C: the conventions, and one call of each kind. */
#include <graze/graze.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(bool holds, const char* claim) {
  if (!holds) {
    ++failures;
    fprintf(stderr, "failed: %s\n", claim);
  }
}
#define CHECK(condition) check(condition, #condition)

static graze_interval box(double inf, double sup) {
  graze_interval x;
  x.inf = inf;
  x.sup = sup;
  return x;
}
static bool same(graze_interval x, double inf, double sup) { return x.inf == inf && x.sup == sup; }

typedef void (*any_function)(void);
/* Every function of the header: the library defines each. */
static const any_function all[] = {
    (any_function)graze_nums_to_interval,
    (any_function)graze_empty,
    (any_function)graze_entire,
    (any_function)graze_pos,
    (any_function)graze_neg,
    (any_function)graze_add,
    (any_function)graze_sub,
    (any_function)graze_mul,
    (any_function)graze_div,
    (any_function)graze_recip,
    (any_function)graze_sqr,
    (any_function)graze_sqrt,
    (any_function)graze_fma,
    (any_function)graze_abs,
    (any_function)graze_min,
    (any_function)graze_max,
    (any_function)graze_sign,
    (any_function)graze_ceil,
    (any_function)graze_floor,
    (any_function)graze_trunc,
    (any_function)graze_round_ties_to_even,
    (any_function)graze_round_ties_to_away,
    (any_function)graze_cbrt,
    (any_function)graze_hypot,
    (any_function)graze_pown,
    (any_function)graze_pow,
    (any_function)graze_rootn,
    (any_function)graze_exp,
    (any_function)graze_exp2,
    (any_function)graze_exp10,
    (any_function)graze_expm1,
    (any_function)graze_log,
    (any_function)graze_log2,
    (any_function)graze_log10,
    (any_function)graze_logp1,
    (any_function)graze_sin,
    (any_function)graze_cos,
    (any_function)graze_tan,
    (any_function)graze_cot,
    (any_function)graze_sec,
    (any_function)graze_csc,
    (any_function)graze_asin,
    (any_function)graze_acos,
    (any_function)graze_atan,
    (any_function)graze_acot,
    (any_function)graze_atan2,
    (any_function)graze_sinh,
    (any_function)graze_cosh,
    (any_function)graze_tanh,
    (any_function)graze_coth,
    (any_function)graze_sech,
    (any_function)graze_csch,
    (any_function)graze_asinh,
    (any_function)graze_acosh,
    (any_function)graze_atanh,
    (any_function)graze_acoth,
    (any_function)graze_intersection,
    (any_function)graze_convex_hull,
    (any_function)graze_cancel_plus,
    (any_function)graze_cancel_minus,
    (any_function)graze_entire,
    (any_function)graze_sqr_rev,
    (any_function)graze_abs_rev,
    (any_function)graze_sin_rev,
    (any_function)graze_cos_rev,
    (any_function)graze_tan_rev,
    (any_function)graze_cosh_rev,
    (any_function)graze_pown_rev,
    (any_function)graze_mul_rev,
    (any_function)graze_pow_rev1,
    (any_function)graze_pow_rev2,
    (any_function)graze_mul_rev_to_pair,
    (any_function)graze_inf,
    (any_function)graze_sup,
    (any_function)graze_mid,
    (any_function)graze_rad,
    (any_function)graze_wid,
    (any_function)graze_mag,
    (any_function)graze_mig,
    (any_function)graze_is_empty,
    (any_function)graze_is_entire,
    (any_function)graze_is_singleton,
    (any_function)graze_is_common_interval,
    (any_function)graze_is_member,
    (any_function)graze_equal,
    (any_function)graze_subset,
    (any_function)graze_interior,
    (any_function)graze_less,
    (any_function)graze_strict_less,
    (any_function)graze_precedes,
    (any_function)graze_strict_precedes,
    (any_function)graze_disjoint,
    (any_function)graze_overlap,
    (any_function)graze_text_to_interval,
    (any_function)graze_interval_to_text,
    (any_function)graze_sum,
    (any_function)graze_sum_abs,
    (any_function)graze_sum_sqr,
    (any_function)graze_dot,
};

int main(void) {
  size_t i;
  graze_interval x, pair[2];
  char text[64];
  const double numbers[] = {1e300, 1, -1e300};
  CHECK(graze_nums_to_interval(1, 2, &x) && same(x, 1, 2));
  CHECK(!graze_nums_to_interval(2, 1, &x) && isnan(x.inf) && isnan(x.sup));
  CHECK(same(graze_add(box(1, 2), box(3, 4)), 4, 6));
  CHECK(graze_add(box(0.1, 0.1), box(0.2, 0.2)).inf == 0x1.3333333333333p-2);
  CHECK(graze_add(box(0.1, 0.1), box(0.2, 0.2)).sup == 0x1.3333333333334p-2);
  CHECK(graze_is_empty(graze_add(box(2, 1), box(0, 0))));
  CHECK(graze_is_empty(graze_mul(box(INFINITY, INFINITY), box(0, 0))));
  CHECK(graze_is_entire(graze_div(box(1, 1), box(-1, 1))));
  CHECK(same(graze_fma(box(1, 2), box(3, 4), box(5, 6)), 8, 14));
  CHECK(same(graze_sqrt(box(-1, 4)), 0, 2));
  CHECK(same(graze_round_ties_to_even(box(0.5, 2.5)), 0, 2));
  CHECK(same(graze_cancel_minus(box(1, 4), box(1, 2)), 0, 2));
  CHECK(same(graze_intersection(box(1, 4), box(2, 5)), 2, 4));
  CHECK(graze_mid(box(1, 2)) == 1.5 && graze_inf(graze_empty()) == INFINITY);
  CHECK(graze_subset(box(1, 2), graze_entire()) && graze_is_member(1, box(1, 1)));
  CHECK(strcmp(graze_overlap(box(1, 2), box(0, 3)), "containedBy") == 0);
  CHECK(graze_text_to_interval("[0.1, 1/2]", &x) == NULL);
  CHECK(same(x, 0x1.9999999999999p-4, 0.5));
  CHECK(strcmp(graze_text_to_interval("[2,1]", &x), "UndefinedOperation") == 0);
  CHECK(graze_is_empty(x));
  CHECK(graze_interval_to_text(box(1, 2), false, text, sizeof text) == 6 &&
        strcmp(text, "[1, 2]") == 0);
  CHECK(graze_interval_to_text(box(1, 2), true, text, 4) == 16 && strcmp(text, "[0x") == 0);
  CHECK(graze_interval_to_text(box(1, 2), true, NULL, 0) == 16);
  CHECK(graze_sum(numbers, 3, 0) == 1 &&
        graze_dot(numbers, numbers, 1, -1) == 0x1.fffffffffffffp+1023);
  CHECK(graze_exp(box(0, 0)).inf == 1 && graze_sin(box(0, 2)).sup == 1);
  for (i = 0; i < sizeof all / sizeof all[0]; ++i)
    check(all[i] != NULL, "a function");
  CHECK(same(graze_pown(box(-2, 3), 2), 0, 9) && same(graze_rootn(box(8, 27), 3), 2, 3));
  CHECK(same(graze_sqr_rev(box(4, 9), box(0, 100)), 2, 3));
  graze_mul_rev_to_pair(box(-1, 1), box(1, 2), pair);
  CHECK(same(pair[0], -INFINITY, -1) && same(pair[1], 1, INFINITY));
  return failures == 0 ? 0 : 1;
}
