/* graze.h from plain C: the conventions, and one call of each kind. */
#include <graze/graze.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(bool holds, const char* what) {
  if (!holds) {
    ++failures;
    fprintf(stderr, "failed: %s\n", what);
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

int main(void) {
  graze_interval x;
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
  return failures == 0 ? 0 : 1;
}
