/* SPDX-License-Identifier: Apache-2.0
 *
 * Grooves along the fibre: vessels that the cut has opened, at the places of
 * vessels.h, and checks. In the reference section each is a paraboloid trough
 *
 *   depth A (1 - q / top), q < top     A = height (2 top - 1) / top
 *
 * of the disc that vessels.h blurs over the footprint: the same volume at every
 * blur, 1.6 depth in the middle of a sharp one. Where troughs meet they add up.
 *
 * A check is a tube of limited length: with t(y) = 4 f (1 - f) along it, f the
 * place within its length, the trough is depth A (t^2 - q / top).
 */
#ifndef SOZAI_WOOD_SURFACE_GROOVES_H
#define SOZAI_WOOD_SURFACE_GROOVES_H

#include "../vessels.h"

/* Depth, and its slopes. */
typedef struct {
  vf depth, x, z, y;
} groove_sum;

/* One trough: at (dx, dz) from its middle, in the disc's units. */
INLINE void groove_add(const disc *d, vf size, vf inverse_square, vf dx, vf dz, groove_sum *g,
                       vf *size_slope) {
  vf zero = splat(0.0f), inverse_top = splat(1.0f) / d->top;
  vf amount = d->height * (d->top + d->top - splat(1.0f)) * inverse_top;
  vf k = inverse_square * inverse_top;
  vf v = size * size - disc_distance(d, dx, dz) * k;
  vm within = gt(v, zero);
  amount = sel(within, amount, zero);
  g->depth = g->depth + amount * v;
  vf slope = zero - amount * k;
  g->x = g->x + slope * (splat(2.0f) * d->xx * dx + d->xz * dz);
  g->z = g->z + slope * (splat(2.0f) * d->zz * dz + d->xz * dx);
  *size_slope = amount * splat(2.0f) * size;
}

/* The field's pores, over their depth; slopes are per mm of (x, z). */
INLINE groove_sum grooves_pores(const wood_constants *w, vu own, vf x, vf z, const disc *d) {
  pore_cells p = pores_near(w, own, x, z, d);
  vf zero = splat(0.0f), unit = splat(PORE_UNIT), one = splat(1.0f), unused;
  groove_sum g = {zero, zero, zero, zero};
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p.hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    vf cx = sel_top(base, a ? p.x - unit : p.x, splat(PORE_NOWHERE)), cz = b ? p.z - unit : p.z;
    vu h = base << 1;
    for (int k = 0; k < 2; k++) {
      groove_add(&p.d, one, lookup16(w->pores.inverse_square, h >> 5), cx - hash_place(h),
                 cz - hash_place2(h), &g, &unused);
      h = base * splatu(PORE_SECOND);
    }
  }
  vf per_mm = splat(1.0f / w->pore_step);
  g.x = g.x * per_mm;
  g.z = g.z * per_mm;
  return g;
}

/* The earlywood's rows; x is along the arc and z along rho. */
INLINE groove_sum grooves_rows(const wood_constants *w, const row_place *p, vf rho, vf da, vf dr,
                               const disc *d) {
  vf zero = splat(0.0f), one = splat(1.0f), unused;
  groove_sum g = {zero, zero, zero, zero};
  vi whole;
  for (int m = 0; m < w->rows; m++) {
    vu row_seed = hash_upper(p->seed + splatu((uint32_t)m * HASH_X));
    vf u = p->turn + to_float((vi)(row_seed >> 8)) * splat(1.0f / 16777216.0f);
    vf place = (u - vfloor(u, &whole)) * p->count - splat(0.5f) + da * p->per_arc;
    vi k0;
    vf within = place - vfloor(place, &k0);
    vf radial = rho + dr - p->start - splat(w->row_start + w->row_spacing * (float)m);
    for (int a = 0; a < 2; a++) {
      vi k = k0 + splati(a);
      k = seli(lti(k, splati(0)), k + p->n, k);
      k = seli(lti(k, p->n), k, k - p->n);
      vu h = hash_upper((vu)k * splatu(HASH_Y) + row_seed);
      vf x = (within - splat((float)a) - hash_place(h) * splat(w->row_step_arc)) * p->arc;
      vf z = radial - hash_place2(h) * splat(w->row_step_radial);
      groove_add(d, one, lookup16(w->row.inverse_square, h >> 5), x, z, &g, &unused);
    }
  }
  g.depth = sel(p->near, g.depth, zero);
  g.x = sel(p->near, g.x, zero);
  g.z = sel(p->near, g.z, zero);
  return g;
}

/* Checks, over their depth. y: along the stem. */
INLINE groove_sum grooves_checks(const wood_constants *w, vu own, vf x, vf y, vf z, const disc *d) {
  const wood_surface *m = &w->surface;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf inverse = splat(m->inverse_check_cell), cell = splat(m->check_cell);
  groove_sum g = {zero, zero, zero, zero};
  vi ix, iz;
  vf px = x * inverse - half, pz = z * inverse - half;
  vf fx = px - vfloor(px, &ix), fz = pz - vfloor(pz, &iz);
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu column = hash_mix((vu)(ix + splati(a)) * splatu(HASH_X) +
                         (vu)(iz + splati(b)) * splatu(HASH_Z) + wood_seed(w, own, SEED_CHECKS));
    /* each column is cut into lengths of its own */
    vf u = y * splat(m->inverse_check_length) +
           to_float((vi)(column >> 8)) * splat(1.0f / 16777216.0f);
    vi length;
    vf f = u - vfloor(u, &length);
    vu h = hash_mix(column + (vu)length * splatu(HASH_Y));
    vf there = sel(lt(to_float((vi)(h >> 8)), splat(m->check_share * 16777216.0f)), one, zero);
    vu p = h * splatu(PORE_SECOND);
    vf dx = (fx - splat((float)a) - hash_place(p) * splat(1.0f / PORE_UNIT)) * cell;
    vf dz = (fz - splat((float)b) - hash_place2(p) * splat(1.0f / PORE_UNIT)) * cell;
    /* of many sizes, most of them small */
    vf grown = to_float((vi)(h & splatu(255u))) * splat(1.0f / 255.0f);
    grown = splat(0.3f) + splat(0.7f) * grown * grown;
    vf size = there * grown * splat(4.0f) * f * (one - f), by_size;
    groove_add(d, size, one, dx, dz, &g, &by_size);
    g.y = g.y + by_size * there * grown * splat(4.0f * m->inverse_check_length) * (one - f - f);
  }
  return g;
}

#endif
