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

#include "../../core/maths.h"
#include "texture.h"

/* max(0, 1 - q/8)^8, which is e^-q nearly, over 2.396 sigma: a bell's density.
 * k: 1 / sigma. */
INLINE vf bell(vf x, vf k) {
  vf z = x * k;
  vf q = vmax(splat(1.0f) - z * z * splat(1.0f / 16.0f), splat(0.0f));
  q = q * q;
  q = q * q;
  q = q * q;
  return q * k * splat(1.0f / 2.39628f);
}

/* A strand's axes: along it, across it in the ground, and out of that; and the
 * variances of the angles by which what it stands for strays across and out. */
typedef struct {
  vf along[3], across[3], up[3];
  vf across2, up2;
} strand_axes;

INLINE vf strand_dot(const vf a[3], const vf b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Radiance of a strand under light of irradiance pi: white; of what went through; of what
 * was scattered within. And the lobe of what goes on through. */
typedef struct {
  vf white, glow, bulk, onward;
  vf even; /* cloth: what comes back of light that was scattered often, the mean 1 */
} strand_lit;

/* What of it does not wait for a root. */
typedef struct {
  vf sum, spread, round, squares, cosine;
} strand_angles;

INLINE void strand_angles_of(const vf light[3], const vf view[3], vf between, const strand_axes *t,
                             strand_angles *q) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  vf shrink = one - splat(0.5f) * (t->across2 + t->up2);
  vf sl = strand_dot(t->along, light) * shrink, sv = strand_dot(t->along, view) * shrink;
  vf la = strand_dot(t->across, light), va = strand_dot(t->across, view);
  vf lu = strand_dot(t->up, light), vu_ = strand_dot(t->up, view);
  vf a = t->across2 * la, u = t->up2 * lu;
  vf sl2 = a * la + u * lu, sv2 = t->across2 * (va * va) + t->up2 * (vu_ * vu_);
  vf both = a * va + u * vu_;
  q->spread = sl2 + sv2 + both + both;
  vf x = sl * sl;
  q->squares = vmax(one - x - sl2, splat(0.01f)) * vmax(one - sv * sv - sv2, splat(0.01f));
  q->round = between - sl * sv - both;
  q->sum = sl + sv;
  /* the cosine of the inclination, as a polynomial of its sine: its mean is known */
  vf fourth = x * x + splat(6.0f) * x * sl2 + splat(3.0f) * sl2 * sl2;
  q->cosine = vmax(splat(0.985f) - splat(0.3f) * (x + sl2) - splat(0.55f) * fourth, zero);
}

INLINE void strand_lobes(const fibertex_constants *w, const strand_angles *q, strand_lit *r) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  vf round = clamp(q->round * inverse_root(q->squares), splat(-1.0f), one);
  vf ahead = vmax(splat(0.25f) - splat(0.5f) * round, zero);
  /* one variance; the other lobes' bells are R's by a factor */
  vf sharp = inverse_root(splat(w->beta2) + q->spread);
  vf lobe[3];
  for (int i = 0; i < 3; i++) {
    lobe[i] = bell(q->sum - splat(w->tilt[i]), sharp * splat(w->sharp[i]));
  }
  /* azimuthal parts: over all round each is 1 / 2 pi; times pi for the irradiance */
  vf reflected = (one + round) * splat(0.5f) * q->cosine;
  r->onward = lobe[1] * (ahead * ahead) * splat(2.82986f) * q->cosine;
  r->white = splat(w->gloss[0]) * lobe[0] * reflected;
  r->glow = splat(w->gloss[1]) * r->onward + splat(w->gloss[2]) * lobe[2] * reflected;
  r->bulk = splat(w->single) * q->cosine;
}

/* Of a yarn. Its strands lie side by side, so that what they do is not lost in what many of all
 * directions do together: what glances off is brighter than what is met squarely (Schlick), TT is
 * all that goes on, and what was scattered often keeps something of its inclination. */
INLINE void strand_lobes_of_yarn(const fibertex_constants *w, const strand_angles *q,
                                 strand_lit *r) {
  const vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f);
  vf round = clamp(q->round * inverse_root(q->squares), splat(-1.0f), one);
  vf ahead = vmax(splat(0.25f) - half * round, zero);
  vf sharp = inverse_root(splat(w->beta2) + q->spread);
  vf square = vsqrt(half + half * round), aside = one - square, aside2 = aside * aside;
  vf mirror = splat(w->mirror) + splat(1.0f - w->mirror) * (aside2 * aside2 * aside);
  vf reflected = bell(q->sum - splat(w->tilt[0]), sharp) * q->cosine * square;
  r->white = splat(w->gloss[0]) * mirror * reflected;
  r->onward = bell(q->sum - splat(w->tilt[1]), sharp) * (ahead * ahead) * splat(2.82986f);
  r->onward = r->onward * q->cosine;
  r->glow = splat(w->gloss[1]) * r->onward;
  r->even = splat(w->even) * bell(q->sum, inverse_root(splat(w->even2) + q->spread));
  r->bulk = zero;
}

#endif
