/* SPDX-License-Identifier: Apache-2.0
 *
 * Near and from afar, the mean over places, lights and views. Two faces of each yarn know the
 * moments of how it lies, not that crests are in less shade, lie more level and face eye and light
 * otherwise than flanks. And directions with a variance about them have bells that are a
 * Gaussian's, where how far strands rise out of an aggregate is not.
 */
#ifndef SOZAI_FIBERTEX_MEASURE_BOTH_H
#define SOZAI_FIBERTEX_MEASURE_BOTH_H

#include "../../core/measure.h"
#include "cloth_looks.h"
#include "hull_looks.h"
#include "measure.h"
#include "shown.h"
#include "surface.h"

/* 0 to 1, of the i-th place and those after it: Roberts' sequence, which fills six dimensions more
 * evenly than chance. */
INLINE vf measure_even(uint32_t i, int which) {
  /* powers of 1 over the root of x^7 = x + 1, of 2^32 */
  static const uint32_t step[6] = {3859688306u, 3468523226u, 3117001274u,
                                   2801104767u, 2517223199u, 2262111973u};
  vf r = splat(0.0f);
  for (uint32_t k = 0; k < LANES; k++) {
    set_lane(&r, k, (float)(((i + k + 1u) * step[which]) >> 8) * (1.0f / 16777216.0f));
  }
  return r;
}

/* Evenly over the cloth's plane, slanted by up to a sine of 0.99. */
INLINE void measure_direction(uint32_t i, int which, vf v[3]) {
  const vf most = splat(1.4f), half = splat(0.5f);
  v[0] = (measure_even(i, which) - half) * most;
  v[1] = (measure_even(i, which + 1) - half) * most;
  v[2] = vsqrt(splat(1.0f) - v[0] * v[0] - v[1] * v[1]);
}

INLINE void measure_look(const fibertex_constants *w, uint32_t i, block *k) {
  const vf one = splat(1.0f);
  const vf wide = splat(MEASURED_EXTENT);
  k->cloth.u = measure_even(i, 0) * wide * splat(w->yarn[1].spacing);
  k->cloth.v = measure_even(i, 1) * wide * splat(w->yarn[0].spacing);
  measure_direction(i, 2, k->f.light);
  measure_direction(i, 4, k->f.view);
  k->f.between = dot3(k->f.light, k->f.view);
  k->front = one;
  for (int c = 0; c < 2; c++) {
    k->inverse[c] = one / (c ? k->f.view[2] : k->f.light[2]);
    k->f.lean2[c] = k->f.view[c] / k->f.view[2];
  }
}

/* What the place shows by its yarn, and by what stands off it, which lies either way. */
INLINE vf measure_place_lit(const fibertex_constants *w, const block *k, const looks *q) {
  const ground *g = &k->ground;
  const float *twist = w->below;
  strand_axes t;
  strand_angles a;
  strand_lit r;
  for (int c = 0; c < 3; c++) {
    t.along[c] = splat(twist[0]) * g->along[c] + splat(twist[1]) * g->across[c];
    t.across[c] = splat(twist[0]) * g->across[c] - splat(twist[1]) * g->along[c];
    t.up[c] = g->up[c];
  }
  t.across2 = splat(w->look[0].across2);
  t.up2 = splat(w->scatter_up);
  strand_angles_of(w, 1, k->f.light, k->f.view, k->f.between, &t, &a);
  strand_lobes_of_yarn(w, &a, &r);
  vf even = r.even * splat(1.0f - w->flown);
  for (int m = FIBERTEX_FACES; m < w->looks; m++) {
    const fibertex_look *o = &w->look[m];
    for (int c = 0; c < 3; c++) {
      t.along[c] = splat(o->along[c]);
      t.across[c] = splat(o->across[c]);
      t.up[c] = splat(o->up[c]);
    }
    t.across2 = splat(o->across2);
    t.up2 = splat(o->up2);
    strand_angles_of(w, 1, k->f.light, k->f.view, k->f.between, &t, &a);
    strand_lobes_of_yarn(w, &a, &r);
    even = even + r.even * splat(o->share * w->flown);
  }
  vf lit = g->face.in * g->face.seen * g->up[2] * even * g->ambient;
  return lit * q->straight * g->around * g->solid;
}

static void measure_faces(const fibertex_constants *cloth, uint32_t count, fibertex_both *out) {
  fibertex_constants w = *cloth;
  w.yarn[0].tone = w.yarn[1].tone = 0.0f; /* the mean is known */
  for (uint32_t i = 0; i < count; i += LANES) {
    block k;
    looks q;
    k.s = splat(0.0f);
    measure_look(&w, i, &k);
    ground_cloth(&w, 1, &k);
    stage_looks_of_cloth(&w, &k, 1, 1, &q);
    vf lit = measure_place_lit(&w, &k, &q);
    measure_add(&out->near[0], lit * (splat(1.0f) - k.ground.weft));
    measure_add(&out->near[1], lit * k.ground.weft);
    for (int c = 0; c < 2; c++) measure_add(&out->far[c], q.around[c] * k.ground.whole);
  }
}

/* The strand at a place as the eye has it, white: and how broad it looks. */
INLINE vf measure_strand(const fibertex_constants *w, const fibertex_layer *c, block *k,
                         const layer_work *of, strand_parts *p) {
  const lane_hit *hit = &of->hit;
  strand_axes t;
  strand_angles a;
  for (int i = 0; i < 2; i++) k->best.direction[i] = of->direction[i];
  k->best.slope = hit->slope;
  k->best.id = hit->id;
  k->best.detail = splat(1.0f);
  best_axes(w, 0, k, &t);
  strand_angles_of(w, 0, k->f.light, k->f.view, k->f.between, &t, &a);
  strand_parts_of(w, &a, p);
  vf slant = k->f.lean2[0] * t.across[0] + k->f.lean2[1] * t.across[1];
  return hit->cover * widening(slant, c->widen_most);
}

/* Of the layers one stands for all. */
static void measure_strands(const fibertex_constants *w, uint32_t count, fibertex_both *out) {
  const fibertex_layer *c = &w->layer[w->layers - 1];
  block k[BLOCKS_TOGETHER];
  measured_blocks(w, k);
  for (uint32_t i = 0; i < count; i += BLOCKS_TOGETHER * LANES) {
    layers_work of;
    measure_blocks(w, c, 0.0f, i, k, of);
    EACH(b, BLOCKS_TOGETHER) {
      const vf zero = splat(0.0f);
      strand_parts p, all = {zero, zero, zero, zero};
      vf straight = zero;
      measure_look(w, i + b * LANES, &k[b]);
      vf seen = measure_strand(w, c, &k[b], &of[0][b], &p);
      looks_of_block(w, &k[b], &all, &straight);
      k[b].f.lean2[0] = k[b].f.lean2[1] = zero; /* squarely again */
      vf inverse = splat(1.0f) / straight, share = seen * splat((float)w->looks) * inverse;
      vf mean = splat(c->mean) * inverse;
      measure_add(&out->near[0], p.reflected * share);
      measure_add(&out->near[1], p.through * share);
      measure_add(&out->near[2], p.back * share);
      measure_add(&out->far[0], all.reflected * mean);
      measure_add(&out->far[1], all.through * mean);
      measure_add(&out->far[2], all.back * mean);
    }
  }
}

static void measure_both(const fibertex_constants *w, uint32_t count, fibertex_both *out) {
  memset(out, 0, sizeof *out);
  if (w->structure == STRUCTURE_WOVEN)
    measure_faces(w, count, out);
  else
    measure_strands(w, count, out);
}

#endif
