/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on one strand: the lobes of Marschner et al., Light scattering from human
 * hair fibers (SIGGRAPH 2003), R, TT and TRT, each of a longitudinal and an
 * azimuthal part, and Kajiya and Kay's diffuse term (SIGGRAPH 1989) for what is
 * scattered more often.
 *
 * The longitudinal part is a bell over the sum of the sines of both inclinations,
 * which is linear in the tangent: over strands whose tangents scatter, the
 * sum scatters about its mean, and the bell becomes a broader one. So a mean
 * direction with a variance stands for many strands.
 */
#ifndef SOZAI_FIBERTEX_STRAND_LIGHT_H
#define SOZAI_FIBERTEX_STRAND_LIGHT_H

#include "../../core/vectors.h"
#include "texture.h"

/* max(0, 1 - q/8)^8, which is e^-q nearly; over FIBERTEX_BELL sigma a bell's density. x: over 4
 * sigma. */
INLINE vf bell(vf x) {
  vf q = vmax(splat(1.0f) - x * x, splat(0.0f));
  q = q * q;
  q = q * q;
  return q * q;
}

/* A strand's axes: along it, across it in the ground, and out of that; and the
 * variances of the angles by which what it stands for strays across and out. */
typedef struct {
  vf along[3], across[3], up[3];
  vf across2, up2;
} strand_axes;

/* Of no strand: numbers, that nobody looks at. */
INLINE void strand_axes_none(strand_axes *t) {
  for (int c = 0; c < 3; c++) t->along[c] = t->across[c] = t->up[c] = splat(0.0f);
  t->across2 = t->up2 = splat(0.0f);
}

/* Radiance of a strand under light of irradiance pi: white; of what went through; of what
 * was scattered within. And the lobe of what goes on through. */
typedef struct {
  vf white, glow, bulk, onward;
  vf even; /* of a yarn: what comes back of light that was scattered often, the mean 1 */
} strand_lit;

/* Its parts, to be multiplied by their amounts: R, TT, TRT, and what is scattered within. */
typedef struct {
  vf reflected, through, back, within;
} strand_parts;

/* What of it does not wait for its last root. sharp: 1 over the width of R's bell. */
typedef struct {
  vf sum, spread, sharp, round, squares, cosine;
} strand_angles;

/* sl, sv: the sines of both inclinations; sl2, sv2: their variances, both: what they have in
 * common of them. given_sum: of strands that scatter those give gloss whose sum is near 0, and it
 * is their azimuths that count; then sines, variances and all are given that sum (a Gaussian's).
 * Of yarns, whose strands lie in order. In bulk it is what all strands do on the mean that
 * was fitted. */
INLINE void strand_angles_from(const fibertex_constants *w, int given_sum, vf sl, vf sv, vf sl2,
                               vf sv2, vf both, vf between, strand_angles *q) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  vf x = sl * sl, mean = x + sl2, of_l = sl2 + both, of_v = sv2 + both;
  q->spread = of_l + of_v;
  q->sum = sl + sv;
  q->sharp = inverse_root(splat(w->beta2) + q->spread);
  if (given_sum) {
    vf inverse = q->sharp * q->sharp, given = q->sum * inverse;
    vf gl = of_l * inverse, gv = of_v * inverse, l = sl - of_l * given, v = sv - of_v * given;
    q->squares = vmax(one - (l * l + (sl2 - of_l * gl)), splat(0.01f)) *
                 vmax(one - (v * v + (sv2 - of_v * gv)), splat(0.01f));
    q->round = between - l * v - (both - of_l * gv);
  } else {
    q->squares = vmax(one - mean, splat(0.01f)) * vmax(one - (sv * sv + sv2), splat(0.01f));
    q->round = between - sl * sv - both;
  }
  /* the cosine of the inclination, as a polynomial of its sine: its mean is known */
  vf fourth = splat(1.1f) * sl2 * (x + mean);
  q->cosine = vmax(splat(0.985f) - mean * (splat(0.3f) + splat(0.55f) * mean) - fourth, zero);
}

INLINE void strand_angles_of(const fibertex_constants *w, int given_sum, const vf light[3],
                             const vf view[3], vf between, const strand_axes *t, strand_angles *q) {
  vf shrink = splat(1.0f) - splat(0.5f) * (t->across2 + t->up2);
  vf sl = dot3(t->along, light) * shrink, sv = dot3(t->along, view) * shrink;
  vf la = dot3(t->across, light), va = dot3(t->across, view);
  vf lu = dot3(t->up, light), vu_ = dot3(t->up, view);
  vf a = t->across2 * la, u = t->up2 * lu;
  vf sl2 = a * la + u * lu, sv2 = t->across2 * (va * va) + t->up2 * (vu_ * vu_);
  strand_angles_from(w, given_sum, sl, sv, sl2, sv2, a * va + u * vu_, between, q);
}

/* What a strand's side reflects, seen that far round it from the light: what glances off is
 * brighter than what is met squarely (Schlick). */
INLINE vf strand_mirror(const fibertex_constants *w, vf round) {
  const vf half = splat(0.5f);
  vf square = vsqrt(half + half * round), aside = splat(1.0f) - square, aside2 = aside * aside;
  return square * (splat(w->mirror) + splat(1.0f - w->mirror) * (aside2 * aside2 * aside));
}

INLINE void strand_parts_of(const fibertex_constants *w, const strand_angles *q, strand_parts *r) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  vf round = clamp(q->round * inverse_root(q->squares), splat(-1.0f), one);
  vf ahead = vmax(splat(0.25f) - splat(0.5f) * round, zero);
  /* one variance; the other lobes' bells are R's by a factor */
  vf sharp = q->sharp;
  vf lobe[3];
  for (int i = 0; i < 3; i++) {
    lobe[i] = bell((q->sum - splat(w->tilt[i])) * (sharp * splat(0.25f * w->sharp[i])));
  }
  vf height = sharp * q->cosine;
  r->reflected = lobe[0] * height * strand_mirror(w, round);
  r->through = lobe[1] * (ahead * ahead) * height;
  r->back = lobe[2] * (height + height * round);
  r->within = q->cosine;
}

/* Azimuthal parts: over all round each is 1 / 2 pi; times pi for the irradiance. */
INLINE void strand_amounts(const fibertex_constants *w, const strand_parts *p, strand_lit *r) {
  r->onward = splat(w->sharp[1] * 2.82986f / (float)FIBERTEX_BELL) * p->through;
  r->white = splat(w->gloss[0] * w->sharp[0] / (float)FIBERTEX_BELL) * p->reflected;
  r->glow = splat(w->gloss[1]) * r->onward +
            splat(w->gloss[2] * w->sharp[2] * 0.5f / (float)FIBERTEX_BELL) * p->back;
  r->bulk = splat(w->single) * p->within;
}

INLINE void strand_lobes(const fibertex_constants *w, const strand_angles *q, strand_lit *r) {
  strand_parts p;
  strand_parts_of(w, q, &p);
  strand_amounts(w, &p, r);
}

/* Of a yarn. Its strands lie side by side, so that what they do is not lost in what many of all
 * directions do together: TT is all that goes on, and what was scattered often keeps something of
 * its inclination. */
typedef struct {
  vf reflected, through, often;
} yarn_parts;

INLINE void yarn_parts_of(const fibertex_constants *w, const strand_angles *q, yarn_parts *r) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  vf round = clamp(q->round * inverse_root(q->squares), splat(-1.0f), one);
  vf ahead = vmax(splat(0.25f) - splat(0.5f) * round, zero);
  vf sharp = q->sharp, narrow = sharp * splat(0.25f);
  vf height = sharp * q->cosine;
  r->reflected = bell((q->sum - splat(w->tilt[0])) * narrow) * height * strand_mirror(w, round);
  r->through = bell((q->sum - splat(w->tilt[1])) * narrow) * height * (ahead * ahead);
  vf even = inverse_root(splat(w->even2) + q->spread);
  r->often = bell(q->sum * (even * splat(0.25f))) * even;
}

INLINE void yarn_amounts(const fibertex_constants *w, const yarn_parts *p, strand_lit *r) {
  r->white = splat(w->gloss[0] / (float)FIBERTEX_BELL) * p->reflected;
  r->onward = splat(2.82986f / (float)FIBERTEX_BELL) * p->through;
  r->glow = splat(w->gloss[1]) * r->onward;
  r->even = splat(w->even / (float)FIBERTEX_BELL) * p->often;
}

INLINE void strand_lobes_of_yarn(const fibertex_constants *w, const strand_angles *q,
                                 strand_lit *r) {
  yarn_parts p;
  yarn_parts_of(w, q, &p);
  yarn_amounts(w, &p, r);
  r->bulk = splat(0.0f);
}

#endif
