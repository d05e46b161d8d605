/* SPDX-License-Identifier: Apache-2.0
 * What is fitted to field tables, and trees that are grown of it. */
#include <math.h>
#include <stdio.h>

#include "tree.h"

#define RAD (3.14159265358979323846 / 180)

/* A tree of known numbers, written as a field table and fitted. */
static void fit_and_siblings(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("sugi_paper",
           "age=30 orders=1 azimuth=turning crown_scatter=0.05 turning_spread=0 seed=3", NULL);
  char *text = field_text(g);
  static const char *const columns[] = {"crown_a", "turns_year", "branches_turn", "divergence_mean",
                                        "divergence_sd"};
  double mean[5] = {0};
  for (int seed = 0; seed < 20; seed++) {
    char values[100];
    snprintf(values, sizeof values, "age=30 orders=1 resample=sibling seed=%d", seed);
    sozai_geometry *s = grow("sugi_paper", values, text);
    sozai_table fit = table_of(s, "fit");
    assert_int_equal(fit.rows, 3);
    for (int k = 0; k < 5; k++) {
      if (seed == 0) {
        double known = statistic(g, columns[k]), got = cell(&fit, 0, columns[k]);
        print_message("%-16s %8.3f fitted %8.3f\n", columns[k], known, got);
        assert_true(fabs(got / known - 1) < 0.01);
      }
      assert_true(fabs(cell(&fit, 2, columns[k]) -
                       (cell(&fit, 1, columns[k]) / cell(&fit, 0, columns[k]) - 1)) < 1e-4);
      mean[k] += cell(&fit, 2, columns[k]) / 20;
    }
    assert_true(fabs(cell(&fit, 2, "height")) < 1e-4);
    geometry()->release(s);
  }
  for (int k = 0; k < 5; k++) {
    print_message("%-16s of 20 siblings off by %+.2f %%\n", columns[k], 100 * mean[k]);
    assert_true(fabs(mean[k]) < 0.04);
  }
  free(text);
  geometry()->release(g);
}

/* Means over siblings of a table's fit: what was measured, what they have, and of deviations the
 * root of the mean square, since a few branches have too little of it in the mean. */
static const char *const built[] = {"elevation", "elevation_sd", "diameter", "slenderness",
                                    "branch_share"};
#define BUILT 5

static void siblings_of(const char *preset, const char *values, const char *text, int count,
                        double was[BUILT], double is[BUILT]) {
  for (int k = 0; k < BUILT; k++) is[k] = 0;
  for (int seed = 0; seed < count; seed++) {
    char all[120];
    snprintf(all, sizeof all, "%s orders=1 resample=sibling seed=%d", values, seed);
    sozai_geometry *s = grow(preset, all, text);
    sozai_table fit = table_of(s, "fit");
    assert_int_equal(fit.rows, 3);
    for (int k = 0; k < BUILT; k++) {
      double a = cell(&fit, 0, built[k]), b = cell(&fit, 1, built[k]);
      double error = k < 2 ? (b - a) * RAD : b / a - 1;
      was[k] = a;
      is[k] += (k == 1 ? b * b : b) / count;
      assert_true(fabs(cell(&fit, 2, built[k]) - error) < 1e-4);
    }
    geometry()->release(s);
  }
  is[1] = sqrt(is[1]);
  for (int k = 0; k < BUILT; k++)
    print_message("%-16s %9.4f, of %d siblings %9.4f\n", built[k], was[k], count, is[k]);
}

/* Five branches that hang, on a trunk of 12 cm: nothing like the species that is to be its sibling,
 * whose branches rise and whose trunk is twice as thick. */
static void hanging_branches(void **unused) {
  (void)unused;
  static const char text[] = "trunk\n60 0 90 12\n40 0 90 10.5\n40 0 90 9\n40 0 90 7.5\n40 0 90 6\n"
                             "80 0 90 4.5\nB100\n0\n90 10 -15 3.1\nB200\n0\n0\n85 150 -20 2.8\n"
                             "B300\n0\n0\n0\n70 280 -25 2.4\nB400\n0\n0\n0\n0\n60 60 -30 2\n"
                             "B500\n0\n0\n0\n0\n0\n45 200 -18 1.6\n";
  double was[BUILT], is[BUILT];
  siblings_of("cherry", "age=20", text, 100, was, is);
  assert_true(fabs(was[0] + 21.6) < 1e-4 && fabs(was[1] - 5.9414) < 1e-3);
  assert_true(fabs(was[2] - 120) < 1e-3 && fabs(was[3] - 11.9 / 350) < 1e-5);
  /* of 500 branches of 5.9 degrees the mean has 0.27 */
  assert_true(fabs(is[0] - was[0]) < 4 * 0.27);
  assert_true(fabs(is[1] / was[1] - 1) < 0.1);
  assert_true(fabs(is[2] / was[2] - 1) < 1e-3);
  assert_true(fabs(is[3] / was[3] - 1) < 0.1);
  assert_true(fabs(is[4] / was[4] - 1) < 0.1);
}

/* Grown, written, fitted: a tree of known numbers, from whose table alone the species' own
 * elevation and thickness learn of them. */
static void build_round_trip(void **unused) {
  (void)unused;
  static const char odd[] =
      "age=12 turns_year=1.1 orders=1 crown_ratio=1 elevation_top=20 elevation_base=-25 "
      "diameter_max=400 stem_form=0.7 slenderness=0.006 thickest=0.45 seed=5";
  sozai_geometry *g = grow("cherry", odd, NULL);
  char *text = field_text(g);
  sozai_table t = table_of(g, "branches");
  const sozai_curves *c = curves_of(g, 0);
  double sum = 0, squares = 0, thick = 0, length = 0, n = 0;
  for (uint64_t i = 1; i < t.rows; i++) {
    if (cell(&t, i, "parent") != 0) continue; /* an arm is not measured */
    n++;
    const float *a = c->points + 3 * c->first[i], *b = c->points + 3 * (c->first[i + 1] - 1);
    double level = hypot((double)b[0] - (double)a[0], (double)b[2] - (double)a[2]);
    double e = atan2((double)b[1] - (double)a[1], level) / RAD;
    sum += e;
    squares += e * e;
    thick += cell(&t, i, "diameter");
    length += cell(&t, i, "length");
  }
  double known[3] = {sum / n, sqrt((squares - sum * sum / n) / (n - 1)), statistic(g, "diameter")};
  double was[BUILT], is[BUILT];
  siblings_of("cherry", "age=12", text, 60, was, is);
  assert_true(n > 20);
  assert_true(fabs(was[0] - known[0]) < 0.01 && fabs(was[1] - known[1]) < 0.01);
  assert_true(fabs(was[2] / known[2] - 1) < 1e-4);
  assert_true(fabs(was[3] / (thick / length) - 1) < 1e-4);
  assert_true(fabs(is[0] - was[0]) < 4 * was[1] / sqrt(n * 60) + 1);
  assert_true(fabs(is[1] / was[1] - 1) < 0.1);
  for (int k = 2; k < BUILT; k++) assert_true(fabs(is[k] / was[k] - 1) < 0.03);
  geometry()->release_curves(c);
  free(text);
  geometry()->release(g);
}

/* A trunk that was first measured at its second node, and one that was not measured at all. */
static void what_is_not_measured(void **unused) {
  (void)unused;
  static const char branches[] = "B100\n0\n60 10 -15\nB200\n0\n0\n50 150 -20\n"
                                 "B300\n0\n0\n40 280 -25\n";
  char text[400];
  snprintf(text, sizeof text, "trunk\n60 0 90 -\n90 0 90 10\n150 0 90 5\n%s", branches);
  sozai_geometry *s = grow("cherry", "age=20 orders=1 resample=sibling", text);
  sozai_table fit = table_of(s, "fit");
  assert_true(fabs(cell(&fit, 0, "diameter") - 100) < 1e-3);
  assert_true(fabs(cell(&fit, 2, "diameter")) < 0.01);
  assert_true(statistic(s, "diameter") > 110 && statistic(s, "diameter") < 200);
  geometry()->release(s);
  snprintf(text, sizeof text, "trunk\n60 0 90\n90 0 90\n150 0 90\n%s", branches);
  s = grow("cherry", "age=20 orders=1 resample=sibling", text);
  sozai_geometry *own = grow("cherry", "age=20 orders=1", NULL);
  fit = table_of(s, "fit");
  for (int k = 2; k < BUILT; k++)
    assert_true(cell(&fit, 0, built[k]) == 0 && cell(&fit, 2, built[k]) == 0);
  assert_true(fabs(statistic(s, "diameter") / statistic(own, "diameter") - 1) < 1e-5);
  geometry()->release(own);
  geometry()->release(s);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(fit_and_siblings), cmocka_unit_test(hanging_branches),
      cmocka_unit_test(build_round_trip), cmocka_unit_test(what_is_not_measured)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
