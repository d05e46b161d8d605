/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings under a footprint that is wide beside a knot's collar: no slope says how
 * they bend in it. The front is looked up at nodes over the square, and between
 * nodes it runs straight.
 */
#ifndef SOZAI_WOOD_KNOT_TAPS_H
#define SOZAI_WOOD_KNOT_TAPS_H

#include "knot_cover.h"
#include "rings.h"

#define KNOT_ALONG 5 /* nodes along the level */
#define KNOT_UP 3    /* and across it */

typedef struct {
  stem_place at[KNOT_UP][KNOT_ALONG]; /* x, z and rho alone */
  vf y[KNOT_UP][KNOT_ALONG];
  vf step;  /* mm: the longer of those between nodes */
  vf widen; /* mm^2: what is not along the square */
  vf share; /* 0..1: from the slope to the nodes */
} knot_taps;

/* p: of the clear stem. */
INLINE void knot_taps_of(const stem_place *p, vf y, vf s, const vf n[3], int ball, knot_taps *q) {
  vf zero = splat(0.0f);
  vf radial = p->rho_x * p->c + p->rho_z * p->s, round = p->rho_z * p->c - p->rho_x * p->s;
  vf face[3] = {p->c, zero, p->s};
  q->widen = splat(12.0f) * p->lost;
  if (ball) {
    q->widen = q->widen + radial * radial * s * s;
  } else {
    for (int c = 0; c < 3; c++) face[c] = n[c];
  }
  /* u: level; on end grain, along the radius */
  vf flat2 = face[0] * face[0] + face[2] * face[2], k = inverse_root(vmax(flat2, splat(1e-6f)));
  vm end = lt(flat2, splat(1e-3f));
  vf ux = sel(end, p->c, face[2] * k), uz = sel(end, p->s, zero - face[0] * k);
  vf vx = face[1] * uz, vy = face[2] * ux - face[0] * uz, vz = zero - face[1] * ux;
  for (int j = 0; j < KNOT_UP; j++) {
    for (int i = 0; i < KNOT_ALONG; i++) {
      vf a = s * splat((float)i / (KNOT_ALONG - 1) - 0.5f), b = s * splat((float)j / (KNOT_UP - 1) - 0.5f);
      vf dy = b * vy, dx = a * ux + b * vx - dy * p->pith.dx, dz = a * uz + b * vz - dy * p->pith.dz;
      stem_place *t = &q->at[j][i];
      t->x = p->x + dx;
      t->z = p->z + dz;
      vf r = vsqrt(vmax(t->x * t->x + t->z * t->z, splat(1e-12f)));
      vf side = dz * p->c - dx * p->s;
      t->rho = vmax(p->rho + (r - p->r) * radial + side * round + dy * p->rho_y, zero);
      q->y[j][i] = y + dy;
    }
  }
  q->step = s * splat(1.0f / (KNOT_UP - 1));
  q->share = zero;
}

/* The front about one knot, of the stem alone. */
INLINE vf knot_front(const wood_knot *k, const knot_section *o, vf rho, vf s) {
  vf zero = splat(0.0f), one = splat(1.0f), front = vmin(rho, splat(k->death));
  vf radius = knot_radius_at(k, rho), inverse = one / radius;
  vf after = vmax(rho - splat(k->death), zero) * splat(0.6f * k->inverse_radius);
  vf fade = one / (one + after * after);
  vf keep = one - smooth_step(splat(2.0f * k->radius), splat(6.0f * k->radius), s);
  vf n2 = vmax(o->a * o->a + o->h * o->h, splat(1e-6f)), upright = o->h * o->h / n2;
  vf wide = splat(KNOT_WIDE) + splat(KNOT_WIDE_RISING) * upright;
  vf high = splat(k->high) + splat(k->high_rising) * upright;
  vf v = vmax(one - vmax(o->d * inverse - one, zero) / wide, zero);
  vf hill = high * radius * v * v * v * keep * fade;
  vm there = and_(o->grown, and_(lt(splat(k->born), front), lt(rho, splat(k->end))));
  return sel(there, vmax(rho - hill, zero), rho);
}

INLINE void knot_taps_add(const wood_knots *all, const wood_knot *k, vm near, vf s, knot_taps *q) {
  vf from = vmax(splat(0.3f * k->radius), splat(KNOT_CLOSE));
  near = and_(near, and_(lt(from, s), lt(s, splat(KNOT_NODES))));
  if (!any(near)) return;
  vf share = clamp01(s / from - splat(1.0f));
  q->share = sel(near, vmax(q->share, share), q->share);
  for (int j = 0; j < KNOT_UP; j++) {
    for (int i = 0; i < KNOT_ALONG; i++) {
      stem_place *t = &q->at[j][i];
      knot_section o = knot_section_at(all, k, q->y[j][i], t);
      knot_section_slopes(k, &o);
      t->rho = sel(near, knot_front(k, &o, t->rho, q->step), t->rho);
    }
  }
}

/* Latewood under the square. */
INLINE void knot_taps_late(const wood_constants *w, vf s, const knot_taps *q, knot_place *out) {
  vf sum = splat(0.0f), half = splat(0.5f), quarter = splat(0.25f);
  vf narrow = splat(1.0f) - smooth_step(splat(0.6f * KNOT_NODES), splat(KNOT_NODES), s);
  out->nodes = q->share * narrow;
  if (!any(gt(out->nodes, splat(0.0f)))) return;
  for (int j = 0; j + 1 < KNOT_UP; j++) {
    for (int i = 0; i + 1 < KNOT_ALONG; i++) {
      vf a = q->at[j][i].rho, b = q->at[j][i + 1].rho;
      vf c = q->at[j + 1][i].rho, d = q->at[j + 1][i + 1].rho;
      vf rho = quarter * (a + b + c + d);
      vf u = half * (b - a + d - c), v = half * (c - a + d - b), uv = half * (a + d - b - c);
      ring_place at = ring_at(w, rho);
      sum = sum + ring_average(w, MEAN_LATE, &at, rho, vsqrt(u * u + v * v + uv * uv + q->widen));
    }
  }
  out->late = splat(1.0f / ((KNOT_ALONG - 1) * (KNOT_UP - 1))) * sum;
}

#endif
