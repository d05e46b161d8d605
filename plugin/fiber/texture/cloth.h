/* SPDX-License-Identifier: Apache-2.0
 *
 * Cloth: which yarn is on top, and where on it the point lies. A yarn's middle
 * goes up and down from crossing to crossing; its section is an ellipse.
 *
 * Cloth is laid on the object from three sides, each face from the one that it
 * faces most.
 */
#ifndef SOZAI_FIBERTEX_CLOTH_H
#define SOZAI_FIBERTEX_CLOTH_H

#include "bundle.h"

/* Where the warp lies on the surface. */
typedef struct {
  vf u, v;    /* along the frame's first axis, which is the warp, and its second: mm */
  vf axis[3]; /* the warp's */
} cloth_place;

INLINE void cloth_axes(const fibertex_constants *w, const vf n[3], const vf at[3], cloth_place *p,
                       vf other[3]) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf a[3] = {vabs(n[0]), vabs(n[1]), vabs(n[2])};
  vm z = and_(le(a[0], a[2]), le(a[1], a[2])), y = and_(not_(z), le(a[0], a[1]));
  /* the face's two axes: the warp's is the one asked for, or the next */
  int32_t i = w->axis_index;
  vf face[3] = {sel(or_(z, y), zero, one), sel(y, one, zero), sel(z, one, zero)};
  vm swap = gt(face[i], zero);
  p->u = sel(swap, at[(i + 1) % 3], at[i]);
  for (int c = 0; c < 3; c++) {
    p->axis[c] = zero;
    other[c] = zero;
  }
  p->axis[i] = sel(swap, zero, one);
  p->axis[(i + 1) % 3] = sel(swap, one, zero);
  p->v = zero;
  for (int c = 0; c < 3; c++) {
    other[c] = one - face[c] - p->axis[c];
    p->v = p->v + other[c] * at[c];
  }
}

typedef struct {
  vm weft;          /* on top */
  vm on;            /* there is yarn at the point itself */
  vf share;         /* of weft, within the footprint */
  vf solid;         /* 1 where there is yarn, 0 in a hole */
  vf along, across; /* mm along the yarn; -1 to 1 across it */
  vf half;
  vf slope; /* of its middle, upwards */
  vf bend;  /* of its strands, to the side of across */
  vf top;   /* height of its face, mm, about the cloth's middle */
  vf ambient;
  vu h;
} cloth_hit;

/* 1 where the warp is on top, else -1. */
INLINE vf cloth_over(const fibertex_constants *w, vi i, vi j) {
  vi key = (i >> w->pair) * splati(w->shift) + (j >> w->pair), whole;
  vf k = to_float(key);
  vf part = k - vfloor((k + splat(0.5f)) * splat(w->inverse_repeat), &whole) * splat(w->repeat);
  return sel(lt(part, splat((float)w->over - 0.5f)), splat(1.0f), splat(-1.0f));
}

/* Where the mine-th yarn is at a place along it. */
typedef struct {
  vf middle, climb; /* how high: 1 on top, -1 below; of that in a mm */
  vf aside, bend;   /* of its straight way: mm, and the slope */
  vf uneven, widen; /* how much broader than the mean, relatively; of that in a mm */
} cloth_way;

INLINE cloth_way cloth_way_of(const fibertex_constants *w, int which, vi mine, vf at, vu h) {
  const fibertex_yarn *y = &w->yarn[which], *x = &w->yarn[1 - which];
  const vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  cloth_way o;
  vi next;
  vf t = at * splat(x->inverse_spacing) - half;
  vf f = t - vfloor(t, &next);
  vf a, b;
  if (which == 0) {
    a = cloth_over(w, mine, next);
    b = cloth_over(w, mine, next + splati(1));
  } else {
    a = zero - cloth_over(w, next, mine);
    b = zero - cloth_over(w, next + splati(1), mine);
  }
  o.middle = a + (b - a) * f * f * (splat(3.0f) - splat(2.0f) * f);
  o.climb = splat(6.0f * x->inverse_spacing) * (b - a) * f * (one - f);
  vf rate;
  o.aside = wave(at * splat(y->course) + phase_of(h << 9), y->sway, &rate);
  o.bend = rate * splat(y->course);
  vf slub = wave(at * splat(y->frequency) + phase_of(h), y->wander, &rate);
  /* what floats spreads, what dives is pressed by its neighbours */
  o.uneven = slub + splat(y->swell) * o.middle;
  o.widen = rate * splat(y->frequency) + splat(y->swell) * o.climb;
  return o;
}

#define CLOTH_BESIDE 1024.0f /* mm: more than any cloth is high */

/* The mine-th yarn's face at a point: `at` along it, `off` from its middle, in spacings. */
INLINE void cloth_yarn(const fibertex_constants *w, int which, vi mine, vf at, vf off, vf s,
                       vf wide, cloth_hit *q) {
  const fibertex_yarn *y = &w->yarn[which];
  const vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  q->h = hash_mix((vu)mine * splatu(HASH_X) + splatu(w->seed + (uint32_t)which));
  cloth_way way = cloth_way_of(w, which, mine, at, q->h);
  q->slope = splat(y->rise) * way.climb;
  vf width = (one + way.uneven) * wide;
  q->half = splat(y->half) * width;
  q->across = (off * splat(y->spacing) - way.aside) * splat(y->inverse_half) / width;
  q->bend = way.bend + q->across * splat(y->half) * way.widen;
  vf rest = one - q->across * q->across;
  q->on = gt(rest, zero);
  q->solid = sel(q->on, one, zero);
  /* of a footprint, the share that lies on the yarn; what is wider than from one yarn to the
   * next has as much as that */
  const vf least = splat(1e-4f); /* mm: less than that and rounding is most of it */
  vf box = vmin(vmax(s, least), splat(y->spacing));
  vf from_middle = vabs(q->across) * q->half, to = vmin(from_middle + half * box, q->half);
  vf part = clamp01((to - vmax(from_middle - half * box, zero - q->half)) / box);
  q->solid = sel(gt(s, least), part, q->solid);
  /* what lies beside the point is seen of the footprint where nothing is at the point itself */
  vf face =
      splat(y->over) + splat(y->rise) * way.middle + splat(y->height) * vsqrt(vmax(rest, zero));
  q->top = face - sel(q->on, zero, splat(CLOTH_BESIDE));
  q->across = clamp(q->across, splat(-1.0f), one);
  q->along = at;
}

#define CLOTH_SEL_(x) r.x = sel(m, b->x, a->x)
INLINE cloth_hit cloth_higher(const cloth_hit *a, const cloth_hit *b) {
  cloth_hit r;
  vm m = lt(a->top, b->top);
  CLOTH_SEL_(along);
  CLOTH_SEL_(across);
  CLOTH_SEL_(half);
  CLOTH_SEL_(slope);
  CLOTH_SEL_(bend);
  CLOTH_SEL_(top);
  r.on = or_(a->on, b->on);
  r.solid = splat(1.0f) - (splat(1.0f) - a->solid) * (splat(1.0f) - b->solid);
  r.h = (vu)seli(m, (vi)b->h, (vi)a->h);
  r.weft = a->weft;
  r.share = r.ambient = splat(0.0f);
  return r;
}
#undef CLOTH_SEL_

/* Of one direction's yarns the higher of the two nearest: what floats spreads over
 * its neighbours. */
INLINE cloth_hit cloth_yarns(const fibertex_constants *w, int which, vf at, vf off, vf s, vf wide) {
  const vf half = splat(0.5f), one = splat(1.0f);
  cloth_hit a, b;
  vi left;
  vf x = off * splat(w->yarn[which].inverse_spacing) - half, f = x - vfloor(x, &left);
  cloth_yarn(w, which, left, at, f, s, wide, &a);
  cloth_yarn(w, which, left + splati(1), at, f - one, s, wide, &b);
  a.weft = b.weft = lt(one, half);
  cloth_hit r = cloth_higher(&a, &b);
  r.solid = vmin(a.solid + b.solid, one); /* side by side */
  return r;
}

/* broad: how much broader warp and weft look at the eye's slant. */
INLINE void cloth_at(const fibertex_constants *w, vf u, vf v, vf s, const vf broad[2],
                     cloth_hit *q) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  cloth_hit warp = cloth_yarns(w, 0, u, v, s, broad[0]);
  cloth_hit weft = cloth_yarns(w, 1, v, u, s, broad[1]);
  weft.across = zero - weft.across;
  weft.bend = zero - weft.bend;
  *q = cloth_higher(&warp, &weft);
  q->weft = lt(warp.top, weft.top);
  /* where the faces cross, a footprint has a share of each */
  vf wide = vmax(s * splat(2.0f * w->yarn[0].height * w->yarn[0].inverse_half), splat(1e-6f));
  q->share = clamp01((weft.top - warp.top) / wide + splat(0.5f));
  vf beside = sel(gt(q->solid, zero), q->top + splat(CLOTH_BESIDE), q->top);
  q->top = vmax(sel(q->on, q->top, beside), splat(w->low));
  vf level = clamp01((q->top - splat(w->low)) * splat(w->inverse_range));
  q->ambient = one - splat(w->hollow) * (one - level);
}

/* How bright that yarn is among the others: 1 in the mean. */
INLINE vf cloth_tone(const fibertex_constants *w, vu h) {
  return splat(1.0f) + splat(w->yarn[0].tone) * field_of(h, 2);
}

/* How deep a face of that height lies below the highest, mm. */
INLINE vf cloth_depth(const fibertex_constants *w, vf top) {
  return splat(w->low) + splat(1.0f) / splat(w->inverse_range) - top;
}

/* The yarn's axes in the hull's frame: along, across, out of it. */
INLINE void cloth_frame(const fibertex_constants *w, const cloth_hit *q, vf along[3], vf across[3],
                        vf up[3]) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf flat = sel(q->weft, splat(w->yarn[1].height * w->yarn[1].inverse_half),
                splat(w->yarn[0].height * w->yarn[0].inverse_half));
  vf weft = sel(q->weft, one, zero), warp = one - weft;
  vf turn = inverse_root(one + q->bend * q->bend), aside = q->bend * turn;
  /* the yarn's way and its side, as it bends */
  vf way[2] = {warp * turn - weft * aside, weft * turn + warp * aside};
  vf k = inverse_root(one + q->slope * q->slope);
  along[0] = way[0] * k;
  along[1] = way[1] * k;
  along[2] = q->slope * k;
  /* an ellipse's normal */
  vf e = q->across * flat, top = vsqrt(vmax(one - q->across * q->across, splat(0.04f)));
  vf m = inverse_root(e * e + top * top);
  e = e * m;
  top = top * m;
  vf side[3] = {zero - way[1], way[0], zero};
  vf lift[3] = {zero - q->slope * along[0], zero - q->slope * along[1], k};
  for (int c = 0; c < 3; c++) {
    up[c] = side[c] * e + lift[c] * top;
    across[c] = side[c] * top - lift[c] * e;
  }
}

#endif
