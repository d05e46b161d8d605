/* SPDX-License-Identifier: Apache-2.0
 *
 * A footprint that is longer than what one look-up answers, cut into up to 8 parts along its
 * longest direction and, where it is broad, once across that.
 */
#ifndef SOZAI_WOOD_FOOTPRINT_PARTS_H
#define SOZAI_WOOD_FOOTPRINT_PARTS_H

#include "../core/filter.h"

/* A footprint over (arc, rho) as two vectors, mm: its longest direction, and
 * what is left, which lies along arc or rho alone. */
typedef struct {
  vf arc, rho;
  vf rest_arc, rest_rho;
} footprint_axes;

INLINE footprint_axes footprint_split(const footprint2 *f) {
  footprint_axes l;
  vf zero = splat(0.0f);
  vm across = le(f->bb, f->aa);
  vf square = vmax(sel(across, f->aa, f->bb), splat(1e-12f));
  vf inverse = inverse_root(square), major = square * inverse, other = f->ab * inverse;
  l.arc = sel(across, major, other);
  l.rho = sel(across, other, major);
  vf rest = vsqrt(vmax(sel(across, f->bb, f->aa) - other * other, zero));
  l.rest_arc = sel(across, zero, rest);
  l.rest_rho = sel(across, rest, zero);
  return l;
}

/* How a footprint is cut into parts, lane by lane: `along` of its longest
 * direction (1, 2, 3 or 4, or 1, 2, 4 or 8), `beside` of what is left (1 or 2). */
typedef struct {
  vm most;          /* into as many as there are */
  vf along, beside; /* inverses of the numbers */
  vf aa, ab, bb;    /* of one part */
  int taps;         /* of the lane that has the most */
} footprint_parts;

INLINE vf square_of(vf x) { return x * x; }

/* most: how many parts there may be, 4 or 8; third: of 4, how long three may be. */
INLINE footprint_parts footprint_cut(const footprint2 *f, const footprint_axes *l, vm cut,
                                     float reach, float third, int most) {
  footprint_parts p;
  vf one = splat(1.0f), half = splat(0.5f), reach2 = splat(reach * reach);
  vf long2 = square_of(l->arc) + square_of(l->rho);
  vf rest2 = square_of(l->rest_arc) + square_of(l->rest_rho);
  vm wide = and_(cut, gt(rest2, splat(0.36f) * reach2)), narrow = not_(wide);
  p.beside = sel(wide, half, one);
  rest2 = rest2 * square_of(p.beside);
  vm two = gt(long2 + rest2, reach2), four = gt(long2 * splat(0.25f) + rest2, reach2);
  vm all = and_(wide, two); /* as many as there may be */
  p.along = sel(two, half, one);
  if (most == 8) {
    all = or_(and_(wide, four), and_(narrow, gt(long2 * splat(0.0625f) + rest2, reach2)));
    p.along = sel(four, splat(0.25f), p.along);
    p.along = sel(and_(narrow, all), splat(0.125f), p.along);
  } else {
    vm three = four; /* or four, where thirds would have their cones cut off */
    four = gt(long2 * splat(1.0f / 9.0f) + rest2, splat(third * third));
    all = or_(all, and_(narrow, four));
    p.along = sel(and_(narrow, three), splat(1.0f / 3.0f), p.along);
    p.along = sel(and_(narrow, four), splat(0.25f), p.along);
    four = three;
  }
  p.most = and_(cut, all);
  p.along = sel(cut, p.along, one);
  vf k = square_of(p.along), r = square_of(p.beside);
  p.aa = sel(cut, square_of(l->arc) * k + square_of(l->rest_arc) * r, f->aa);
  p.bb = sel(cut, square_of(l->rho) * k + square_of(l->rest_rho) * r, f->bb);
  p.ab = sel(cut, l->arc * l->rho * k, f->ab);
  p.taps = any(p.most) ? most : any(and_(cut, or_(four, wide))) ? 4 : any(cut) ? 2 : 1;
  return p;
}

/* Of a footprint in parts: where the i-th is, and its share of the whole. */
typedef struct {
  vf arc, rho, weight;
} footprint_part;

INLINE vm footprint_has_part(const footprint_parts *part, int i) {
  return lt(splat((float)i + 0.5f) * part->along * part->beside, splat(1.0f));
}

/* `along` runs first, then the other side. */
INLINE footprint_part footprint_part_of(const footprint_axes *l, const footprint_parts *part,
                                        vm cut, int i) {
  footprint_part q;
  vf zero = splat(0.0f), one = splat(1.0f);
  vf at = splat((float)i + 0.5f) * part->along;
  vm second = gt(at, one);
  vf a = at - splat(0.5f) - sel(second, one, zero);
  vf side = sel(lt(part->beside, one), sel(second, splat(0.25f), splat(-0.25f)), zero);
  q.weight = sel(footprint_has_part(part, i), part->along * part->beside, zero);
  q.arc = sel(cut, l->arc * a + l->rest_arc * side, zero);
  q.rho = sel(cut, l->rho * a + l->rest_rho * side, zero);
  return q;
}

#endif
