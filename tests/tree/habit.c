/* SPDX-License-Identifier: Apache-2.0
 * How branches wander and break, and what needles are drawn as. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tree.h"

static double step(const float *a, const float *b, double d[3]) {
  double sum = 0;
  for (int c = 0; c < 3; c++) d[c] = (double)b[c] - (double)a[c], sum += d[c] * d[c];
  return sqrt(sum);
}

/* Every first-order branch of twenty trees: its row in the table, and its points. */
typedef struct {
  double death, length, azimuth;
  const float *points;
  uint64_t count;
} branch;
typedef void visit(const branch *b, void *context);

static void each_branch(const char *preset, const char *values, visit *each, void *context) {
  for (int seed = 1; seed <= 20; seed++) {
    char text[96];
    snprintf(text, sizeof text, "age=45 orders=1 %s seed=%d", values, seed);
    sozai_geometry *g = grow(preset, text, NULL);
    sozai_table t = table_of(g, "branches");
    const sozai_curves *c = curves_of(g, 0);
    for (uint64_t i = 1; i < c->curve_count; i++) {
      const branch b = {cell(&t, c->ids[i], "death"), cell(&t, c->ids[i], "length"),
                        cell(&t, c->ids[i], "azimuth"), c->points + 3 * c->first[i],
                        c->first[i + 1] - c->first[i]};
      each(&b, context);
    }
    geometry()->release_curves(c);
    geometry()->release(g);
  }
}

typedef struct {
  double early[2], late[2], off;
} lengths;

static void add_length(const branch *b, void *context) {
  lengths *sum = context;
  double length = 0, d[3];
  for (uint64_t k = 0; k + 1 < b->count; k++) {
    length += step(b->points + 3 * k, b->points + 3 * k + 3, d);
  }
  double left = length / b->length;
  if (b->death < 0) {
    sum->off = fmax(sum->off, fabs(left - 1));
    return;
  }
  assert_true(left > 0.03 && left < 1.001);
  double *to = b->death > 43 ? sum->early : sum->late;
  to[0] += left;
  to[1]++;
}

/* Live branches are as long as they grew; dead ones have lost some of that, more with the years. */
static void dead_branches_break(void **unused) {
  (void)unused;
  lengths sum = {0};
  each_branch("scots_pine", "", add_length, &sum);
  const double early = sum.early[0] / sum.early[1], late = sum.late[0] / sum.late[1];
  print_message(
      "live: within %.1g of what they grew; dead for 2 years: %.2f left, for longer: %.2f "
      "(%.0f and %.0f branches)\n",
      sum.off, early, late, sum.early[1], sum.late[1]);
  assert_true(sum.off < 1e-4 && sum.early[1] > 50 && sum.late[1] > 50);
  assert_true(late < 0.75 && early > late + 0.1);
}

typedef struct {
  double square, count;
} turns;

static void add_turn(const branch *b, void *context) {
  if (b->death >= 0 || b->length < 2500) return;
  turns *sum = context;
  const float *tip = b->points + 3 * (b->count - 1);
  double d[3];
  step(tip - 3, tip, d);
  double turn = atan2(d[0], -d[2]) * 180 / 3.14159265358979;
  double aside = remainder(turn - b->azimuth, 360);
  sum->square += aside * aside;
  sum->count++;
}

/* A way that keeps all of what it has turned would be off by 42 degrees at its 13th turn. */
static void branches_are_called_back(void **unused) {
  (void)unused;
  turns sum = {0};
  each_branch("akamatsu", "wander=20 elevation_top=10", add_turn, &sum);
  double sd = sqrt(sum.square / sum.count);
  print_message("%.0f branches end %.1f degrees aside (sd; 13 to 24)\n", sum.count, sd);
  assert_true(sum.count > 200 && sd > 13 && sd < 24);
}

/* Short needles give way to clothed shoots, long ones to fewer of them. */
static void long_needles_are_seen(void **unused) {
  (void)unused;
  static const struct {
    const char *preset, *values;
    double clothed, most;
  } cases[] = {{"kuromatsu", "age=20", 0, 1200000},
               {"kuromatsu", "age=20 leaves_most=200000", 0, 200000},
               {"kuromatsu", "age=20 leaves_most=2000", 1, 1e9},
               {"sugi", "age=20 leaves_most=60000", 1, 1e9}};
  for (int i = 0; i < 4; i++) {
    sozai_geometry *g = grow(cases[i].preset, cases[i].values, NULL);
    double organs = statistic(g, "fourth_order");
    print_message("%s, %s: %.0f, %s\n", cases[i].preset, cases[i].values, organs,
                  statistic(g, "clothed") > 0 ? "clothed shoots" : "needles");
    assert_true(statistic(g, "clothed") == cases[i].clothed);
    assert_true(organs > 0 && organs <= cases[i].most);
    geometry()->release(g);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(dead_branches_break),
                                     cmocka_unit_test(branches_are_called_back),
                                     cmocka_unit_test(long_needles_are_seen)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
