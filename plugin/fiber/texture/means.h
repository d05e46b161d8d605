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
  vf flown; /* what single strands that stand off a yarn show */
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

/* One of the directions that stand for all. */
INLINE void look_lit(const fibertex_constants *w, const fibertex_look *o, const block *k,
                     const strand_angles *a, looks *q) {
  strand_lit r;
  strand_lobes(w, a, &r);
  /* strands across the view's slant look broader, and are more of what is seen */
  vf share = splat(o->share) *
             widening(k->f.lean2[0] * splat(o->across[0]) + k->f.lean2[1] * splat(o->across[1]),
                      w->layer[w->layers - 1].widen_most);
  q->onward = q->onward + share * r.onward;
  q->around[0] = q->around[0] + splat(o->share) * k->ground.around;
  q->glow[0] = q->glow[0] + share * r.glow;
  q->bulk[0] = q->bulk[0] + share * r.bulk;
  q->white[0] = q->white[0] + share * r.white;
  q->straight = q->straight + share;
}

/* The same of a cloth: one of the faces that stand for a yarn's, or of what stands off it. */
INLINE void look_woven(const fibertex_constants *w, const fibertex_look *o, const block *k,
                       const strand_angles *a, looks *q) {
  strand_lit r;
  strand_lobes_of_yarn(w, a, &r);
  int i = o->weft;
  if (o->flown) {
    vf share = splat(o->share) *
               widening(k->f.lean2[0] * splat(o->across[0]) + k->f.lean2[1] * splat(o->across[1]),
                        FLOWN_WIDEST);
    q->flown = q->flown + share * r.onward;
    return;
  }
  vf tip[2] = {splat(o->tip[0]), splat(o->tip[1])};
  face_light f;
  face_of(k, tip, &f);
  vf share = splat(o->share) * f.seen;
  vf lit = share * face_lit(&f);
  q->around[i] = q->around[i] + splat(o->lit * o->up[2]) * f.seen * f.in * r.even;
  q->glow[i] = q->glow[i] + lit * r.glow;
  q->white[i] = q->white[i] + lit * r.white;
  q->straight = q->straight + share;
}

/* Over all of them. */
INLINE void looks_woven(const fibertex_constants *w, const block *k, looks *q) {
  q->straight = splat(1.0f) / q->straight;
  vf yarn = splat(1.0f - w->flown) * q->straight;
  q->flown = q->flown * k->ground.flown;
  vf flown = q->flown * splat(w->flown);
  q->flown = q->flown * splat(w->hair * (1.0f - w->flown));
  const vf share[2] = {splat(w->warp_share), splat(1.0f - w->warp_share)};
  for (int i = 0; i < 2; i++) {
    q->around[i] = q->around[i] * q->straight * k->ground.around;
    q->white[i] = q->white[i] * yarn;
    q->glow[i] = q->glow[i] * yarn + (flown + q->flown) * share[i];
  }
}

STAGE void stage_looks(const fibertex_constants *w, int woven, const block *k, uint32_t blocks,
                       int light, looks *q) {
  const vf zero = splat(0.0f);
  EACH(b, blocks) {
    for (int i = 0; i < 2; i++) {
      q[b].white[i] = q[b].glow[i] = q[b].bulk[i] = q[b].around[i] = q[b].albedo[i] = zero;
    }
    q[b].straight = q[b].onward = q[b].flown = zero;
  }
  for (int m = 0; m < w->looks; m++) {
    const fibertex_look *o = &w->look[m];
    int i = woven ? o->weft : 0;
    if (!o->flown) EACH(b, blocks) q[b].albedo[i] = q[b].albedo[i] + splat(o->lit);
    if (!light) continue;
    strand_axes t;
    strand_angles a[BLOCKS_TOGETHER];
    look_axes(o, &t);
    EACH(b, blocks) strand_angles_of(k[b].f.light, k[b].f.view, k[b].f.between, &t, &a[b]);
    if (woven)
      EACH(b, blocks) look_woven(w, o, &k[b], &a[b], &q[b]);
    else
      EACH(b, blocks) look_lit(w, o, &k[b], &a[b], &q[b]);
  }
  if (!light) return;
  if (woven) {
    EACH(b, blocks) looks_woven(w, &k[b], &q[b]);
    return;
  }
  EACH(b, blocks) {
    vf inverse = splat(1.0f) / q[b].straight;
    q[b].glow[0] = q[b].glow[0] * inverse;
    q[b].bulk[0] = q[b].bulk[0] * inverse;
    q[b].white[0] = q[b].white[0] * inverse;
    q[b].onward = q[b].onward * inverse;
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
  vf under = k->sum.left * splat(w->deep), shaded = under * k->shade;
  add_mean(w, &k->sum, under, shaded * splat(w->deep_ambient), shaded * k->deep_lit,
           under * (splat(w->deep_depth) + k->ground.level));
  k->sum.left = k->sum.left + k->hole;
}

#endif
