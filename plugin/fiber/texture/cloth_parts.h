/* SPDX-License-Identifier: Apache-2.0
 *
 * What yarns show of a footprint that is a good part of one, or holds some of them: the mean of
 * parts of it. Which yarn is on top and how deep its shade is change too much from place to place
 * for the middle to stand for all.
 */
#ifndef SOZAI_FIBERTEX_CLOTH_PARTS_H
#define SOZAI_FIBERTEX_CLOTH_PARTS_H

#include "block.h"

/* Means over the parts. */
typedef struct {
  vf seen[2]; /* of warp and weft: what is seen of them, in its shade */
  vf ambient, weft, straight;
  vf solid, top;
} yarn_shows;

/* The parts' middles, in parts; n: to a side. How the footprint lies is not said: it is taken as
 * halfway between square with the yarns and diagonal. */
INLINE void parts_mean(const fibertex_constants *w, int n, const vf wide[2], const block *k,
                       yarn_shows *o) {
  const vf zero = splat(0.0f);
  const float co = 0.92387953f, si = 0.38268343f, middle = 0.5f * (float)(n - 1);
  const vf s = k->s * splat(1.0f / (float)n);
  yarn_shows sum = {{zero, zero}, zero, zero, zero, zero, zero};
  ROLLED for (int i = 0; i < n * n; i++) {
    float x = (float)(i % n) - middle, y = (float)(i / n) - middle;
    cloth_hit q;
    cloth_at(w, k->cloth.u + s * splat(co * x - si * y), k->cloth.v + s * splat(si * x + co * y), s,
             wide, &q);
    vf tone = cloth_tone(w, q.h), lit = q.ambient * tone;
    vf weft = lit * q.share;
    sum.ambient = sum.ambient + lit;
    sum.weft = sum.weft + weft;
    sum.seen[0] = sum.seen[0] + q.solid * (lit - weft);
    sum.seen[1] = sum.seen[1] + q.solid * weft;
    sum.straight = sum.straight + tone;
    sum.solid = sum.solid + q.solid;
    sum.top = sum.top + q.top;
  }
  const vf each = splat(1.0f / (float)(n * n));
  for (int i = 0; i < 2; i++) o->seen[i] = sum.seen[i] * each;
  o->ambient = sum.ambient * each;
  o->weft = sum.weft * each;
  o->straight = sum.straight * each;
  o->solid = sum.solid * each;
  o->top = sum.top * each;
}

/* b itself where share is 1: then a may not have been looked at. */
INLINE vf part_mix(vf share, vf a, vf b) {
  return sel(lt(share, splat(1.0f)), mix(a, b, share), b);
}

/* 2 x 2 parts, or 3 x 3 where the footprint holds whole yarns. */
INLINE void parts_of(const fibertex_constants *w, vm inside, const vf wide[2], const block *k,
                     yarn_shows *o) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const fibertex_parts *p = &w->parts;
  yarn_shows more = {{zero, zero}, zero, zero, zero, zero, zero};
  *o = more;
  vf finer = smooth_step(splat(p->finer[0]), splat(p->finer[1]), k->s);
  if (any(and_(inside, lt(finer, one)))) parts_mean(w, 2, wide, k, o);
  if (!any(and_(inside, gt(finer, zero)))) return;
  parts_mean(w, 3, wide, k, &more);
  for (int i = 0; i < 2; i++) o->seen[i] = part_mix(finer, o->seen[i], more.seen[i]);
  o->ambient = part_mix(finer, o->ambient, more.ambient);
  o->weft = part_mix(finer, o->weft, more.weft);
  o->straight = part_mix(finer, o->straight, more.straight);
  o->solid = part_mix(finer, o->solid, more.solid);
  o->top = part_mix(finer, o->top, more.top);
}

/* In place of what the middle has, and of the mean of all cloth. */
STAGE void ground_parts(const fibertex_constants *w, const vf wide[2], block *k) {
  const vf one = splat(1.0f);
  const fibertex_parts *p = &w->parts;
  ground *g = &k->ground;
  vm inside = and_(gt(k->s, splat(p->near[0])), lt(k->s, splat(p->far[1])));
  if (!any(inside)) return;
  yarn_shows q;
  parts_of(w, inside, wide, k, &q);
  vf share = smooth_step(splat(p->near[0]), splat(p->near[1]), k->s);
#define PART_(x, y) x = sel(inside, part_mix(share, x, y), x)
  PART_(g->weft, q.weft / vmax(q.ambient, splat(1e-6f)));
  PART_(g->ambient, q.ambient);
  PART_(g->straight, q.straight);
  PART_(g->solid, q.solid);
  PART_(g->level, cloth_depth(w, q.top));
#undef PART_
  /* over the mean of what that direction's yarns show: from afar all that is told of it */
  vf told = share * (one - smooth_step(splat(p->far[0]), splat(p->far[1]), k->s));
  vf still = one - told;
  vf yarn = told / vmax(q.solid, splat(1e-6f));
  for (int i = 0; i < 2; i++) {
    g->own[i] = sel(inside, still + yarn * (q.seen[i] * splat(p->inverse_mean[i])), one);
  }
  g->whole = sel(inside, g->whole + told * (q.solid - g->whole), g->whole);
}

#endif
