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
  vf white[2], glow[2], around[2], albedo[2], straight;
  vf bulk, onward; /* of an aggregate */
  vf flown;        /* of a cloth: what single strands that stand off a yarn show */
} looks;

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
  if (w->pile)
    wide = pile_widening_mean(w, &k->f.pile, k->f.lean2, w->layer[w->layers - 1].widen_most);
  vf left = one, lit = zero, ambient = zero, depth = zero, reach = k->front;
  vf step = zero;
  if (light) step = exp2_(splat(-1.442695f * w->step) * k->inverse_up);
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    vf mean = splat(c->mean);
    if (c->ends) mean = vmin(mean * vmin(wide, splat(c->widen_most)), splat(0.97f));
    vf share = left * mean;
    left = left - share;
    if (l == w->yarns_from) reach = k->reach;
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
  add_mean(w, out, (one - left + under) * k->ground.whole,
           (ambient + under * splat(w->deep_ambient)) * k->ground.whole,
           (lit + under * k->deep_lit) * k->ground.whole,
           (depth + under * splat(w->deep_depth)) * k->ground.whole);
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
