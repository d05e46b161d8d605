/* SPDX-License-Identifier: Apache-2.0
 *
 * Means over many points of what a texture shows, for its own constants.
 */
#ifndef SOZAI_FIBERTEX_MEASURE_H
#define SOZAI_FIBERTEX_MEASURE_H

#include "../../core/measure.h"
#include "layers.h"
#include "surface.h"
#include "ground.h"

#define MEASURED_EXTENT 4096.0f /* large to everything */

/* What the yarns show: warp's and weft's shares, and those in their shade. */
static void measure_cloth(const fibertex_constants *w, uint32_t count, fibertex_means *out) {
  const vf zero = splat(0.0f), one = splat(1.0f), squarely[2] = {one, one};
  for (uint32_t i = 0; i < count; i += LANES) {
    cloth_hit q;
    cloth_at(w, measure_place(i, 0, MEASURED_EXTENT) * splat(w->yarn[1].spacing),
             measure_place(i, 1, MEASURED_EXTENT) * splat(w->yarn[0].spacing), zero, squarely, &q);
    vf weft = sel(q.weft, q.solid, zero), warp = sel(q.weft, zero, q.solid);
    measure_add(&out->yarn[0], warp);
    measure_add(&out->yarn[1], weft);
    measure_add(&out->shaded[0], warp * q.ambient);
    measure_add(&out->shaded[1], weft * q.ambient);
    vf across2 = q.across * q.across, slope2 = one - one / (one + q.slope * q.slope);
    measure_add(&out->across2[0], warp * across2);
    measure_add(&out->across2[1], weft * across2);
    measure_add(&out->slope2[0], warp * slope2);
    measure_add(&out->slope2[1], weft * slope2);
  }
  for (int i = 0; i < 2; i++) {
    out->yarn[i] /= count;
    out->shaded[i] /= count;
    out->across2[i] /= count;
    out->slope2[i] /= count;
  }
}

static void measure(const fibertex_constants *w, uint32_t count, fibertex_means *out) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  /* any surface; this leans alike against every axis */
  block k = {.i = 0, .n = LANES};
  k.f = (hull_frame){.n = {splat(0.57735027f), splat(0.57735027f), splat(0.57735027f)}};
  const vf axis[3] = {splat(w->axis[0]), splat(w->axis[1]), splat(w->axis[2])};
  frame_axes(w, axis, &k.f);
  for (int c = 0; c < 2; c++) k.f.lean2[c] = zero;
  for (int c = 0; c < 3; c++) k.f.step[c] = zero;
  memset(out, 0, sizeof *out);
  k.filter = lane_filter_of(w->layer[0].radius, zero);
  k.s = zero;
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    for (uint32_t i = 0; i < count; i += LANES) {
      vf at[3];
      for (uint32_t a = 0; a < 3; a++)
        at[a] = measure_place(i, a, MEASURED_EXTENT) * splat(c->size);
      layers_work of;
      const lane_hit *q = &of[0][0].hit;
      if (c->ends) {
        lattice_of(&k.f, at, 1, k.g);
        stages_of_hull(w, c, 1, &k, 1, 1, of);
      } else {
        yarn_place(c, at, splatu(0), &of[0][0].p);
        stages_of_lanes(w, c, 1, 0, &k, 1, of);
      }
      measure_add(&out->point[l], q->cover);
      measure_add(&out->soft[l], q->soft * (one - q->cover));
      measure_add(&out->bright[l], q->cover * q->bright);
      measure_add(&out->formula[l], lane_expected(c, c->ends, &of[0][0].p));
    }
    out->soft[l] /= count - out->point[l];
    if (out->point[l] > 0.0) out->bright[l] /= out->point[l];
    out->point[l] /= count;
    out->formula[l] /= count;
  }
  if (w->structure == STRUCTURE_WOVEN) measure_cloth(w, count, out);
}

#endif
