/* SPDX-License-Identifier: Apache-2.0
 *
 * The stem: from a point in log space to (rho, theta) about its pith, where
 * rho is the radius that the point's year has in the mean, straight section.
 *
 *   rho = r s(y) / (1 + w(theta)) - u(x, y, z)
 *
 * w is the section's outline (a few harmonics, so theta = +-pi is no seam),
 * s the taper, u the undulation of the growth front. s = 1 and u = 0 at y = 0:
 * there R(t, theta) = Rmean(t) (1 + w(theta)) exactly. Everything is smooth
 * and its derivatives are exact, which the fibre direction rests on.
 */
#ifndef SOZAI_WOOD_STEM_H
#define SOZAI_WOOD_STEM_H

#include "../core/filter.h"
#include "../core/noise_held.h"
#include "wood.h"

/* own: a board's offset, 0 where there are no boards. */
INLINE vu wood_seed(const wood_constants *w, vu own, uint32_t which) {
  return splatu(w->seeds[which]) + own;
}

typedef struct {
  vf x, z;   /* mm, of the pith */
  vf dx, dz; /* slopes along y */
} stem_pith;

/* held: here and below, NULL or what is held of a noise's last cell. */
INLINE stem_pith pith_at(const wood_constants *w, vu own, vf y, noise_held *held) {
  noise_stem a = noise_split_axial(y * splat(w->pith_frequency), HASH_Y);
  vf amplitude = splat(w->pith_amplitude), slope = splat(w->pith_amplitude * w->pith_frequency);
  vf n[2], dy[2];
  noise_axial1_twice(&a, wood_seed(w, own, SEED_PITH_X),
                     w->seeds[SEED_PITH_Z] - w->seeds[SEED_PITH_X], held, n, dy);
  return (stem_pith){amplitude * n[0], amplitude * n[1], dy[0] * slope, dy[1] * slope};
}

/* w(theta) for the unit direction (c, s), and dw/dtheta. */
INLINE vf outline_at(const wood_constants *w, vf c, vf s, vf *slope) {
  vf ck = c, sk = s, sum = splat(0.0f), d = sum;
  for (int k = 0; k < WOOD_HARMONICS; k++) {
    vf a = splat(w->outline_cos[k]), b = splat(w->outline_sin[k]);
    sum = sum + (a * ck + b * sk);
    float order = (float)(k + 1);
    d = d + (splat(order * w->outline_sin[k]) * ck - splat(order * w->outline_cos[k]) * sk);
    vf next = ck * c - sk * s;
    sk = sk * c + ck * s;
    ck = next;
  }
  *slope = d;
  return sum;
}

typedef struct {
  stem_pith pith;
  vf x, z;    /* mm, about the pith */
  vf r, c, s; /* distance from it and direction */
  vf inverse_r;
  vf rho;          /* mm */
  vf rho_x, rho_z; /* derivatives about the pith at a fixed height */
  vf rho_y;        /* at a fixed place about the pith */
  vf lost;         /* mm^2: variance of rho that the footprint swallowed */
  vf lost_slope;   /* variance of the fibres' slope along the radius that went likewise */
  vf eye;          /* 0..1: how far within a bird's eye */
} stem_place;

/* Growing in steps, so that the kernel can take a few blocks through each: */

/* the way from the pith, */
INLINE void stem_about(vf x, vf z, stem_place *p) {
  p->x = x - p->pith.x;
  p->z = z - p->pith.z;
  vf square = p->x * p->x + p->z * p->z;
  vm centre = lt(square, splat(1e-12f));
  square = vmax(square, splat(1e-12f));
  p->inverse_r = inverse_root(square);
  /* rounded as well as can be: shear along a fibre multiplies its error */
  p->r = vsqrt(square);
  p->c = sel(centre, splat(1.0f), p->x * p->inverse_r);
  p->s = sel(centre, splat(0.0f), p->z * p->inverse_r);
}

/* the sum of the undulation's octaves and its derivatives, before it dies out
 * towards the pith, */
typedef struct {
  vf n, nx, ny, nz;
} undulation_sum;

INLINE undulation_sum undulation_none(void) {
  vf zero = splat(0.0f);
  return (undulation_sum){zero, zero, zero, zero};
}

/* What an octave has of the wood; see fibre_octave. */
typedef struct {
  vf section, axis, height, touches, variance;
  vu seed;
  float size;
  int o, idle;
} undulation_octave;

INLINE undulation_octave undulation_octave_of(const wood_constants *w, int o) {
  return (undulation_octave){.section = splat(w->undulation_frequency_section[o]),
                             .axis = splat(w->undulation_frequency_axis[o]),
                             .height = splat(w->undulation[o]),
                             .touches = splat(0.5f * w->undulation_size[o]),
                             .variance = splat(0.025f * w->undulation[o] * w->undulation[o]),
                             .seed = splatu(w->seeds[SEED_UNDULATION + o]),
                             .size = w->undulation_size[o],
                             .o = o,
                             .idle = w->undulation[o] == 0.0f};
}

/* Octaves finer than the footprint are left out; p->lost is the variance that
 * went with them. */
INLINE void undulation_add(const undulation_octave *q, vu own, vf y, vf footprint, noise_held *held,
                           stem_place *p, undulation_sum *u) {
  if (q->idle) return;
  vf f = q->section, fy = q->axis;
  noise_stem ay = noise_split_axial(y * fy, HASH_Y);
  /* the second octave is turned by atan(3/4), so that lattices do not line up */
  vf x = p->x, z = p->z;
  if (q->o == 1) {
    x = splat(0.8f) * p->x - splat(0.6f) * p->z;
    z = splat(0.6f) * p->x + splat(0.8f) * p->z;
  }
  noise_axis ax = noise_split_cubic(x * f, HASH_X), az = noise_split_cubic(z * f, HASH_Z);
  vf a = q->height;
  if (any(gt(footprint, q->touches))) {
    vf keep = filter_keep(footprint, q->size);
    a = a * keep;
    /* the noise's variance is about 1/40, measured */
    vf gone = splat(1.0f) - keep * keep;
    p->lost = p->lost + q->variance * gone;
  }
  vf gx, gy, gz;
  vf v = noise_axial3_held(&ax, &ay, &az, q->seed + own, held, &gx, &gy, &gz);
  u->n = u->n + a * v;
  gx = gx * (a * f);
  gz = gz * (a * f);
  u->ny = u->ny + gy * (a * fy);
  if (q->o == 1) {
    u->nx = u->nx + (splat(0.8f) * gx + splat(0.6f) * gz);
    u->nz = u->nz + (splat(0.8f) * gz - splat(0.6f) * gx);
  } else {
    u->nx = u->nx + gx;
    u->nz = u->nz + gz;
  }
}

/* and rho with its derivatives. */
INLINE void stem_rho(const wood_constants *w, vf y, const undulation_sum *u, stem_place *p) {
  /* no undulation at the pith, where directions crowd */
  vf t = vmin(p->r * splat(w->undulation_core), splat(1.0f));
  vf envelope = t * t * (splat(3.0f) - t - t);
  vf steep = splat(6.0f * w->undulation_core) * t * (splat(1.0f) - t) * u->n;

  vf slope, outline = outline_at(w, p->c, p->s, &slope);
  vf widen = splat(1.0f) / (splat(1.0f) + outline);
  vf lean = splat(w->taper) * y;
  vf bounded = clamp(lean, splat(-0.9f), splat(0.9f));
  vf q = (splat(1.0f) + bounded) * widen;
  vf turn = q * slope * widen;
  p->rho = vmax(p->r * q - envelope * u->n, splat(0.0f));
  p->rho_x = q * p->c + turn * p->s - (envelope * u->nx + steep * p->c);
  p->rho_z = q * p->s - turn * p->c - (envelope * u->nz + steep * p->s);
  p->rho_y = sel(eq(lean, bounded), p->r * splat(w->taper) * widen, splat(0.0f)) - envelope * u->ny;
}

#endif
