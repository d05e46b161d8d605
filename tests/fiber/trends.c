/* SPDX-License-Identifier: Apache-2.0
 * Row 6: the trends of tables 2 to 4, on a hull with thin ears and on a tube. */
#include <math.h>
#include <stdio.h>
#include "fiber.h"

#define SEEDS 4

static const char *const crimps[] = {"phi_max=0 theta_max=0", "phi_max=0 theta_max=10.8",
                                     "phi_max=0 theta_min=-10.8 theta_max=10.8",
                                     "phi_max=36 theta_max=10.8"};

/* Iterations as the paper counts them, the mean of several seeds: one strand, the
 * slowest, decides each. And moves of a strand, of which there are many. */
static double iterations(const mesh *m, const char *mode, const char *values, double *moves) {
  double sum = 0;
  *moves = 0;
  for (int seed = 1; seed <= SEEDS; seed++) {
    char text[256];
    snprintf(text, sizeof text, "mode=%s halvings=0 step=0.5 seed=%d %s", mode, seed, values);
    sozai_geometry *g = grow(m, text);
    sum += statistic(g, "iterations") / SEEDS;
    *moves += statistic(g, "mean_moves") / SEEDS;
    geometry()->release(g);
  }
  return sum;
}

static void table_2(const char *mode, const char *count_of, int hull_count) {
  static const char *const hulls[] = {"bunny", "serpent"};
  for (int h = 0; h < hull_count; h++) {
    mesh m = hull_of(hulls[h]);
    double count[4], moves[4], most = 0;
    for (int k = 0; k < 4; k++) {
      char text[128];
      snprintf(text, sizeof text, "%s %s", count_of, crimps[k]);
      count[k] = iterations(&m, mode, text, &moves[k]);
      if (k != 1) most = fmax(most, count[k]);
    }
    print_message(
        "table 2, %s, %s: iterations %.1f %.1f %.1f %.1f; moves a strand %.2f %.2f %.2f %.2f\n",
        hulls[h], mode, count[0], count[1], count[2], count[3], moves[0], moves[1], moves[2],
        moves[3]);
    /* bent one way, strands need the most */
    assert_true(count[1] > most);
    mesh_free(&m);
  }
}

static void table_2_field(void **unused) {
  (void)unused;
  table_2("field", "count=1024", 2);
}

static void table_2_literal(void **unused) {
  (void)unused;
  table_2("literal", "count=300", 1);
}

static void table_3(void **unused) {
  (void)unused;
  mesh m = hull_of("bunny");
  double moves[3], count[3];
  count[0] = iterations(&m, "field", "count=1024 length=5", &moves[0]);
  count[1] = iterations(&m, "field", "count=1024 length=10", &moves[1]);
  count[2] = iterations(&m, "field", "count=1024 length=20", &moves[2]);
  print_message("table 3: lengths 5, 10, 20: %.1f, %.1f, %.1f iterations; the paper 17, 31, 71\n",
                count[0], count[1], count[2]);
  assert_true(count[1] / count[0] > 1.3 && count[2] / count[1] > 1.3);
  assert_true(moves[1] > 1.5 * moves[0] && moves[2] > 1.5 * moves[1]);
  mesh_free(&m);
}

static void table_4(void **unused) {
  (void)unused;
  mesh m = hull_of("bunny");
  double moves[3], count[3];
  count[0] = iterations(&m, "field", "count=512", &moves[0]);
  count[1] = iterations(&m, "field", "count=1024", &moves[1]);
  count[2] = iterations(&m, "field", "count=2048", &moves[2]);
  print_message(
      "table 4: 512, 1024, 2048 strands: %.1f, %.1f, %.1f iterations; the paper 32, 31, 31\n",
      count[0], count[1], count[2]);
  /* work a strand is the same, so that all of it is linear in the count */
  assert_true(fabs(moves[0] / moves[2] - 1) < 0.12 && fabs(moves[1] / moves[2] - 1) < 0.08);
  assert_true(count[2] < 1.35 * count[0]);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(table_2_field),
                                     cmocka_unit_test(table_2_literal), cmocka_unit_test(table_3),
                                     cmocka_unit_test(table_4)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
