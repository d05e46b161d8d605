/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings: which year's growth a radius belongs to, and the season profile
 * across it with its exact integral, so that an average over any width is a
 * difference of two look-ups.
 */
#ifndef SOZAI_WOOD_RINGS_H
#define SOZAI_WOOD_RINGS_H

#include "../core/maths.h"
#include "wood.h"

typedef struct {
  vi ring;          /* years since the pith's first */
  vi j;             /* the ring's place in the table */
  vf turns;         /* times the table has repeated */
  vf start;         /* mm: rho of the ring's start, within the table */
  vf inverse_width; /* 1/mm */
  vf phase;         /* 0 at the ring's start, 1 at its end */
} ring_place;

INLINE ring_place ring_at(const wood_constants *w, vf rho) {
  ring_place p;
  vi turns;
  p.turns = vfloor(rho * splat(w->inverse_ring_period), &turns);
  vf m = clamp(rho - p.turns * splat(w->ring_period), splat(0.0f), splat(w->ring_period));
  vi bin = to_int(vmin(m * splat(w->bin_scale), splat((float)w->bin_last)));
  /* a bin is narrower than any ring: at most one boundary lies in it */
  vi j = gatheri(w->bin, bin);
  vf next = gather(w->start + 1, j);
  vm over = and_(le(next, m), lti(j, splati(WOOD_RINGS - 1)));
  p.j = seli(over, j + splati(1), j);
  p.start = sel(over, next, gather(w->start, j));
  p.inverse_width = gather(w->inverse_width, p.j);
  p.phase = clamp01((m - p.start) * p.inverse_width);
  p.ring = turns * splati(WOOD_RINGS) + p.j;
  return p;
}

/* Integral of the latewood profile from 0 to f: the profile is 0 up to
 * late_start, rises as a smooth step, and stays 1 to the ring's end. */
INLINE vf late_integral(const wood_constants *w, vf f) {
  vf past = f - splat(w->late_start);
  vf g = clamp01(past * splat(w->inverse_late_rise));
  vf g3 = g * g * g;
  return splat(w->late_rise) * (g3 - splat(0.5f) * g3 * g) +
         vmax(past - splat(w->late_rise), splat(0.0f));
}

/* Integral from 0 to f of the pores' expected coverage over its full value. */
INLINE vf pore_integral(const wood_constants *w, vf f) {
  vf e = splat(w->pore_early), g = splat(w->pore_growth);
  return f * (e * e + f * (e * g + f * g * g * splat(1.0f / 3.0f)));
}

/* What is averaged across rings. */
typedef struct {
  vf late; /* latewood profile, weighted by the ring */
  vf pore; /* expected coverage of the field's pores, over its full value */
  vf row;  /* share of the earlywood band */
} ring_means;

/* The integrals from the table's start to phase f of ring place p, mm. */
INLINE ring_means ring_integrals(const wood_constants *w, const ring_place *p) {
  vf width = splat(1.0f) / p->inverse_width;
  ring_means m;
  m.late = p->turns * splat(w->late_period) + gather(w->late_before, p->j) +
           gather(w->late_weight, p->j) * width * late_integral(w, p->phase);
  m.pore = splat(w->pore_ring_mean) * (p->turns * splat(w->ring_period) + p->start) +
           width * pore_integral(w, p->phase);
  m.row = splat(w->band) * to_float(p->ring) + vmin(p->phase * width, splat(w->band));
  return m;
}

/* Averages over rho - e/2 .. rho + e/2. */
INLINE ring_means ring_average(const wood_constants *w, const ring_place *at, vf rho, vf e) {
  e = vmax(e, splat(w->blur));
  vf low = vmax(rho - splat(0.5f) * e, splat(0.0f)), high = rho + splat(0.5f) * e;

  /* within one ring: differences of phase, nothing large cancels */
  vf start = at->start + at->turns * splat(w->ring_period);
  vf width = splat(1.0f) / at->inverse_width;
  vf f0 = (low - start) * at->inverse_width, f1 = (high - start) * at->inverse_width;
  vm inside = and_(le(splat(0.0f), f0), le(f1, splat(1.0f)));
  vf g0 = clamp01(f0), g1 = vmax(clamp01(f1), g0 + splat(1e-6f));
  vf q = splat(1.0f) / (g1 - g0);
  ring_means m;
  m.late = gather(w->late_weight, at->j) * (late_integral(w, g1) - late_integral(w, g0)) * q;
  m.pore = (pore_integral(w, g1) - pore_integral(w, g0)) * q;
  vf b = splat(w->band);
  m.row = (vmin(g1 * width, b) - vmin(g0 * width, b)) * at->inverse_width * q;

  if (any(not_(inside))) {
    ring_place p0 = ring_at(w, low), p1 = ring_at(w, high);
    ring_means i0 = ring_integrals(w, &p0), i1 = ring_integrals(w, &p1);
    vf k = splat(1.0f) / (high - low);
    m.late = sel(inside, m.late, (i1.late - i0.late) * k);
    m.pore = sel(inside, m.pore, (i1.pore - i0.pore) * k);
    m.row = sel(inside, m.row, (i1.row - i0.row) * k);
  }
  m.late = clamp01(m.late);
  return m;
}

#endif
