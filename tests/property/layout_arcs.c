/* SPDX-License-Identifier: Apache-2.0
 *
 * Segmental arcs: where rows end at a bay's side no sett is a sliver, and none is much longer than
 * one and a half. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "wood.h"

enum { SIDE = 800 };

typedef struct {
  float id;
  unsigned at;
} seen;

static int by_id(const void *a, const void *b) {
  float x = ((const seen *)a)->id, y = ((const seen *)b)->id;
  return x < y ? -1 : x > y;
}

/* Least and most of the units wholly in the window, of its area; how many there are. */
static unsigned areas(const sozai_texture *t, double step, double *least, double *most) {
  points p = {0};
  for (int i = 0; i < SIDE * SIDE; i++) points_add(&p, step * (i % SIDE), step * (i / SIDE), 0, 0);
  points_ask(&p, t);
  seen *s = malloc(p.count * sizeof *s);
  assert_non_null(s);
  for (unsigned i = 0; i < p.count; i++) s[i] = (seen){p.out[BOARD_ID][i], i};
  qsort(s, p.count, sizeof *s, by_id);
  unsigned units = 0;
  *least = 1e30;
  *most = 0;
  for (unsigned i = 0, j; i < p.count; i = j) {
    unsigned border = 0;
    for (j = i; j < p.count && s[j].id == s[i].id; j++) {
      unsigned x = s[j].at % SIDE, y = s[j].at / SIDE;
      border += x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1;
    }
    if (border > 0) continue;
    double area = (j - i) * step * step;
    *least = fmin(*least, area);
    *most = fmax(*most, area);
    units++;
  }
  free(s);
  points_free(&p);
  return units;
}

static void no_slivers(void **state) {
  (void)state;
  static const double lengths[] = {70, 100, 160};
  for (int k = 0; k < 3; k++) {
    char text[128];
    snprintf(text, sizeof text, "layout=arcs; board_length=%g; board_width=100; joint_width=0",
             lengths[k]);
    sozai_texture *t = wood_make(NULL, text);
    double least, most, whole = lengths[k] * 100;
    unsigned units = areas(t, 4, &least, &most);
    CHECK(units > 400 && least > 0.7 * whole && most < 1.5 * whole,
          "setts of %g by 100 mm: %u have %.3f to %.3f of that area\n", lengths[k], units,
          least / whole, most / whole);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(no_slivers)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
