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
  vf rho[KNOT_UP][KNOT_ALONG];
  vf u[3], v[3]; /* mm from the middle to the last node: about the pith, and up */
  vf step;       /* mm: the longer of those between nodes */
  vf widen;      /* mm^2: what is not along the square */
  vf share;      /* 0..1: from the slope to the nodes */
} knot_taps;

/* From -1 to 1 along a side. */
INLINE vf knot_tap_at(int i, int count) {
  return splat(2.0f * (float)i / (float)(count - 1) - 1.0f);
}

/* p: of the clear stem. */
INLINE void knot_taps_of(const stem_place *p, vf s, const vf n[3], int ball, knot_taps *q) {
  vf zero = splat(0.0f), half = splat(0.5f) * s;
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
  q->u[0] = half * ux;
  q->u[1] = zero;
  q->u[2] = half * uz;
  q->v[0] = half * (vx - vy * p->pith.dx);
  q->v[1] = half * vy;
  q->v[2] = half * (vz - vy * p->pith.dz);
  for (int j = 0; j < KNOT_UP; j++) {
    for (int i = 0; i < KNOT_ALONG; i++) {
      vf a = knot_tap_at(i, KNOT_ALONG), b = knot_tap_at(j, KNOT_UP);
      vf dx = a * q->u[0] + b * q->v[0], dz = a * q->u[2] + b * q->v[2];
      vf x = p->x + dx, z = p->z + dz, side = dz * p->c - dx * p->s;
      vf r = vsqrt(vmax(x * x + z * z, splat(1e-12f)));
      q->rho[j][i] =
          vmax(p->rho + (r - p->r) * radial + side * round + b * q->v[1] * p->rho_y, zero);
    }
  }
  q->step = s * splat(1.0f / (KNOT_UP - 1));
  q->share = zero;
}

/* The front about a knot, of the stem alone. o: at the middle. */
INLINE void knot_taps_add(const wood_knot *k, const knot_section *o, vm near, vf s, knot_taps *q) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf from = vmax(splat(0.3f * k->radius), splat(KNOT_CLOSE));
  near = and_(near, and_(lt(from, s), lt(s, splat(KNOT_NODES))));
  if (!any(near)) return;
  q->share = sel(near, vmax(q->share, clamp01(s / from - one)), q->share);
  vf keep = one - smooth_step(splat(2.0f * k->radius), splat(6.0f * k->radius), q->step);
  vf kc = splat(k->c), ks = splat(k->s), cosine = splat(k->cosine), slope = splat(k->slope);
  vf ua = q->u[2] * kc - q->u[0] * ks, uu = q->u[0] * kc + q->u[2] * ks;
  vf va = q->v[2] * kc - q->v[0] * ks, vu = q->v[0] * kc + q->v[2] * ks;
  vf uh = zero - cosine * slope * uu, vh = cosine * (q->v[1] - slope * vu);
  vf squash = splat(k->squash), lean2 = splat(2.0f * k->lean), death = splat(k->death);
  for (int j = 0; j < KNOT_UP; j++) {
    for (int i = 0; i < KNOT_ALONG; i++) {
      vf along = knot_tap_at(i, KNOT_ALONG), up = knot_tap_at(j, KNOT_UP), rho = q->rho[j][i];
      vf u = o->u + along * uu + up * vu, a = o->a + along * ua + up * va;
      vf h = o->h + along * uh + up * vh, h2 = h * h, n2 = vmax(a * a + h2, splat(1e-6f));
      vm there = and_(and_(lt(splat(k->born), rho), lt(rho, splat(k->end))),
                      and_(lt(zero, u), lt(u, splat(k->reach))));
      vf upright = h2 / n2, d2 = vmax(a * a + squash * h2 + lean2 * a * h, splat(1e-6f));
      vf radius = knot_radius_at(k, rho);
      vf d = d2 * inverse_root(d2) + splat(k->pith_a) * a + splat(k->pith_h) * h;
      vf wide = (splat(KNOT_WIDE) + splat(KNOT_WIDE_RISING) * upright) * radius;
      vf v = vmax(one - vmax(d - radius, zero) / wide, zero);
      vf after = vmax(rho - death, zero) * splat(0.6f * k->inverse_radius);
      vf high = splat(k->high) + splat(k->high_rising) * upright;
      vf hill = high * radius * v * v * v * keep / (one + after * after);
      q->rho[j][i] = sel(and_(near, there), vmax(rho - hill, zero), rho);
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
      vf a = q->rho[j][i], b = q->rho[j][i + 1], c = q->rho[j + 1][i], d = q->rho[j + 1][i + 1];
      vf rho = quarter * (a + b + c + d);
      vf u = half * (b - a + d - c), v = half * (c - a + d - b), uv = half * (a + d - b - c);
      ring_place at = ring_at(w, rho);
      sum = sum + ring_average(w, MEAN_LATE, &at, rho, vsqrt(u * u + v * v + uv * uv + q->widen));
    }
  }
  out->late = splat(1.0f / ((KNOT_ALONG - 1) * (KNOT_UP - 1))) * sum;
}

#endif
