/* SPDX-License-Identifier: Apache-2.0
 *
 * What strands lie on: the hull, or the yarn of a cloth.
 */
#ifndef SOZAI_FIBERTEX_GROUND_H
#define SOZAI_FIBERTEX_GROUND_H

#include "cloth_parts.h"

#define RELIEF 0.5f       /* how much more or less a yarn's flank is lit or seen, at most */
#define FLOWN_WIDEST 2.6f /* how much broader strands that stand off look at a slant, at most */

/* What comes back after many strands: less of light that grazes, and to an eye that does, but
 * more of a thin shell, which is deeper at a slant. And what goes on through, which fades where
 * light grazes. */
INLINE void light_in_bulk(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  vf in = vmax(k->f.light[2], zero), out = vmax(k->f.view[2], zero);
  vf deep = splat(w->slab) * (k->inverse[0] + k->inverse[1]), most = deep * deep;
  vf slab = most / (most + splat(w->slab_linear) * deep + splat(w->slab_square));
  /* how a pile looks from one side and another is in its layers' shade: here the mean of all */
  vf x = one - in, y = w->pile ? splat(1.0f / 3.0f) : one - out;
  g->around = in * slab * (one - splat(w->graze) * (x + y) + splat(w->graze_both) * x * y);
  g->onward = in * in * splat(w->chain) / (in + splat(0.25f));
}

INLINE void ground_hull(const fibertex_constants *w, int light, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  for (int c = 0; c < 3; c++) {
    g->along[c] = c == 0 ? one : zero;
    g->across[c] = c == 1 ? one : zero;
    g->up[c] = c == 2 ? one : zero;
  }
  g->weft = g->level = zero;
  g->ambient = g->straight = g->solid = g->whole = one;
  g->around = g->onward = zero;
  if (light) light_in_bulk(w, k);
  g->place[0] = g->place[1] = zero;
  g->h = splatu(0);
}

/* How a face that leans by a tangent to either side of the cloth's is lit and seen. Where light
 * comes lower than the face leans, what one flank loses the other has more, and no more than
 * that: yarns shade one another. So the mean over a yarn is as its middle, and so is the eye's. */
INLINE void face_of(const block *k, const vf tip[2], face_light *o) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const vf *light = k->f.light, *lean = k->ground.lean;
  /* and where it grazes, much of it is lost between them */
  vf cosine = vmax(light[2], zero), in = cosine * cosine / (cosine + splat(0.045f));
  vf most = splat(RELIEF) * in;
  o->in = in + clamp(light[0] * tip[0] + light[1] * tip[1], zero - most, most);
  o->seen = one + clamp(lean[0] * tip[0] + lean[1] * tip[1], splat(-RELIEF), splat(RELIEF));
  o->out = o->seen * vmax(k->f.view[2], splat(0.05f));
}

/* What of straight light a thick body of strands sends back after meeting one: after Lommel and
 * Seeliger. */
INLINE vf face_lit(const face_light *f) { return f->in / vmax(f->in + f->out, splat(0.01f)); }

/* How the yarn and what stands off it are lit. */
INLINE void ground_light(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  vf deep = splat(w->slab) * (k->inverse[0] + k->inverse[1]);
  g->around = deep / (deep + splat(w->slab_linear)) * k->front;
  /* what stands off shades itself, where light grazes */
  vf in = vmax(k->f.light[2], zero);
  g->flown = in * splat(w->flown_gloss) / (in + splat(w->flown_deep + 1e-4f));
  vf steep = one / vmax(g->up[2], splat(0.05f));
  const vf tip[2] = {g->up[0] * steep, g->up[1] * steep};
  face_of(k, tip, &g->face);
}

STAGE void ground_cloth(const fibertex_constants *w, int light, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  cloth_hit q;
  vf x = k->f.lean2[0], y = k->f.lean2[1];
  vf most = vmin(inverse_root(vmax(x * x + y * y, splat(1e-6f))), one);
  g->lean[0] = x * most;
  g->lean[1] = y * most;
  vf wide[2], left = splat(w->gaps);
  for (int i = 0; i < 2; i++) {
    vf slant = g->lean[1 - i] * splat(w->yarn[i].edge);
    wide[i] = vsqrt(one + slant * slant);
    left = left *
           vmax(one - splat(w->yarn[i].half * 2.0f * w->yarn[i].inverse_spacing) * wide[i], zero);
  }
  g->whole = one - left;
  cloth_at(w, k->cloth.u, k->cloth.v, k->s, wide, &q);
  cloth_frame(w, &q, g->along, g->across, g->up);
  g->weft = q.share;
  g->ambient = q.ambient;
  g->around = g->onward = zero;
  if (light) ground_light(w, k);
  g->straight = one;
  g->place[0] = q.along;
  /* the way round an ellipse from its crest: nearly */
  g->place[1] = q.half * q.across * (one + splat(0.3f) * q.across * q.across);
  g->level = cloth_depth(w, q.top);
  g->solid = q.solid;
  vf tone = cloth_tone(w, q.h);
  g->ambient = g->ambient * tone;
  g->straight = g->straight * tone;
  g->h = q.h;
  g->own[0] = g->own[1] = one;
  ground_parts(w, wide, k);
}

#endif
