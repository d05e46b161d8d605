/* SPDX-License-Identifier: Apache-2.0
 *
 * Means over many points of what is counted of a layer's strands.
 */
#ifndef SOZAI_FIBERTEX_MEASURE_COUNTS_H
#define SOZAI_FIBERTEX_MEASURE_COUNTS_H

#include "../../core/measure.h"
#include "layers.h"

#define LANES_FEW 3.0f  /* all are counted, */
#define LANES_MANY 6.0f /* or their mean is taken: footprints for the means of what is counted. */
/* At one of so many places: at all of them creation would take 1.6 times as long. */
#define COUNTED_EACH 4

/* Sums over a layer's places, of few lanes and of many: of what is counted, also by how much of it
 * lies beyond the bundle; and of how bright the formula's strands are. */
typedef struct {
  double count, cover[2], dim[2], near[2], bare[2], luck, formula, pale, beyond, beyond_of[2],
      beyond_near, beyond_bare;
} measured_counts;

STAGE void measure_counts(const fibertex_constants *w, const fibertex_layer *c,
                          const layers_work of, measured_counts *sum) {
  for (int many = 0; many < 2; many++) {
    const lane_filter t =
        lane_filter_of(c->radius, splat((many ? LANES_MANY : LANES_FEW) * c->spacing));
    EACH(b, BLOCKS_TOGETHER) {
      const layer_work *q = &of[0][b];
      lane_counted n;
      lane_count(w, c, c->ends, !many, &q->p, &t, &n);
      lane_overlap(&q->p, &n);
      vf beyond = splat(0.0f); /* a yarn has no end */
      if (c->ends) beyond = splat(1.0f) - lane_within(bundle_edge(c, &q->cell), &t);
      vf share = splat(1.0f) - n.cover;
      measure_add(&sum->cover[many], n.cover);
      measure_add(&sum->dim[many], n.dim[0]);
      measure_add(&sum->near[many], n.near * share);
      measure_add(&sum->bare[many], share);
      if (many) {
        sum->count += LANES;
        measure_add(&sum->beyond, beyond);
        measure_add(&sum->beyond_of[0], n.cover * beyond);
        measure_add(&sum->beyond_of[1], n.dim[0] * beyond);
        measure_add(&sum->beyond_near, n.near * share * beyond);
        measure_add(&sum->beyond_bare, share * beyond);
        vf formula = lane_expected(c, c->ends, &q->p);
        measure_add(&sum->formula, formula);
        measure_add(&sum->pale, formula * lane_expected_bright(c, &q->p));
      } else {
        measure_add(&sum->luck, n.luck);
      }
    }
  }
}

static void measured_means(const measured_counts *sum, int l, fibertex_means *out) {
  fibertex_counted *q = &out->counted[l];
  const double count = sum->count;
  if (sum->formula > 0.0) out->pale[l] = sum->pale / sum->formula;
  for (int many = 0; many < 2; many++) {
    if (sum->bare[many] > 0.0) q->near[many] = sum->near[many] / sum->bare[many];
  }
  if (sum->beyond_bare > 0.0) q->beyond_near = sum->beyond_near / sum->beyond_bare;
  q->luck = sum->luck / count;
  q->cover = sum->cover[0] / count;
  if (sum->cover[0] > 0.0) q->bright = sum->dim[0] / sum->cover[0];
  if (!(sum->cover[1] > 0.0 && sum->dim[1] > 0.0 && sum->beyond > 0.0)) return;
  q->beyond[0] = sum->beyond_of[0] / sum->cover[1] * count / sum->beyond;
  q->beyond[1] = sum->beyond_of[1] / sum->dim[1] * count / sum->beyond;
}

#endif
