/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels, looked up where they are and never listed.
 *
 * Pores of the field (diffuse-porous wood, and the latewood of the others)
 * stand in square cells of the reference section; each cell holds 0 to 3 of
 * them at uniform places, with the mean and the variance of a Poisson count,
 * so that counts over an area are those of Kawai's uniform distribution.
 * Earlywood vessels stand along the ring boundary, 2 pi R P to a ring, evenly
 * spaced with jitter. Radii are normally distributed, truncated above zero.
 *
 * Filtering. A vessel's edge is a ramp in q = (distance / radius)^2 from 0.75
 * to 1.25: its area and its half level are the disc's. Under a footprint of
 * covariance C the disc's matrix R^2 I grows to R^2 I + C / 0.2552 (0.2552 R^2
 * is the ramped disc's own variance), and its height falls by the ratio of the
 * areas: the mean is exact, the shape approximate. Where a footprint is longer
 * than the cells looked at, it is cut into four along its longest direction;
 * beyond that the expected coverage takes over.
 */
#ifndef SOZAI_WOOD_VESSELS_H
#define SOZAI_WOOD_VESSELS_H

#include "rings.h"
#include "stem.h"

/* A symmetric 2 x 2 matrix over (x, z) of the reference section, or over
 * (arc, rho). */
typedef struct {
  vf xx, xz, zz;
} matrix2;

/* What a blurred disc comes to: cov = height * clamp(2.5 - q), with
 * q = 2 d^T M^-1 d in units of the mean radius. */
typedef struct {
  vf xx, xz, zz, height;
} disc;

INLINE disc disc_blurred(vf radius2, matrix2 c) {
  vf k = splat(1.0f / 0.2552f);
  vf xx = radius2 + k * c.xx, zz = radius2 + k * c.zz, xz = k * c.xz;
  vf det = vmax(xx * zz - xz * xz, radius2 * radius2);
  vf root = splat(1.0f) / vsqrt(det), inverse = root * root;
  disc d;
  d.height = radius2 * root;
  d.xx = zz * inverse * splat(2.0f);
  d.zz = xx * inverse * splat(2.0f);
  d.xz = xz * inverse * splat(-4.0f);
  return d;
}

INLINE vf disc_cover(const disc *d, vf x, vf z, vf inverse_square) {
  vf q = (d->xx * x + d->xz * z) * x + d->zz * z * z;
  return d->height * clamp01(splat(2.5f) - q * inverse_square);
}

/* Expected cover of one vessel drawn from hash bits at the offset given. */
INLINE vf vessel_cover(const wood_vessels *v, const disc *d, vu h, vf x, vf z) {
  vi i = (vi)(h & splatu(WOOD_RADII - 1));
  return disc_cover(d, x, z, gather(v->inverse_square, i));
}

/* Coverage by the field's pores at (x, z) of the reference section. */
INLINE vf pores_cover(const wood_constants *w, vf x, vf z, const disc *d) {
  const wood_vessels *v = &w->pores;
  vf inverse_cell = splat(1.0f / v->cell), cell = splat(v->cell);
  vi ix, iz;
  vf fx = x * inverse_cell, fz = z * inverse_cell;
  fx = fx - vfloor(fx, &ix);
  fz = fz - vfloor(fz, &iz);
  vu seed = wood_seed(w, SEED_PORES);
  vf sum = splat(0.0f);
  const float bits = 1.0f / 2048.0f;
  for (int b = -1; b <= 1; b++) {
    for (int a = -1; a <= 1; a++) {
      vu base = hash_mix((vu)(ix + splati(a)) * splatu(HASH_X) +
                         ((vu)(iz + splati(b)) * splatu(HASH_Z) + seed));
      /* how many: 0 to 3 with chances 0.4, 0.3, 0.2, 0.1 (mean 1, variance 1) */
      vu more = (base * splatu(HASH_Y)) >> 22;
      vu h = base;
      for (int k = 0; k < 3; k++) {
        static const int32_t threshold[3] = {614, 307, 102}; /* of 1024 */
        vm there = lti((vi)more, splati(threshold[k]));
        if (!any(there)) break;
        vf dx = fx - splat((float)a) - to_float((vi)(h >> 21)) * splat(bits);
        vf dz = fz - splat((float)b) - to_float((vi)((h >> 10) & splatu(2047))) * splat(bits);
        vf c = vessel_cover(v, d, h, dx * cell, dz * cell);
        sum = sum + sel(there, c, splat(0.0f));
        h = hash_mix(h + splatu(HASH_Y));
      }
    }
  }
  return sum;
}

/* Coverage by the earlywood rows of the ring whose band is nearest.
 * turn: theta' / 2 pi; rho: mm; ring, start: the ring and the rho it begins at. */
INLINE vf rows_cover(const wood_constants *w, vf turn, vf rho, vi ring, vf start, const disc *d) {
  vi n;
  vf count = vfloor(start * splat(6.2831853f * w->row_density) + splat(0.5f), &n);
  vf arc = splat(6.2831853f) * rho / vmax(count, splat(1.0f));
  vu seed = (vu)ring * splatu(HASH_Z) + wood_seed(w, SEED_ROWS);
  vi unused;
  vf sum = splat(0.0f);
  for (int m = 0; m < w->rows; m++) {
    vu row_seed = hash_mix(seed + splatu((uint32_t)m * HASH_X));
    /* each row begins at an azimuth of its own */
    vf u = turn + to_float((vi)(row_seed >> 8)) * splat(1.0f / 16777216.0f);
    vf place = (u - vfloor(u, &unused)) * count;
    vi k0;
    vf within = place - vfloor(place, &k0);
    vf radial = rho - start - splat(w->row_start + w->row_spacing * (float)m);
    for (int a = -1; a <= 1; a++) {
      vi k = k0 + splati(a);
      k = seli(lti(k, splati(0)), k + n, k);
      k = seli(lti(k, n), k, k - n);
      vu h = hash_mix((vu)k * splatu(HASH_Y) + row_seed);
      vf j = to_float((vi)(h >> 21)) * splat(1.0f / 2048.0f) - splat(0.5f);
      vf i = to_float((vi)((h >> 10) & splatu(2047))) * splat(1.0f / 2048.0f) - splat(0.5f);
      vf x = (within - splat((float)a + 0.5f) - j * splat(w->row_jitter_arc)) * arc;
      vf z = radial - i * splat(w->row_jitter_radial);
      sum = sum + vessel_cover(&w->row, d, h, x, z);
    }
  }
  return sel(lt(count, splat(3.0f)), splat(0.0f), sum);
}

/* Where a point's vessels are looked up. */
typedef struct {
  vf x, z;   /* mm: in the reference section */
  vf c, s;   /* direction of (x, z) */
  vf rho;    /* mm: of the point's year */
  ring_place ring;
  footprint2 f; /* over (arc, rho) */
} vessel_place;

/* The footprint's longest direction over (arc, rho), and what is left when it
 * is taken out. Covariances are a twelfth of the products. */
typedef struct {
  vf arc, rho;  /* mm: the whole length along it */
  vf aa, ab, bb;
} footprint_axis;

INLINE footprint_axis footprint_longest(const footprint2 *f) {
  footprint_axis l;
  vm across = le(f->bb, f->aa);
  vf major = vsqrt(vmax(sel(across, f->aa, f->bb), splat(1e-12f)));
  vf other = f->ab / major;
  l.arc = sel(across, major, other);
  l.rho = sel(across, other, major);
  l.aa = vmax(f->aa - l.arc * l.arc, splat(0.0f));
  l.bb = vmax(f->bb - l.rho * l.rho, splat(0.0f));
  l.ab = splat(0.0f);
  return l;
}

/* From (arc, rho) at direction (c, s) to (x, z). */
INLINE matrix2 to_section(vf aa, vf ab, vf bb, vf c, vf s) {
  matrix2 m;
  vf cs = c * s, cc = c * c, ss = s * s;
  m.xx = aa * ss - (ab + ab) * cs + bb * cc;
  m.zz = aa * cc + (ab + ab) * cs + bb * ss;
  m.xz = (bb - aa) * cs + ab * (cc - ss);
  return m;
}

typedef struct {
  vf pores, rows;               /* coverage, where it could be looked up */
  vf pores_faded, rows_faded;   /* 1: the expected coverage is to be used */
} vessel_cover_t;

INLINE vf fade_beyond(vf e2, float reach) {
  return smooth_step(splat(0.6f * reach), splat(reach), vsqrt(e2));
}

/* One tap: the footprint's part `share` (1 or 1/4) along its longest direction. */
INLINE void vessels_tap(const wood_constants *w, const vessel_place *p, const footprint_axis *l,
                        vf along, float share, vf turn, vessel_cover_t *sum) {
  vf k = splat(share * share / 12.0f), rest = splat(1.0f / 12.0f);
  vf aa = l->arc * l->arc * k + l->aa * rest, bb = l->rho * l->rho * k + l->bb * rest;
  vf ab = l->arc * l->rho * k;
  vf da = l->arc * along, dr = l->rho * along;
  if (w->has_pores) {
    matrix2 m = to_section(aa, ab, bb, p->c, p->s);
    vf size = splat(w->pore_early) + splat(w->pore_growth) * p->ring.phase;
    disc d = disc_blurred(splat(w->pores.radius * w->pores.radius) * size * size, m);
    /* radii in the table are relative to the mean, and so is the disc's */
    vf x = p->x + (dr * p->c - da * p->s), z = p->z + (dr * p->s + da * p->c);
    sum->pores = sum->pores + pores_cover(w, x, z, &d) * splat(share);
  }
  if (w->rows) {
    matrix2 m = {aa, ab, bb};
    vf rho = p->rho + dr;
    /* the band just ahead, where that is nearer than the one behind */
    vf width = splat(1.0f) / p->ring.inverse_width;
    vf into = (p->ring.phase * width) + dr;
    vf extent = vsqrt(bb) * splat(2.0f);
    vm ahead = lt(width - into, vmin(into - splat(w->band), extent + splat(w->row.radius)));
    vm here = lt(into, splat(w->band) + extent + splat(w->row.radius));
    if (any(or_(ahead, here))) {
      disc d = disc_blurred(splat(w->row.radius * w->row.radius), m);
      vf start = p->ring.start + p->ring.turns * splat(w->ring_period);
      start = sel(ahead, start + width, start);
      vi ring = seli(ahead, p->ring.ring + splati(1), p->ring.ring);
      vf inverse_arc = splat(0.15915494f) / vmax(p->rho, splat(1e-3f));
      vf c = rows_cover(w, turn + da * inverse_arc, rho, ring, start, &d);
      sum->rows = sum->rows + sel(or_(ahead, here), c, splat(0.0f)) * splat(share);
    }
  }
}

INLINE vessel_cover_t vessels_at(const wood_constants *w, const vessel_place *p) {
  vessel_cover_t zero = {splat(0.0f), splat(0.0f), splat(0.0f), splat(0.0f)}, one = zero,
                 four = zero;
  footprint_axis l = footprint_longest(&p->f);
  vf turn = splat(0.0f);
  if (w->rows) turn = arctan2(p->s, p->c) * splat(0.15915494f) + splat(0.5f);
  vf e2 = p->f.aa + p->f.bb, along2 = l.arc * l.arc + l.rho * l.rho, rest2 = l.aa + l.bb;
  vf quarter2 = along2 * splat(1.0f / 16.0f) + rest2;

  float reach = 1e9f;
  if (w->has_pores) reach = w->pores.reach;
  if (w->rows && w->row.reach < reach) reach = w->row.reach;
  vm cut = gt(e2, splat(0.36f * reach * reach));
  /* past this even quarters are too long, and nothing looked up is used */
  float most = 0.0f;
  if (w->has_pores) most = w->pores.reach;
  if (w->rows && w->row.reach > most) most = w->row.reach;
  vm useful = lt(quarter2, splat(most * most));

  if (any(not_(cut))) vessels_tap(w, p, &l, splat(0.0f), 1.0f, turn, &one);
  if (any(and_(cut, useful))) {
    for (int i = 0; i < 4; i++) {
      vessels_tap(w, p, &l, splat(((float)i - 1.5f) * 0.25f), 0.25f, turn, &four);
    }
  }
  vessel_cover_t v;
  v.pores = sel(cut, four.pores, one.pores);
  v.rows = sel(cut, four.rows, one.rows);
  vf e = sel(cut, quarter2, e2);
  v.pores_faded = fade_beyond(e, w->pores.reach);
  v.rows_faded = fade_beyond(e, w->row.reach);
  v.pores = sel(lt(v.pores_faded, splat(1.0f)), v.pores, splat(0.0f));
  v.rows = sel(lt(v.rows_faded, splat(1.0f)), v.rows, splat(0.0f));
  return v;
}

#endif
