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
#include "measure_counts.h"

#define MEASURED_EXTENT 4096.0f /* large to everything */

INLINE void set_number(vu *v, uint32_t k, uint32_t x) {
#if LANES == 1
  (void)k;
  *v = x;
#else
  (*v)[k] = x;
#endif
}

static void measure_cloth(const fibertex_constants *w, uint32_t count, fibertex_cloth_means *out) {
  memset(out, 0, sizeof *out);
  const vf zero = splat(0.0f), one = splat(1.0f), squarely[2] = {one, one};
  for (uint32_t i = 0; i < count; i += LANES) {
    cloth_hit q;
    cloth_at(w, measure_place(i, 0, MEASURED_EXTENT) * splat(w->yarn[1].spacing),
             measure_place(i, 1, MEASURED_EXTENT) * splat(w->yarn[0].spacing), zero, squarely, &q);
    vf axes[3][3];
    cloth_frame(w, &q, axes[0], axes[1], axes[2]);
    vf weft = sel(q.weft, q.solid, zero), warp = sel(q.weft, zero, q.solid);
    measure_add(&out->yarn[0], warp);
    measure_add(&out->yarn[1], weft);
    measure_add(&out->shaded[0], warp * q.ambient);
    measure_add(&out->shaded[1], weft * q.ambient);
    measure_add(&out->level[0], warp * q.ambient * axes[2][2]);
    measure_add(&out->level[1], weft * q.ambient * axes[2][2]);
    /* how far its face leans over to its side, and how steeply it rises: sines */
    vf level = one / (one + q.slope * q.slope), slope2 = one - level,
       out2 = axes[2][2] * axes[2][2];
    vf lean2 = vmax(one - out2 / level, zero);
    measure_add(&out->lean2[0], warp * lean2);
    measure_add(&out->lean2[1], weft * lean2);
    measure_add(&out->lean4[0], warp * (lean2 * lean2));
    measure_add(&out->lean4[1], weft * (lean2 * lean2));
    measure_add(&out->slope2[0], warp * slope2);
    measure_add(&out->slope2[1], weft * slope2);
    measure_add(&out->slope4[0], warp * (slope2 * slope2));
    measure_add(&out->slope4[1], weft * (slope2 * slope2));
  }
  for (int i = 0; i < 2; i++) {
    out->yarn[i] /= count;
    out->shaded[i] /= count;
    out->level[i] /= count;
    out->lean2[i] /= count;
    out->lean4[i] /= count;
    out->slope2[i] /= count;
    out->slope4[i] /= count;
  }
}

/* Places for a layer's means, of a block: cells of it. */
INLINE void measure_cells(const fibertex_layer *c, uint32_t i, vf at[3]) {
  vu first = splatu(0);
  for (uint32_t k = 0; k < LANES; k++) set_number(&first, k, (i + k) * 3u);
  for (uint32_t a = 0; a < 3; a++) {
    vu h = hash_mix(first + splatu(a + HASH_Z));
    at[a] = to_float((vi)(h >> 8)) * splat(MEASURED_EXTENT / 16777216.0f) * splat(c->size);
  }
}

/* What a layer shows of as many footprints of s mm as blocks have points, from the i-th on. */
STAGE void measure_blocks(const fibertex_constants *w, const fibertex_layer *c, float s, uint32_t i,
                          block *k, layers_work of) {
  const footprints all = {s, s};
  vf at[BLOCKS_TOGETHER][3];
  EACH(b, BLOCKS_TOGETHER) {
    k[b].s = splat(s);
    k[b].filter = lane_filter_of(w->layer[0].radius, k[b].s);
  }
  EACH(b, BLOCKS_TOGETHER) measure_cells(c, i + b * LANES, at[b]);
  if (c->ends) {
    EACH(b, BLOCKS_TOGETHER) lattice_of(&k[b].f, at[b], 1, k[b].g);
    stages_of_hull(w, c, 1, k, BLOCKS_TOGETHER, 1, &all, of);
  } else {
    EACH(b, BLOCKS_TOGETHER) yarn_place(c, at[b], splatu(0), &of[0][b].p);
    stages_of_lanes(w, c, 1, 0, k, BLOCKS_TOGETHER, &all, of);
  }
}

/* On any surface; this leans alike against every axis. */
static void measured_blocks(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f);
  const vf axis[3] = {splat(w->axis[0]), splat(w->axis[1]), splat(w->axis[2])};
  EACH(b, BLOCKS_TOGETHER) {
    hull_frame *f = &k[b].f;
    for (int a = 0; a < 3; a++) f->n[a] = splat(0.57735027f);
    frame_axes(w, axis, f);
    f->lean2[0] = f->lean2[1] = f->step[0] = f->step[1] = f->step[2] = zero;
  }
}

static void measure(const fibertex_constants *w, uint32_t count, float lanes, int counted,
                    fibertex_means *out) {
  const vf one = splat(1.0f);
  block k[BLOCKS_TOGETHER];
  measured_blocks(w, k);
  memset(out, 0, sizeof *out);
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    measured_counts sum = {0};
    for (uint32_t i = 0; i < count; i += BLOCKS_TOGETHER * LANES) {
      layers_work of;
      measure_blocks(w, c, lanes * c->spacing, i, k, of);
      EACH(b, BLOCKS_TOGETHER) {
        const lane_hit *q = &of[0][b].hit;
        measure_add(&out->point[l], q->cover);
        measure_add(&out->soft[l], (q->soft + splat(c->soft)) * (one - q->cover));
        measure_add(&out->bright[l], q->cover * q->bright);
        measure_add(&out->formula[l], lane_expected(c, c->ends, &of[0][b].p));
      }
      if (counted && i / 64 % COUNTED_EACH == 0) measure_counts(w, c, of, &sum);
    }
    out->soft[l] /= count - out->point[l];
    if (out->point[l] > 0.0) out->bright[l] /= out->point[l];
    if (counted) measured_means(&sum, l, out);
    out->point[l] /= count;
    out->formula[l] /= count;
  }
}

#endif
