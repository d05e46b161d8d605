/* SPDX-License-Identifier: Apache-2.0
 *
 * Wear: earlywood lies below latewood, by the rings' own profile averaged over
 * the footprint and at least over `soft`, with weights 1/4, 1/2, 1/4 of boxes
 * side by side half overlapping, so that a ring's edge is rounded; and single
 * bundles of fibres stand out, by a noise over the reference section.
 */
#ifndef SOZAI_WOOD_SURFACE_WEAR_H
#define SOZAI_WOOD_SURFACE_WEAR_H

#include "../rings.h"
#include "../stem.h"

/* Latewood's profile at rho, not averaged. */
INLINE vf wear_profile(const wood_constants *w, vf rho) {
  ring_place p = ring_at(w, vmax(rho, splat(0.0f)));
  return p.weight * late_profile(w, p.phase);
}

/* The average, and its slope along rho. e: mm of the boxes. */
INLINE vf wear_average(const wood_constants *w, const ring_place *ring, vf rho, vf e, vf *slope) {
  vf half = splat(0.5f) * e, quarter = splat(0.25f);
  vf sum = splat(0.5f) * ring_average(w, MEAN_LATE, ring, rho, e);
  for (int i = -1; i <= 1; i += 2) {
    vf at = rho + splat((float)i) * half;
    ring_place p = ring_at(w, vmax(at, splat(0.0f)));
    sum = sum + quarter * ring_average(w, MEAN_LATE, &p, at, e);
  }
  vf rise = splat(0.5f) * (wear_profile(w, rho + half) - wear_profile(w, rho - half)) +
            quarter * (wear_profile(w, rho + e) - wear_profile(w, rho - e));
  *slope = rise / e;
  return sum;
}

/* How it rises over rho at the ring's edges, seen from `late` high. Inwards the last ring's
 * latewood ends at once; boxes leave of that two corners, at 1 and 7/8 of it. Outwards this ring's
 * latewood rises to a shoulder, to which a tangent goes. further: mm to it. */
INLINE vf wear_rise(const wood_constants *w, const ring_place *p, vf late, vf e, vm outwards,
                    vf *further) {
  vf zero = splat(0.0f), one = splat(1.0f), width = one / p->inverse_width;
  vf in = p->phase * width + e, corner = in - splat(0.5f) * e;
  vf rise = vmax((p->last - late) / in, (splat(0.875f) * p->last - late) / corner);
  vf to = (splat(w->late_middle + w->late_after) - p->phase) * width;
  vf over = splat(w->late_after) * width + splat(0.5f) * e;
  vf below = one - splat(w->late_deepening) - late / vmax(p->weight, splat(0.05f));
  vf from = to - vsqrt(vmax(to * to - splat(2.0f) * below * over * over, zero));
  vf slope = p->weight * clamp(from, zero, over) / (over * over);
  slope = sel(gt(below, zero), slope, zero);
  *further = sel(outwards, vmax(to, zero) + e, in);
  return vmax(sel(outwards, sel(gt(to, zero), slope, zero), rise), zero);
}

/* Mean square of that slope under boxes of e, per mm^2. */
INLINE vf wear_slope2(const wood_surface *m, vf e) {
  vi i;
  vf x = splat(2.0f) * log2_(e * splat(1.0f / m->soft));
  x = clamp(x, splat(0.0f), splat(SURFACE_WEAR_STEPS - 1.001f));
  vf part = x - vfloor(x, &i);
  return mix(gather(m->wear_slope2, i), gather(m->wear_slope2 + 1, i), part);
}

/* The fibres' noise at a place of the reference section. */
typedef struct {
  vf height, x, z; /* mm, and its slopes */
  vf lost, left,
      rank; /* of their mean square along an axis, and what is not; height in it, in sd */
} fibre_relief;

INLINE fibre_relief wear_fibres(const wood_constants *w, vu own, vf x, vf z, vf extent) {
  vf zero = splat(0.0f);
  fibre_relief r = {zero, zero, zero, zero, zero, zero};
  for (int o = 0; o < SURFACE_OCTAVES; o++) {
    const surface_noise *q = &w->surface.fibre[o];
    if (q->height == 0.0f) continue;
    vf keep = splat(1.0f) - smooth_step(splat(0.5f * q->size), splat(2.0f * q->size), extent);
    r.lost = r.lost + (splat(1.0f) - keep * keep) * splat(q->slope2[0]);
    r.left = r.left + keep * keep * splat(q->slope2[0]);
    if (!any(gt(keep, splat(0.0f)))) continue;
    vf f = splat(q->frequency[0]), u = x, v = z;
    if (o) { /* turned, so that lattices do not line up */
      u = splat(0.8f) * x - splat(0.6f) * z;
      v = splat(0.6f) * x + splat(0.8f) * z;
    }
    noise_axis au = noise_split_cubic(u * f, HASH_X), av = noise_split_cubic(v * f, HASH_Z);
    vf du, dv, k = keep * splat(q->height);
    vf n = noise_value2(&au, &av, wood_seed(w, own, SEED_WEAR + (uint32_t)o), &du, &dv);
    r.height = r.height + k * n;
    r.rank = r.rank + keep * n * splat(q->rank);
    k = k * f;
    if (o) {
      r.x = r.x + k * (splat(0.8f) * du + splat(0.6f) * dv);
      r.z = r.z + k * (splat(0.8f) * dv - splat(0.6f) * du);
    } else {
      r.x = r.x + k * du;
      r.z = r.z + k * dv;
    }
  }
  return r;
}

#endif
