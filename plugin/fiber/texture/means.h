/* SPDX-License-Identifier: Apache-2.0
 *
 * What all strands together show: from afar, and what lies too deep to be told apart.
 */
#ifndef SOZAI_FIBERTEX_MEANS_H
#define SOZAI_FIBERTEX_MEANS_H

#include "ground.h"
#include "strand_light.h"

/* Of warp and weft (of an aggregate the first is all): what all directions together
 * show, and what reaches them. */
typedef struct {
  vf white[2], glow[2], bulk[2], around[2], albedo[2], straight, onward;
} looks;

INLINE void look_axes(const fibertex_look *o, strand_axes *t) {
  for (int c = 0; c < 3; c++) {
    t->along[c] = splat(o->along[c]);
    t->across[c] = splat(o->across[c]);
    t->up[c] = splat(o->up[c]);
  }
  t->across2 = splat(o->across2);
  t->up2 = splat(o->up2);
}

/* One of the directions that stand for all of a cloth's. */
INLINE void look_lit(const fibertex_constants *w, const fibertex_look *o, const block *k,
                     const strand_angles *a, looks *q) {
  strand_lit r;
  strand_axes t;
  look_axes(o, &t);
  strand_lobes(w, a, &r);
  int i = o->weft;
  vf up = dot3(t.up, k->f.light);
  vf around = vmax(up, splat(0.0f)) * k->front, share = splat(o->straight) * flank(up);
  q->around[i] = q->around[i] + splat(o->around) * around;
  q->glow[i] = q->glow[i] + share * r.glow;
  q->bulk[i] = q->bulk[i] + share * r.bulk;
  q->white[i] = q->white[i] + share * r.white;
  q->straight = q->straight + share;
}

STAGE void stage_looks(const fibertex_constants *w, const block *k, uint32_t blocks, int light,
                       looks *q) {
  const vf zero = splat(0.0f);
  EACH(b, blocks) {
    for (int i = 0; i < 2; i++) {
      q[b].white[i] = q[b].glow[i] = q[b].bulk[i] = q[b].around[i] = q[b].albedo[i] = zero;
    }
    q[b].straight = q[b].onward = zero;
  }
  for (int m = 0; m < w->looks; m++) {
    const fibertex_look *o = &w->look[m];
    int i = o->weft;
    EACH(b, blocks) q[b].albedo[i] = q[b].albedo[i] + splat(o->lit);
    if (!light) continue;
    strand_axes t;
    strand_angles a[BLOCKS_TOGETHER];
    look_axes(o, &t);
    EACH(b, blocks) strand_angles_of(k[b].f.light, k[b].f.view, k[b].f.between, &t, &a[b]);
    EACH(b, blocks) look_lit(w, o, &k[b], &a[b], &q[b]);
  }
}

/* Adds a density of strands: cover, with its ambient and its straight light. */
INLINE void add_mean(const fibertex_constants *w, sums *sum, vf cover, vf ambient, vf lit,
                     vf depth) {
  vf second = splat(w->second_share), first = splat(1.0f) - second;
  sum->left = sum->left - cover;
  sum->depth = sum->depth + depth;
  sum->albedo[0] = sum->albedo[0] + first * ambient;
  sum->albedo[1] = sum->albedo[1] + second * ambient;
  sum->direct[0] = sum->direct[0] + first * lit;
  sum->direct[1] = sum->direct[1] + second * lit;
  sum->bare = sum->bare + lit;
}

/* The layers' means over one another, and what lies deeper. */
STAGE void far_sums(const fibertex_constants *w, const block *k, int light, sums *out) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  /* widening's mean over all directions */
  vf x = vmin(k->f.lean2[0] * k->f.lean2[0] + k->f.lean2[1] * k->f.lean2[1], splat(3.5f));
  vf wide = one + x * (splat(0.24f) + x * (splat(-0.03225f) + x * splat(0.00266f)));
  vf left = one, lit = zero, ambient = zero, depth = zero, reach = k->front;
  vf step = exp2_(splat(-1.442695f * w->step) * k->inverse_up);
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    vf mean = splat(c->mean);
    if (c->ends) mean = vmin(mean * vmin(wide, splat(c->widen_most)), splat(0.97f));
    vf share = left * mean;
    left = left - share;
    if (light) {
      lit = lit + share * reach;
      reach = reach * step;
      step = step * k->step[1];
    }
    ambient = ambient + share * splat(c->ambient);
    depth = depth + share * splat(c->depth);
  }
  vf under = left * splat(w->deep);
  out->left = one;
  out->bare = out->depth = zero;
  for (int i = 0; i < 2; i++) out->albedo[i] = out->direct[i] = zero;
  add_mean(w, out, (one - left + under) * splat(w->solid),
           (ambient + under * splat(w->deep_ambient)) * splat(w->solid),
           (lit + under * k->deep_lit) * splat(w->solid),
           (depth + under * splat(w->deep_depth)) * splat(w->solid));
}

/* What is below the layers, seen between their strands. */
INLINE void stage_deep(const fibertex_constants *w, block *k) {
  k->sum.bare = k->sum.direct[0];
  k->sum.albedo[0] = k->sum.albedo[0] - k->sum.albedo[1];
  k->sum.direct[0] = k->sum.direct[0] - k->sum.direct[1];
  vf under = k->sum.left * splat(w->deep), shaded = under * k->shade;
  add_mean(w, &k->sum, under, shaded * splat(w->deep_ambient), shaded * k->deep_lit,
           under * (splat(w->deep_depth) + k->ground.level));
  k->sum.left = k->sum.left + k->hole;
}

#endif
