/* SPDX-License-Identifier: Apache-2.0
 *
 * Charred wood shrinks into cells, like an alligator's skin: columns along the
 * fibre, Voronoi's in the reference section, and each cracked across at places
 * of its own, all of it bent by noise. Between two such cracks a plate lies, warped its own way, so
 * that no two mirror the same sky; some have a hairline more. A crack's height is a parabola of the
 * distance to the nearest crack, with a narrow core: -depth (0.45 (1 - d / W)^2 + 0.55 (1 - 4 d /
 * W)^2), each where its bracket is positive. At a column's edge the distance is 0, so that where
 * neighbours' cracks do not meet nothing jumps.
 */
#ifndef SOZAI_WOOD_SURFACE_CRACKS_H
#define SOZAI_WOOD_SURFACE_CRACKS_H

#include "../stem.h"

typedef struct {
  vf depth, x, y, z; /* over crack_depth; slopes per mm */
  vf dark;           /* 0..1: how far into the core */
} crack_place;

/* A crack that light may come over. */
typedef struct {
  vf across, away[3]; /* half widths from its middle, and how that goes with the place, per mm */
  vf other;           /* over crack_depth: how high the plate beyond stands */
} crack_side;

/* Along the nearest edge of the column, and the nearest one across it. */
typedef struct {
  crack_side side[2];
} crack_view;

/* The middle of column (ix + a, iz + b), from the point's own cell's corner. */
INLINE vu crack_column(vi ix, vi iz, int a, int b, vu seed, vf *x, vf *z) {
  vu h = hash_mix((vu)(ix + splati(a)) * splatu(HASH_X) + (vu)(iz + splati(b)) * splatu(HASH_Z) +
                  seed);
  *x = splat((float)a + 0.5f) + to_float((vi)h) * splat(0.42f / 2147483648.0f);
  *z = splat((float)b + 0.5f) + to_float((vi)(h << 11)) * splat(0.42f / 2147483648.0f);
  return h;
}

/* The place, bent so that no crack is straight, and the gradient's way back. */
typedef struct {
  vf x, y, z;
  vf back[3][3]; /* rows: of x, y and z over the place's own */
} crack_warp;

#define CRACK_JAG 0.3f       /* of the bends' size: the finer ones' */
#define CRACK_JAG_REACH 0.8f /* and how far those go, beside the others for their size */

/* s: mm, what the footprint takes the finer bends with. */
INLINE crack_warp cracks_warp(const wood_surface *m, vu seed, vf x, vf y, vf z, vf s) {
  crack_warp q;
  float cell = 1.0f / m->crack_frequency[0];
  const float size[3] = {1.6f * cell, 2.2f * cell, 1.6f * cell}; /* x, y, z */
  const float reach[3] = {0.42f * cell, 0.75f * cell, 0.42f * cell};
  vf at[3] = {x, y, z}, to[3];
  for (int c = 0; c < 3; c++) {
    to[c] = at[c];
    for (int i = 0; i < 3; i++) q.back[c][i] = splat(c == i ? 1.0f : 0.0f);
  }
  for (int o = 0; o < 2; o++) {
    float finer = o ? CRACK_JAG : 1.0f;
    vf keep = splat(o ? CRACK_JAG * CRACK_JAG_REACH : 1.0f);
    if (o && filter_touches(s, CRACK_JAG * cell)) keep = keep * filter_keep(s, CRACK_JAG * cell);
    if (o && !any(gt(keep, splat(0.0f)))) break;
    for (int c = 0; c < 3; c++) {
      vf g[3], k = splat(reach[c]) * keep;
      vf n =
          noise_gradient3(x * splat(1.0f / (finer * size[0])), y * splat(1.0f / (finer * size[1])),
                          z * splat(1.0f / (finer * size[2])),
                          seed + splatu(HASH_X * (uint32_t)(c + 1 + 3 * o)), g);
      to[c] = to[c] + k * n;
      for (int i = 0; i < 3; i++) {
        q.back[c][i] = q.back[c][i] + k * splat(1.0f / (finer * size[i])) * g[i];
      }
    }
  }
  q.x = to[0];
  q.y = to[1];
  q.z = to[2];
  return q;
}

/* A hash as a factor of a crack's distance: 1 wide open to `most` a hairline. */
INLINE vf crack_narrow(vu h, float least, float most) {
  return splat(least) + splat((most - least) / 255.0f) * to_float((vi)(h & splatu(255u)));
}

/* What is across a column at a height. */
typedef struct {
  vf d, slope; /* mm to the nearest crack, times its factor; and how that goes with y */
  vf off;      /* mm from that crack upwards */
  vi number;   /* of the stretch between two cracks, */
  vf from;     /* and mm from its middle */
  vi beyond;   /* the next one over the nearest crack, */
  vf there;    /* and mm from its middle to that, or about */
} crack_spot;

/* chance: of 256, how many of the cracks there are. */
INLINE crack_spot crack_across(vf y, float frequency, vu column, float least, float most,
                               uint32_t chance) {
  crack_spot q;
  vf zero = splat(0.0f), half = splat(0.5f), f = splat(frequency), per = splat(1.0f / frequency);
  vf u = y * f + to_float((vi)(column >> 8)) * splat(1.0f / 16777216.0f), c[3];
  vi at;
  vf within = u - vfloor(u, &at);
  q.d = splat(1e9f);
  q.slope = q.off = zero;
  for (int i = 0; i < 3; i++) {
    vu h = hash_mix((vu)(at + splati(i - 1)) * splatu(HASH_Y) + column);
    c[i] = within - (splat((float)i - 0.5f) + to_float((vi)h) * splat(0.36f / 2147483648.0f));
    vf narrow = crack_narrow(h, least, most), d = vabs(c[i]) * narrow;
    vm nearer = lt(d, q.d);
    if (chance < 256) {
      nearer = and_(nearer, lti((vi)(h >> 8 & splatu(255u)), splati((int32_t)chance)));
    }
    q.d = sel(nearer, d, q.d);
    q.slope = sel(nearer, sel(lt(c[i], zero), zero - narrow, narrow), q.slope);
    q.off = sel(nearer, c[i], q.off);
  }
  vm above = gt(c[1], zero);
  vi plate = at + seli(above, splati(1), splati(0));
  vf below = sel(above, c[1], c[0]), over = sel(above, c[2], c[1]);
  q.number = plate;
  q.from = half * (below + over) * per;
  /* the third crack ends the one beyond if the second begins it */
  vm up = lt(q.off, zero);
  vf length = sel(eq(q.off, c[1]), sel(above, c[0] - c[1], c[1] - c[2]), splat(1.0f));
  q.beyond = plate + seli(up, splati(1), splati(-1));
  q.there = sel(up, zero - half, half) * length * per;
  q.d = q.d * per;
  q.off = q.off * per;
  return q;
}

#define HAIRLINES 150       /* of 256 places, those that have one */
#define HAIRLINE_KEEPS 0.2f /* of the way between cracks: what it keeps from them */

/* The column that a place of the bent reference section is in. */
typedef struct {
  vu column;
  vf x, z;         /* cells: the place, from the column's middle */
  vf edge, ex, ez; /* mm: to its nearest edge, and the slopes of that */
  vu beside;       /* the column over that edge, */
  vf bx, bz;       /* and where from its middle */
} crack_cell;

INLINE crack_cell crack_cell_of(const wood_surface *m, vu seed, vf px, vf pz) {
  vf zero = splat(0.0f), half = splat(0.5f), far = splat(1e9f), f = splat(m->crack_frequency[0]);
  vf ux = px * f, uz = pz * f;
  vi ix, iz;
  vf fx = ux - vfloor(ux, &ix), fz = uz - vfloor(uz, &iz);
  vf least = far, mx = zero, mz = zero, cx, cz;
  vu column = splatu(0);
  for (int i = 0; i < 9; i++) {
    vu h = crack_column(ix, iz, i % 3 - 1, i / 3 - 1, seed, &cx, &cz);
    vf d = (cx - fx) * (cx - fx) + (cz - fz) * (cz - fz);
    vm nearer = lt(d, least);
    least = sel(nearer, d, least);
    mx = sel(nearer, cx, mx);
    mz = sel(nearer, cz, mz);
    column = (vu)seli(nearer, (vi)h, (vi)column);
  }
  /* cracks along the fibre are the narrower, some of them much so */
  vf edge = far, ex = zero, ez = zero, bx = zero, bz = zero;
  vu beside = splatu(0);
  for (int i = 0; i < 9; i++) {
    vu h = crack_column(ix, iz, i % 3 - 1, i / 3 - 1, seed, &cx, &cz);
    vf dx = cx - mx, dz = cz - mz, d2 = dx * dx + dz * dz;
    vf k = inverse_root(vmax(d2, splat(1e-6f))),
       narrow = crack_narrow(hash_mix(h + column), 1.2f, 2.2f);
    vf d = (((mx + cx) * half - fx) * dx * k + ((mz + cz) * half - fz) * dz * k) * narrow;
    vm nearer = and_(lt(d, edge), gt(d2, splat(1e-6f)));
    edge = sel(nearer, d, edge);
    ex = sel(nearer, zero - dx * k * narrow, ex);
    ez = sel(nearer, zero - dz * k * narrow, ez);
    bx = sel(nearer, cx, bx);
    bz = sel(nearer, cz, bz);
    beside = (vu)seli(nearer, (vi)h, (vi)beside);
  }
  edge = vmax(edge, zero) * splat(1.0f / m->crack_frequency[0]);
  return (crack_cell){column, fx - mx, fz - mz, edge, ex, ez, beside, fx - bx, fz - bz};
}

/* A hash's 10 bits, from -1 to 1. */
INLINE vf plate_slope(vu h) {
  return (to_float((vi)(h & splatu(1023u))) - splat(511.5f)) * splat(1.0f / 511.5f);
}

/* A plate's slopes, over plate_tilt, and how high it stands at (x, z) cells and y mm from its
 * middle. */
INLINE vf plate_plane(const wood_surface *m, vu column, vi number, vf x, vf y, vf z, vf tilt[3]) {
  vf size = splat(1.0f / m->crack_frequency[0]);
  vu h = hash_mix((vu)number * splatu(HASH_Z) + column);
  for (int c = 0; c < 3; c++) tilt[c] = plate_slope(h >> (10 * c));
  return tilt[0] * x * size + tilt[1] * y + tilt[2] * z * size;
}

/* The same of the plate over the column's nearest edge, there. */
INLINE vf plate_beside(const wood_surface *m, const crack_cell *cell, vf y) {
  vf tilt[3];
  crack_spot q = crack_across(y, m->crack_frequency[1], cell->beside, 1.0f, 2.0f, 256);
  vf square = vmax(cell->ex * cell->ex + cell->ez * cell->ez, splat(0.1f));
  vf way = cell->edge * splat(m->crack_frequency[0]) / square;
  vf x = cell->bx - way * cell->ex, z = cell->bz - way * cell->ez;
  return plate_plane(m, cell->beside, q.number, x, q.from, z, tilt);
}

/* The shape of a crack over its depth, x from its middle in its half widths: 9/20 of one parabola
 * and 11/20 of another that is a quarter as wide. */
INLINE vf crack_shape(vf x, vf *slope) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf outer = vmax(one - x, zero), core = vmax(one - splat(4.0f) * x, zero);
  *slope = zero - (splat(0.9f) * outer + splat(4.4f) * core);
  return splat(0.45f) * outer * outer + splat(0.55f) * core * core;
}

/* Its integral from the middle. */
INLINE vf crack_integral(vf x) {
  vf zero = splat(0.0f), one = splat(1.0f), far = vabs(x);
  vf outer = vmax(one - far, zero), core = vmax(one - splat(4.0f) * far, zero);
  vf sum = splat(0.15f) * (one - outer * outer * outer) +
           splat(0.55f / 12.0f) * (one - core * core * core);
  return sel(lt(x, zero), zero - sum, sum);
}

/* Both averaged from x - e to x + e, over which the crack's two sides cancel. */
INLINE vf crack_average(vf x, vf e, vf *slope) {
  vf sharp, unused, height = crack_shape(x, &sharp);
  vm wide = gt(e, splat(0.01f));
  *slope = sharp;
  if (!any(wide)) return height;
  vf per = splat(0.5f) / vmax(e, splat(0.01f));
  vf mean = (crack_integral(x + e) - crack_integral(x - e)) * per;
  vf rise = (crack_shape(vabs(x + e), &unused) - crack_shape(vabs(x - e), &unused)) * per;
  *slope = sel(wide, rise, sharp);
  return sel(wide, mean, height);
}

#define CRACK_CORE                                                                                 \
  0.117f /* half widths from the middle: within, light comes past the core's shoulder */

/* How steeply a crack rises to its other side, from a point so deep: by the tangent to the outer
 * parabola's shoulder, which is as high as the plate there; within the core, to both parabolas'
 * own, one added to the other, and less what that is too much (to 4 %). */
INLINE vf crack_rise(const crack_side *v, vf depth) {
  vf one = splat(1.0f), zero = splat(0.0f), four = splat(4.0f), x = v->across;
  vm within = lt(x, splat(CRACK_CORE));
  vf core = one - four * x, inner = one - splat(2.0f) * vsqrt(vmin(x, splat(0.25f)));
  vf high = vmax(splat(0.45f) + v->other, splat(0.1f)), way = one + x;
  vf up = v->other + depth - sel(within, splat(0.55f) * core * core, zero);
  vf before = way - vsqrt(vmax(way * way - vmax(up, zero) / high, zero));
  vf rise = (high + high) * vmin(before, one);
  vf both = (rise + splat(4.4f) * inner * inner) * (one - splat(1.5f) * x);
  return sel(within, both, rise);
}

/* How much of the slopes' square such an average leaves: exact where e is small and where it is
 * large, and at most 0.02 off between. Cracks are narrower by 1.5 on the whole. */
INLINE vf crack_left(const wood_surface *m, vf e) {
  vf x = e * splat(1.5f / m->crack_width), one = splat(1.0f);
  return one / (one + x * (splat(6.7f) + splat(50.0f) * x));
}

/* widen: mm that the footprint takes at least. view: filled in if it is given. */
INLINE crack_place cracks_at(const wood_constants *w, vu own, vf px, vf py, vf pz, vf widen,
                             crack_view *view) {
  const wood_surface *m = &w->surface;
  vf zero = splat(0.0f), one = splat(1.0f);
  vu seed = wood_seed(w, own, SEED_CRACKS);
  crack_warp q = cracks_warp(m, seed, px, py, pz, widen + widen);
  crack_cell cell = crack_cell_of(m, seed, q.x, q.z);
  vf edge = cell.edge;

  /* across: cracks that part the plates, and hairlines between them */
  crack_spot part = crack_across(q.y, m->crack_frequency[1], cell.column, 1.0f, 2.0f, 256);
  crack_spot fine = crack_across(q.y, 2.6f * m->crack_frequency[1], cell.column + splatu(HASH_X),
                                 2.0f, 3.5f, HAIRLINES);
  vm along = lt(edge, part.d);
  vf rim = sel(along, edge, part.d), d = rim;
  vf keeps = splat(HAIRLINE_KEEPS / m->crack_frequency[1]);
  vm hair = and_(lt(fine.d, d), gt(vabs(part.off - fine.off), keeps));
  d = sel(hair, fine.d, d);

  vf wide = splat(m->crack_width) + widen, inverse = one / wide;
  vf share = splat(m->crack_width) * inverse;
  vf core = vmax(one - splat(4.0f) * d * inverse, zero), half = splat(1.0f / m->crack_width);
  crack_place p;
  vf slope;
  p.depth = crack_average(d * half, widen * half, &slope);
  p.dark = share * core;
  slope = slope * half;
  vm on_edge = and_(along, not_(hair));
  vf away[3] = {sel(on_edge, cell.ex, zero), sel(on_edge, zero, sel(hair, fine.slope, part.slope)),
                sel(on_edge, cell.ez, zero)};
  vf g[3] = {slope * away[0], slope * away[1], slope * away[2]};

  /* the plate's own plane, which its rims end */
  vf tilt[3];
  vf plane = plate_plane(m, cell.column, part.number, cell.x, part.from, cell.z, tilt);
  vf over = vmax(one - rim * inverse, zero), level = one - over * over;
  vf fall = splat(2.0f) * over * inverse * plane;
  vf edges[3] = {sel(along, fall * cell.ex, zero), sel(along, zero, fall * part.slope),
                 sel(along, fall * cell.ez, zero)};
  vf deep = zero - share * splat(m->plate_tilt);
  p.depth = p.depth + deep * plane * level;
  for (int c = 0; c < 3; c++) g[c] = g[c] + deep * (tilt[c] * level + edges[c]);
  p.x = g[0] * q.back[0][0] + g[1] * q.back[1][0] + g[2] * q.back[2][0];
  p.y = g[0] * q.back[0][1] + g[1] * q.back[1][1] + g[2] * q.back[2][1];
  p.z = g[0] * q.back[0][2] + g[1] * q.back[1][2] + g[2] * q.back[2][2];
  if (!view) return p;
  vf ahead = sel(hair, fine.slope, part.slope) * half, ex = cell.ex * half, ez = cell.ez * half;
  for (int i = 0; i < 3; i++) {
    view->side[0].away[i] = ex * q.back[0][i] + ez * q.back[2][i];
    view->side[1].away[i] = ahead * q.back[1][i];
  }
  view->side[0].across = cell.edge * half;
  view->side[1].across = sel(hair, fine.d, part.d) * half;
  view->side[0].other = splat(m->plate_tilt) * plate_beside(m, &cell, q.y);
  vf beyond = plate_plane(m, cell.column, part.beyond, cell.x, part.there, cell.z, tilt);
  view->side[1].other = splat(m->plate_tilt) * sel(hair, plane, beyond);
  return p;
}

#endif
