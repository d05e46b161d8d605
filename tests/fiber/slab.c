/* SPDX-License-Identifier: Apache-2.0
 * Grown strands are pressed flat to the rise that is wanted, and cut to a tile. */
#include "slab.h"

#include <math.h>
#include <stdio.h>

/* ---- the slab ---------------------------------------------------------- */

/* Keeps of [from, to] what lies between -half and half of a + t d. */
static void keep_within(double a, double d, double half, double *from, double *to) {
  if (fabs(d) < 1e-9) {
    if (fabs(a) > half) *to = *from - 1;
    return;
  }
  double s = (-half - a) / d, t = (half - a) / d;
  *from = fmax(*from, fmin(s, t));
  *to = fmin(*to, fmax(s, t));
}

/* The straight strands, pressed flat, within a tile: it is repeated without end. */
static void cut(slab *b, const sozai_curves *c) {
  const aggregate *a = b->of;
  double radius = a->diameter / 2000, length = 0, level = 0;
  double half[3] = {a->side / 2, a->side / 2, a->thick / 2};
  uint64_t n = 0;
  b->points = malloc(6 * c->curve_count * sizeof *b->points);
  b->radii = malloc(2 * c->curve_count * sizeof *b->radii);
  b->first = malloc((c->curve_count + 1) * sizeof *b->first);
  assert_true(b->points && b->radii && b->first);
  for (uint64_t i = 0; i < c->curve_count; i++) {
    const float *p = c->points + 3 * c->first[i], *q = c->points + 3 * (c->first[i + 1] - 1);
    double from = 0, to = 1, at[3], d[3];
    for (int k = 0; k < 3; k++) {
      double press = k == 2 ? a->squeeze : 1;
      at[k] = (double)p[k] * press;
      d[k] = ((double)q[k] - (double)p[k]) * press;
      keep_within(at[k], d[k], half[k], &from, &to);
    }
    if (from >= to) continue;
    for (int k = 0; k < 3; k++) {
      b->points[6 * n + (uint64_t)k] = (float)(at[k] + from * d[k]);
      b->points[6 * n + 3 + (uint64_t)k] = (float)(at[k] + to * d[k]);
    }
    b->radii[2 * n] = b->radii[2 * n + 1] = (float)radius;
    b->first[n] = 2 * n;
    n++;
    length += (to - from) * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    level += (to - from) * hypot(d[0], d[1]);
  }
  b->first[n] = 2 * n;
  double part = level / length;
  b->packing = length * PI * radius * radius / (a->side * a->side * a->thick);
  b->rise = sqrt(3 * (1 / (part * part) - 1));
  const sozai_curves made = {.size = sizeof made,
                             .curve_count = n,
                             .point_count = 2 * n,
                             .points = b->points,
                             .radii = b->radii,
                             .first = b->first};
  failure why;
  assert_true(strands_open(&b->t.s, &made, 1, false, &why));
  b->t.half[0] = b->t.half[1] = (float)(a->side / 2);
  b->t.high = (float)(a->thick / 2 + 0.05);
}

void grow_slab(slab *b, const aggregate *a) {
  memset(b, 0, sizeof *b);
  b->of = a;
  double height = a->thick / a->squeeze + a->length, radius = a->diameter / 2000;
  mesh m = box_of(a->side + a->length, a->side + a->length, height);
  /* squeezing makes what is steep shorter */
  double volume = (a->side + a->length) * (a->side + a->length) * height * a->squeeze;
  double count = a->packing * volume / (PI * radius * radius * a->length);
  char text[256];
  snprintf(text, sizeof text, "count=%d vertices=2 length=%g diameter=%g iterations=0 seed=5",
           (int)count, a->length, a->diameter);
  sozai_geometry *g = grow(&m, text);
  const sozai_curves *c = curves_of(g);
  cut(b, c);
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
  b->t.round = a->round;
  memcpy(b->t.colour, colours, sizeof colours);
  b->t.lobe = fiber_lobe_make(a->roughness, a->round, a->tilt, a->index);
}

void free_slab(slab *b) {
  strands_close(&b->t.s);
  free(b->points);
  free(b->radii);
  free(b->first);
}

/* ---- what is looked at ------------------------------------------------- */

/* Loose felt, of an optical depth of some 1 and 4. */
#define THIN_FELT(words, mm)                                                                       \
  {                                                                                                \
    .name = words, .preset = "felt", .diameter = 20, .length = 1.2, .side = 5, .thick = mm,        \
    .packing = 0.03, .squeeze = 0.5, .roughness = 10, .round = 0.4f, .tilt = 3, .index = 1.553f    \
  }

const aggregate aggregates[] = {
    {.name = "felt",
     .preset = "felt",
     .diameter = 20,
     .length = 1.2,
     .side = 3,
     .thick = 4,
     .packing = 0.1,
     .squeeze = 0.3,
     .roughness = 10,
     .round = 0.4f,
     .tilt = 3,
     .index = 1.553f},
    {.name = "merino",
     .preset = "wool_merino",
     .diameter = 20,
     .length = 1.2,
     .side = 3,
     .thick = 10,
     .packing = 0.03,
     .squeeze = 0.3,
     .roughness = 9,
     .round = 0.35f,
     .tilt = 3,
     .index = 1.553f},
    {.name = "cotton",
     .preset = "cotton",
     .diameter = 14,
     .length = 1.2,
     .side = 3,
     .thick = 12,
     .packing = 0.02,
     .squeeze = 0.5,
     .roughness = 14,
     .round = 0.55f,
     .index = 1.55f},
    THIN_FELT("thin", 0.7),
    THIN_FELT("half-thick", 2.7),
};

const int aggregate_count = sizeof aggregates / sizeof *aggregates;
