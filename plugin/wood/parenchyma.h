/* SPDX-License-Identifier: Apache-2.0
 *
 * Axial parenchyma along the rings: bands that stand by themselves (IAWA list of microscopic
 * features for hardwood identification, 1989: 85, 86), what lies between the vessels of a band, and
 * the line at a ring's end (89, rings.h). That about single vessels is in vessels_sheaths.h.
 *
 * A band is where a phase is near a whole number, as those of vessels are (vessels_bands.h). Its
 * mean over a footprint is a difference of two values of its integral, exact for a box along the
 * phase's slope; the square's own corners are left out.
 */
#ifndef SOZAI_WOOD_PARENCHYMA_H
#define SOZAI_WOOD_PARENCHYMA_H

#include "footprint_parts.h"
#include "vessels_bands.h"

#define SOFT_EDGE 0.05f   /* turns: no band's edge is sharper */
#define SOFT_WIDEST 1e10f /* square of turns: what no footprint needs to go beyond */

/* The integral from 0 to t of pulses that begin at whole numbers and last `share`. */
INLINE vf pulses_to(vf t, vf share) {
  vi unused;
  vf whole = vfloor(t, &unused);
  return whole * share + vmin(t - whole, share);
}

/* A footprint's width along a phase, turns, and its inverse. */
typedef struct {
  vf turns, inverse;
} phase_width;

INLINE phase_width phase_width_of(vf square) {
  square = vmax(square, splat(SOFT_EDGE * SOFT_EDGE));
  vf inverse = inverse_root(square);
  return (phase_width){square * inverse, inverse};
}

/* The mean of pulses about whole numbers over that much about t. share: of each. */
INLINE vf pulses_mean(vf t, phase_width wide, vf share) {
  vf low = t + splat(0.5f) * (share - wide.turns);
  return (pulses_to(low + wide.turns, share) - pulses_to(low, share)) * wide.inverse;
}

/* Where bands are asked for: a point, or a place in its footprint with the part of that about it.
 */
typedef struct {
  vessel_place at;
  matrix2 seen;        /* the footprint over (x, z) */
  fibre_bundle bundle; /* the bundles' noise there, as much as the footprint leaves of it */
  vf pores;            /* what they cover */
} soft_place;

/* What the part of a footprint that is cut has lost: how much of the variance of the bundles'
 * noise. Lanes that are not cut have lost nothing. */
typedef struct {
  vm cut;
  vf lost;
} soft_long;

/* Share of bands of their own. part: NULL where no lane is cut. */
INLINE vf soft_bands(const wood_constants *w, const soft_place *q, const soft_long *part) {
  const wood_parenchyma *m = &w->parenchyma;
  const fibre_bundle *b = &q->bundle;
  const vessel_place *at = &q->at;
  vf one = splat(1.0f), inverse = at->ring.inverse_width, stray = splat(m->bands_stray);
  vf count = bands_to_ring(m->bands_often, inverse), rate = count * inverse;
  vf phase = at->ring.phase * count - splat(0.5f) + stray * b->at;
  vf x = rate * at->c + stray * b->x, z = rate * at->s + stray * b->z;
  vf wide2 = phase_across2(x, z, &q->seen);
  if (part) wide2 = vmin(wide2 + splat(m->bands_lost) * part->lost, splat(SOFT_WIDEST));
  vf share = splat(m->bands_share) * (one + splat(m->bands_uneven) * b->at);
  return pulses_mean(phase, phase_width_of(wide2), share);
}

/* Share of what lies between the vessels of a band v, in the tissue that vessels leave. Where a
 * footprint averages over bands, vessels are denser in them than it says. part: as above. */
INLINE vf soft_between(const wood_constants *w, const soft_place *q, const vessel_bands *v,
                       const soft_long *part) {
  const wood_parenchyma *m = &w->parenchyma;
  vf one = splat(1.0f), zero = splat(0.0f), two = splat(2.0f), half = splat(m->between_half);
  vf share, wide2 = phase_across2(v->x, v->z, &q->seen);
  if (part) wide2 = vmin(wide2 + splat(m->between_lost) * part->lost, splat(SOFT_WIDEST));
  phase_width wide = phase_width_of(wide2);
  if (w->bands.fork > 0.0f) {
    half = half - v->half;
    share = pulses_mean(v->phase, wide, two * (v->fork + half)) -
            pulses_mean(v->phase, wide, two * vmax(v->fork - half, zero));
  } else {
    share = pulses_mean(v->phase, wide, two * half);
  }
  share = splat(m->between) * share;
  if (!part) return share; /* short of a band */
  /* of the tissue that pores leave, (1 - denser pores) / (1 - pores), to the second order */
  vf more = splat(m->between_denser) * vmin(wide.turns, one) * q->pores;
  more = sel(part->cut, more, zero);
  return share * vmax(one - more - more * q->pores, zero);
}

/* Footprints that swallow some of the bundles' noise, or may meet other rings. */
INLINE vm soft_cut(const wood_constants *w, const footprint2 *f) {
  float part = w->parenchyma.part;
  return gt(f->aa + f->bb, splat(part * part));
}

INLINE fibre_bundle bundle_of(const fibre_bundle *b, vf keep) {
  return (fibre_bundle){b->at * keep, b->x * keep, b->z * keep};
}

/* What is left of the tissue between vessels at one of the places in a longer footprint. */
INLINE vf soft_leave(const wood_constants *w, const soft_place *q, const soft_long *part) {
  const wood_parenchyma *m = &w->parenchyma;
  vf left = splat(1.0f);
  if (m->between > 0.0f) {
    vessel_bands v = bands_strayed(w, bands_straight(w, &q->at), &q->bundle);
    left = left - soft_between(w, q, &v, part);
  }
  if (m->bands_often > 0.0f) {
    left = left - left * soft_bands(w, q, part);
  }
  return left;
}

/* Lanes whose footprint meets so many of what bands there are that one mean over all of it is near
 * enough the share they have: parts differ from it by a pulse in so many. */
#define SOFT_MANY 8.0f /* turns */
INLINE vm soft_many(const wood_constants *w, const soft_place *q) {
  const wood_parenchyma *m = &w->parenchyma;
  const vessel_place *at = &q->at;
  vf least = splat(SOFT_WIDEST);
  if (m->between > 0.0f) {
    vessel_bands v = bands_straight(w, at);
    least = vmin(least, phase_across2(v.x, v.z, &q->seen));
  }
  if (m->bands_often > 0.0f) {
    vf inverse = at->ring.inverse_width, rate = bands_to_ring(m->bands_often, inverse) * inverse;
    least = vmin(least, phase_across2(rate * at->c, rate * at->s, &q->seen));
  }
  return gt(least, splat(SOFT_MANY * SOFT_MANY));
}

#define SOFT_PARTS 4 /* 8 err less by nothing that is seen */

/* The mean of that, over up to so many parts: each asks ring and noise where it lies. */
INLINE vf soft_leave_parts(const wood_constants *w, const soft_place *from) {
  fibre_octave octave = fibre_octave_of(w, FIBRE_BUNDLE);
  const vessel_place *p = &from->at;
  const float reach = w->parenchyma.part;
  footprint_axes l = footprint_split(&p->f);
  vm cut = soft_cut(w, &p->f);
  footprint_parts part = footprint_cut(&p->f, &l, cut, reach, reach, SOFT_PARTS);
  fibre_sum under;
  soft_place q = *from;
  q.at.f = (footprint2){part.aa, part.ab, part.bb};
  fibre_under(&q.at.f, &under);
  vf one = splat(1.0f), zero = splat(0.0f), keep = sel(cut, fibre_keep(&octave, &under), one);
  soft_long has = {cut, one - keep * keep};
  /* where no part has anything left of the noise, and there are many bands */
  vm gone = le(keep, zero);
  if (any(gone)) {
    cut = and_(cut, not_(and_(gone, soft_many(w, from))));
    part = footprint_cut(&p->f, &l, cut, reach, reach, SOFT_PARTS);
    q.at.f = (footprint2){part.aa, part.ab, part.bb};
  }
  q.seen = to_section(part.aa, part.ab, part.bb, p->c, p->s);
  const int strays = w->has_strays && any(not_(gone));
  if (w->has_strays && !strays) q.bundle = (fibre_bundle){zero, zero, zero};
  vf left = zero, per_turn = splat(0.15915494f);
  for (int i = 0; i < part.taps; i++) {
    footprint_part at = footprint_part_of(&l, &part, cut, i);
    q.at.x = p->x + (at.rho * p->c - at.arc * p->s);
    q.at.z = p->z + (at.rho * p->s + at.arc * p->c);
    q.at.rho = sel(cut, vmax(p->rho + at.rho, zero), p->rho);
    q.at.turn = p->turn + per_turn * at.arc / vmax(q.at.rho, splat(1e-3f));
    q.at.ring = ring_at(w, q.at.rho);
    if (strays) {
      fibre_bundle whole;
      fibre_bundle_at(&octave, p->own, q.at.x, q.at.z, &whole);
      q.bundle = bundle_of(&whole, keep);
    }
    left = left + soft_leave(w, &q, &has) * at.weight;
  }
  return left;
}

#endif
