/* SPDX-License-Identifier: Apache-2.0
 *
 * Pores of the field: diffuse-porous wood, and the latewood of the others.
 *
 * They stand in square cells of the reference section, two in every other cell at
 * uniform places: mean, variance and pair density are those of Kawai's uniform
 * distribution. Pores in bands are one to a smaller cell, and
 * there where that place is within a band. A footprint longer than the cells looked at is cut into
 * up to 4 parts.
 */
#ifndef SOZAI_WOOD_VESSELS_PORES_H
#define SOZAI_WOOD_VESSELS_PORES_H

#include "footprint_parts.h"
#include "vessels_bands.h"

/* The four cells nearest to a point of the reference section, which hold
 * everything within half a cell. Places are in units of 1 / PORE_UNIT of a cell. */
typedef struct {
  vf x, z; /* from the first cell's middle, 0..2^32 */
  vu hash; /* of the first cell */
  disc d;  /* in those units */
  vessel_bands bands;
} pore_cells;

/* A disc in those units. */
INLINE disc disc_in_cells(const wood_constants *w, const disc *d) {
  vf square = splat(w->pore_step * w->pore_step);
  return (disc){d->xx * square, d->xz * square, d->zz * square, d->top, d->height, d->apart, NULL};
}

#define PORE_NOWHERE 1e13f      /* far from everything */
#define PORE_SECOND 0x2c1b3c6du /* makes another hash of a cell's */

INLINE pore_cells pores_near(const wood_constants *w, int banded, vu own, vf x, vf z,
                             const disc *d) {
  pore_cells p;
  vf inverse_cell = splat(w->inverse_pore_cell), unit = splat(PORE_UNIT), half = splat(0.5f);
  vi ix, iz;
  x = x * inverse_cell - half;
  z = z * inverse_cell - half;
  p.x = (x - vfloor(x, &ix)) * unit;
  p.z = (z - vfloor(z, &iz)) * unit;
  p.hash = (vu)ix * splatu(HASH_X) + (vu)iz * splatu(HASH_Z) + wood_seed(w, own, SEED_PORES);
  p.d = disc_in_cells(w, d);
  if (banded) p.bands = bands_per(&w->bands, d->bands, w->pore_step);
  return p;
}

/* The sum of the covers by pores in bands. */
INLINE vf pores_in_bands(const wood_constants *w, const pore_cells *p) {
  vf sum = splat(0.0f), unit = splat(PORE_UNIT), zero = sum;
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p->hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    vu h = base << 1;
    vf x = (a ? p->x - unit : p->x) - hash_place(h), z = (b ? p->z - unit : p->z) - hash_place2(h);
    vm held = bands_hold(&w->bands, &p->bands, base, x, z);
    if (idle(held)) continue;
    vf cover = vessel_cover(&w->pores, &p->d, h, disc_distance(&p->d, x, z));
    sum = sum + sel(held, cover, zero);
  }
  return sum;
}

/* The sum of the covers by their pores: two in every other cell, by its hash's
 * top bit; the rest gives their places and radii. */
#ifndef WITHIN_A_POINT
INLINE vf pores_sum(const wood_vessels *v, const pore_cells *p) {
  vf sum = splat(0.0f), unit = splat(PORE_UNIT);
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p->hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    if (idle(lti((vi)base, splati(0)))) continue;
    vf x = sel_top(base, a ? p->x - unit : p->x, splat(PORE_NOWHERE)), z = b ? p->z - unit : p->z;
    vu h = base << 1;
    vf two = splat(0.0f); /* apart from the sum, which would have each cell wait for the last */
    UNROLL(2)
    for (int k = 0; k < 2; k++) {
      vf q = disc_distance(&p->d, x - hash_place(h), z - hash_place2(h));
      /* past `farthest` the cover is exactly 0: passing over it changes nothing */
      if (!idle(lt(q, splat(v->farthest)))) two = two + vessel_cover(v, &p->d, h, q);
      h = base * splatu(PORE_SECOND);
    }
    sum = sum + two;
  }
  return sum;
}
#else
/* One point alone: the eight places are eight lanes, and the sum is taken in
 * the same order. */
INLINE vf pores_sum(const wood_vessels *v, const pore_cells *p) {
  const u4 cell = {0, HASH_X, HASH_Z, HASH_X + HASH_Z};
  u4 base = cell + p->hash;
  base ^= base >> 16;
  base *= 0x7feb352du;
  base ^= base >> 15;
  base *= 0x846ca68bu;
  vf x1 = p->x - PORE_UNIT, z1 = p->z - PORE_UNIT;
  f4 x = {p->x, x1, p->x, x1}, z = {p->z, p->z, z1, z1};
  i4 there = (i4)base < 0;
  x = (f4)(((i4)x & there) |
           ((i4)(f4){PORE_NOWHERE, PORE_NOWHERE, PORE_NOWHERE, PORE_NOWHERE} & ~there));
  u8 h = join_u4(base << 1, base * PORE_SECOND);
  f8 dx = join_f4(x, x) - to_f8((i8)h), dz = join_f4(z, z) - to_f8((i8)(h << 11));
  f8 q = (p->d.xx * dx + p->d.xz * dz) * dx + p->d.zz * dz * dz;
  f8 cover = clamp01_f8(p->d.top - q * lookup8_f8(v->inverse_square, h >> 5));
  f4 two = half_f8(cover, 0) + half_f8(cover, 1);
  return two[0] + two[1] + two[2] + two[3];
}
#endif

/* Coverage by the field's pores. banded: w->bands.on, which the kernel asks outside its loops. */
INLINE vf pores_cover(const wood_constants *w, int banded, vu own, vf x, vf z, const disc *d) {
  pore_cells p = pores_near(w, banded, own, x, z, d);
  vf sum = banded ? pores_in_bands(w, &p) : pores_sum(&w->pores, &p);
  return vessel_overlap(d, w->pores.overlap, sum);
}

/* A pore at its mean radius under a footprint over (x, z). */
INLINE disc pores_disc(const wood_constants *w, const vessel_place *p, const matrix2 *f) {
  vf radius2 = splat(w->pores.radius * w->pores.radius);
  if (w->pore_growth != 0.0f) {
    vf size = splat(w->pore_early) + splat(w->pore_growth) * p->ring.phase;
    radius2 = radius2 * size * size;
  }
  disc d = disc_blurred(radius2, *f);
  d.bands = p->bands;
  return d;
}

#endif
