/* SPDX-License-Identifier: Apache-2.0
 *
 * From sums over layers to what is seen, of each of the palette.
 */
#ifndef SOZAI_FIBERTEX_SHOWN_H
#define SOZAI_FIBERTEX_SHOWN_H

#include "means.h"

/* What a point's sums come to, of each of the palette. */
typedef struct {
  vf cover, depth, white;
  vf albedo[FIBERTEX_COLOURS], glow[FIBERTEX_COLOURS], bulk[FIBERTEX_COLOURS];
} shown;

/* From afar: by the means of all directions. */
INLINE void show_far(const fibertex_constants *w, int woven, const block *k, const sums *s,
                     const looks *q, shown *o) {
  o->cover = splat(1.0f) - s->left;
  o->depth = s->depth;
  o->white = s->bare * (q->white[0] + q->white[1]);
  vf often[2], albedo[2], glow[2];
  for (int i = 0; i < 2; i++) {
    vf own = woven ? k->ground.own[i] : splat(1.0f);
    often[i] = splat(w->multiple) * q->around[i] * own;
    albedo[i] = q->albedo[i] * own;
    glow[i] = q->glow[i] * own;
  }
  o->albedo[COLOUR_FIRST] = s->albedo[0] * albedo[0];
  o->albedo[COLOUR_WEFT] = s->albedo[0] * albedo[1];
  o->albedo[COLOUR_SECOND] = s->albedo[1] * (albedo[0] + albedo[1]);
  o->glow[COLOUR_FIRST] = s->direct[0] * glow[0];
  o->glow[COLOUR_WEFT] = s->direct[0] * glow[1];
  o->glow[COLOUR_SECOND] = s->direct[1] * (glow[0] + glow[1]);
  o->bulk[COLOUR_FIRST] = s->albedo[0] * often[0];
  o->bulk[COLOUR_WEFT] = s->albedo[0] * often[1];
  o->bulk[COLOUR_SECOND] = s->albedo[1] * (often[0] + often[1]);
  if (woven) return; /* what goes through one of its strands goes out */
  vf onward = q->onward * k->ground.onward;
  o->glow[COLOUR_FIRST] = o->glow[COLOUR_FIRST] + s->albedo[0] * onward;
  o->glow[COLOUR_SECOND] = o->glow[COLOUR_SECOND] + s->albedo[1] * onward;
  o->bulk[COLOUR_FIRST] = o->bulk[COLOUR_FIRST] + s->direct[0] * q->bulk;
  o->bulk[COLOUR_SECOND] = o->bulk[COLOUR_SECOND] + s->direct[1] * q->bulk;
}

/* The strand that is seen: its axes in the hull's frame. */
INLINE void best_axes(const fibertex_constants *w, int woven, const block *k, strand_axes *t) {
  const vf one = splat(1.0f), zero = splat(0.0f);
  const ground *g = &k->ground;
  vf slope = k->best.slope, lost = one - k->best.detail;
  vf rise =
      splat(w->lean) + splat(w->rise * FIELD(1.0f)) * field_of(k->best.id, 2) * k->best.detail;
  if (!woven && w->nap > 0.0f) rise = rise * k->f.pile.over;
  vf flat = inverse_root(one + slope * slope), steep = inverse_root(one + rise * rise);
  vf x = (k->best.direction[0] - slope * k->best.direction[1]) * flat;
  vf y = (k->best.direction[1] + slope * k->best.direction[0]) * flat;
  if (woven) {
    /* what stands off lies on the hull */
    vm flown = lt(splat(0.5f), k->best.flown);
    for (int c = 0; c < 3; c++) {
      vf along = sel(flown, splat(c == 0 ? 1.0f : 0.0f), g->along[c]);
      vf across = sel(flown, splat(c == 1 ? 1.0f : 0.0f), g->across[c]);
      vf up = sel(flown, splat(c == 2 ? 1.0f : 0.0f), g->up[c]);
      vf level = x * along + y * across;
      t->along[c] = (level + rise * up) * steep;
      t->across[c] = x * across - y * along;
      t->up[c] = (up - rise * level) * steep;
    }
  } else {
    vf up = rise * steep;
    t->along[0] = x * steep;
    t->along[1] = y * steep;
    t->along[2] = up;
    t->across[0] = zero - y;
    t->across[1] = x;
    t->across[2] = zero;
    t->up[0] = zero - up * x;
    t->up[1] = zero - up * y;
    t->up[2] = steep;
  }
  t->across2 = lost * splat(w->scatter);
  t->up2 = lost * splat(w->scatter_up);
}

/* How much of what has gone on through many strands keeps the last one's lobe: the less, the
 * better a footprint's mean stands for its strands. */
#define ONWARD_LAST 0.5f

/* Of a cloth the first colour is the warp's, or the weft's is in its place. */
INLINE void give_colours(int woven, const block *k, vf first, vf second, vf out[]) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf a = vmax(first, zero);
  out[COLOUR_SECOND] = vmax(second, zero);
  out[COLOUR_FIRST] = woven ? a * (one - k->ground.weft) : a;
  out[COLOUR_WEFT] = woven ? a * k->ground.weft : zero;
}

/* What one strand shows beyond its means, given to the colours; second: its share of the second. */
INLINE void share_out(int woven, const block *k, vf mean, vf change, vf second, const vf often[2],
                      vf out[]) {
  const sums *s = &k->sum;
  vf b = change * second, a = s->direct[0] * mean + (change - b);
  b = s->direct[1] * mean + b;
  if (woven) {
    a = a * k->ground.straight;
    b = b * k->ground.straight;
  }
  give_colours(woven, k, a + often[0], b + often[1], out);
}

/* What a strand of a yarn shows, or one that stands off it: from its lobes. around: what comes
 * back of what is scattered often; given without the yarn's face. */
INLINE void yarn_lit(const fibertex_constants *w, const block *k, const looks *q, strand_lit *r,
                     vf *around) {
  const vf one = splat(1.0f);
  const ground *g = &k->ground;
  vf share = g->face.seen * q->straight, lit = share * face_lit(&g->face);
  vf flown = k->best.flown * k->best.detail, yarn = one - flown;
  r->white = r->white * lit * yarn;
  r->glow = r->onward * (splat(w->gloss[1]) * lit * yarn + g->flown * flown);
  r->glow = r->glow + q->flown * yarn;
  *around = *around * (g->face.in * g->up[2] * r->even * share) * g->ambient;
}

/* Near: by the strand that is seen; what else is there by the means. */
INLINE void show_near(const fibertex_constants *w, int woven, const block *k, const looks *q,
                      const strand_axes *t, const strand_lit *lobes, int light, shown *o) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const ground *g = &k->ground;
  const sums *s = &k->sum;
  o->cover = one - s->left;
  o->depth = s->depth;
  for (int i = 0; i < FIBERTEX_COLOURS; i++) o->albedo[i] = o->glow[i] = o->bulk[i] = zero;
  o->albedo[COLOUR_FIRST] = s->albedo[0];
  o->albedo[COLOUR_SECOND] = s->albedo[1];
  if (woven) {
    vf first = s->albedo[0] * g->ambient;
    o->albedo[COLOUR_FIRST] = first * (one - g->weft);
    o->albedo[COLOUR_WEFT] = first * g->weft;
    o->albedo[COLOUR_SECOND] = s->albedo[1] * g->ambient;
  }
  o->white = zero;
  if (!light) return;
  vf white = q->white[0], glow = q->glow[0], bulk = q->bulk;
  if (woven) {
    white = white + q->white[1];
    glow = glow + q->glow[1];
  }
  /* a strand is brighter on the side that the light is on */
  vf facing = k->best.across * dot3(t->across, k->f.light), side = one + splat(0.6f) * facing;
  /* what chance gave it; of what is a mean the mean's */
  vf detail = k->best.detail;
  vf second = zero;
  if (w->second_chance) {
    second = sel(lane_first(w, k->best.id), zero, detail) + splat(w->second_share) * (one - detail);
  }
  vf part = k->most - k->next, lit = part * k->best.bare;
  vf around = splat(w->multiple) * g->around;
  strand_lit r = *lobes;
  if (woven)
    yarn_lit(w, k, q, &r, &around);
  else
    around = around * (one + splat(0.25f) * part * facing);
  const vf often[2] = {s->albedo[0] * around, s->albedo[1] * around};
  if (woven) {
    const vf none[2] = {zero, zero};
    share_out(woven, k, glow, lit * (r.glow * side - glow), second, none, o->glow);
    give_colours(woven, k, often[0], often[1], o->bulk);
  } else {
    /* the last of the strands that it went through is the one that is seen */
    vf last = (q->onward + splat(ONWARD_LAST) * part * (r.onward - q->onward)) * g->onward;
    const vf onward[2] = {s->albedo[0] * last, s->albedo[1] * last};
    share_out(woven, k, glow, lit * (r.glow * side - glow), second, onward, o->glow);
    share_out(woven, k, bulk, lit * (r.bulk * side - bulk), second, often, o->bulk);
  }
  o->white = s->bare * white + lit * (r.white - white);
  if (woven) o->white = o->white * g->straight;
  o->white = vmax(o->white, zero);
}

INLINE void blend(shown *a, const shown *b, vf far, int woven, int light) {
  vm some = gt(far, splat(0.0f)), all = le(splat(1.0f), far);
  vf near = splat(1.0f) - far;
#define BLEND_(x) a->x = sel(some, sel(all, b->x, a->x * near + b->x * far), a->x)
  BLEND_(cover);
  BLEND_(depth);
  const int colours = woven ? FIBERTEX_COLOURS : COLOUR_WEFT;
  for (int i = 0; i < colours; i++) BLEND_(albedo[i]);
  if (!light) return;
  BLEND_(white);
  for (int i = 0; i < colours; i++) {
    BLEND_(glow[i]);
    BLEND_(bulk[i]);
  }
#undef BLEND_
}

#endif
