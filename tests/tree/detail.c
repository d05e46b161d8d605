/* SPDX-License-Identifier: Apache-2.0
 *
 * Levels of detail: a leaf, needle or clothed shoot hides as much of what is
 * behind it at each, and level 1 has about half the triangles. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "tree.h"

#define GRID 24      /* across an organ's shadow */
#define DIRECTIONS 4 /* from which each is seen */
#define MOST_SEEN 800

typedef struct {
  double x[3], y[3]; /* square to the direction */
} view;

static double random_unit(uint32_t *state) {
  *state = *state * 1664525u + 1013904223u;
  return (double)(*state >> 8) / 16777216.0;
}

/* Evenly over the sphere. */
static view look(uint32_t *state) {
  double z = 2 * random_unit(state) - 1, turn = 2 * M_PI * random_unit(state);
  double r = sqrt(1 - z * z), spin = 2 * M_PI * random_unit(state);
  double u[3] = {-sin(turn), cos(turn), 0}, v[3] = {-z * cos(turn), -z * sin(turn), r};
  view out;
  for (int c = 0; c < 3; c++) {
    out.x[c] = cos(spin) * u[c] + sin(spin) * v[c];
    out.y[c] = cos(spin) * v[c] - sin(spin) * u[c];
  }
  return out;
}

static double dot(const double *a, const float *b) {
  return a[0] * (double)b[0] + a[1] * (double)b[1] + a[2] * (double)b[2];
}

/* The triangles of one organ, projected; then how much of the plane they cover, not how often. */
static double shadow(const sozai_mesh *m, uint64_t first, uint64_t count, const view *v,
                     uint32_t *state) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, (*p)[3][2];
  p = malloc(count * sizeof *p);
  assert_non_null(p);
  for (uint64_t i = 0; i < 3 * count; i++) {
    const float *at = m->points + 3 * m->indices[3 * first + i];
    double *q = p[i / 3][i % 3];
    q[0] = dot(v->x, at), q[1] = dot(v->y, at);
    for (int c = 0; c < 2; c++) low[c] = fmin(low[c], q[c]), high[c] = fmax(high[c], q[c]);
  }
  uint64_t hit = 0;
  for (int i = 0; i < GRID * GRID; i++) {
    /* somewhere in each cell: a needle lies along the diagonal of what it spans */
    double x = low[0] + (high[0] - low[0]) * (i % GRID + random_unit(state)) / GRID;
    double y = low[1] + (high[1] - low[1]) * ((double)(i / GRID) + random_unit(state)) / GRID;
    for (uint64_t k = 0; k < count; k++) {
      int sides = 0;
      for (int c = 0; c < 3; c++) {
        const double *a = p[k][c], *b = p[k][(c + 1) % 3];
        sides += (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0;
      }
      if (sides % 3) continue;
      hit++;
      break;
    }
  }
  free(p);
  return (double)hit / (GRID * GRID) * (high[0] - low[0]) * (high[1] - low[1]);
}

typedef struct {
  double hides;  /* mm2: all leaves together, each by itself, in the mean from all around */
  double leaves; /* triangles */
  double all;
} detail;

/* organs: as many are drawn. */
static detail measure(const sozai_geometry *g, uint32_t level) {
  const sozai_mesh *m = mesh_of(g, level);
  const sozai_part *part = &m->parts[m->part_count - 1];
  assert_true(strcmp(part->id, "needle") == 0 || strcmp(part->id, "leaf") == 0);
  uint64_t all = (uint64_t)statistic(g, "fourth_order"),
           stride = level > 1 ? 1ull << (level - 1) : 1;
  uint64_t organs = (all + stride - 1) / stride, each = part->count / organs;
  assert_int_equal(organs * each, part->count);
  uint64_t skip = organs / MOST_SEEN + 1, seen = 0;
  double sum = 0;
  uint32_t state = 1;
  for (uint64_t i = 0; i < organs; i += skip, seen++)
    for (int k = 0; k < DIRECTIONS; k++) {
      view v = look(&state);
      sum += shadow(m, part->first + i * each, each, &v, &state);
    }
  detail d = {sum / DIRECTIONS / (double)seen * (double)organs, (double)part->count,
              (double)m->triangle_count};
  geometry()->release_mesh(m);
  return d;
}

/* Needles and leaves one by one, and shoots clothed as one body each where the species may be. */
static void levels_hide_as_much(void **unused) {
  (void)unused;
  static const char *const how[] = {"age=8 foliage=full leaves_most=2000000",
                                    "age=10 leaves_most=60000"};
  const sozai_generator_info *info = geometry()->find("tree");
  for (uint32_t i = 0; i < 2 * info->preset_count; i++) {
    sozai_geometry *g = grow(info->presets[i / 2]->id, how[i % 2], NULL);
    detail d[5];
    double beyond = 0;
    for (uint32_t level = 0; level < 5; level++) d[level] = measure(g, level);
    double half = d[1].leaves / d[0].leaves, all = d[1].all / d[0].all;
    bool clothed = statistic(g, "clothed") > 0;
    print_message("%-14s %-7s level 1 has %.2f of the triangles, %.2f of the leaves'; hides",
                  info->presets[i / 2]->id, clothed ? "clothed" : "", all, half);
    /* the pines' needles, which are seen one by one, as they always were */
    double within = strcmp(info->presets[i / 2]->id, "kuromatsu") == 0 ? 0.03 : 0.08;
    for (int level = 1; level < 5; level++) {
      double share = d[level].hides / d[0].hides;
      print_message(" %.3f", share);
      beyond = fmax(beyond, fabs(share - 1) - within);
    }
    print_message(" of level 0 at 1 to 4\n");
    assert_true(half >= 0.4 && half <= 0.67 && all >= 0.45 && all <= 0.61);
    assert_true(beyond <= 0);
    geometry()->release(g);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(levels_hide_as_much)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
