/* SPDX-License-Identifier: Apache-2.0
 *
 * Pile: strands that stand out of the surface. What lies side by side is seen, and met by light, as
 * the sine of the angle between it and the ray has it (Jakob et al., A radiative transfer framework
 * for rendering materials with anisotropic structure, SIGGRAPH 2010, section 5): an eye that looks
 * along a pile looks deep into it, where little light comes to, and one that grazes it sees its
 * lit tips.
 */
#ifndef SOZAI_FIBERTEX_PILE_H
#define SOZAI_FIBERTEX_PILE_H

#include "../../core/maths.h"
#include "texture.h"

/* How narrow strands look along themselves, squared: none is quite straight. */
#define PILE_LEAST2 0.05f

/* How a pile leans at a place. */
typedef struct {
  vf lean, steep2; /* tangent of its elevation: mean, mean square */
  vf flat2;        /* what of a strand is seen squarely, over what is in the mean, squared */
  vf up, out;      /* cosine and sine of the mean elevation */
  vf over;         /* tangents, over the mean's */
} pile_lean;

INLINE void pile_lean_of(const fibertex_constants *w, vf over, pile_lean *p) {
  const vf one = splat(1.0f);
  p->over = over;
  p->lean = splat(w->lean) * over;
  p->steep2 = splat(w->steep2) * (over * over);
  p->flat2 = splat(1.0f + w->steep2) / (one + p->steep2);
  p->up = inverse_root(one + p->lean * p->lean);
  p->out = p->lean * p->up;
}

/* How broad strands look by a ray of tangents lean2 to the surface's axes, over what they are in
 * the mean and squarely. They lean to (co, si): the root of the mean square, of the sine between
 * strand and ray over the ray's cosine. */
INLINE vf pile_widening(const pile_lean *p, const vf lean2[2], vf co, vf si, float most) {
  const vf one = splat(1.0f);
  vf a = lean2[0] * co + lean2[1] * si, b = lean2[1] * co - lean2[0] * si;
  vf x = a * (a * p->steep2 - (p->lean + p->lean)) + b * b * (one + p->steep2);
  return vsqrt(clamp((x + one) * p->flat2, splat(PILE_LEAST2), splat(most * most)));
}

/* Its mean over the directions that stand for all. */
INLINE vf pile_widening_mean(const fibertex_constants *w, const pile_lean *p, const vf lean2[2],
                             float most) {
  vf sum = splat(0.0f);
  for (int m = 0; m < w->looks / 2; m++) {
    const fibertex_look *o = &w->look[m];
    vf co = splat(o->across[1]), si = splat(o->across[0]);
    sum = sum + pile_widening(p, lean2, co, si, most);
    sum = sum + pile_widening(p, lean2, co, splat(0.0f) - si, most);
  }
  return sum * splat(1.0f / (float)w->looks);
}

#endif
