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
  vf weight, last;  /* of its latewood, and of the ring's before it */
  vf phase;         /* 0 at the ring's start, 1 at its end */
} ring_place;

/* In two steps, so that the kernel can take a few blocks through each: which ring it
 * is, and rho within the table, */
INLINE vf ring_find(const wood_constants *w, vf rho, ring_place *p) {
  vi turns;
  vf repeats = rho * splat(w->inverse_ring_period);
#if LANES == 1
  /* a point alone goes by the guess that the table has not repeated: less to wait for */
  vf m = rho;
  turns = 0;
  p->turns = 0.0f;
  if (!(repeats < 1.0f)) {
    p->turns = vfloor(repeats, &turns);
    m = rho - p->turns * w->ring_period;
  }
  m = clamp(m, 0.0f, w->ring_period);
#else
  p->turns = vfloor(repeats, &turns);
  vf m = clamp(rho - p->turns * splat(w->ring_period), splat(0.0f), splat(w->ring_period));
#endif
  vi bin = to_int(vmin(m * splat(w->bin_scale), splat((float)w->bin_last)));
  /* a bin is narrower than any ring: at most one boundary lies in it */
  vf at[2];
  gather2_near(w->bin, bin, at);
  vf j = at[0] + sel(le(at[1], m), splat(1.0f), splat(0.0f));
  p->j = to_int(j);
  p->ring = turns * splati(WOOD_RINGS) + p->j;
  return m;
}

/* and what the ring is like. m: from ring_find. */
INLINE void ring_read(const wood_constants *w, vf m, ring_place *p) {
  vf row[4];
  gather4_near(w->ring_row, p->j, row);
  p->start = row[0];
  p->inverse_width = row[1];
  p->weight = row[2];
  p->last = row[3];
  p->phase = clamp01((m - p->start) * p->inverse_width);
}

INLINE ring_place ring_at(const wood_constants *w, vf rho) {
  ring_place p;
  vf m = ring_find(w, rho, &p);
  ring_read(w, m, &p);
  return p;
}

/* The latewood profile at phase f: 0 up to late_start, rising by a parabola to 1/2 at
 * late_middle, by another to 1 - late_deepening late_after further on, and by a line to 1
 * at the ring's end: the tracheids' lumina narrow to the last row, and with them the
 * density, as microdensitometry shows it (Polge, Wood Science
 * and Technology 12, 1978). */
INLINE vf late_profile(const wood_constants *w, vf f) {
  vf one = splat(1.0f), half = splat(0.5f), past = f - splat(w->late_middle);
  vf a = clamp01((f - splat(w->late_start)) * splat(w->inverse_late_before));
  vf b = one - clamp01(past * splat(w->inverse_late_after));
  vf left = one - clamp01((past - splat(w->late_after)) * splat(w->inverse_late_full));
  vf missing = splat(w->late_deepening) * (left - b * b);
  return sel(lt(past, splat(0.0f)), half * a * a, one - half * b * b - missing);
}

/* Its integral from 0 to f. */
INLINE vf late_integral(const wood_constants *w, vf f) {
  vf one = splat(1.0f), past = f - splat(w->late_middle);
  vf a = clamp01((f - splat(w->late_start)) * splat(w->inverse_late_before));
  vf b = one - clamp01(past * splat(w->inverse_late_after));
  vf after = splat(w->late_after), sixth = splat(1.0f / 6.0f),
     full = vmax(past - after, splat(0.0f));
  vf whole = splat(w->late_sixth) * a * a * a +
             after * (splat(5.0f / 6.0f) - b + b * b * b * sixth) + full;
  if (!(w->late_deepening > 0.0f)) return whole;
  vf missing = after * (splat(2.0f / 3.0f) - b + b * b * b * splat(1.0f / 3.0f)) +
               full * (one - full * splat(0.5f * w->inverse_late_full));
  return whole - splat(w->late_deepening) * missing;
}

/* Integral from 0 to f of the pores' expected coverage over its full value. */
INLINE vf pore_integral(const wood_constants *w, vf f) {
  vf e = splat(w->pore_early), g = splat(w->pore_growth);
  return f * (e * e + f * (e * g + f * g * g * splat(1.0f / 3.0f)));
}

/* What can be averaged across rings. */
enum { MEAN_LATE, MEAN_PORE, MEAN_ROW, MEAN_MARGIN, RING_MEANS };
/* MEAN_LATE    latewood profile, weighted by the ring
 * MEAN_PORE    expected coverage of the field's pores, over its full value
 * MEAN_ROW     share of the earlywood band
 * MEAN_MARGIN  share of the line of parenchyma at the ring's end */

/* The integral from the ring's start to phase f, over its width. */
INLINE vf ring_integral(const wood_constants *w, int what, vf f, vf inverse_width) {
  if (what == MEAN_LATE) return late_integral(w, f);
  if (what == MEAN_PORE) return pore_integral(w, f);
  if (what == MEAN_MARGIN) {
    vf wide = vmin(splat(w->parenchyma.margin) * inverse_width, splat(0.5f));
    return vmax(f + wide - splat(1.0f), splat(0.0f));
  }
  return vmin(f, splat(w->band) * inverse_width);
}

/* The integral from the pith to ring place p, mm. */
INLINE vf integral_to(const wood_constants *w, int what, const ring_place *p) {
  vf width = splat(1.0f) / p->inverse_width;
  vf within = width * ring_integral(w, what, p->phase, p->inverse_width);
  if (what == MEAN_LATE) {
    return p->turns * splat(w->late_period) + gather(w->late_before, p->j) + p->weight * within;
  }
  if (what == MEAN_PORE) {
    return splat(w->pore_ring_mean) * (p->turns * splat(w->ring_period) + p->start) + within;
  }
  if (what == MEAN_MARGIN) {
    return p->turns * splat(w->parenchyma.margin_period) +
           gather(w->parenchyma.margin_before, p->j) + within;
  }
  return p->turns * splat(w->row_period) + gather(w->row_before, p->j) + within;
}

/* Average over rho - e/2 .. rho + e/2. */
INLINE vf ring_average(const wood_constants *w, int what, const ring_place *at, vf rho, vf e) {
  e = vmax(e, splat(w->blur));
  vf low = vmax(rho - splat(0.5f) * e, splat(0.0f)), high = rho + splat(0.5f) * e;

  /* within one ring: differences of phase, nothing large cancels */
  vf start = at->start + at->turns * splat(w->ring_period);
  vf f0 = (low - start) * at->inverse_width, f1 = (high - start) * at->inverse_width;
  vm inside = and_(le(splat(0.0f), f0), le(f1, splat(1.0f)));
  vf g0 = clamp01(f0), g1 = vmax(clamp01(f1), g0 + splat(1e-6f));
  vf m = (ring_integral(w, what, g1, at->inverse_width) -
          ring_integral(w, what, g0, at->inverse_width)) /
         (g1 - g0);
  if (what == MEAN_LATE) {
    m = m * at->weight;
    /* across one edge, and narrow: past it there is only earlywood, before it
     * only the last ring's latewood */
    vm edge = and_(not_(inside), le(e, splat(w->safe)));
    if (any(edge)) {
      vf width = splat(1.0f) / at->inverse_width;
      vf within = at->weight * (late_integral(w, g1) - late_integral(w, g0));
      vf before = vmax(splat(0.0f) - f0, splat(0.0f));
      /* as if the last ring were as wide as this one */
      vf missing = before * splat(0.5f * w->late_deepening * w->inverse_late_full);
      before = before * (splat(1.0f) - missing) * at->last;
      m = sel(edge, (within + before) * width / e, m);
      inside = or_(inside, edge);
    }
  }

  if (any(not_(inside))) {
    ring_place p0 = ring_at(w, low), p1 = ring_at(w, high);
    vf across = (integral_to(w, what, &p1) - integral_to(w, what, &p0)) / (high - low);
    m = sel(inside, m, across);
  }
  return clamp01(m);
}

#endif
