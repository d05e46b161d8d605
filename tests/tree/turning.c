/* SPDX-License-Identifier: Apache-2.0
 * A thousand 7-year sugi against the paper's table 1 and its divergence. */
#include <math.h>
#include <stdio.h>

#include "tree.h"

typedef struct {
  double turns, branches, mean, sd, least, most, a_up, a_down, n;
} sums;

static sums of_trees(const char *preset, const char *values, int count) {
  sums s = {.least = 360};
  double all = 0, sum = 0, squares = 0;
  for (int i = 0; i < count; i++) {
    char text[160];
    snprintf(text, sizeof text, "orders=1 seed=%d %s", i, values);
    sozai_geometry *g = grow(preset, text, NULL);
    s.turns += statistic(g, "turns_year") / count;
    s.branches += statistic(g, "branches_turn") / count;
    s.a_up += statistic(g, "crown_a_up") / count;
    s.a_down += statistic(g, "crown_a_down") / count;
    s.n += statistic(g, "first_order") / count;
    sozai_table t = table_of(g, "turning");
    for (uint64_t k = 1; k < t.rows; k++) {
      double d = cell(&t, k, "divergence");
      all++;
      sum += d;
      squares += d * d;
      s.least = fmin(s.least, d);
      s.most = fmax(s.most, d);
    }
    geometry()->release(g);
  }
  s.mean = sum / all;
  s.sd = sqrt(squares / all - s.mean * s.mean);
  return s;
}

static void near_to(const char *what, double got, double want, double share) {
  print_message("%-24s %8.3f, the paper's %8.3f (%+.2f %%)\n", what, got, want,
                100 * (got / want - 1));
  assert_true(fabs(got / want - 1) <= share);
}

static void table_1(void **unused) {
  (void)unused;
  sums s = of_trees("sugi_paper", "age=7 azimuth=turning crown_scatter=0.15", 1000);
  near_to("turns a year", s.turns, 3.19, 0.02);
  near_to("branches a turn", s.branches, 2.10, 0.02);
  near_to("divergence, no. 9", s.mean, 173, 0.02);
  near_to("its deviation", s.sd, 73, 0.03);
  print_message("divergence from %.1f to %.1f\n", s.least, s.most);
  assert_true(s.least >= 32.99 && s.least < 40);
  assert_true(s.most <= 293.01 && s.most > 286);
  near_to("crown a, upslope", s.a_up, 0.25, 0.02);
  near_to("crown a, downslope", s.a_down, 0.26, 0.02);
}

static void hinoki(void **unused) {
  (void)unused;
  sums s = of_trees("hinoki", "age=11 turning_spread=0 crown_ratio=1 crown_narrowing=0", 300);
  near_to("hinoki: divergence", s.mean, 164, 0.02);
  near_to("its deviation", s.sd, 52, 0.03);
  near_to("crown a", s.a_up, 0.28, 0.02);
}

static void younger_planting(void **unused) {
  (void)unused;
  sums s = of_trees("sugi_h4", "crown_ratio=1 crown_narrowing=0", 300);
  near_to("sugi H4: crown a, up", s.a_up, 0.33, 0.02);
  near_to("sugi H4: crown a, down", s.a_down, 0.35, 0.02);
}

/* A step a year: most of its height in the first half of its turning. */
static void spring_is_steep(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi_paper", "age=7 orders=1", NULL);
  sozai_table t = table_of(g, "turning");
  double early = 0, late = 0;
  for (uint64_t i = 0; i < t.rows; i++) {
    uint64_t first = i, last = i;
    double year = cell(&t, i, "year");
    while (last + 1 < t.rows && cell(&t, last + 1, "year") == year) last++;
    if (last >= first + 4) {
      uint64_t middle = (first + last) / 2;
      double z = cell(&t, middle, "height");
      early += (z - cell(&t, first, "height")) / (double)(middle - first);
      late += (cell(&t, last, "height") - z) / (double)(last - middle);
    }
    i = last;
  }
  print_message("height a branch, spring over autumn: %.2f\n", early / late);
  assert_true(early > 1.5 * late);
  geometry()->release(g);
}

static void whorls_are_steps(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("akamatsu", "age=10 orders=1 crown_ratio=1", NULL);
  sozai_table t = table_of(g, "turning");
  double within = 0, between = 0;
  for (uint64_t i = 1; i < t.rows; i++) {
    double step = cell(&t, i, "height") - cell(&t, i - 1, "height");
    if (cell(&t, i, "year") == cell(&t, i - 1, "year"))
      within = fmax(within, step);
    else
      between = between > 0 ? fmin(between, step) : step;
  }
  print_message("within a whorl at most %.4f of the height, from whorl to whorl at least %.4f\n",
                within, between);
  assert_true(within < 0.2 * between);
  geometry()->release(g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(table_1), cmocka_unit_test(hinoki), cmocka_unit_test(younger_planting),
      cmocka_unit_test(spring_is_steep), cmocka_unit_test(whorls_are_steps)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
