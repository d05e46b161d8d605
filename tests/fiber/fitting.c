/* SPDX-License-Identifier: Apache-2.0
 * Row 5: the fitting. */
#include <math.h>
#include <stdio.h>
#include "fiber.h"

static const char *const modes[] = {"field", "exact", "literal"};

static double distance(const float *a, const float *b) {
  double s = 0;
  for (int k = 0; k < 3; k++) s += ((double)a[k] - (double)b[k]) * ((double)a[k] - (double)b[k]);
  return sqrt(s);
}

/* Rigid: every distance between two vertices of a strand as it was, to what a
 * float of that size can hold. */
static void rigid(void **unused) {
  (void)unused;
  failure why;
  mesh m;
  assert_true(hull_make_bunny(&m, 40, &why));
  for (int k = 0; k < 3; k++) {
    char text[128];
    snprintf(text, sizeof text, "mode=%s count=100 iterations=0", modes[k]);
    sozai_geometry *before = grow(&m, text);
    snprintf(text, sizeof text, "mode=%s count=100", modes[k]);
    sozai_geometry *after = grow(&m, text);
    const sozai_curves *a = curves_of(before), *b = curves_of(after);
    double worst = 0;
    for (uint64_t i = 0; i < a->curve_count; i++)
      for (uint64_t v = 1; v < 32; v++)
        for (uint64_t w = 0; w < v; w += v == 31 ? 1 : v) {
          const float *p = a->points + 96 * i, *q = b->points + 96 * i;
          worst =
              fmax(worst, fabs(distance(p + 3 * v, p + 3 * w) - distance(q + 3 * v, q + 3 * w)));
        }
    print_message("%s: %.0f moves at most, lengths off by %.1e of the strand's\n", modes[k],
                  statistic(after, "iterations"), worst / 10);
    assert_true(worst / 10 < 1e-6);
    assert_true(statistic(after, "iterations") > 5);
    geometry()->release_curves(a);
    geometry()->release_curves(b);
    geometry()->release(before);
    geometry()->release(after);
  }
  mesh_free(&m);
}

/* C never falls from one iteration to the next, and the bound on them holds;
 * a strand that ended stays. */
static void never_falls(void **unused) {
  (void)unused;
  mesh m;
  failure why;
  assert_true(hull_make_serpent(&m, 20, &why));
  for (int k = 0; k < 3; k++) {
    float last[60];
    double moved = 0;
    for (int most = 0; most < 14; most++) {
      char text[128];
      snprintf(text, sizeof text, "mode=%s count=60 halvings=0 length=25 step=2 iterations=%d",
               modes[k], most);
      sozai_geometry *g = grow(&m, text);
      sozai_table t = table_of(g, "strands");
      for (uint64_t i = 0; i < 60; i++) {
        float c = (float)cell(&t, i, "sum");
        double moves = cell(&t, i, "moves");
        assert_true(moves <= most);
        if (most == 0) {
          assert_true(c == (float)cell(&t, i, "sum_first"));
        } else {
          assert_true(c >= last[i]);
          if (moves < most) assert_true(c == last[i] || moves == most - 1);
        }
        last[i] = c;
        moved += moves;
      }
      geometry()->release(g);
    }
    assert_true(moved > 400);
  }
  mesh_free(&m);
}

/* Only strands with a vertex outside move; all end, and mostly inside. */
static void ends(void **unused) {
  (void)unused;
  mesh m = hull_of("bunny");
  for (int k = 0; k < 3; k += 2) {
    char text[128];
    snprintf(text, sizeof text, "mode=%s count=1000 iterations=0", modes[k]);
    sozai_geometry *first = grow(&m, text);
    snprintf(text, sizeof text, "mode=%s count=1000", modes[k]);
    sozai_geometry *g = grow(&m, text);
    sozai_table a = table_of(first, "strands"), b = table_of(g, "strands");
    for (uint64_t i = 0; i < 1000; i++) {
      /* a vertex that is outside by less than the field shows may stay */
      if (cell(&a, i, "inside") >= 32) assert_true(cell(&b, i, "moves") <= 2);
      if (cell(&b, i, "moves") > 0) assert_true(cell(&b, i, "sum") >= cell(&b, i, "sum_first"));
    }
    double sum = statistic(g, "ended_inside") + statistic(g, "ended_best") +
                 statistic(g, "ended_visited") + statistic(g, "ended_bound");
    print_message("%s: inside %.4f of vertices, before %.4f\n", modes[k], statistic(g, "inside"),
                  statistic(g, "inside_first"));
    assert_true(sum == 1000 && statistic(g, "ended_bound") == 0);
    assert_true(statistic(g, "inside") > 0.99);
    assert_true(statistic(g, "inside_first") < 0.9);
    geometry()->release(first);
    geometry()->release(g);
  }
  mesh_free(&m);
}

/* A strand too long for a thin slab never fits: along level ground the literal
 * way must stop, at a pose that was or at the bound. */
static void terminates(void **unused) {
  (void)unused;
  mesh m = box_of(30, 0.5, 30);
  sozai_geometry *g =
      grow(&m, "mode=literal count=100 length=60 theta_max=0 iterations=300 spacing=1");
  sozai_table t = table_of(g, "strands");
  for (uint64_t i = 0; i < t.rows; i++) assert_true(cell(&t, i, "moves") <= 300);
  print_message("of 100: %.0f best, %.0f visited, %.0f at the bound\n", statistic(g, "ended_best"),
                statistic(g, "ended_visited"), statistic(g, "ended_bound"));
  assert_true(statistic(g, "ended_best") + statistic(g, "ended_visited") > 50);
  geometry()->release(g);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rigid), cmocka_unit_test(never_falls),
                                     cmocka_unit_test(ends), cmocka_unit_test(terminates)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
