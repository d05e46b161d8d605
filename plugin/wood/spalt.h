/* SPDX-License-Identifier: Apache-2.0
 *
 * Spalting. Colonies of two fungi grow along the fibre, each where a noise is above
 * its level; the second keeps out of the first. Where a colony ends is a thin black
 * zone line, which swells and thins, and the wood within is bleached; that outside is stained by
 * the line. So lines close, or end on another, as
 * territories do. They are ragged down to some millimetres, since fungi go from fibre
 * to fibre: finer octaves, that both noises have in common. A point's distance from a
 * line is its value over its gradient.
 *
 * That is straight over a small part of a colony only, so that a footprint is
 * looked at in as many parts as it takes, 36 at most. They cost what they cost
 * where there is spalting and the footprint is wide; what is to be expected
 * takes over from two to five colonies.
 *
 * S. C. Robinson et al. (2007, see species.c), and A. Rayner and L. Boddy, Fungal decomposition of
 * wood (1988), on zone lines as the ends of colonies.
 */
#ifndef SOZAI_WOOD_SPALT_H
#define SOZAI_WOOD_SPALT_H

#include "../core/filter.h"
#include "../core/noise.h"
#include "rays.h"

typedef struct {
  vf line, bleached, stained; /* shares of the footprint */
} spalt_place;

/* A footprint as the fungi see it. */
typedef struct {
  vf at[3]; /* the fibre's place x, z in the reference section, and y between them: the height */
  vf row[3][3]; /* of the map from log space to it */
  const vf *n;  /* normal, log space */
  int ball;
  vf s;
  vf spread; /* of the surface over the noise's lattice, both directions' squares */
} spalt_eye;

#define SPALT_LONG 2.5f /* along the fibre, to a width of 1 */
#define SPALT_SOFT 0.2f /* colonies: over how much of one bleaching comes without a line */
#define SPALT_FLAT 1.0f /* of an octave that a part of its lattice's size takes, and takes on */

/* d: from a level of the noise. */
INLINE vf spalt_line(vf d, vf half, vf e) { return ray_overlap(d - e, d + e, half); }

/* A noise, and its gradient over x, z and y between them, in the octave's own lattice
 * and of unit weight; or a sum of such, in that of the first. */
typedef struct {
  vf n, slope[3], lost, rough; /* lost: variance within the part that slopes do not tell of; rough:
                                * the slopes' own that is lost */
} spalt_noise;

/* One octave's mean over a part of side s, which strays less than the octave by what the
 * straight run of it within the part does; where the part is wide that is less than the
 * octave loses. */
INLINE void spalt_octave(const wood_constants *w, const spalt_eye *q, vu own, const vf at[3], vf s,
                         uint32_t seed, float scale, float weight, spalt_noise *sum) {
  vf one = splat(1.0f), f = splat(w->spalt_frequency * scale), g[3];
  vf n = noise_gradient3(at[0] * f, at[1] * f * splat(1.0f / SPALT_LONG), at[2] * f,
                         wood_seed(w, own, seed), g);
  vf wide = s * f * s * f * q->spread * splat(SPALT_FLAT), keep = one / (one + wide);
  vf kept = keep * splat(weight), lost = wide * kept;
  sum->n = sum->n + n * kept;
  sum->lost = sum->lost + splat(SPALT_VARIANCE) * lost * lost;
  float steep = weight * scale;
  sum->rough = sum->rough + splat(SPALT_SLOPE * steep * steep) * (one - keep * keep);
  for (int i = 0; i < 3; i++) sum->slope[i] = sum->slope[i] + g[i] * (kept * splat(scale));
}

/* A colony's edge: its zone line, and how much of the part is within. */
typedef struct {
  vf line, within;
  /* how far from the line it is, in colonies and inwards: the least and the most in the part; and
   * the mean of what lies within */
  vf low, high, depth;
} spalt_edge;

INLINE spalt_edge spalt_edge_of(const wood_constants *w, const spalt_eye *q, const spalt_noise *n,
                                float level, vf width, vf s) {
  vf one = splat(1.0f), f = splat(w->spalt_frequency), flat[3], slope[3], unused;
  vf steep2 = splat(1e-3f);
  for (int i = 0; i < 3; i++) {
    slope[i] = i == 1 ? n->slope[i] * splat(1.0f / SPALT_LONG) : n->slope[i];
    steep2 = steep2 + slope[i] * slope[i];
  }
  for (int i = 0; i < 3; i++) {
    flat[i] = slope[0] * q->row[0][i] + slope[1] * q->row[1][i] + slope[2] * q->row[2][i];
  }
  vf inverse = inverse_root(steep2), steep = steep2 * inverse * f; /* of the noise to a mm */
  vf across2 = f * f * footprint_along(flat, q->n, q->ball, &unused);
  vf e = vsqrt(splat(0.25f) * s * s * across2 + splat(3.0f) * n->lost);
  e = vmax(e, splat(0.02f) * steep);
  vf d = n->n - splat(level);
  spalt_edge r;
  /* by what its edge winds, too, of which about half is lost */
  const float axes = 0.5f * (2.0f + 1.0f / (SPALT_LONG * SPALT_LONG));
  vf thin = width * f * vsqrt(steep2 + splat(axes) * n->rough);
  r.line = vmin(spalt_line(d, thin, e), one);
  r.within = clamp01(d / (e + e) + splat(0.5f));
  r.low = (d - e) * inverse;
  r.high = (d + e) * inverse;
  /* a part that is wider than a colony goes no deeper for that */
  r.depth = vmax(d * inverse, splat(0.5f) * vmin(r.high, splat(0.2f)));
  return r;
}

/* Half a line's width, where the other noise is `press` of its deviation. */
INLINE vf spalt_half(const wood_constants *w, vf press, vf some) {
  vf half = splat(0.5f * w->spalt_width) * some * (splat(1.0f) + splat(SPALT_SWELL) * press);
  return vmax(half, splat(0.06f * w->spalt_width));
}

/* A smooth step from 0 to `soft`, summed up from minus infinity to x. */
INLINE vf spalt_opened(vf soft, vf inverse, vf x) {
  vf t = x * inverse, u = clamp01(t), half = splat(0.5f);
  return soft * (u * u * u * (splat(1.0f) - half * u) + vmax(t - splat(1.0f), splat(0.0f)));
}

/* Of the part, what a colony bleaches: from the line on; where that is thin, or has never been,
 * it comes gradually. */
INLINE vf spalt_open(const spalt_edge *r, vf press) {
  vf one = splat(1.0f), soft = splat(SPALT_SOFT) * clamp01(splat(0.75f) - press) + splat(1e-3f);
  vf inverse = one / soft;
  vf sum = spalt_opened(soft, inverse, r->high) - spalt_opened(soft, inverse, r->low);
  return clamp01(sum / (r->high - r->low));
}

/* And what its line stains outside, less with the square of the distance. */
INLINE vf spalt_stain(const spalt_edge *r) {
  vf per = splat(1.0f / SPALT_STAIN), one = splat(1.0f);
  vf far = clamp01(one + r->low * per), by = clamp01(one + r->high * per);
  return (by * by * by - far * far * far) / ((r->high - r->low) * splat(3.0f / SPALT_STAIN));
}

/* A part of a footprint, of side s about `at`. */
INLINE spalt_place spalt_part(const wood_constants *w, vu own, const spalt_eye *q, const vf at[3],
                              vf s) {
  vf zero = splat(0.0f), one = splat(1.0f);
  spalt_noise fine = {zero, {zero, zero, zero}, zero, zero};
  for (uint32_t o = 1; o < SPALT_OCTAVES; o++) {
    spalt_octave(w, q, own, at, s, o == 1 ? SEED_SPALT + 1 : SEED_SPALT_MORE + o, spalt_scale[o],
                 spalt_weight[o], &fine);
  }
  spalt_noise first = fine, second = fine;
  second.n = zero - fine.n;
  for (int i = 0; i < 3; i++) second.slope[i] = zero - fine.slope[i];
  spalt_octave(w, q, own, at, s, SEED_SPALT, 1.0f, 1.0f, &first);
  spalt_octave(w, q, own, at, s, SEED_SPALT_MORE, SPALT_SECOND, 1.0f, &second);
  /* thinner and thicker from place to place, as the other fungus presses */
  vf per = splat(1.0f / SPALT_DEVIATION);
  vf press = (second.n + fine.n) * per, push = (first.n - fine.n) * per;
  vf some = one + splat(0.25f) * fine.slope[0];
  spalt_edge a = spalt_edge_of(w, q, &first, w->spalt_level, spalt_half(w, press, some), s);
  spalt_edge b = spalt_edge_of(w, q, &second, w->spalt_other, spalt_half(w, push, some), s);
  vf left = one - a.within;
  spalt_place p;
  p.line = vmin(a.line + b.line * left, one);
  /* most bleached by the line, and in patches */
  vf pale = splat(0.4f) + splat(0.6f) * clamp01(one - a.depth * splat(3.0f));
  pale = pale * vmax(one + splat(0.3f) * press, splat(0.25f));
  vf other = splat(SPALT_PALE) * vmax(one + splat(0.3f) * push, splat(0.25f));
  p.bleached = spalt_open(&a, press) * pale + left * spalt_open(&b, push) * other;
  p.stained = vmax(spalt_stain(&a) * (one - b.within), spalt_stain(&b) * left);
  return p;
}

/* The mean of side * side parts. */
static __attribute__((noinline)) spalt_place spalt_parts(const wood_constants *w, vu own,
                                                         const spalt_eye *q, int side) {
  vf zero = splat(0.0f), one = splat(1.0f), inverse = splat(1.0f / (float)side);
  /* two directions in the surface: the height's, or x where that is the normal, is one */
  vm up = lt(vabs(q->n[1]), splat(0.9f));
  vf t[3] = {sel(up, zero, one), sel(up, one, zero), zero}, u[3];
  vf along = t[0] * q->n[0] + t[1] * q->n[1];
  for (int i = 0; i < 3; i++) t[i] = t[i] - along * q->n[i];
  vf k = inverse_root(vmax(t[0] * t[0] + t[1] * t[1] + t[2] * t[2], splat(1e-6f)));
  for (int i = 0; i < 3; i++) t[i] = t[i] * k;
  for (int i = 0; i < 3; i++) {
    u[i] = q->n[(i + 1) % 3] * t[(i + 2) % 3] - q->n[(i + 2) % 3] * t[(i + 1) % 3];
  }
  vf part = q->s * inverse;
  spalt_place sum = {zero, zero, zero};
  for (int j = 0; j < side; j++) {
    for (int i = 0; i < side; i++) {
      float middle = 0.5f * (float)(side - 1);
      /* where no normal is known the parts lie in depth too, each elsewhere */
      float depth = q->ball ? (float)((5 * i + 3 * j) % side) - middle : 0.0f;
      vf p[3], at[3];
      for (int c = 0; c < 3; c++) {
        p[c] = t[c] * splat((float)i - middle) + u[c] * splat((float)j - middle);
        p[c] = (p[c] + q->n[c] * splat(depth)) * part;
      }
      for (int c = 0; c < 3; c++) {
        const vf *row = q->row[c];
        at[c] = q->at[c] + row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
      }
      spalt_place one_of = spalt_part(w, own, q, at, part);
      sum.line = sum.line + one_of.line;
      sum.bleached = sum.bleached + one_of.bleached;
      sum.stained = sum.stained + one_of.stained;
    }
  }
  sum.line = sum.line * (inverse * inverse);
  sum.bleached = sum.bleached * (inverse * inverse);
  sum.stained = sum.stained * (inverse * inverse);
  return sum;
}

INLINE spalt_place spalt_at(const wood_constants *w, vu own, spalt_eye *q) {
  /* sides in colonies up to which so many parts to a side do */
  static const float most[4] = {0.0125f, 0.06f, 0.3f, 5.0f};
  static const int sides[4] = {1, 2, 4, 6};
  vf one = splat(1.0f), size = q->s * splat(w->spalt_frequency);
  spalt_place mean = {splat(w->spalt_line_mean), splat(w->spalt_bleach_mean),
                      splat(w->spalt_stain_mean)};
  spalt_place p = mean;
  vf unused, before = splat(-1.0f);
  q->spread =
      footprint_along(q->row[0], q->n, q->ball, &unused) +
      footprint_along(q->row[2], q->n, q->ball, &unused) +
      footprint_along(q->row[1], q->n, q->ball, &unused) * splat(1.0f / (SPALT_LONG * SPALT_LONG));
  for (int k = 0; k < 4; k++) {
    vm mine = and_(gt(size, before), le(size, splat(most[k])));
    before = splat(most[k]);
    if (!any(mine)) continue;
    spalt_place found = k ? spalt_parts(w, own, q, sides[k]) : spalt_part(w, own, q, q->at, q->s);
    p.line = sel(mine, found.line, p.line);
    p.bleached = sel(mine, found.bleached, p.bleached);
    p.stained = sel(mine, found.stained, p.stained);
  }
  vf fade = smooth_step(splat(2.0f), splat(5.0f), size);
  vm near = lt(fade, one);
  p.line = sel(near, mix(p.line, mean.line, fade), mean.line);
  p.bleached = sel(near, mix(p.bleached, mean.bleached, fade), mean.bleached);
  p.stained = sel(near, mix(p.stained, mean.stained, fade), mean.stained);
  return p;
}

#endif
