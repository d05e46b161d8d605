/* SPDX-License-Identifier: Apache-2.0
 *
 * The relief of a unit: bevelled edges, the joint's depth, and the slight
 * cupping of a board, as height and slope in the plane, averaged over a
 * footprint.
 */
#ifndef SOZAI_LAYOUT_RELIEF_H
#define SOZAI_LAYOUT_RELIEF_H

#include "units.h"

typedef struct {
  vf height;           /* mm, 0: the face */
  vf slope_x, slope_y; /* of the height, in the plane */
} layout_height;

/* The integral from 0 to x of the bevel's depth, over its slope. */
INLINE vf bevel_integral(vf x, vf bevel) {
  x = clamp(x, splat(0.0f), bevel);
  return bevel * x - splat(0.5f) * x * x;
}

INLINE layout_height layout_relief(const layout *l, const layout_profile *r, const layout_unit *p,
                                   vf e) {
  layout_height h;
  vf zero = splat(0.0f), one = splat(1.0f);
  h.height = h.slope_x = h.slope_y = zero;
  e = vmax(e, splat(COVER_LEAST));
  vf size = vmin(p->length, p->width);
  vf far = smooth_step(size, splat(2.0f) * size, e), near = one - far;
  if (r->bevel > 0.0f || r->depth > 0.0f) {
    /* across the nearest edge: this unit's bevel, the joint, the next one's */
    vf b = splat(r->bevel), t = splat(r->slope), g = splat(l->joint), half = splat(0.5f) * e;
    vf low = p->edge - half, high = p->edge + half, other = zero - g;
    vf ramp = bevel_integral(high, b) - bevel_integral(low, b) + bevel_integral(other - low, b) -
              bevel_integral(other - high, b);
    vf foot = splat(r->bevel * r->slope + r->depth);
    vf joint = cover_share(p->edge, e, other, zero);
    h.height = zero - t * ramp / e - foot * joint;
    h.height = mix(h.height, splat(r->mean), far);
    vf tilt = t * (cover_share(p->edge, e, zero, b) - cover_share(p->edge, e, other - b, other));
    h.slope_x = tilt * p->inx * near;
    h.slope_y = tilt * p->iny * near;
  }
  if (r->cup > 0.0f) {
    /* heart up or heart down; no two alike */
    vf amount = layout_random(hash_mix(p->id + splatu(HASH_Y)));
    amount = splat(r->cup) * (amount + amount - one) * near;
    vf q = p->v / p->width - splat(0.5f);
    h.height = h.height + amount * (one - splat(4.0f) * q * q);
    vf slope = splat(-8.0f) * amount * q / p->width;
    h.slope_x = h.slope_x - slope * p->s;
    h.slope_y = h.slope_y + slope * p->c;
  }
  return h;
}

#endif
