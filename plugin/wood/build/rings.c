/* SPDX-License-Identifier: Apache-2.0
 *
 * How wide each year's ring is, and the tables that the kernel finds them by.
 */
#include "parts.h"

#include <string.h>

#include "../../core/scalar.h"
#include "../../core/status.h"
#include "../parameters.h"
#include "late.h"

/* Widths that vary about a mean, to a tree's growth at a height, from the year
 * in which its tip was there. After its last year it goes on as it did then. */
static void tree_widths(const knot_source *tree, double height, double mean, double *width) {
  int from = 0, last = (int)tree->age;
  while (from < last && knot_source_radius(tree, height, from + 1.0) <= 0.0) from++;
  double before = 0.0, wide = mean, least = 0.15;
  for (int j = 0; j < WOOD_RINGS; j++) {
    if (from + j < last) {
      double radius = knot_source_radius(tree, height, from + j + 1.0);
      wide = radius - before;
      before = radius;
      if (wide < least) wide = least;
    }
    width[j] *= wide / mean;
  }
}

/* Widths that are given, from the pith out, and over again. */
static int32_t given_widths(const sozai_buffer *b, double *width) {
  uint64_t n = b->dims[0] * b->dims[1];
  if (n == 0 || b->dims[1] != 1) {
    return fail(SOZAI_ERROR_RANGE, "ring_widths: a table of %llu x %llu is not one column",
                (unsigned long long)b->dims[0], (unsigned long long)b->dims[1]);
  }
  for (uint64_t i = 0; i < n; i++) {
    double x = (double)b->data[i];
    if (!(x >= 0.02 && x <= 200.0)) {
      return fail(SOZAI_ERROR_RANGE, "ring_widths: row %llu is %.9g, outside 0.02 to 200 mm",
                  (unsigned long long)i, x);
    }
  }
  for (int j = 0; j < WOOD_RINGS; j++) width[j] = (double)b->data[(uint64_t)j % n];
  return SOZAI_OK;
}

/* Widths of the table's rings, mm. */
static int32_t ring_widths(const wood_constants *w, const settings *s, const knot_source *tree,
                           double *width) {
  const sozai_buffer *b = s->list[P_RING_WIDTHS].buffer;
  if (b) return given_widths(b, width);
  double mean = number_at(s, P_RING_WIDTH), sd = number_at(s, P_RING_VARIATION), sum = 0.0,
         before = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    /* good years come together: neighbours correlate by 0.4 */
    double n = wood_normal(w->seed, STREAM_RINGS, (uint32_t)j);
    before = j ? 0.4 * before + 0.9165 * n : n;
    double f = scalar_exp(sd * before - 0.5 * sd * sd);
    width[j] = f < 0.4 ? 0.4 : f > 3.0 ? 3.0 : f;
    sum += width[j];
  }
  for (int j = 0; j < WOOD_RINGS; j++) width[j] *= mean * WOOD_RINGS / sum;
  if (tree->rings.count && number_at(s, P_TREE_RINGS) != 0.0) {
    tree_widths(tree, number_at(s, P_LOG_HEIGHT), mean, width);
  }
  return SOZAI_OK;
}

/* Boundaries, and the latewood before each. width: mm, asked for; returned as the kernel sees
 * them. Returns the narrowest ring's. */
static double lay_rings(wood_constants *w, double variation, double *width) {
  double total = 0.0, least = 1e30, late = 0.0, whole = late_profile_integral(w, 1.0);
  for (int j = 0; j < WOOD_RINGS; j++) {
    w->start[j] = (float)total;
    total += width[j];
    w->start[j + 1] = (float)total;
    /* widths as the kernel sees them: the rounded boundaries' difference */
    width[j] = (double)w->start[j + 1] - (double)w->start[j];
    w->inverse_width[j] = (float)(1.0 / width[j]);
    if (width[j] < least) least = width[j];
    w->late_weight[j + 1] =
        (float)(1.0 - variation * wood_uniform(w->seed, STREAM_LATE, (uint32_t)j));
    w->late_before[j] = (float)late;
    late += (double)w->late_weight[j + 1] * width[j] * whole;
    w->late_before[j + 1] = (float)late;
  }
  w->ring_period = w->start[WOOD_RINGS];
  w->inverse_ring_period = (float)(1.0 / (double)w->ring_period);
  w->late_weight[0] = w->late_weight[WOOD_RINGS];
  w->late_period = (float)late;
  w->ring_width = (float)(total / WOOD_RINGS);
  return least;
}

/* Where the kernel looks up a radius. least: mm, the narrowest ring. */
static int32_t build_bins(wood_constants *w, double least) {
  double bins = (double)w->ring_period / (0.9 * least) + 1.0;
  if (bins > WOOD_BINS_MAX) {
    return fail(SOZAI_ERROR_RANGE,
                "ring_widths: the narrowest, %.9g mm, is below a %dth of the mean, %.9g mm", least,
                WOOD_BINS_MAX / WOOD_RINGS, (double)w->ring_width);
  }
  int count = (int)bins;
  w->bin_last = count - 1;
  w->bin_scale = (float)(count / (double)w->ring_period);
  int j = 0; /* the ring in which a bin begins */
  for (int b = 0; b < count; b++) {
    /* a little early, so that rounding never puts a point before its bin */
    double at = (b - 0.001) / (double)w->bin_scale;
    while (j + 1 < WOOD_RINGS && (double)w->start[j + 1] <= at) j++;
    w->bin[b][0] = (float)j;
    w->bin[b][1] = j + 1 < WOOD_RINGS ? w->start[j + 1] : 3e38f;
  }
  return SOZAI_OK;
}

int32_t wood_build_rings(wood_constants *w, const settings *s, const knot_source *tree) {
  double width[WOOD_RINGS];
  int32_t r = ring_widths(w, s, tree, width);
  if (r) return r;
  double least = lay_rings(w, number_at(s, P_LATE_VARIATION), width);
  w->blur = 0.02f;
  double plateau = 1.0 - (double)w->late_middle - (double)w->late_after;
  double flat = (double)w->late_start < plateau ? (double)w->late_start : plateau;
  w->safe = (float)(flat * least);
  r = build_bins(w, least);
  if (r) return r;
  for (int j = 0; j < WOOD_RINGS; j++) {
    const float row[4] = {w->start[j], w->inverse_width[j], w->late_weight[j + 1],
                          w->late_weight[j]};
    memcpy(w->ring_row[j], row, sizeof row);
  }
  return SOZAI_OK;
}
