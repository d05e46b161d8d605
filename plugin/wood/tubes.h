/* SPDX-License-Identifier: Apache-2.0
 *
 * Tubes along the fibre, of limited length, looked up where they are: checks
 * and mineral streaks. In the reference section each is a paraboloid
 *
 *   A (t^2 - q / top), where that is above 0     A = height (2 top - 1) / top
 *
 * of the disc that vessels.h blurs over the footprint, which keeps the volume
 * at every blur; 1.6 in the middle of a sharp and whole one. t = g 4 f (1 - f)
 * runs along the tube, f the place within its length and g its own size.
 *
 * A footprint longer than one look-up answers is cut into up to 8, as vessels'
 * are; past those the mean takes over.
 */
#ifndef SOZAI_WOOD_TUBES_H
#define SOZAI_WOOD_TUBES_H

#include "footprint_parts.h"
#include "vessels.h"

/* A sum of troughs and its slopes. */
typedef struct {
  vf depth, x, z, y;
  vf fall; /* of each its depth, times how that falls off with the disc's distance */
} trough_sum;

/* How high a blurred trough still is, in sharp ones' 1.6. */
INLINE vf trough_amount(const disc *d) {
  return d->height * (d->top + d->top - splat(1.0f)) / d->top;
}

/* How much of a trough's slope is left in a blurred one, squared. */
INLINE vf trough_left(const disc *d) {
  vf a = trough_amount(d) * splat(1.0f / 1.6f);
  return vmin(a * a, splat(1.0f));
}

/* One trough more: at (dx, dz) from its middle, in the disc's units. size_slope:
 * the slope along its size. */
INLINE void trough_add(const disc *d, vf size, vf inverse_square, vf dx, vf dz, trough_sum *g,
                       vf *size_slope) {
  vf zero = splat(0.0f), k = inverse_square / d->top;
  vf v = size * size - disc_distance(d, dx, dz) * k;
  vf amount = sel(gt(v, zero), trough_amount(d), zero);
  vf deep = amount * v;
  g->depth = g->depth + deep;
  vf slope = zero - amount * k;
  g->fall = g->fall - deep * slope;
  g->x = g->x + slope * (splat(2.0f) * d->xx * dx + d->xz * dz);
  g->z = g->z + slope * (splat(2.0f) * d->zz * dz + d->xz * dx);
  *size_slope = amount * splat(2.0f) * size;
}

/* The tubes about (x, z) of the reference section at height y, added. */
INLINE void tubes_tap(const wood_tubes *m, vu seed, vf x, vf y, vf z, const disc *d, vf weight,
                      trough_sum *sum) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf inverse = splat(m->inverse_cell), cell = splat(m->cell);
  trough_sum g = {zero, zero, zero, zero, zero};
  vi ix, iz;
  vf px = x * inverse - half, pz = z * inverse - half;
  vf fx = px - vfloor(px, &ix), fz = pz - vfloor(pz, &iz);
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu column = hash_mix((vu)(ix + splati(a)) * splatu(HASH_X) +
                         (vu)(iz + splati(b)) * splatu(HASH_Z) + seed);
    /* each column is cut into lengths of its own */
    vf u = y * splat(m->inverse_length) + to_float((vi)(column >> 8)) * splat(1.0f / 16777216.0f);
    vi length;
    vf f = u - vfloor(u, &length);
    vu h = hash_mix(column + (vu)length * splatu(HASH_Y));
    vf there = sel(lt(to_float((vi)(h >> 8)), splat(m->share * 16777216.0f)), one, zero);
    vu p = h * splatu(PORE_SECOND);
    vf dx = (fx - splat((float)a) - hash_place(p) * splat(1.0f / PORE_UNIT)) * cell;
    vf dz = (fz - splat((float)b) - hash_place2(p) * splat(1.0f / PORE_UNIT)) * cell;
    /* of many sizes, most of them small */
    vf grown = to_float((vi)(h & splatu(255u))) * splat(1.0f / 255.0f);
    grown = there * (splat(m->least) + splat(1.0f - m->least) * grown * grown);
    vf by_size;
    trough_add(d, grown * splat(4.0f) * f * (one - f), one, dx, dz, &g, &by_size);
    g.y = g.y + by_size * grown * splat(4.0f * m->inverse_length) * (one - f - f);
  }
  sum->depth = sum->depth + weight * g.depth;
  sum->x = sum->x + weight * g.x;
  sum->z = sum->z + weight * g.z;
  sum->y = sum->y + weight * g.y;
  sum->fall = sum->fall + weight * weight * g.fall;
}

/* Over the footprint at a place. left: how much of the slopes' square is; d: what a tube is there.
 */
INLINE trough_sum tubes_over(const wood_tubes *m, vu seed, const vessel_place *v, vf y, vf *left,
                             disc *d) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vm cut = gt(v->f.aa + v->f.bb, splat(m->reach * m->reach));
  footprint_axes l = footprint_split(&v->f);
  footprint_parts part = footprint_cut(&v->f, &l, cut, m->reach, 0.0f, 8);
  vf faded = sel(part.most, fade_beyond(part.aa + part.bb, m->reach), zero), keep = one - faded;
  trough_sum sum = {splat(m->mean) * faded, zero, zero, zero, zero};
  *left = zero;
  *d = (disc){zero, zero, zero, zero, zero, zero, NULL};
  if (!any(gt(keep, zero))) return sum;
  matrix2 c = to_section(part.aa, part.ab, part.bb, v->c, v->s);
  *d = disc_blurred(splat(m->radius * m->radius), c);
  for (int i = 0; i < part.taps; i++) {
    footprint_part q = footprint_part_of(&l, &part, cut, i);
    vf weight = keep * q.weight;
    vf x = v->x + (q.rho * v->c - q.arc * v->s), z = v->z + (q.rho * v->s + q.arc * v->c);
    tubes_tap(m, seed, x, y, z, d, weight, &sum);
  }
  /* the parts' slopes are of either sign */
  *left = trough_left(d) * keep * keep * part.along * part.beside;
  return sum;
}

#endif
