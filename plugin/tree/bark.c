/* SPDX-License-Identifier: Apache-2.0 */
#include "bark.h"

static float end_of(const tree *t, const tree_branch *b) {
  return b->death >= 0.0f ? b->death : (float)t->plan.age;
}

/* From the curve of the stem's height, or of a branch's length: how far a branch of the
 * first order reaches over what it reached last, which is free of its own scatter. */
static void follow_curve(bark_growth *g, const tree *t, const tree_branch *b, float end) {
  const tree_plan *p = &t->plan;
  double z = (double)b->at, begin = (double)b->birth, last = (double)end;
  double whole = b->order ? plan_reach(p, z, last, 0) : plan_height(p, last);
  g->count = BARK_TIMES;
  for (uint32_t i = 0; i < BARK_TIMES; i++) {
    double year = begin + (last - begin) * i / (BARK_TIMES - 1);
    double now = b->order ? plan_reach(p, z, year, 0) : plan_height(p, year);
    g->year[i] = (float)year;
    g->along[i] = whole > 0.0 ? (float)((double)b->length * now / whole) : 0.0f;
  }
}

void bark_growth_of(bark_growth *out, const tree *t, const tree_branch *b) {
  float end = end_of(t, b);
  if (t->by_years && (!b->order || (b->order == 1 && !b->parent))) {
    follow_curve(out, t, b, end);
    return;
  }
  /* a shoot, an arm, or measured: nobody knows better than evenly */
  out->count = 2;
  out->along[0] = 0.0f, out->along[1] = b->length;
  out->year[0] = b->birth, out->year[1] = end;
}

float bark_year(const bark_growth *g, float along) {
  uint32_t i = 0;
  while (i + 2 < g->count && along > g->along[i + 1]) i++;
  float step = g->along[i + 1] - g->along[i];
  float share = step > 0.0f ? (along - g->along[i]) / step : 0.0f;
  if (!(share > 0.0f)) share = 0.0f;
  if (share > 1.0f) share = 1.0f;
  return g->year[i] + share * (g->year[i + 1] - g->year[i]);
}

void bark_ages(const tree *t, const tree_branch *b, float *out) {
  bark_growth g;
  const tree_node *nodes = &t->nodes[b->first];
  int by_height = t->by_years && b->order == 0;
  float end = end_of(t, b), along = 0.0f;
  bark_growth_of(&g, t, b);
  for (uint32_t i = 0; i < b->nodes; i++) {
    if (i > 0) {
      float sum = 0.0f;
      for (int c = 0; c < 3; c++) {
        float d = nodes[i].p[c] - nodes[i - 1].p[c];
        sum += d * d;
      }
      along += __builtin_sqrtf(sum);
    }
    out[i] = end - bark_year(&g, by_height ? nodes[i].p[1] : along);
  }
}

/* From 0 to 1 between two ages, level at both. */
static float between(float age, float from, float to) {
  if (!(age > from)) return 0.0f;
  if (!(age < to)) return 1.0f;
  float s = (age - from) / (to - from);
  return s * s * (3.0f - 2.0f * s);
}

float bark_old(const tree_plan *p, float age) {
  return between(age, p->rhytidome_from, p->rhytidome_age);
}

float bark_periderm(const tree_plan *p, float age) {
  return between(age, 0.0f, p->periderm_age) * (1.0f - bark_old(p, age));
}

void bark_colours(const tree_plan *p, float age, float bare[3], float turned[3]) {
  float grown = between(age, 0.0f, p->periderm_age);
  for (int c = 0; c < 3; c++) {
    float shoot = p->colours[COLOUR_SHOOT][c], bark = p->colours[COLOUR_BARK][c];
    bare[c] = shoot + grown * (bark - shoot);
    turned[c] = p->colours[COLOUR_RHYTIDOME][c] - bare[c];
  }
}

void bark_colour(const tree_plan *p, float age, float out[3]) {
  float old = bark_old(p, age), turned[3];
  bark_colours(p, age, out, turned);
  for (int c = 0; c < 3; c++) out[c] += old * turned[c];
}
