/* SPDX-License-Identifier: Apache-2.0
 *
 * What strands lie on: the hull, or the yarn of a cloth.
 */
#ifndef SOZAI_FIBERTEX_GROUND_H
#define SOZAI_FIBERTEX_GROUND_H

#include "block.h"

INLINE void ground_hull(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  for (int c = 0; c < 3; c++) {
    g->along[c] = c == 0 ? one : zero;
    g->across[c] = c == 1 ? one : zero;
    g->up[c] = c == 2 ? one : zero;
  }
  g->weft = g->level = zero;
  g->ambient = g->straight = g->solid = one;
  /* what comes back after many strands: less of light that grazes, and to an eye that does,
   * but more of a thin shell, which is deeper at a slant */
  vf in = vmax(k->f.light[2], zero), out = vmax(k->f.view[2], zero);
  vf deep = splat(w->slab) * (k->inverse[0] + k->inverse[1]), most = deep * deep;
  vf slab = most / (most + splat(w->slab_linear) * deep + splat(w->slab_square));
  vf x = one - in, y = one - out;
  g->around = in * slab * (one - splat(w->graze) * (x + y) + splat(w->graze_both) * x * y);
  /* what goes on through fades where light grazes */
  g->onward = in * in * splat(w->chain) / (in + splat(0.25f));
  g->place[0] = g->place[1] = zero;
  g->h = splatu(0);
}

/* How much of the straight light a yarn's flank lets its strands have. */
INLINE vf flank(vf up) { return clamp01(splat(0.25f) + splat(1.1f) * up); }

STAGE void ground_cloth(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  cloth_hit q;
  cloth_at(w, k->cloth.u, k->cloth.v, k->s, &q);
  cloth_frame(w, &q, g->along, g->across, g->up);
  g->weft = q.share;
  g->ambient = q.ambient;
  vf up = dot3(k->f.light, g->up);
  g->around = vmax(up, zero) * k->front;
  g->onward = zero;
  g->straight = flank(up);
  g->place[0] = q.along;
  /* the way round an ellipse from its crest: nearly */
  g->place[1] = q.half * q.across * (one + splat(0.3f) * q.across * q.across);
  g->level = splat(w->low) + one / splat(w->inverse_range) - q.top;
  g->solid = q.solid;
  vf tone = one + splat(w->yarn[0].tone) * field_of(q.h, 2);
  g->ambient = g->ambient * tone;
  g->straight = g->straight * tone;
  g->h = q.h;
}

#endif
