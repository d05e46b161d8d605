/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels, looked up where they are and never listed.
 *
 * Pores of the field (diffuse-porous wood, and the latewood of the others)
 * stand in square cells of the reference section, one to a cell on average;
 * each cell holds 0 to 3 of them at uniform places, with the mean and the variance of a Poisson count,
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
  vf root = inverse_root(det), inverse = root * root;
  disc d;
  d.height = radius2 * root;
  d.xx = zz * inverse * splat(2.0f);
  d.zz = xx * inverse * splat(2.0f);
  d.xz = xz * inverse * splat(-4.0f);
  return d;
}

INLINE vf disc_distance(const disc *d, vf x, vf z) {
  return (d->xx * x + d->xz * z) * x + d->zz * z * z;
}

/* Cover by one vessel at distance q, its radius drawn from the hash; over the
 * disc's height. */
INLINE vf vessel_cover(const wood_vessels *v, vu h, vf q) {
  vi i = (vi)((h >> 5) & splatu(WOOD_RADII - 1));
  return clamp01(splat(2.5f) - q * lookup32(v->inverse_square, i));
}

/* Coverage by the field's pores at (x, z) of the reference section. The four
 * nearest cells hold everything within half a cell. */
INLINE vf pores_cover(const wood_constants *w, vf x, vf z, const disc *d) {
  const wood_vessels *v = &w->pores;
  vf inverse_cell = splat(v->inverse_cell), cell = splat(v->cell);
  vi ix, iz;
  vf fx = x * inverse_cell - splat(0.5f), fz = z * inverse_cell - splat(0.5f);
  fx = fx - vfloor(fx, &ix) + splat(0.5f);
  fz = fz - vfloor(fz, &iz) + splat(0.5f);
  vu hx = (vu)ix * splatu(HASH_X) + wood_seed(w, SEED_PORES), hz = (vu)iz * splatu(HASH_Z);
  vf sum = splat(0.0f);
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(hx + hz + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    vf ox = (fx - splat((float)a)) * cell, oz = (fz - splat((float)b)) * cell;
    /* two in every other cell, by the top bit; the rest gives their places */
    vm there = lti((vi)base, splati(0));
    if (idle(there)) continue;
    ox = sel(there, ox, splat(1e6f));
    vu h = base << 1;
    UNROLL(2)
    for (int k = 0; k < 2; k++) {
      vf x1 = ox - to_float((vi)(h >> 21)) * splat(v->step);
      vf z1 = oz - to_float((vi)((h >> 10) & splatu(2047))) * splat(v->step);
      vf q = disc_distance(d, x1, z1);
      /* past `farthest` the cover is exactly 0: passing over it changes nothing */
      if (!idle(lt(q, splat(v->farthest)))) sum = sum + vessel_cover(v, h, q);
      h = base * splatu(0x2c1b3c6du);
    }
  }
  return sum * d->height;
}

/* The earlywood band nearest to a point, and the point's place along it. */
typedef struct {
  vm near;   /* close enough to matter */
  vf count;  /* vessels to the ring */
  vi n;      /* the same */
  vf start;  /* mm: rho of the ring's start */
  vf turn;   /* theta' / 2 pi, 0..1 */
  vf per_arc; /* vessels to a mm of arc at the point */
  vf arc;     /* its inverse */
  vu seed;
} row_place;

/* extent: mm, how far along rho the footprint and its taps reach. */
INLINE row_place row_at(const wood_constants *w, const ring_place *ring, vf rho, vf c, vf s,
                        vf extent) {
  row_place p;
  vf width = splat(1.0f) / ring->inverse_width;
  vf into = ring->phase * width, before = width - into;
  vf reach = extent + splat(w->row.radius);
  /* the band just ahead, where that is nearer than the one behind */
  vm ahead = lt(before, vmin(into - splat(w->band), reach));
  p.near = or_(ahead, lt(into, splat(w->band) + reach));
  p.turn = p.per_arc = p.arc = p.count = p.start = splat(0.0f);
  p.n = splati(0);
  p.seed = splatu(0);
  if (!any(p.near)) return p;
  p.start = ring->start + ring->turns * splat(w->ring_period) + sel(ahead, width, splat(0.0f));
  vi which = seli(ahead, ring->ring + splati(1), ring->ring);
  p.count = vfloor(p.start * splat(6.2831853f * w->row_density) + splat(0.5f), &p.n);
  p.near = and_(p.near, le(splat(3.0f), p.count));
  p.turn = arctan2(s, c) * splat(0.15915494f) + splat(0.5f);
  p.arc = splat(6.2831853f) * rho / vmax(p.count, splat(1.0f));
  p.per_arc = splat(1.0f) / vmax(p.arc, splat(1e-3f));
  p.seed = (vu)which * splatu(HASH_Z) + wood_seed(w, SEED_ROWS);
  return p;
}

/* Coverage by the rows, da along the arc and dr along rho from the point. The
 * two nearest vessels of a row hold everything within a spacing less half the
 * jitter. */
INLINE vf rows_cover(const wood_constants *w, const row_place *p, vf rho, vf da, vf dr,
                     const disc *d) {
  vi unused;
  vf sum = splat(0.0f);
  for (int m = 0; m < w->rows; m++) {
    vu row_seed = hash_upper(p->seed + splatu((uint32_t)m * HASH_X));
    /* each row begins at an azimuth of its own */
    vf u = p->turn + to_float((vi)(row_seed >> 8)) * splat(1.0f / 16777216.0f);
    vf place = (u - vfloor(u, &unused)) * p->count - splat(0.5f) + da * p->per_arc;
    vi k0;
    vf within = place - vfloor(place, &k0);
    vf radial = rho + dr - p->start - splat(w->row_start + w->row_spacing * (float)m);
    UNROLL(2)
    for (int a = 0; a < 2; a++) {
      vi k = k0 + splati(a);
      k = seli(lti(k, splati(0)), k + p->n, k);
      k = seli(lti(k, p->n), k, k - p->n);
      vu h = hash_upper((vu)k * splatu(HASH_Y) + row_seed);
      vf j = to_float((vi)(h >> 21)) * splat(1.0f / 2048.0f) - splat(0.5f);
      vf i = to_float((vi)((h >> 10) & splatu(2047))) * splat(1.0f / 2048.0f) - splat(0.5f);
      vf x = (within - splat((float)a) - j * splat(w->row_jitter_arc)) * p->arc;
      vf z = radial - i * splat(w->row_jitter_radial);
      sum = sum + vessel_cover(&w->row, h, disc_distance(d, x, z));
    }
  }
  return sel(p->near, sum * d->height, splat(0.0f));
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

/* One tap: part i of the `parts` (1, 2 or 4, lane by lane) that a footprint is
 * cut into along its longest direction. `share` is 1 / parts. */
INLINE void vessels_tap(const wood_constants *w, const vessel_place *p, const row_place *row,
                        const footprint_axis *l, vm cut, vf share, vf along, vf weight, vessel_cover_t *sum) {
  vf twelfth = splat(1.0f / 12.0f);
  vf aa = p->f.aa * twelfth, ab = p->f.ab * twelfth, bb = p->f.bb * twelfth;
  vf da = splat(0.0f), dr = da;
  if (any(cut)) {
    vf part = share * share * twelfth;
    aa = sel(cut, l->arc * l->arc * part + l->aa * twelfth, aa);
    bb = sel(cut, l->rho * l->rho * part + l->bb * twelfth, bb);
    ab = sel(cut, l->arc * l->rho * part, ab);
    da = sel(cut, l->arc * along, da);
    dr = sel(cut, l->rho * along, dr);
  }
  if (w->has_pores) {
    matrix2 m = to_section(aa, ab, bb, p->c, p->s);
    vf radius2 = splat(w->pores.radius * w->pores.radius);
    if (w->pore_growth != 0.0f) {
      vf size = splat(w->pore_early) + splat(w->pore_growth) * p->ring.phase;
      radius2 = radius2 * size * size;
    }
    disc d = disc_blurred(radius2, m);
    vf x = p->x + (dr * p->c - da * p->s), z = p->z + (dr * p->s + da * p->c);
    sum->pores = sum->pores + pores_cover(w, x, z, &d) * weight;
  }
  if (w->rows && any(row->near)) {
    matrix2 m = {aa, ab, bb};
    disc d = disc_blurred(splat(w->row.radius * w->row.radius), m);
    sum->rows = sum->rows + rows_cover(w, row, p->rho, da, dr, &d) * weight;
  }
}

/* A footprint within reach is answered by one tap, a longer one by two halves
 * or four quarters; past the reach of those the expected coverage fades in. */
INLINE vessel_cover_t vessels_at(const wood_constants *w, const vessel_place *p) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vessel_cover_t v = {zero, zero, zero, zero};
  vf reach2 = splat(w->vessel_reach * w->vessel_reach);
  vm cut = gt(p->f.aa + p->f.bb, reach2), gone = not_(le(zero, one)), halves = gone;
  vf share = one;
  footprint_axis l = {zero, zero, zero, zero, zero};
  int taps = 1;
  if (any(cut)) {
    l = footprint_longest(&p->f);
    vf along2 = l.arc * l.arc + l.rho * l.rho, rest2 = l.aa + l.bb;
    vf quarter2 = along2 * splat(1.0f / 16.0f) + rest2;
    halves = and_(cut, le(along2 * splat(0.25f) + rest2, reach2));
    share = sel(cut, sel(halves, splat(0.5f), splat(0.25f)), one);
    gone = and_(cut, gt(quarter2, splat(w->vessel_last * w->vessel_last)));
    vm quarters = and_(and_(cut, not_(halves)), not_(gone));
    taps = any(quarters) ? 4 : any(halves) ? 2 : any(not_(cut)) ? 1 : 0;
    vf faded = sel(and_(cut, not_(halves)), quarter2, zero);
    v.pores_faded = fade_beyond(faded, w->pores.reach);
    v.rows_faded = fade_beyond(faded, w->row.reach);
  }
  row_place row;
  if (w->rows) row = row_at(w, &p->ring, p->rho, p->c, p->s, vsqrt(p->f.bb));
  for (int i = 0; i < taps; i++) {
    vf along = (splat((float)i + 0.5f)) * share - splat(0.5f);
    vf weight = sel(lt(along, splat(0.5f)), share, zero);
    vessels_tap(w, p, &row, &l, cut, share, along, weight, &v);
  }
  v.pores = sel(gone, zero, v.pores);
  v.rows = sel(gone, zero, v.rows);
  return v;
}

#endif
