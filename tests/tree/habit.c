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

/* Live branches are as long as they grew; dead ones have lost some of that, more with the years. */
static void dead_branches_break(void **unused) {
  (void)unused;
  double early[2] = {0, 0}, late[2] = {0, 0}, off = 0;
  for (int seed = 1; seed <= 20; seed++) {
    char text[64];
    snprintf(text, sizeof text, "age=45 orders=1 seed=%d", seed);
    sozai_geometry *g = grow("scots_pine", text, NULL);
    sozai_table b = table_of(g, "branches");
    const sozai_curves *c = curves_of(g, 0);
    for (uint64_t i = 1; i < c->curve_count; i++) {
      double length = 0, d[3], grown = cell(&b, c->ids[i], "length"),
             death = cell(&b, c->ids[i], "death");
      for (uint64_t k = c->first[i]; k + 1 < c->first[i + 1]; k++) {
        length += step(c->points + 3 * k, c->points + 3 * k + 3, d);
      }
      double left = length / grown;
      if (death < 0) {
        off = fmax(off, fabs(left - 1));
        continue;
      }
      assert_true(left > 0.03 && left < 1.001);
      double *to = death > 43 ? early : late;
      to[0] += left;
      to[1]++;
    }
    geometry()->release_curves(c);
    geometry()->release(g);
  }
  print_message(
      "live: within %.1g of what they grew; dead for 2 years: %.2f left, for longer: %.2f "
      "(%.0f and %.0f branches)\n",
      off, early[0] / early[1], late[0] / late[1], early[1], late[1]);
  assert_true(off < 1e-4 && early[1] > 50 && late[1] > 50);
  assert_true(late[0] / late[1] < 0.75 && early[0] / early[1] > late[0] / late[1] + 0.1);
}

/* A way that keeps all of what it has turned would be off by 42 degrees at its 13th turn. */
static void branches_are_called_back(void **unused) {
  (void)unused;
  double square = 0, count = 0;
  for (int seed = 1; seed <= 20; seed++) {
    char text[96];
    snprintf(text, sizeof text, "age=45 orders=1 wander=20 elevation_top=10 seed=%d", seed);
    sozai_geometry *g = grow("akamatsu", text, NULL);
    sozai_table b = table_of(g, "branches");
    const sozai_curves *c = curves_of(g, 0);
    for (uint64_t i = 1; i < c->curve_count; i++) {
      if (cell(&b, c->ids[i], "death") >= 0 || cell(&b, c->ids[i], "length") < 2500) continue;
      const float *tip = c->points + 3 * (c->first[i + 1] - 1);
      double d[3];
      step(tip - 3, tip, d);
      double turn = atan2(d[0], -d[2]) * 180 / 3.14159265358979;
      double aside = remainder(turn - cell(&b, c->ids[i], "azimuth"), 360);
      square += aside * aside;
      count++;
    }
    geometry()->release_curves(c);
    geometry()->release(g);
  }
  double sd = sqrt(square / count);
  print_message("%.0f branches end %.1f degrees aside (sd; 13 to 24)\n", count, sd);
  assert_true(count > 200 && sd > 13 && sd < 24);
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

/* What needles hide from all around: a quarter of a closed surface, half of a sheet. */
static double breadth(const sozai_geometry *g, uint32_t level) {
  const sozai_mesh *m = mesh_of(g, level);
  double sum = 0;
  for (uint32_t p = 0; p < m->part_count; p++) {
    const sozai_part *part = &m->parts[p];
    if (strcmp(part->id, "needle") != 0) continue;
    double share = part->flags & SOZAI_PART_CLOSED ? 0.25 : 0.5;
    for (uint64_t i = part->first; i < part->first + part->count; i++) {
      const uint32_t *at = m->indices + 3 * i;
      double a[3], b[3], square = 0;
      step(m->points + 3 * at[0], m->points + 3 * at[1], a);
      step(m->points + 3 * at[0], m->points + 3 * at[2], b);
      for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        double n = a[d] * b[e] - a[e] * b[d];
        square += n * n;
      }
      sum += share * 0.5 * sqrt(square);
    }
  }
  geometry()->release_mesh(m);
  return sum;
}

static void levels_are_as_broad(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("kuromatsu", "age=8 foliage=full", NULL);
  double whole = breadth(g, 0);
  assert_true(whole > 0);
  for (uint32_t level = 1; level <= 4; level++) {
    double share = breadth(g, level) / whole;
    print_message("level %u: needles hide %.3f of what they do at 0 (0.97 to 1.03)\n", level,
                  share);
    assert_true(share > 0.97 && share < 1.03);
  }
  geometry()->release(g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(dead_branches_break), cmocka_unit_test(branches_are_called_back),
      cmocka_unit_test(long_needles_are_seen), cmocka_unit_test(levels_are_as_broad)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
