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

/* Mean square of that slope under boxes of e, per mm^2. */
INLINE vf wear_slope2(const wood_surface *m, vf e) {
  vi i;
  vf x = splat(2.0f) * log2_(e * splat(1.0f / m->soft));
  x = clamp(x, splat(0.0f), splat(SURFACE_WEAR_STEPS - 1.001f));
  vf part = x - vfloor(x, &i);
  return mix(gather(m->wear_slope2, i), gather(m->wear_slope2 + 1, i), part);
}

/* The fibres' noise at (x, z) of the reference section, and its slopes there. */
INLINE vf wear_fibres(const wood_constants *w, vu own, vf x, vf z, vf extent, vf *dx, vf *dz,
                      vf *lost) {
  vf sum = splat(0.0f);
  *dx = *dz = *lost = sum;
  for (int o = 0; o < SURFACE_OCTAVES; o++) {
    const surface_noise *q = &w->surface.fibre[o];
    if (q->height == 0.0f) continue;
    vf keep = splat(1.0f) - smooth_step(splat(0.5f * q->size), splat(2.0f * q->size), extent);
    *lost = *lost + (splat(1.0f) - keep * keep) * splat(q->slope2[0]);
    if (!any(gt(keep, splat(0.0f)))) continue;
    vf f = splat(q->frequency[0]), u = x, v = z;
    if (o) { /* turned, so that lattices do not line up */
      u = splat(0.8f) * x - splat(0.6f) * z;
      v = splat(0.6f) * x + splat(0.8f) * z;
    }
    noise_axis au = noise_split_cubic(u * f, HASH_X), av = noise_split_cubic(v * f, HASH_Z);
    vf du, dv, k = keep * splat(q->height);
    sum = sum + k * noise_value2(&au, &av, wood_seed(w, own, SEED_WEAR + (uint32_t)o), &du, &dv);
    k = k * f;
    if (o) {
      *dx = *dx + k * (splat(0.8f) * du + splat(0.6f) * dv);
      *dz = *dz + k * (splat(0.8f) * dv - splat(0.6f) * du);
    } else {
      *dx = *dx + k * du;
      *dz = *dz + k * dv;
    }
  }
  return sum;
}

#endif
